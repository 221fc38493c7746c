// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0

// Compiled once for each instruction set, with NACRE_VECTOR_CLONES as its attribute and namespace
// `nacre` under a name of its own, so that the copies do not meet.
#include "stack_batch_clone.h"

// NOLINTBEGIN: copies with another macro are the point
#include "optics/lanes/angled_stack.cpp"
#include "optics/lanes/lane_fields.cpp"
#include "optics/lanes/phase_map.cpp"
#include "optics/lanes/stack_batch.cpp"
// NOLINTEND

namespace nacre_clones {
namespace {

using nacre::optics::BatchAmplitudes;
using nacre::optics::BatchPower;
using nacre::optics::ComplexLanes;
using nacre::optics::kLanes;
using nacre::optics::LaneAmplitudes;
using nacre::optics::LanePower;
using nacre::optics::Lanes;
using nacre::optics::LaneStack;

constexpr std::size_t kRows = 5;

LaneStack unpack(const Input& input)
{
    const double* next = input.values.data();
    const auto take = [&next](Lanes& lanes) {
        for (double& value : lanes) value = *next++;
    };
    const auto take_index = [&take](ComplexLanes& lanes) {
        take(lanes.re);
        take(lanes.im);
    };
    LaneStack stack;
    take(stack.n_0);
    take(stack.cos_0);
    stack.above = {stack.n_0, {}};
    stack.above.im.fill(0.0);
    take_index(stack.below);
    stack.layers.resize(input.layers);
    for (auto& layer : stack.layers) {
        take_index(layer.n);
        take(layer.waves);
    }
    return stack;
}

void append(std::vector<double>& out, const Lanes& lanes)
{
    out.insert(out.end(), lanes.begin(), lanes.end());
}

void append(std::vector<double>& out, const LanePower& power, const LaneAmplitudes& amplitudes)
{
    for (const Lanes* lanes : {&amplitudes.r.re, &amplitudes.r.im, &amplitudes.t.re,
                               &amplitudes.t.im, &power.R, &power.T})
        append(out, *lanes);
}

}  // namespace

std::vector<double> NACRE_CLONE(const Input& input)
{
    const LaneStack stack = unpack(input);
    std::vector<double> out;
    BatchPower power;
    BatchAmplitudes amplitudes;
    stack_batch(stack, power, amplitudes);
    append(out, power.s, amplitudes.s);
    append(out, power.p, amplitudes.p);
    append(out, power.doubt);

    std::vector<Lanes> R(kRows), T(kRows);
    const auto append_rows = [&] {
        for (std::size_t row = 0; row < kRows; ++row) {
            append(out, R[row]);
            append(out, T[row]);
        }
    };
    nacre::optics::ScaledStack(stack).march(0.5, 0.3, R, T);
    append_rows();
    for (std::size_t varying = 0; varying < input.layers; ++varying) {
        const Lanes& waves = stack.layers[varying].waves;
        nacre::optics::PhaseMap(stack, varying).march(waves, waves, R, T);
        append_rows();
    }
    return out;
}

}  // namespace nacre_clones
