// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/preview.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "nacre/lut/film_table.h"
#include "nacre/optics/microfacet.h"
#include "rough/rough_glass.h"
#include "rough/rough_texels.h"

namespace nacre::lut {
namespace {

using spectral::Vec3;

constexpr int kColumns = 33;
// Tables are read linearly, these rows are enlarged by cubics: fewer do. Each row of a factor on
// all layers is a stack of its own, and closed forms are computed row by row; of one layer that
// varies rows are cheap.
constexpr int kScaledRows = 41, kRowsPerClosedFormRow = 4, kRowsPerRow = 2;
constexpr int kInnerRows = 25;

/// Four neighbours and their weights: Catmull and Rom, with the ends continued straight.
struct Cubic {
    std::array<std::size_t, 4> at;
    std::array<float, 4> weight;

    Cubic(double x, int count)
    {
        const auto last = static_cast<std::ptrdiff_t>(count - 1);
        const auto low =
            std::min(static_cast<std::ptrdiff_t>(x), std::max<std::ptrdiff_t>(last - 1, 0));
        const double t = x - static_cast<double>(low);
        std::array<double, 4> w{0.5 * t * (t * (2.0 - t) - 1.0),
                                0.5 * (t * t * (3.0 * t - 5.0) + 2.0),
                                0.5 * t * (t * (4.0 - 3.0 * t) + 1.0), 0.5 * t * t * (t - 1.0)};
        if (low == 0) shift(w, 0, 1, 2);
        if (low + 2 > last) shift(w, 3, 2, 1);
        for (std::ptrdiff_t k = 0; k < 4; ++k) {
            const auto i = static_cast<std::size_t>(k);
            at[i] = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(low - 1 + k, 0, last));
            weight[i] = static_cast<float>(w[i]);
        }
    }

private:
    /// The neighbour that is missing is 2 a − b.
    static void shift(std::array<double, 4>& w, std::size_t missing, std::size_t a, std::size_t b)
    {
        w[a] += 2.0 * w[missing];
        w[b] -= w[missing];
        w[missing] = 0.0;
    }
};

std::vector<Cubic> cubics(int from, int to)
{
    std::vector<Cubic> result;
    result.reserve(static_cast<std::size_t>(to));
    for (int i = 0; i < to; ++i)
        result.emplace_back(to == 1 ? 0.0 : static_cast<double>(i) * (from - 1) / (to - 1), from);
    return result;
}

void enlarge(Table& table, TexelSize size)
{
    const auto from = static_cast<std::size_t>(table.x.texels);
    const auto width = static_cast<std::size_t>(size.width);
    const std::vector<Cubic> across = cubics(table.x.texels, size.width),
                             along = cubics(table.y.texels, size.height);
    std::vector<float> texels(3 * width * static_cast<std::size_t>(size.height));
    tbb::parallel_for(std::size_t{0}, along.size(), [&](std::size_t y) {
        std::vector<float> row(3 * from);
        for (std::size_t k = 0; k < 4; ++k) {
            const float* source = &table.texels[3 * from * along[y].at[k]];
            for (std::size_t i = 0; i < row.size(); ++i) row[i] += along[y].weight[k] * source[i];
        }
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t c = 0; c < 3; ++c) {
                float sum = 0.0F;
                for (std::size_t k = 0; k < 4; ++k)
                    sum += across[x].weight[k] * row[3 * across[x].at[k] + c];
                texels[3 * (y * width + x) + c] = sum;
            }
    });
    table.texels = std::move(texels);
    table.x.texels = size.width;
    table.y.texels = size.height;
}

/// The facets that one direction sees.
struct View {
    std::vector<double> weights;
    double albedo;
};

/// Of all slices and columns of a rough table; they do not depend on the film, and are kept.
struct Views {
    std::vector<View> at;  ///< [slice][column]
    std::array<double, kRoughSlices> mean_albedo;

