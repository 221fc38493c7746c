// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "stacks/stack_call.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/guard.h"

namespace nacre::capi {

optics::FilmStack film_stack(const Stacks& in, const Item& item)
{
    optics::FilmStack stack{.ambient = item.index(0), .layers = {}, .substrate = {}};
    for (std::size_t j = 0; j < in.layers; ++j)
        stack.layers.push_back({.n = item.index(j + 1),
                                .thickness_nm = item.d_nm[j],
                                .coherent = in.coherent(j),
                                .spread_nm = in.spread_nm(j)});
    stack.substrate = item.index(in.layers + 1);
    return stack;
}

namespace {

bool good_angle(double degrees)
{
    return degrees >= 0.0 && degrees < 90.0;
}
bool good_wavelength(double nm)
{
    return std::isfinite(nm) && nm > 0.0;
}

void check_item(const Stacks& in, const Item& item, std::size_t number)
{
    const auto refuse = [number](const std::string& field, const std::string& message) {
        fail(field, fmt::format("{} (item {})", message, number));
    };
    if (!good_angle(item.angle_deg))
        refuse("angle_deg", fmt::format("must be in [0, 90) (got {})", item.angle_deg));
    if (!good_wavelength(item.wavelength_nm))
        refuse("wavelength_nm", fmt::format("must be finite and > 0 (got {})", item.wavelength_nm));
    const auto problem = validate(film_stack(in, item));
    if (!problem) return;
    const auto index = static_cast<std::size_t>(problem->index);
    const bool of_index = problem->field[0] == 'n';
    const Complex n = of_index ? item.index(index) : Complex{};
    const std::string got =
        of_index ? fmt::format("{}{:+}i", n.real(), n.imag()) : fmt::format("{}", item.d_nm[index]);
    refuse(fmt::format("{}[{}]", problem->field, index),
           fmt::format("{} (got {})", problem->message, got));
}

/// Whether every element is good, each looked at once however many items share it.
bool all_good(const Stacks& in)
{
    const std::vector<double> no_thickness(in.layers, 0.0);
    const auto good_media = [&](std::size_t element) {
        Item item{};
        item.n = in.n.values + 2 * (in.layers + 2) * element;
        item.d_nm = no_thickness.data();
        return !validate(film_stack(in, item));
    };
    const auto good_thicknesses = [&](std::size_t element) {
        const double* d_nm = in.d_nm.values + in.layers * element;
        return std::all_of(d_nm, d_nm + in.layers,
                           [](double d) { return std::isfinite(d) && d >= 0.0; });
    };
    const auto every = [&in](const nacre_grid_array& array, auto&& good) {
        return every_element(in.shape, in.steps(array), good);
    };
    return every(in.angle_deg, [&](std::size_t i) { return good_angle(in.angle_deg.values[i]); }) &&
           every(in.wavelength_nm,
                 [&](std::size_t i) { return good_wavelength(in.wavelength_nm.values[i]); }) &&
           every(in.n, good_media) && every(in.d_nm, good_thicknesses);
}

void check_coherence(const Stacks& in)
{
    const double bandwidth = in.coherence.bandwidth_nm;
    if (!std::isfinite(bandwidth) || bandwidth < 0.0)
        fail("bandwidth_nm", fmt::format("must be finite and ≥ 0 (got {})", bandwidth));
    for (std::size_t j = 0; j < in.layers; ++j) {
        const double spread = in.spread_nm(j);
        const std::string field = fmt::format("spread_nm[{}]", j);
        if (!std::isfinite(spread) || spread < 0.0)
            fail(field, fmt::format("must be finite and ≥ 0 (got {})", spread));
        if (spread > 0.0 && !in.coherent(j))
            fail(field, fmt::format("must be 0 in a layer that is incoherent (got {})", spread));
    }
    if (in.absorption != nullptr && in.any_spread())
        fail("absorption", "by layer is not known where layers have a spread or light a bandwidth");
}

}  // namespace

void check(const Stacks& in)
{
    if (in.layers > optics::kMaxLayers)
        fail("d_nm",
             fmt::format("must have at most {} layers (got {})", optics::kMaxLayers, in.layers));
    if (in.count == 0) return;
    require(in.n.values, "n");
    if (in.layers > 0) require(in.d_nm.values, "d_nm");
    require(in.angle_deg.values, "angle_deg");
    require(in.wavelength_nm.values, "wavelength_nm");
    require(in.power, "power");
    if (in.polarisation < NACRE_S || in.polarisation > NACRE_UNPOLARISED)
        fail("polarisation", "must be s, p or u");
    if (in.amplitudes != nullptr && (in.polarisation == NACRE_UNPOLARISED || !in.fully_coherent()))
        fail("amplitudes", "exist for s or p and coherent layers only");
    check_coherence(in);
    if (all_good(in)) return;
    ItemCursor cursor(in, 0);
    for (std::size_t item = 0; item < in.count; ++item, cursor.advance())
        check_item(in, *cursor, item);
}

}  // namespace nacre::capi
