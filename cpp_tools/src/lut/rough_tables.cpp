// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/rough_tables.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "colour_error.h"
#include "further_bounces.h"
#include "nacre/optics/microfacet.h"
#include "sizing.h"

namespace nacre::lut {
namespace {

using spectral::Vec3;

constexpr std::size_t kSlices = kRoughSlices;

/// Of one slice.
struct RoughSize {
    std::size_t width, height;
};

/// Means over facets are smoother over the angle than what they are means of, and a lobe's colour
/// needs not be as exact as a mirror's.
RoughSize rough_size(const Table& smooth)
{
    const auto share = [](int texels, int parts) {
        return static_cast<std::size_t>((texels + parts - 1) / parts);
    };
    constexpr std::size_t kFewestTexels = 17;
    return {std::max(kFewestTexels, share(smooth.x.texels, 4)),
            smooth.y.texels == 1 ? 1 : std::max(kFewestTexels, share(smooth.y.texels, 3))};
}

/// The facets seen at one angle and roughness.
struct SeenFacets {
    std::vector<double> weights;
    double albedo, cos_theta, slice;

    SeenFacets(double at, double slices, std::size_t columns)
        : weights(columns), albedo(1.0), cos_theta(at), slice(slices)
    {
        const double roughness = slice / kRoughSlices;
        if (slice > 0.0)
            albedo = optics::facet_weights(cos_theta, roughness * roughness, weights);
        else
            interpolate();
    }

private:
    void interpolate()
    {
        const double x = cos_theta * static_cast<double>(weights.size() - 1);
        const std::size_t i = std::min(static_cast<std::size_t>(x), weights.size() - 2);
        weights[i + 1] = x - static_cast<double>(i);
        weights[i] = 1.0 - weights[i + 1];
    }
};

/// What a view sees of a row of a smooth table.
Vec3 mean(const Table& table, std::size_t row, const SeenFacets& view)
{
    Vec3 sum{};
    const float* colours = &table.texels[3 * row * view.weights.size()];
    for (std::size_t i = 0; i < view.weights.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += view.weights[i] * static_cast<double>(colours[3 * i + c]);
    return sum;
}

/// Mean of a row over the hemisphere, weighted by the cosine.
Vec3 hemispherical_mean(const Table& table, std::size_t row)
{
    const auto last = static_cast<std::size_t>(table.x.texels - 1);
    const float* colours = &table.texels[3 * row * (last + 1)];
    const double h = 1.0 / static_cast<double>(last);
    Vec3 sum{};
    for (std::size_t i = 0; i <= last; ++i) {
        const double weight = 2.0 * static_cast<double>(i) * h * h * (i == last ? 0.5 : 1.0);
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] += weight * static_cast<double>(colours[3 * i + c]);
    }
    return sum;
}

/// The share that a film passes of diffuse light that it does not reflect: 1 where nothing absorbs.
Vec3 passing(const FilmTables& smooth, std::size_t row)
{
    const Vec3 R = hemispherical_mean(smooth.reflectance, row);
    const Vec3 T = hemispherical_mean(*smooth.transmittance, row);
    Vec3 result{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double rest = 1.0 - R[c];
        result[c] = std::abs(rest) < 1e-3 ? 1.0 : std::clamp(T[c] / rest, 0.0, 1.0);
    }
    return result;
}

struct RoughColour {
    FilmColour film;
    Vec3 further{};
};

/// Rough colours anywhere on the rows of `smooth`, which has them half-way between those of the
/// rough table too.
class RoughColours {
public:
    RoughColours(const FilmTableRequest& request, FilmTables smooth, Bounces bounces)
        : smooth_(std::move(smooth))
    {
        if (bounces == Bounces::one) return;
        const auto rows = static_cast<std::size_t>(smooth_.reflectance.y.texels);
        further_.emplace(request, rows);
        if (!smooth_.transmittance) return;
        for (std::size_t row = 0; row < rows; ++row) passing_.push_back(passing(smooth_, row));
    }

