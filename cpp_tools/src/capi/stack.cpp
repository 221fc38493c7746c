// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "guard.h"
#include "nacre/optics/multilayer.h"
#include "nacre/optics/stack_batch.h"

namespace nacre::capi {
namespace {

using optics::Complex;
using optics::kLanes;
using optics::Polarisation;

/// The arrays of a call.
struct Stacks {
    std::size_t count, layers;
    const double *n, *d_nm, *angle_deg, *wavelength_nm;
    const unsigned char* coherent;
    nacre_polarisation polarisation;
    double *power, *amplitudes;

    [[nodiscard]] Complex index(std::size_t item, std::size_t medium) const
    {
        const double* pair = n + 2 * (item * (layers + 2) + medium);
        return {pair[0], pair[1]};
    }
    [[nodiscard]] double thickness(std::size_t item, std::size_t layer) const
    {
        return d_nm[item * layers + layer];
    }
    [[nodiscard]] double cos_angle(std::size_t item) const
    {
        constexpr long double radians = std::numbers::pi_v<long double> / 180;
        return static_cast<double>(std::cos(static_cast<long double>(angle_deg[item]) * radians));
    }
    [[nodiscard]] bool all_coherent() const
    {
        return coherent == nullptr || std::all_of(coherent, coherent + layers,
                                                  [](unsigned char flag) { return flag != 0; });
    }
};

optics::FilmStack film_stack(const Stacks& in, std::size_t item)
{
    optics::FilmStack stack{.ambient = in.index(item, 0), .layers = {}, .substrate = {}};
    for (std::size_t j = 0; j < in.layers; ++j)
        stack.layers.push_back({.n = in.index(item, j + 1),
                                .thickness_nm = in.thickness(item, j),
                                .coherent = in.coherent == nullptr || in.coherent[j] != 0});
    stack.substrate = in.index(item, in.layers + 1);
    return stack;
}

void check_item(const Stacks& in, std::size_t item)
{
    const auto refuse = [item](const std::string& field, const std::string& message) {
        fail(field, fmt::format("{} (item {})", message, item));
    };
    const double angle = in.angle_deg[item], wavelength = in.wavelength_nm[item];
    if (!(angle >= 0.0 && angle < 90.0))
        refuse("angle_deg", fmt::format("must be in [0, 90) (got {})", angle));
    if (!(std::isfinite(wavelength) && wavelength > 0.0))
        refuse("wavelength_nm", fmt::format("must be finite and > 0 (got {})", wavelength));
    const auto problem = validate(film_stack(in, item));
    if (!problem) return;
    const auto index = static_cast<std::size_t>(problem->index);
    const bool of_index = problem->field[0] == 'n';
    const Complex n = of_index ? in.index(item, index) : Complex{};
    const std::string got = of_index ? fmt::format("{}{:+}i", n.real(), n.imag())
                                     : fmt::format("{}", in.thickness(item, index));
    refuse(fmt::format("{}[{}]", problem->field, index),
           fmt::format("{} (got {})", problem->message, got));
}

void check(const Stacks& in)
{
    if (in.layers > optics::kMaxLayers)
        fail("d_nm",
             fmt::format("must have at most {} layers (got {})", optics::kMaxLayers, in.layers));
    if (in.count == 0) return;
    require(in.n, "n");
    if (in.layers > 0) require(in.d_nm, "d_nm");
    require(in.angle_deg, "angle_deg");
    require(in.wavelength_nm, "wavelength_nm");
    require(in.power, "power");
    if (in.polarisation < NACRE_S || in.polarisation > NACRE_UNPOLARISED)
        fail("polarisation", "must be s, p or u");
    if (in.amplitudes != nullptr && (in.polarisation == NACRE_UNPOLARISED || !in.all_coherent()))
        fail("amplitudes", "exist for s or p and coherent layers only");
    for (std::size_t item = 0; item < in.count; ++item) check_item(in, item);
}

void store_power(const Stacks& in, std::size_t item, const optics::PowerRatios& power)
{
    in.power[3 * item] = power.R;
    in.power[3 * item + 1] = power.T;
    in.power[3 * item + 2] = power.A;
}

void store_amplitudes(const Stacks& in, std::size_t item, Complex r, Complex t)
{
    if (in.amplitudes == nullptr) return;
    double* out = in.amplitudes + 4 * item;
    out[0] = r.real();
    out[1] = r.imag();
    out[2] = t.real();
    out[3] = t.imag();
}

void solve_one(const Stacks& in, std::size_t item)
{
    const optics::FilmStack stack = film_stack(in, item);
    const double cosine = in.cos_angle(item), wavelength = in.wavelength_nm[item];
    if (in.polarisation == NACRE_UNPOLARISED) {
        store_power(in, item, stack_power_unpolarised(stack, cosine, wavelength));
        return;
    }
    const auto polarisation = in.polarisation == NACRE_S ? Polarisation::s : Polarisation::p;
    store_power(in, item, stack_power(stack, cosine, wavelength, polarisation));
    if (in.amplitudes == nullptr) return;
    const auto [r, t] = stack_amplitudes(stack, cosine, wavelength, polarisation);
    store_amplitudes(in, item, r, t);
}

void set(optics::ComplexLanes& lanes, std::size_t i, Complex value)
{
    lanes.re[i] = value.real();
    lanes.im[i] = value.imag();
}

/// Items first, first + 1, …; lanes past the end repeat the last item.
void fill(optics::LaneStack& stack, const Stacks& in, std::size_t first)
{
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t item = std::min(first + i, in.count - 1);
        stack.n_0[i] = in.index(item, 0).real();
        stack.cos_0[i] = in.cos_angle(item);
        set(stack.above, i, in.index(item, 0));
        set(stack.below, i, in.index(item, in.layers + 1));
        for (std::size_t j = 0; j < in.layers; ++j) {
            set(stack.layers[j].n, i, in.index(item, j + 1));
            stack.layers[j].waves[i] = in.thickness(item, j) / in.wavelength_nm[item];
        }
    }
}

optics::PowerRatios power(const optics::LaneResponse& response, std::size_t i)
{
    return {.R = response.R[i], .T = response.T[i], .A = 1.0 - response.R[i] - response.T[i]};
}

void store(const Stacks& in, std::size_t item, const optics::BatchResponse& response, std::size_t i)
{
    const optics::PowerRatios s = power(response.s, i), p = power(response.p, i);
    if (in.polarisation == NACRE_UNPOLARISED) {
        store_power(in, item,
                    {.R = 0.5 * (s.R + p.R), .T = 0.5 * (s.T + p.T), .A = 0.5 * (s.A + p.A)});
        return;
    }
    const auto& chosen = in.polarisation == NACRE_S ? response.s : response.p;
    store_power(in, item, in.polarisation == NACRE_S ? s : p);
    store_amplitudes(in, item, {chosen.r.re[i], chosen.r.im[i]}, {chosen.t.re[i], chosen.t.im[i]});
}

/// Lanes in double precision; an item whose result would lose more than this is computed again in
/// extended precision, so that every result is good to 1e-12.
constexpr double kDoubtAllowed = 4e-14;

void solve(const Stacks& in)
{
    if (!in.all_coherent()) {
        for (std::size_t item = 0; item < in.count; ++item) solve_one(in, item);
        return;
    }
    optics::LaneStack stack;
    stack.layers.resize(in.layers);
    optics::BatchResponse response;
    for (std::size_t first = 0; first < in.count; first += kLanes) {
        fill(stack, in, first);
        stack_batch(stack, response);
        for (std::size_t i = 0; i < std::min(kLanes, in.count - first); ++i) {
            if (response.doubt[i] <= kDoubtAllowed)
                store(in, first + i, response, i);
            else
                solve_one(in, first + i);
        }
    }
}

}  // namespace
}  // namespace nacre::capi

extern "C" nacre_status nacre_stack(size_t count, size_t layers, const double* n,
                                    const double* d_nm, const double* angle_deg,
                                    const double* wavelength_nm, const unsigned char* coherent,
                                    nacre_polarisation polarisation, double* power,
                                    double* amplitudes)
{
    return nacre::capi::guarded([&] {
        const nacre::capi::Stacks stacks{count,     layers,        n,        d_nm,
                                         angle_deg, wavelength_nm, coherent, polarisation,
                                         power,     amplitudes};
        nacre::capi::check(stacks);
        nacre::capi::solve(stacks);
    });
}