    explicit Views(std::size_t width) : at(kRoughSlices * width), mean_albedo{}
    {
        const double step = 1.0 / static_cast<double>(width - 1);
        tbb::parallel_for(std::size_t{0}, at.size(), [&](std::size_t i) {
            const std::size_t slice = i / width;
            const double roughness = static_cast<double>(slice + 1) / kRoughSlices;
            View& view = at[i];
            view.weights.resize(kColumns);
            view.albedo = optics::facet_weights(static_cast<double>(i % width) * step,
                                                roughness * roughness, view.weights);
        });
        for (std::size_t slice = 0; slice < kRoughSlices; ++slice)
            for (std::size_t x = 0; x < width; ++x) {
                const double end = x == width - 1 ? 0.5 : 1.0;
                mean_albedo[slice] +=
                    2.0 * static_cast<double>(x) * step * step * end * at[slice * width + x].albedo;
            }
    }

    static const Views& of(std::size_t width)
    {
        static std::mutex mutex;
        static std::map<std::size_t, Views> known;
        const std::scoped_lock lock(mutex);
        return known.try_emplace(width, width).first->second;
    }
};

/// Of the last border of glass that was asked for, which no film changes; shared with who reads it.
std::shared_ptr<const std::vector<optics::GlassFacets>> glass_views(double index, std::size_t width)
{
    using Known = std::shared_ptr<const std::vector<optics::GlassFacets>>;
    static std::mutex mutex;
    static std::map<std::size_t, std::pair<double, Known>> known;
    const std::scoped_lock lock(mutex);
    auto& [of_index, views] = known[width];
    if (!views || of_index != index) {
        of_index = index;
        views = std::make_shared<const std::vector<optics::GlassFacets>>(
            all_glass_facets(index, width, kColumns));
    }
    return views;
}

/// One smooth table, resampled to the columns of the views.
class Facets {
public:
    Facets(const Table& table, int rows) : table_(table) { enlarge(table_, {kColumns, rows}); }

    [[nodiscard]] const Table& table() const { return table_; }
    [[nodiscard]] Vec3 mean(std::size_t row, const View& view) const
    {
        return lut::mean(table_, row, view.weights);
    }
    /// Over the hemisphere, weighted by the cosine.
    [[nodiscard]] Vec3 hemispherical(std::size_t row) const
    {
        View view{.weights = std::vector<double>(kColumns), .albedo = 1.0};
        constexpr double kStep = 1.0 / (kColumns - 1);
        for (std::size_t i = 0; i < kColumns; ++i)
            view.weights[i] =
                2.0 * static_cast<double>(i) * kStep * kStep * (i == kColumns - 1 ? 0.5 : 1.0);
        return mean(row, view);
    }

private:
    Table table_;
};

/// What leaves after two and more bounces, of the light that does not leave after one.
double further_share(double mean_reflectance, double mean_albedo)
{
    const double F = std::clamp(mean_reflectance, 0.0, 1.0);
    return F * F * mean_albedo / (1.0 - F * (1.0 - mean_albedo));
}

Table rough_preview(const Table& smooth, TexelSize size, int sides)
{
    Table table = rough_like(smooth, TableContent::rough, size.width, size.height, sides);
    table.error_max = table.error_mean = kNotMeasured;
    table.texels.resize(3 * static_cast<std::size_t>(size.width) *
                        static_cast<std::size_t>(size.height));
    return table;
}

/// Both tables; `row(y)` gives what gives the colour of each texel of that row.
template <class Row>
RoughTables rough_tables(const FilmTables& smooth, TexelSize size, int sides, Row&& row)
{
    RoughTables result{.reflectance = rough_preview(smooth.reflectance, size, sides),
                       .transmittance = {},
                       .further = {}};
    if (smooth.transmittance)
        result.transmittance = rough_preview(*smooth.transmittance, size, sides);
    const auto width = static_cast<std::size_t>(size.width);
    tbb::parallel_for(std::size_t{0}, static_cast<std::size_t>(size.height), [&](std::size_t y) {
        const auto colour_at = row(y);
        for (std::size_t i = 0; i < width; ++i) {
            const FilmColour colour = colour_at(i);
            const std::size_t texel = 3 * (y * width + i);
            for (std::size_t c = 0; c < 3; ++c) {
                result.reflectance.texels[texel + c] = static_cast<float>(colour.reflectance[c]);
                if (result.transmittance)
                    result.transmittance->texels[texel + c] =
                        static_cast<float>(colour.transmittance[c]);
            }
        }
    });
    return result;
}