    [[nodiscard]] std::size_t columns() const
    {
        return static_cast<std::size_t>(smooth_.reflectance.x.texels);
    }

    /// Of a lobe whose colour is 1.
    [[nodiscard]] double reflected_share(const SeenFacets& view) const
    {
        return further_ ? view.albedo : 1.0;
    }

    [[nodiscard]] RoughColour at(std::size_t row, const SeenFacets& view) const
    {
        RoughColour result{};
        const Vec3 R = mean(smooth_.reflectance, row, view);
        if (further_) result.further = further_->read(view.slice, view.cos_theta, row);
        for (std::size_t c = 0; c < 3; ++c) {
            result.further[c] /= view.albedo;
            result.film.reflectance[c] = R[c] + result.further[c];
        }
        if (smooth_.transmittance)
            result.film.transmittance = transmitted(row, R, mean(*smooth_.transmittance, row, view),
                                                    result.further, view.albedo);
        return result;
    }

private:
    FilmTables smooth_;
    std::optional<FurtherBounces> further_;

    std::vector<Vec3> passing_;  ///< of each row, see passing()

    /// Light that was reflected and did not get out falls on other facets, at any angle.
    [[nodiscard]] Vec3 transmitted(std::size_t row, const Vec3& R, const Vec3& T,
                                   const Vec3& further, double albedo) const
    {
        if (!further_) return T;
        Vec3 result = T;
        for (std::size_t c = 0; c < 3; ++c)
            result[c] += passing_[row][c] * (R[c] * (1.0 - albedo) - further[c] * albedo);
        return result;
    }
};

/// The texels of all three tables.
struct Texels {
    RoughSize size;
    std::vector<RoughColour> values;

    [[nodiscard]] const RoughColour& at(std::size_t slice, std::size_t x, std::size_t y) const
    {
        return values[(y * kSlices + slice) * size.width + x];
    }
};

double step_of(RoughSize size)
{
    return 1.0 / static_cast<double>(size.width - 1);
}

std::size_t exact_row(RoughSize size, std::size_t half_rows)
{
    return size.height == 1 ? 0 : half_rows;
}

/// As texels hold it. What rounding adds to the light that is reflected is taken from what passes,
/// so that a clear wall keeps all light to half a step.
RoughColour rounded(const RoughColour& exact, double reflected_share)
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

Texels fill(const RoughColours& colours, RoughSize size)
{
    Texels texels{.size = size,
                  .values = std::vector<RoughColour>(kSlices * size.width * size.height)};
    tbb::parallel_for(std::size_t{0}, kSlices * size.width, [&](std::size_t i) {
        const std::size_t slice = i / size.width, x = i % size.width;
        const SeenFacets view(static_cast<double>(x) * step_of(size),
                              static_cast<double>(slice + 1), colours.columns());
        for (std::size_t y = 0; y < size.height; ++y)
            texels.values[y * kSlices * size.width + i] =
                rounded(colours.at(exact_row(size, 2 * y), view), colours.reflected_share(view));
    });
    return texels;
}

struct Errors {
    ErrorStatistics reflectance, transmittance;

