// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/rough_glass_tables.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "rough/rough_glass.h"
#include "rough/rough_texels.h"

namespace nacre::lut {
namespace {

using spectral::Vec3;

/// Colours of a film at any view of the glass.
class GlassColours {
public:
    static constexpr int kSides = kGlassSides;

    struct View {
        double cos_theta = 1.0;
        optics::GlassFacets facets;
    };

    GlassColours(double index, FilmTables smooth, const Vec3& white)
        : index_(index), smooth_(std::move(smooth)), white_(white)
    {}

    [[nodiscard]] std::pair<double, std::size_t> surface() const
    {
        return {index_, static_cast<std::size_t>(smooth_.reflectance.x.texels)};
    }

    [[nodiscard]] View see(const RoughPlace& place) const
    {
        const optics::GlassView view =
            glass_view(place.column, place.slice / kRoughSlices, index_, place.side);
        return {view.cos_theta,
                optics::glass_facets(view, static_cast<std::size_t>(smooth_.reflectance.x.texels))};
    }

    [[nodiscard]] RoughColour at(std::size_t row, const View& view) const
    {
        return {.film = glass_colour(smooth_.reflectance, *smooth_.transmittance, row, view.facets,
                                     white_),
                .further = {}};
    }

    /// Both lobes share the light, and what each gains or loses.
    [[nodiscard]] static double reflected_share(const View&) { return 0.0; }

    /// What leaves: where all facets reflect totally, no tint matters.
    [[nodiscard]] static FilmColour counted(FilmColour tints, const View& view)
    {
        for (double& channel : tints.reflectance) channel *= view.facets.mirror;
        for (double& channel : tints.transmittance) channel *= view.facets.window;
        return tints;
    }

private:
    double index_;
    FilmTables smooth_;
    Vec3 white_;
};

/// F is linear within 2e-4 between so many cosines, up to an index of 4.
constexpr int kSmoothLobeTexels = 257;

/// `share` of each of the facets, in grey.
template <class Share>
Table lobe_table(TableRole role, const std::vector<optics::GlassFacets>& facets, Share&& share)
{
    Table table{.role = role,
                .quantity = "lobe_share",
                .x = {"cos_theta", "1", 0.0, 1.0, static_cast<int>(facets.size())},
                .y = {"thickness_nm", "nm", 0.0, 0.0, 1},
                .channels = {"R", "G", "B"},
                .texels = {},
                .error_unit = "1"};
    for (const optics::GlassFacets& seen : facets)
        table.texels.insert(table.texels.end(), 3, static_cast<float>(share(seen)));
    return table;
}

std::vector<optics::GlassFacets> flat_facets(double index)
{
    std::vector<optics::GlassFacets> result;
    result.reserve(kSmoothLobeTexels);
    for (int i = 0; i < kSmoothLobeTexels; ++i)
        result.push_back(optics::glass_facets(
            {.cos_theta = i / (kSmoothLobeTexels - 1.0), .alpha = 0.0, .index = index}, 2));
    return result;
}

}  // namespace

FilmColour glass_colour(const Table& reflectance, const Table& transmittance, std::size_t row,
                        const optics::GlassFacets& facets, const Vec3& white)
{
    const Vec3 met_R = mean(reflectance, row, facets.met),
               met_T = mean(transmittance, row, facets.met);
    FilmColour result{.reflectance = mean(reflectance, row, facets.reflected),
                      .transmittance = mean(transmittance, row, facets.passed)};
    for (std::size_t c = 0; c < 3; ++c) {
        double &R = result.reflectance[c], &T = result.transmittance[c];
        const double going_on = (met_R[c] + met_T[c] - R - T) / white[c];
        const double rounds = 1.0 / (1.0 - std::clamp(going_on, 0.0, 1.0 - 1e-3));
        R *= rounds / facets.mirror;
        T *= facets.window > 0.0 ? rounds / facets.window : 0.0;
    }
    return result;
}

std::vector<optics::GlassFacets> all_glass_facets(double index, std::size_t width,
                                                  std::size_t columns)
{
    constexpr std::size_t kStrips = std::size_t{kGlassSides} * std::size_t{kRoughSlices};
    std::vector<optics::GlassFacets> result(kStrips * width);
    tbb::parallel_for(std::size_t{0}, result.size(), [&](std::size_t i) {
        const std::size_t strip = i / width;
        const double x = static_cast<double>(i % width) / static_cast<double>(width - 1);
        const double roughness = static_cast<double>(strip % kRoughSlices + 1) / kRoughSlices;
        result[i] = optics::glass_facets(
            glass_view(x, roughness, index, static_cast<int>(strip / kRoughSlices)), columns);
    });
    return result;
}

optics::GlassView glass_view(double x, double roughness, double index, int side)
{
    optics::GlassView view{
        .cos_theta = x, .alpha = roughness * roughness, .index = index, .inside = side == 1};
    if (!view.inside) return view;
    const double t = 2.0 * x - 1.0, n_squared = index * index;
    // 1 − n² sin²θ: the squared cosine in the ambient, or where it is negative the decay.
    const double along = t >= 0.0 ? t * t : -t * t * std::max(0.0, n_squared - 1.0);
    view.cos_theta = std::sqrt(std::max(0.0, 1.0 - (1.0 - along) / n_squared));
    return view;
}

RoughTables bake_rough_glass_tables(const FilmTableRequest& request, const FilmTables& smooth,
                                    double index)
{
    const GlassColours colours(index, on_half_rows(request, smooth), request.weights.white());
    return rough_film_tables(colours, request, smooth);
}

std::vector<Table> bake_lobe_tables(double index, int width)
{
    const auto reflected = [](const optics::GlassFacets& seen) {
        return seen.clear_mirror / seen.mirror;
    };
    const auto passed = [](const optics::GlassFacets& seen) {
        return seen.window > 0.0 ? seen.clear_window / seen.window : 0.0;
    };
    const std::vector<optics::GlassFacets> flat = flat_facets(index);
    const auto rough = all_glass_facets(index, static_cast<std::size_t>(width), 2);
    std::vector<Table> tables{lobe_table({TableOf::lobe_R}, flat, reflected),
                              lobe_table({TableOf::lobe_R, TableContent::rough}, rough, reflected),
                              lobe_table({TableOf::lobe_T}, flat, passed),
                              lobe_table({TableOf::lobe_T, TableContent::rough}, rough, passed)};
    for (const std::size_t i : {1U, 3U}) {
        tables[i].slices = kRoughSlices;
        tables[i].sides = kGlassSides;
    }
    return tables;
}

}  // namespace nacre::lut