/// One row of both rough tables.
class RoughRow {
public:
    RoughRow(const Facets& reflectance, const Facets* transmittance, std::size_t row)
        : reflectance_(reflectance),
          transmittance_(transmittance),
          row_(row),
          mean_R_(reflectance.hemispherical(row))
    {
        if (!transmittance) return;
        const Vec3 mean_T = transmittance->hemispherical(row);
        for (std::size_t c = 0; c < 3; ++c) {
            const double rest = 1.0 - mean_R_[c];
            passing_[c] = std::abs(rest) < 1e-3 ? 1.0 : std::clamp(mean_T[c] / rest, 0.0, 1.0);
        }
    }

    [[nodiscard]] FilmColour at(const View& view, double mean_albedo) const
    {
        FilmColour result{.reflectance = reflectance_.mean(row_, view), .transmittance = {}};
        if (transmittance_) result.transmittance = transmittance_->mean(row_, view);
        for (std::size_t c = 0; c < 3; ++c) {
            const double lost = 1.0 - view.albedo;
            const double further = lost * further_share(mean_R_[c], mean_albedo);
            result.transmittance[c] += passing_[c] * (result.reflectance[c] * lost - further);
            result.reflectance[c] += further / view.albedo;
        }
        return result;
    }

private:
    const Facets& reflectance_;
    const Facets* transmittance_;
    std::size_t row_;
    Vec3 mean_R_, passing_{};
};

}  // namespace

namespace {

int coarse_rows(const FilmTableRequest& request, int height)
{
    if (!request.variation) return height;
    const bool scale = !request.variation->layer;
    const int step = request.technique ? kRowsPerClosedFormRow : kRowsPerRow;
    const int rows = scale ? kScaledRows : std::max(kScaledRows, (height + step - 1) / step);
    return std::min(rows, height);
}

}  // namespace

FilmTables preview_film_tables(const FilmTableRequest& request, TexelSize size)
{
    FilmTableRequest coarse = request;
    coarse.size =
        std::array<int, 2>{std::min(kColumns, size.width), coarse_rows(request, size.height)};
    coarse.measure_error = false;
    coarse.precision = Precision::single_precision;
    coarse.progress = nullptr;
    FilmTables tables = bake_film_tables(coarse);
    enlarge(tables.reflectance, size);
    if (tables.transmittance) enlarge(*tables.transmittance, size);
    return tables;
}

RoughTables preview_rough_tables(const FilmTables& smooth, TexelSize size)
{
    const Views& views = Views::of(static_cast<std::size_t>(size.width) / kRoughSlices);
    const std::size_t width = views.at.size() / kRoughSlices;
    const Facets R(smooth.reflectance, size.height);
    std::optional<Facets> T;
    if (smooth.transmittance) T.emplace(*smooth.transmittance, size.height);
    return rough_tables(smooth, size, 1, [&](std::size_t y) {
        return [&, row = RoughRow(R, T ? &*T : nullptr, y)](std::size_t i) {
            return row.at(views.at[i], views.mean_albedo[i / width]);
        };
    });
}

RoughTables preview_rough_glass_tables(const FilmTables& smooth, double index, TexelSize size)
{
    constexpr int kStrips = kGlassSides * kRoughSlices;
    const auto facets = glass_views(index, static_cast<std::size_t>(size.width / kStrips));
    const Facets R(smooth.reflectance, size.height), T(*smooth.transmittance, size.height);
    return rough_tables(smooth, size, kGlassSides, [&](std::size_t y) {
        return [&, y](std::size_t i) {
            return glass_colour(R.table(), T.table(), y, (*facets)[i], {1.0, 1.0, 1.0});
        };
    });
}

InnerTables preview_inner_tables(const FilmTableRequest& request, int height)
{
    InnerTables tables = bake_inner_tables(request, std::min(kInnerRows, height));
    for (Table* table : {&tables.reflectance, &tables.transmittance}) {
        enlarge(*table, {1, height});
        table->error_max = table->error_mean = kNotMeasured;
    }
    return tables;
}

}  // namespace nacre::lut