    void add(const Errors& other)
    {
        reflectance.add(other.reflectance);
        transmittance.add(other.transmittance);
    }
};

/// In the middle of the cells of one strip: between columns x and x + 1, and between the slice and
/// the one below it, which is the smooth table for the first.
Errors strip_errors(const RoughColours& colours, const Texels& texels, std::size_t slice,
                    std::size_t x, const ColourError& difference)
{
    const RoughSize size = texels.size;
    const double cos_theta = (static_cast<double>(x) + 0.5) * step_of(size);
    Errors errors;
    if (cos_theta < kLeastCountedCosine) return errors;
    const SeenFacets exact(cos_theta, static_cast<double>(slice) + 0.5, colours.columns());
    const SeenFacets mirror(cos_theta, 0.0, colours.columns());
    const double share = slice_share(static_cast<double>(slice) + 0.5, static_cast<int>(slice));
    for (std::size_t y = 0; y < std::max<std::size_t>(1, size.height - 1); ++y) {
        const std::size_t up = std::min(y + 1, size.height - 1), row = exact_row(size, 2 * y + 1);
        const auto in_slice = [&](std::size_t s) {
            return midpoint(midpoint(texels.at(s, x, y).film, texels.at(s, x + 1, y).film),
                            midpoint(texels.at(s, x, up).film, texels.at(s, x + 1, up).film));
        };
        const FilmColour below = slice == 0 ? colours.at(row, mirror).film : in_slice(slice - 1);
        const FilmColour read = mix(below, in_slice(slice), share),
                         wanted = colours.at(row, exact).film;
        errors.reflectance.add(difference(read.reflectance, wanted.reflectance));
        errors.transmittance.add(difference(read.transmittance, wanted.transmittance));
    }
    return errors;
}

Errors measure(const RoughColours& colours, const Texels& texels, const ColourError& difference)
{
    const std::size_t strips = texels.size.width - 1;
    std::vector<Errors> errors(kSlices * strips);
    tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t i) {
        errors[i] = strip_errors(colours, texels, i / strips, i % strips, difference);
    });
    Errors all;
    for (const Errors& strip : errors) all.add(strip);
    return all;
}

template <class Quantity>
Table make_table(const Table& smooth, const std::string& name, const Texels& texels,
                 const ErrorStatistics& error, Quantity&& quantity)
{
    Table table{.name = name,
                .quantity = smooth.quantity,
                .x = smooth.x,
                .y = smooth.y,
                .channels = smooth.channels,
                .texels = {},
                .error_max = error.max,
                .error_mean = error.mean(),
                .slices = kRoughSlices,
                .texel_bits = kRoughTexelBits};
    table.x.texels = static_cast<int>(kSlices * texels.size.width);
    table.y.texels = static_cast<int>(texels.size.height);
    table.texels.reserve(3 * texels.values.size());
    for (const RoughColour& colour : texels.values)
        for (const double channel : quantity(colour))
            table.texels.push_back(static_cast<float>(channel));
    return table;
}

Table further_table(const Table& smooth, const RoughColours& colours, RoughSize size)
{
    const RoughSize narrow{kFurtherColumns, size.height};
    const Texels texels = fill(colours, narrow);
    return make_table(smooth, "R_further", texels, {},
                      [](const RoughColour& at) { return at.further; });
}

}  // namespace

double slice_share(double slice, int low) noexcept
{
    const auto alpha_squared = [](double at) { return at * at * at * at; };
    return (alpha_squared(slice) - alpha_squared(low)) /
           (alpha_squared(low + 1.0) - alpha_squared(low));
}

RoughTables bake_rough_tables(const FilmTableRequest& request, const FilmTables& smooth,
                              Bounces bounces)
{
    const RoughSize size = rough_size(smooth.reflectance);
    FilmTableRequest finer = request;
    const auto rows = static_cast<int>(size.height == 1 ? 1 : 2 * size.height - 1);
    finer.size = std::array<int, 2>{smooth.reflectance.x.texels, rows};
    finer.measure_error = false;
    finer.progress = nullptr;
    const RoughColours colours(request, bake_film_tables(finer), bounces);
    const Texels texels = fill(colours, size);
    const Errors error = measure(colours, texels, ColourError(request.weights.to_xyz_d65));

    const Table& like = smooth.reflectance;
    RoughTables result{
        .reflectance = make_table(like, "R_rough", texels, error.reflectance,
                                  [](const RoughColour& at) { return at.film.reflectance; }),
        .transmittance = {},
        .further = {}};
    if (smooth.transmittance)
        result.transmittance =
            make_table(*smooth.transmittance, "T_rough", texels, error.transmittance,
                       [](const RoughColour& at) { return at.film.transmittance; });
    if (bounces == Bounces::all) result.further = further_table(like, colours, size);
    return result;
}

}  // namespace nacre::lut
