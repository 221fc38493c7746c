// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/optics/multilayer.h"
#include "optics/light.h"
#include "stacks.h"

// Laws that every stack obeys.

namespace nacre::optics {
namespace {

double distance(const Amplitudes& a, const Amplitudes& b)
{
    return std::abs(a.r - b.r) + std::abs(a.t - b.t);
}

RC_GTEST_PROP(MultilayerProperty, ClearStacksKeepTheEnergy, ())
{
    const LitStack lit = *test::clear_stack();
    for (const Polarisation polarisation : kBoth) {
        const auto power = stack_power(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation);
        RC_ASSERT(power.R >= 0.0 && power.T >= 0.0);
        RC_ASSERT(std::abs(power.A) < 1e-15);
    }
}

RC_GTEST_PROP(MultilayerProperty, NoStackMakesEnergy, ())
{
    const LitStack lit = *test::any_stack();
    for (const Polarisation polarisation : kBoth) {
        const auto power = stack_power(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation);
        RC_ASSERT(power.R >= 0.0 && power.T >= 0.0);
        RC_ASSERT(power.A > -1e-15);
        RC_ASSERT(std::abs(power.R + power.T + power.A - 1.0) < 1e-15);
    }
}

RC_GTEST_PROP(MultilayerProperty, PowerIsThatOfTheAmplitudes, ())
{
    const LitStack lit = *test::any_stack();
    const Complex n_0 = lit.stack.ambient, n_f = lit.stack.substrate;
    const Complex cos_f = forward_cosine(n_0, n_f, lit.cos_ambient);
    for (const Polarisation polarisation : kBoth) {
        const auto [r, t] =
            stack_amplitudes(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation);
        const auto power = stack_power(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation);
        const double beam = polarisation == Polarisation::s ? (n_f * cos_f).real()
                                                            : (n_f * std::conj(cos_f)).real();
        RC_ASSERT(std::abs(power.R - std::norm(r)) < 1e-14);
        RC_ASSERT(std::abs(power.T - beam / (n_0.real() * lit.cos_ambient) * std::norm(t)) < 1e-13);
    }
}

RC_GTEST_PROP(MultilayerProperty, TransmittanceIsTheSameFromTheOtherSide, ())
{
    const double n_0 = *test::between(1.0, 1.8), n_f = *test::between(1.8, 2.5);
    LitStack lit = *test::lit_stack(test::index_of_any(), rc::gen::just(Complex(n_f)));
    lit.stack.ambient = n_0;
    FilmStack reversed{n_f, {lit.stack.layers.rbegin(), lit.stack.layers.rend()}, n_0};
    const double cos_f = forward_cosine(n_0, n_f, lit.cos_ambient).real();
    for (const Polarisation polarisation : kBoth) {
        const auto down = stack_power(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation);
        const auto up = stack_power(reversed, cos_f, lit.wavelength_nm, polarisation);
        RC_ASSERT(std::abs(down.T - up.T) <= 1e-12 * down.T + 1e-300);
    }
}

RC_GTEST_PROP(MultilayerProperty, OnlyThicknessOverWavelengthCounts, ())
{
    const LitStack lit = *test::any_stack();
    FilmStack twice = lit.stack;
    for (Layer& layer : twice.layers) layer.thickness_nm *= 2.0;
    for (const Polarisation polarisation : kBoth)
        RC_ASSERT(
            distance(stack_amplitudes(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation),
                     stack_amplitudes(twice, lit.cos_ambient, 2.0 * lit.wavelength_nm,
                                      polarisation)) == 0.0);
}

RC_GTEST_PROP(MultilayerProperty, ALayerMayBeCutAnywhere, ())
{
    const LitStack lit = *rc::gen::suchThat(test::any_stack(), [](const LitStack& any) {
        return !any.stack.layers.empty() && any.stack.layers.size() < kMaxLayers;
    });
    const auto cut = *rc::gen::inRange(std::size_t{0}, lit.stack.layers.size());
    const double share = *test::between(0.0, 1.0);
    FilmStack parted = lit.stack;
    Layer upper = parted.layers[cut];
    upper.thickness_nm *= share;
    parted.layers[cut].thickness_nm -= upper.thickness_nm;
    parted.layers.insert(parted.layers.begin() + static_cast<std::ptrdiff_t>(cut), upper);
    for (const Polarisation polarisation : kBoth)
        RC_ASSERT(
            distance(stack_amplitudes(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation),
                     stack_amplitudes(parted, lit.cos_ambient, lit.wavelength_nm, polarisation)) <
            1e-13);
}

// A half-wave layer at this very angle turns both fields by −1.
RC_GTEST_PROP(MultilayerProperty, AbsenteeLayersVanishAnywhere, ())
{
    const LitStack lit = *rc::gen::suchThat(test::any_stack(), [](const LitStack& any) {
        return any.stack.layers.size() < kMaxLayers;
    });
    const auto at = *rc::gen::inRange(std::size_t{0}, lit.stack.layers.size() + 1);
    const double n = *test::between(2.0, 2.8);
    const double q = n * forward_cosine(lit.stack.ambient, n, lit.cos_ambient).real();
    FilmStack padded = lit.stack;
    padded.layers.insert(padded.layers.begin() + static_cast<std::ptrdiff_t>(at),
                         {n, 0.5 * lit.wavelength_nm / q});
    for (const Polarisation polarisation : kBoth) {
        const Amplitudes x =
            stack_amplitudes(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation);
        const Amplitudes y =
            stack_amplitudes(padded, lit.cos_ambient, lit.wavelength_nm, polarisation);
        RC_ASSERT(distance(x, {y.r, -y.t}) < 1e-12);
    }
}

RC_GTEST_PROP(MultilayerProperty, AllIncoherentFlagsKeepTheEnergyOfClearStacks, ())
{
    LitStack lit = *test::clear_stack();
    for (Layer& layer : lit.stack.layers) layer.coherent = *rc::gen::arbitrary<bool>();
    for (const Polarisation polarisation : kBoth) {
        const auto power = stack_power(lit.stack, lit.cos_ambient, lit.wavelength_nm, polarisation);
        RC_ASSERT(std::abs(power.R + power.T - 1.0) < 1e-13);
        RC_ASSERT(power.R >= 0.0 && power.T >= 0.0);
    }
}

}  // namespace
}  // namespace nacre::optics
