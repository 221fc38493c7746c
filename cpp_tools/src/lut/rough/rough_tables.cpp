// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/rough_tables.h"

#include <algorithm>
#include <cmath>

#include "nacre/optics/microfacet.h"
#include "rough/further_bounces.h"
#include "rough/rough_texels.h"

namespace nacre::lut {
namespace {

using spectral::Vec3;

/// The facets seen at one angle and roughness.
struct SeenFacets {
    std::vector<double> weights;
    double albedo = 1.0, cos_theta = 1.0, slice = 0.0;

    SeenFacets() = default;
    SeenFacets(double at, double slices, std::size_t columns)
        : weights(columns), cos_theta(at), slice(slices)
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
Vec3 passing(const FilmTables& smooth, std::size_t row, const Vec3& white)
{
    const Vec3 R = hemispherical_mean(smooth.reflectance, row);
    const Vec3 T = hemispherical_mean(*smooth.transmittance, row);
    Vec3 result{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double rest = white[c] - R[c];
        result[c] =
            std::abs(rest) < 1e-3 * std::abs(white[c]) ? 1.0 : std::clamp(T[c] / rest, 0.0, 1.0);
    }
    return result;
}

/// Rough colours anywhere on the rows of `smooth`, which has them half-way between those of the
/// rough table too.
class RoughColours {
public:
    static constexpr int kSides = 1;
    using View = SeenFacets;

    RoughColours(const FilmTableRequest& request, FilmTables smooth)
        : smooth_(std::move(smooth)),
          further_(request, static_cast<std::size_t>(smooth_.reflectance.y.texels))
    {
        if (!smooth_.transmittance) return;
        const auto rows = static_cast<std::size_t>(smooth_.reflectance.y.texels);
        const Vec3 white = request.weights.white();
        for (std::size_t row = 0; row < rows; ++row)
            passing_.push_back(passing(smooth_, row, white));
    }

    [[nodiscard]] std::pair<double, std::size_t> surface() const
    {
        return {1.0, static_cast<std::size_t>(smooth_.reflectance.x.texels)};
    }

    [[nodiscard]] SeenFacets see(const RoughPlace& place) const
    {
        return {place.column, place.slice, static_cast<std::size_t>(smooth_.reflectance.x.texels)};
    }

    [[nodiscard]] RoughColour at(std::size_t row, const SeenFacets& view) const
    {
        RoughColour result{};
        const Vec3 R = mean(smooth_.reflectance, row, view.weights);
        result.further = further_.read(view.slice, view.cos_theta, row);
        for (std::size_t c = 0; c < 3; ++c) {
            result.further[c] /= view.albedo;
            result.film.reflectance[c] = R[c] + result.further[c];
        }
        if (smooth_.transmittance)
            result.film.transmittance =
                transmitted(row, R, mean(*smooth_.transmittance, row, view.weights), result.further,
                            view.albedo);
        return result;
    }

    [[nodiscard]] static double reflected_share(const SeenFacets& view) { return view.albedo; }

    [[nodiscard]] static FilmColour counted(const FilmColour& tints, const SeenFacets&)
    {
        return tints;
    }

private:
    FilmTables smooth_;
    FurtherBounces further_;
    std::vector<Vec3> passing_;  ///< of each row, see passing()

    /// Light that was reflected and did not get out falls on other facets, at any angle.
    [[nodiscard]] Vec3 transmitted(std::size_t row, const Vec3& R, const Vec3& T,
                                   const Vec3& further, double albedo) const
    {
        Vec3 result = T;
        for (std::size_t c = 0; c < 3; ++c)
            result[c] += passing_[row][c] * (R[c] * (1.0 - albedo) - further[c] * albedo);
        return result;
    }
};

Table further_table(const Table& smooth, const RoughColours& colours, RoughSize size)
{
    const RoughSize narrow{kFurtherColumns, size.height};
    return make_rough_table(smooth, TableContent::further, fill(colours, narrow), {},
                            [](const RoughColour& at) { return at.further; });
}

}  // namespace

RoughTables bake_rough_tables(const FilmTableRequest& request, const FilmTables& smooth)
{
    const RoughColours colours(request, on_half_rows(request, smooth));
    RoughTables result = rough_film_tables(colours, request, smooth);
    result.further = further_table(smooth.reflectance, colours, rough_size(smooth.reflectance));
    return result;
}

}  // namespace nacre::lut
