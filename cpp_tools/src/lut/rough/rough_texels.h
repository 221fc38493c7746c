// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <string>
#include <vector>

#include "films/colour_error.h"
#include "films/sizing.h"
#include "nacre/lut/film_table.h"
#include "nacre/lut/rough_slices.h"
#include "rough/rough_views.h"

/// @file
/// Rough tables of colours that are known at every view, row and roughness. `Colours` has
///   static constexpr int kSides;                              // of the surface, see Table::sides
///   struct View;                                              // with a cos_theta
///   std::pair<double, std::size_t> surface() const;           // what views depend on
///   View see(const RoughPlace&) const;
///   RoughColour at(std::size_t row, const View&) const;       // rows half-way between texels too
///   double reflected_share(const View&) const;                // see rounded()
///   FilmColour counted(FilmColour tints, const View&) const;  // whose error is measured

namespace nacre::lut {

/// Means over facets are smoother over the angle than what they are means of, and a lobe's colour
/// needs not be as exact as a mirror's.
[[nodiscard]] inline RoughSize rough_size(const Table& smooth)
{
    const auto share = [](int texels, int parts) {
        return static_cast<std::size_t>((texels + parts - 1) / parts);
    };
    constexpr std::size_t kFewestTexels = 17;
    return {std::max(kFewestTexels, share(smooth.x.texels, 4)),
            smooth.y.texels == 1 ? 1 : std::max(kFewestTexels, share(smooth.y.texels, 3))};
}

/// The smooth tables on the rows of the rough ones and half-way between them.
[[nodiscard]] inline FilmTables on_half_rows(const FilmTableRequest& request,
                                             const FilmTables& smooth)
{
    const RoughSize size = rough_size(smooth.reflectance);
    FilmTableRequest finer = request;
    const auto rows = static_cast<int>(size.height == 1 ? 1 : 2 * size.height - 1);
    finer.size = std::array<int, 2>{smooth.reflectance.x.texels, rows};
    finer.measure_error = false;
    finer.progress = nullptr;
    return bake_film_tables(finer);
}

/// Mean of a row of a smooth table.
[[nodiscard]] inline spectral::Vec3 mean(const Table& table, std::size_t row,
                                         const std::vector<double>& weights)
{
    spectral::Vec3 sum{};
    const float* colours = &table.texels[3 * row * weights.size()];
    for (std::size_t i = 0; i < weights.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += weights[i] * static_cast<double>(colours[3 * i + c]);
    return sum;
}

struct RoughColour {
    FilmColour film;
    spectral::Vec3 further{};
};

/// The texels of all tables of a kind. A strip is a slice of one side.
struct RoughTexels {
    RoughSize size;
    std::size_t strips;
    std::vector<RoughColour> values;

    [[nodiscard]] const RoughColour& at(std::size_t strip, std::size_t x, std::size_t y) const
    {
        return values[(y * strips + strip) * size.width + x];
    }
};

/// As texels hold it. What rounding adds to the light that is reflected is taken from what passes,
/// so that a clear wall keeps all light to half a step.
/// @param reflected_share  of the light that passes, the albedo of the lobe that reflects
[[nodiscard]] inline RoughColour rounded(const RoughColour& exact, double reflected_share)
{
    RoughColour result{};
    const auto round = [](double value) { return rounded_texel(value, kRoughTexelBits); };
    for (std::size_t c = 0; c < 3; ++c) {
        const double R = exact.film.reflectance[c];
        result.film.reflectance[c] = round(R);
        const double added = reflected_share * (result.film.reflectance[c] - R);
        result.film.transmittance[c] = round(exact.film.transmittance[c] - added);
        result.further[c] = round(exact.further[c]);
    }
    return result;
}

template <class Colours>
RoughTexels fill(const Colours& colours, RoughSize size)
{
    constexpr std::size_t kStrips = Colours::kSides * kRoughSlices;
    const auto views = views_of_strips(colours, size);
    RoughTexels texels{.size = size,
                       .strips = kStrips,
                       .values = std::vector<RoughColour>(kStrips * size.width * size.height)};
    tbb::parallel_for(std::size_t{0}, kStrips * size.width, [&](std::size_t i) {
        const auto& view = (*views)[i];
        for (std::size_t y = 0; y < size.height; ++y)
            texels.values[y * kStrips * size.width + i] =
                rounded(colours.at(size.exact_row(2 * y), view), colours.reflected_share(view));
    });
    return texels;
}

struct RoughErrors {
    ErrorStatistics reflectance, transmittance;

    void add(const RoughErrors& other)
    {
        reflectance.add(other.reflectance);
        transmittance.add(other.transmittance);
    }
};

/// In the middle of the cells of one strip: between columns x and x + 1, and between the slice and
/// the one below it, which is the smooth table for the first.
template <class Colours>
RoughErrors strip_errors(const Colours& colours, const RoughTexels& texels, std::size_t strip,
                         std::size_t x, const ColourError& difference)
{
    const RoughSize size = texels.size;
    const auto slice = strip % kRoughSlices;
    const RoughPlace place{.column = (static_cast<double>(x) + 0.5) * size.step(),
                           .slice = static_cast<double>(slice) + 0.5,
                           .side = static_cast<int>(strip / kRoughSlices)};
    RoughErrors errors;
    const auto exact = colours.see(place);
    if (exact.cos_theta < kLeastCountedCosine) return errors;
    const auto smooth = colours.see({.column = place.column, .slice = 0.0, .side = place.side});
    const double share = slice_share(place.slice, static_cast<int>(slice));
    for (std::size_t y = 0; y < std::max<std::size_t>(1, size.height - 1); ++y) {
        const std::size_t up = std::min(y + 1, size.height - 1), row = size.exact_row(2 * y + 1);
        const auto in_strip = [&](std::size_t s) {
            return midpoint(midpoint(texels.at(s, x, y).film, texels.at(s, x + 1, y).film),
                            midpoint(texels.at(s, x, up).film, texels.at(s, x + 1, up).film));
        };
        const FilmColour below = slice == 0 ? colours.at(row, smooth).film : in_strip(strip - 1);
        const FilmColour read = colours.counted(mix(below, in_strip(strip), share), exact),
                         wanted = colours.counted(colours.at(row, exact).film, exact);
        errors.reflectance.add(difference(read.reflectance, wanted.reflectance));
        errors.transmittance.add(difference(read.transmittance, wanted.transmittance));
    }
    return errors;
}

template <class Colours>
RoughErrors measure(const Colours& colours, const RoughTexels& texels,
                    const ColourError& difference)
{
    const std::size_t cells = texels.size.width - 1;
    std::vector<RoughErrors> errors(texels.strips * cells);
    tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t i) {
        errors[i] = strip_errors(colours, texels, i / cells, i % cells, difference);
    });
    RoughErrors all;
    for (const RoughErrors& strip : errors) all.add(strip);
    return all;
}

