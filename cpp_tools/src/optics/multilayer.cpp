// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/multilayer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <span>

#include "coherent_packet.h"

namespace nacre::optics {
namespace {

using detail::Incidence;
using detail::PacketResponse;
using detail::Real;

/// Power coefficients of a coherent packet for light from above and from below.
struct TwoWay {
    Real R, T, R_back, T_back;
};

TwoWay respond_both_ways(const Incidence& incidence, Complex above, std::span<const Layer> layers,
                         Complex below, Polarisation polarisation)
{
    const std::vector<Layer> reversed(layers.rbegin(), layers.rend());
    const PacketResponse down = respond(incidence, above, layers, below, polarisation);
    const PacketResponse up = respond(incidence, below, reversed, above, polarisation);
    return {.R = down.R, .T = down.T, .R_back = up.R, .T_back = up.T};
}

/// What one passage through a layer leaves of an intensity.
Real single_pass(const Incidence& incidence, const Layer& layer)
{
    const Real rate = 4 * std::numbers::pi_v<Real> / static_cast<Real>(incidence.wavelength_nm) *
                      normal_index(incidence, layer.n).imag();
    return std::exp(-rate * static_cast<Real>(layer.thickness_nm));
}

PowerRatios power_ratios(Real R, Real T)
{
    return {.R = static_cast<double>(R),
            .T = static_cast<double>(T),
            .A = static_cast<double>(1 - R - T)};
}

/// Packets of coherent layers separated by incoherent ones, from the substrate up: intensities that
/// bounce inside an incoherent layer form a geometric series (Byrnes 2016, section 6),
///     R ← R_f + T_f T_b P² R / (1 − R_b P² R),   T ← T_f P T / (1 − R_b P² R).
PowerRatios mixed_power(const FilmStack& stack, const Incidence& incidence,
                        Polarisation polarisation)
{
    const std::span<const Layer> layers = stack.layers;
    const auto incoherent = [](const Layer& layer) { return !layer.coherent; };

    Real R = 0, T = 1, pass = 0;
    Complex below = stack.substrate;
    for (std::size_t end = layers.size();;) {
        const auto above = std::find_if(layers.rend() - static_cast<std::ptrdiff_t>(end),
                                        layers.rend(), incoherent);
        const auto begin = static_cast<std::size_t>(layers.rend() - above);
        const Complex n_above = begin == 0 ? stack.ambient : layers[begin - 1].n;
        const auto packet = respond_both_ways(
            incidence, n_above, layers.subspan(begin, end - begin), below, polarisation);
        // Nothing gets in: the quotients of a totally reflecting face would be 0/0.
        if (packet.T == 0) {
            R = packet.R;
            T = 0;
        } else {
            const Real returned = pass * pass * R, series = 1 - packet.R_back * returned;
            R = packet.R + packet.T * packet.T_back * returned / series;
            T = packet.T * (end == layers.size() ? Real{1} : pass) * T / series;
        }
        if (begin == 0) return power_ratios(R, T);
        pass = single_pass(incidence, layers[begin - 1]);
        below = n_above;
        end = begin - 1;
    }
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
    const Incidence incidence{stack.ambient, cos_ambient, wavelength_nm};
    const auto coherent = [](const Layer& layer) { return layer.coherent; };
    if (!std::all_of(stack.layers.begin(), stack.layers.end(), coherent))
        return mixed_power(stack, incidence, polarisation);
    const PacketResponse response =
        respond(incidence, stack.ambient, stack.layers, stack.substrate, polarisation);
    return power_ratios(response.R, response.T);
}

PowerRatios stack_power_unpolarised(const FilmStack& stack, double cos_ambient,
                                    double wavelength_nm)
{
    const PowerRatios s = stack_power(stack, cos_ambient, wavelength_nm, Polarisation::s);
    const PowerRatios p = stack_power(stack, cos_ambient, wavelength_nm, Polarisation::p);
    return {.R = 0.5 * (s.R + p.R), .T = 0.5 * (s.T + p.T), .A = 0.5 * (s.A + p.A)};
}

std::optional<StackProblem> validate(const FilmStack& stack) noexcept
{
    const int count = static_cast<int>(stack.layers.size());
    if (count > kMaxLayers) return StackProblem{"d_nm", kMaxLayers, "at most 64 layers"};
    if (const char* message = index_problem(stack.ambient, true))
        return StackProblem{"n", 0, message};
    for (int j = 0; j < count; ++j) {
        const Layer& layer = stack.layers[static_cast<std::size_t>(j)];
        if (const char* message = index_problem(layer.n, false))
            return StackProblem{"n", j + 1, message};
        if (!std::isfinite(layer.thickness_nm) || layer.thickness_nm < 0.0)
            return StackProblem{"d_nm", j, "must be finite and ≥ 0"};
    }
    if (const char* message = index_problem(stack.substrate, false))
        return StackProblem{"n", count + 1, message};
    return std::nullopt;
}

}  // namespace nacre::optics
