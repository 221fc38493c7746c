// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/stack_colour.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "base/guard.h"
#include "colour/colour_maker.h"
#include "nacre/library/media_library.h"
#include "nacre/media/working_range.h"
#include "nacre/optics/film_stack.h"
#include "nacre/optics/stack_colour.h"
#include "nacre/spectral/colour_quadrature.h"

namespace nacre::capi {
namespace {

using optics::StackColour;

spectral::OpticalConstantsPtr constants(const nacre_medium_index& medium,
                                        spectral::WorkingRange& range)
{
    if (medium.key != nullptr) return range.cover(spectral::library_medium(medium.key).constants);
    require(medium.n, "n");
    if (medium.count == 1) return spectral::constant_index({medium.n[0], medium.n[1]});
    if (medium.count != spectral::kWavelengths)
        fail("count",
             fmt::format("must be 1 or {} (got {})", spectral::kWavelengths, medium.count));
    std::array<spectral::Complex, spectral::kWavelengths> n;
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = {medium.n[2 * i], medium.n[2 * i + 1]};
    return spectral::index_on_grid(n);
}

optics::DispersiveStack read_stack(const nacre_colour_stacks& stacks)
{
    if (stacks.layers > optics::kMaxLayers)
        fail("layers", fmt::format("must be ≤ {} (got {})", optics::kMaxLayers, stacks.layers));
    require(stacks.media, "media");
    spectral::WorkingRange range(spectral::RangeRule::hold_ends);
    optics::DispersiveStack stack;
    stack.media.reserve(stacks.layers + 2);
    for (std::size_t m = 0; m < stacks.layers + 2; ++m) {
        try {
            stack.media.push_back(constants(stacks.media[m], range));
        } catch (const InputError& error) {
            const Diagnostic& problem = error.diagnostics().front();
            const bool named = stacks.media[m].key != nullptr;
            fail(
                named ? fmt::format("media[{}]", m) : fmt::format("media[{}].{}", m, problem.field),
                problem.message);
        }
    }
    stack.coherent.reserve(stacks.layers);
    for (std::size_t j = 0; j < stacks.layers; ++j)
        stack.coherent.push_back(stacks.coherent == nullptr || stacks.coherent[j] != 0);
    return stack;
}

void check_stacks(const nacre_colour_stacks& stacks)
{
    if (stacks.polarisation < NACRE_S || stacks.polarisation > NACRE_UNPOLARISED)
        fail("polarisation", "must be s, p or u");
    if (stacks.count == 0) return;
    require(stacks.angle_deg, "angle_deg");
    if (stacks.layers > 0) require(stacks.d_nm, "d_nm");
    for_each_item(stacks.count, [&](std::size_t i) {
        const double angle_deg = stacks.angle_deg[i];
        if (!(angle_deg >= 0.0 && angle_deg < 90.0))
            fail("angle_deg", fmt::format("must be in [0, 90) (got {})", angle_deg));
        for (std::size_t j = 0; j < stacks.layers; ++j) {
            const double d_nm = stacks.d_nm[i * stacks.layers + j];
            if (!(d_nm >= 0.0 && std::isfinite(d_nm)))
                fail(fmt::format("d_nm[{}]", j),
                     fmt::format("must be finite and ≥ 0 (got {})", d_nm));
        }
    });
}

double share_of_s(nacre_polarisation polarisation)
{
    return polarisation == NACRE_S ? 1.0 : polarisation == NACRE_P ? 0.0 : 0.5;
}

/// All stacks with what `make` makes, once a thread.
template <class Make>
std::vector<StackColour> solve_all(const nacre_colour_stacks& stacks, const Make& make)
{
    std::vector<StackColour> colours(stacks.count);
    // Made here once, so that what is wrong with a medium is said even where there is no stack.
    tbb::enumerable_thread_specific<decltype(make())> solvers(make);
    (void)solvers.local();
    tbb::parallel_for(std::size_t{0}, stacks.count, [&](std::size_t i) {
        const std::span<const double> d_nm(stacks.d_nm + i * stacks.layers, stacks.layers);
        const optics::ObliqueLight light{
            .cos_ambient = std::cos(stacks.angle_deg[i] * std::numbers::pi / 180.0),
            .share_of_s = share_of_s(stacks.polarisation)};
        colours[i] = solvers.local().at(d_nm, light);
    });
    return colours;
}

std::vector<StackColour> solve(const nacre_colour_stacks& stacks,
                               const spectral::ColourWeights& weights)
{
    const optics::DispersiveStack stack = read_stack(stacks);
    const auto quadrature =
        named_quadrature(stacks.sampling ? stacks.sampling : "adaptive", weights);
    if (quadrature)
        return solve_all(stacks, [&] { return optics::SummedColours(stack, *quadrature); });
    return solve_all(stacks, [&] { return optics::AdaptiveColours(stack, weights); });
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_stack_colours(const nacre_colour_stacks* stacks,
                                 const nacre_colour_options* options, nacre_colour* reflectance,
                                 nacre_colour* transmittance, size_t* wavelengths)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(stacks, "stacks");
        capi::require(options, "options");
        nacre_colour_options of_reflectance = *options;
        of_reflectance.reflectance = 1;
        const capi::ColourMaker make(of_reflectance);
        capi::check_stacks(*stacks);
        // Errors count in a space like that of a screen; XYZ is a matrix away.
        const spectral::ColourSpace& space = spectral::colour_space("lin_rec709_scene");
        const auto colours = capi::solve(
            *stacks,
            reflectance_weights(make.light(), make.observer(), space, spectral::Adaptation::none));
        for (std::size_t i = 0; i < colours.size(); ++i) {
            const auto colour = [&](const spectral::Vec3& rgb) {
                return make.from_xyz(spectral::multiply(space.to_xyz_d65, rgb));
            };
            if (reflectance) reflectance[i] = colour(colours[i].reflectance);
            if (transmittance) transmittance[i] = colour(colours[i].transmittance);
            if (wavelengths) wavelengths[i] = colours[i].evaluations;
        }
    });
}

nacre_status nacre_map_range(size_t count, double* rgb, const char* range)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(range, "range");
        const auto mapping = spectral::range_mapping_from_name(range);
        if (count == 0) return;
        capi::require(rgb, "rgb");
        for (std::size_t i = 0; i < 3 * count; ++i)
            if (!std::isfinite(rgb[i]))
                capi::fail(fmt::format("rgb[{}, {}]", i / 3, i % 3),
                           fmt::format("must be finite (got {})", rgb[i]));
        std::vector<spectral::Vec3> colours(count);
        for (std::size_t i = 0; i < count; ++i) std::copy_n(rgb + 3 * i, 3, colours[i].begin());
        spectral::map_range(colours, mapping);
        for (std::size_t i = 0; i < count; ++i)
            std::copy(colours[i].begin(), colours[i].end(), rgb + 3 * i);
    });
}
}