/// Over the axes of a smooth table, `width` by `height` texels in all; none of them is there yet.
[[nodiscard]] inline Table rough_like(const Table& smooth, TableContent form, int width, int height,
                                      int sides)
{
    Table table{.role = {smooth.role.of, form, smooth.role.is_bare},
                .quantity = smooth.quantity,
                .x = smooth.x,
                .y = smooth.y,
                .channels = smooth.channels,
                .texels = {},
                .slices = kRoughSlices,
                .sides = sides};
    table.x.texels = width;
    table.y.texels = height;
    return table;
}

template <class Quantity>
Table make_rough_table(const Table& smooth, TableContent form, const RoughTexels& texels,
                       const ErrorStatistics& error, Quantity&& quantity)
{
    Table table = rough_like(smooth, form, static_cast<int>(texels.strips * texels.size.width),
                             static_cast<int>(texels.size.height),
                             static_cast<int>(texels.strips) / kRoughSlices);
    table.error_max = error.max;
    table.error_mean = error.count > 0 ? error.mean() : error.max;
    table.texel_bits = kRoughTexelBits;
    table.texels.reserve(3 * texels.values.size());
    for (const RoughColour& colour : texels.values)
        for (const double channel : quantity(colour))
            table.texels.push_back(static_cast<float>(channel));
    return table;
}

/// R and T of all strips, with what is lost between texels.
template <class Colours>
RoughTables rough_film_tables(const Colours& colours, const FilmTableRequest& request,
                              const FilmTables& smooth)
{
    const RoughTexels texels = fill(colours, rough_size(smooth.reflectance));
    const RoughErrors error =
        request.measure_error ? measure(colours, texels, ColourError(request.weights.to_xyz_d65))
                              : RoughErrors{{.max = kNotMeasured}, {.max = kNotMeasured}};
    RoughTables result{.reflectance = make_rough_table(
                           smooth.reflectance, TableContent::rough, texels, error.reflectance,
                           [](const RoughColour& at) { return at.film.reflectance; }),
                       .transmittance = {},
                       .further = {}};
    if (smooth.transmittance)
        result.transmittance = make_rough_table(
            *smooth.transmittance, TableContent::rough, texels, error.transmittance,
            [](const RoughColour& at) { return at.film.transmittance; });
    return result;
}

}  // namespace nacre::lut
