// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/multilayer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>

#include "stacks/coherent_packet.h"
#include "stacks/incoherent_series.h"
#include "stacks/partial_coherence.h"

namespace nacre::optics {
namespace {

using detail::MeanPower;
using detail::PacketResponse;
using detail::Real;

PowerRatios power_ratios(Real R, Real T)
{
    return {.R = static_cast<double>(R),
            .T = static_cast<double>(T),
            .A = static_cast<double>(1 - R - T)};
}

bool finite(Complex n)
{
    return std::isfinite(n.real()) && std::isfinite(n.imag());
}

const char* index_problem(Complex n, bool ambient)
{
    if (!finite(n)) return "must be finite";
    if (!(n.real() > 0.0)) return "real part must be > 0";
    if (n.imag() < 0.0) return "imaginary part must be ≥ 0 (media with gain are not supported)";
    if (ambient && n.imag() != 0.0) return "the ambient must not absorb (imaginary part 0)";
    return nullptr;
}

}  // namespace

Amplitudes stack_amplitudes(const FilmStack& stack, double cos_ambient, double wavelength_nm,
                            Polarisation polarisation)
{
    assert(!validate(stack));
    const PacketResponse response =
        detail::respond({stack.ambient, cos_ambient, wavelength_nm}, stack.ambient, stack.layers,
                        stack.substrate, polarisation);
    // The recursion carries H for p; E = H/n.
    const detail::Extended to_field =
        polarisation == Polarisation::p
            ? detail::Extended(stack.ambient) / detail::Extended(stack.substrate)
            : detail::Extended(1);
    return {.r = Complex(response.r), .t = Complex(response.t * to_field)};
}

PowerRatios stack_power(const FilmStack& stack, double cos_ambient, double wavelength_nm,
                        Polarisation polarisation)
{
    assert(!validate(stack));
    const detail::Incidence incidence{stack.ambient, cos_ambient, wavelength_nm};
    const auto coherent = [](const Layer& layer) { return layer.coherent; };
    if (!std::all_of(stack.layers.begin(), stack.layers.end(), coherent)) {
        const detail::Packet whole = detail::packets(stack, incidence, polarisation).front();
        return power_ratios(whole.R_whole, whole.T_whole);
    }
    const MeanPower power =
        mean_response(incidence, stack.ambient, stack.layers, stack.substrate, polarisation);
    return power_ratios(power.R, power.T);
}

PowerRatios stack_power_unpolarised(const FilmStack& stack, double cos_ambient,
                                    double wavelength_nm)
{
    const PowerRatios s = stack_power(stack, cos_ambient, wavelength_nm, Polarisation::s);
    const PowerRatios p = stack_power(stack, cos_ambient, wavelength_nm, Polarisation::p);
    return {.R = 0.5 * (s.R + p.R), .T = 0.5 * (s.T + p.T), .A = 0.5 * (s.A + p.A)};
}

FilmStack seen_in_band(FilmStack stack, double bandwidth_nm, double wavelength_nm)
{
    assert(bandwidth_nm >= 0.0);
    // From the full width at half maximum of a Gaussian to its standard deviation.
    const double to_deviation = 1.0 / (2.0 * std::sqrt(2.0 * std::numbers::ln2));
    // A phase ∝ d/λ cannot tell a spread of 1/λ from one of d.
    const double relative = bandwidth_nm * to_deviation / wavelength_nm;
    for (Layer& layer : stack.layers)
        if (layer.coherent)
            layer.spread_nm = std::hypot(layer.spread_nm, relative * layer.thickness_nm);
    return stack;
}

bool has_amplitudes(const FilmStack& stack) noexcept
{
    return std::all_of(stack.layers.begin(), stack.layers.end(),
                       [](const Layer& layer) { return layer.coherent && layer.spread_nm == 0.0; });
}

std::optional<StackProblem> validate(const FilmStack& stack) noexcept
{
    const int count = static_cast<int>(stack.layers.size());
    static_assert(kMaxLayers == 64, "the message has it too");
    if (count > kMaxLayers) return StackProblem{"d_nm", kMaxLayers, "at most 64 layers"};
    if (const char* message = index_problem(stack.ambient, true))
        return StackProblem{"n", 0, message};
    for (int j = 0; j < count; ++j) {
        const Layer& layer = stack.layers[static_cast<std::size_t>(j)];
        if (const char* message = index_problem(layer.n, false))
            return StackProblem{"n", j + 1, message};
        if (!std::isfinite(layer.thickness_nm) || layer.thickness_nm < 0.0)
            return StackProblem{"d_nm", j, "must be finite and ≥ 0"};
        if (!std::isfinite(layer.spread_nm) || layer.spread_nm < 0.0)
            return StackProblem{"spread_nm", j, "must be finite and ≥ 0"};
        if (layer.spread_nm > 0.0 && !layer.coherent)
            return StackProblem{"spread_nm", j, "must be 0 in a layer that is incoherent"};
    }
    if (const char* message = index_problem(stack.substrate, false))
        return StackProblem{"n", count + 1, message};
    return std::nullopt;
}

}  // namespace nacre::optics
