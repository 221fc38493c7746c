// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <complex>
#include <numbers>

#include "nacre/optics/stack_batch.h"

// The series of intensities of multilayer.cpp, on lanes.

namespace nacre::optics {
namespace {

/// Power ratios of one polarisation, from the substrate up to some depth.
struct Intensities {
    Lanes R, T;
};

/// What one passage through a layer leaves of an intensity.
Lanes single_pass(const LaneStack& stack, const LaneLayer& layer)
{
    Lanes pass;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::complex<double> n(layer.n.re[i], layer.n.im[i]);
        const double n_0 = stack.n_0[i], across = n_0 * stack.cos_0[i];
        const std::complex<double> q = std::sqrt((n - n_0) * (n + n_0) + across * across);
        pass[i] = std::exp(-4.0 * std::numbers::pi * q.imag() * layer.waves[i]);
    }
    return pass;
}

void add_packet(Intensities& sum, const LanePower& down, const LanePower& up, const Lanes& pass)
{
    for (std::size_t i = 0; i < kLanes; ++i) {
        if (down.T[i] == 0.0) {  // total reflection: the quotients below would be 0/0
            sum.R[i] = down.R[i];
            sum.T[i] = 0.0;
            continue;
        }
        const double returned = pass[i] * pass[i] * sum.R[i];
        const double series = 1.0 - up.R[i] * returned;
        sum.R[i] = down.R[i] + down.T[i] * up.T[i] * returned / series;
        sum.T[i] = down.T[i] * pass[i] * sum.T[i] / series;
    }
}

}  // namespace

void mixed_batch(const LaneStack& stack, const std::vector<bool>& coherent, Lanes& R, Lanes& T)
{
    LaneStack packet{
        .n_0 = stack.n_0, .cos_0 = stack.cos_0, .above = {}, .below = stack.below, .layers = {}};
    LaneStack reversed = packet;
    BatchPower down, up;
    Intensities s, p;
    s.R.fill(0.0);
    s.T.fill(1.0);
    p = s;
    Lanes pass;
    pass.fill(1.0);  // below the last packet nothing returns: R = 0 there

    for (std::size_t end = stack.layers.size();;) {
        std::size_t begin = end;
        while (begin > 0 && coherent[begin - 1]) --begin;
        const auto at = [&](std::size_t j) {
            return stack.layers.begin() + static_cast<std::ptrdiff_t>(j);
        };
        packet.above = begin == 0 ? stack.above : stack.layers[begin - 1].n;
        packet.layers.assign(at(begin), at(end));
        reversed.above = packet.below;
        reversed.below = packet.above;
        reversed.layers.assign(packet.layers.rbegin(), packet.layers.rend());
        stack_batch(packet, down);
        stack_batch(reversed, up);
        add_packet(s, down.s, up.s, pass);
        add_packet(p, down.p, up.p, pass);
        if (begin == 0) break;
        pass = single_pass(stack, stack.layers[begin - 1]);
        packet.below = packet.above;
        end = begin - 1;
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        R[i] = 0.5 * (s.R[i] + p.R[i]);
        T[i] = 0.5 * (s.T[i] + p.T[i]);
    }
}

}  // namespace nacre::optics
