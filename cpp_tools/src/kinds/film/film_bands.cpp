// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/film_bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

#include "film/film_tables.h"
#include "film/solid_index.h"
#include "nacre/core/diagnostics.h"
#include "nacre/kinds/media_reader.h"

namespace nacre::kinds {
namespace film {
namespace {

/// What nodes read: neither fits nor what the lobe of clear glass brings along.
bool is_read(const TableRole& role)
{
    return role.content != TableContent::powers && role.of != TableOf::lobe_R &&
           role.of != TableOf::lobe_T;
}

spectral::ColourWeights weights(const BandPass& pass, spectral::ObserverId observer)
{
    constexpr spectral::Mat3 kNone{{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}}};
    return {.weight = pass,
            .space = "bands",
            .illuminant = "E",
            .observer = observer,
            .to_xyz_d65 = kNone};
}

/// Width and height of the smooth tables of one substrate.
std::optional<std::array<int, 2>> smooth_size(std::span<const TableLayout> layout, bool is_bare)
{
    const auto of_it = std::ranges::find(
        layout, TableRole{TableOf::R, TableContent::smooth, is_bare}, &TableLayout::role);
    if (of_it == layout.end()) return std::nullopt;
    return std::array{of_it->size.width, of_it->size.height};
}

/// All tables of one pass, of the sizes that the smooth ones of `layout` lead to.
std::vector<lut::Table> tables_of_pass(const MaterialTemplate& source,
                                       lut::FilmTableRequest request, std::optional<double> solid,
                                       std::span<const TableLayout> layout)
{
    const Interior below = film_of(source).interior();
    std::vector<lut::Table> tables;
    if ((request.size = smooth_size(layout, false)))
        tables = film_tables(request, below, solid, lut::kFloatBits);
    if ((request.size = smooth_size(layout, true)))
        std::ranges::move(bare_tables(request, below, solid, lut::kFloatBits),
                          std::back_inserter(tables));
    return tables;
}

lut::Table& table_of(std::vector<lut::Table>& tables, const TableLayout& wanted,
                     const MaterialTemplate& source)
{
    const auto found = std::ranges::find(tables, wanted.role, &lut::Table::role);
    if (found != tables.end() && found->x.texels == wanted.size.width &&
        found->y.texels == wanted.size.height)
        return *found;
    const std::string what =
        found == tables.end()
            ? fmt::format("such a film has no table {}; compile it anew", table_name(wanted.role))
            : fmt::format("table {} cannot be {} x {}; compile it anew", table_name(wanted.role),
                          wanted.size.width, wanted.size.height);
    throw InputError(Diagnostic{source.file, 0, {}, what});
}

}  // namespace
}  // namespace film

std::vector<lut::Table> band_tables(const MaterialTemplate& source, const CompileOptions& options,
                                    std::span<const BandPass> passes,
                                    std::span<const TableLayout> layout)
{
    lut::FilmTableRequest request = film_request(source, options);
    request.measure_error = false;
    request.precision = lut::Precision::single_precision;
    const std::optional<double> solid = film::solid_index(source, options.range);
    std::vector<lut::Table> stacked;
    film::with_file(source, [&] {
        for (const BandPass& pass : passes) {
            request.weights = film::weights(pass, options.observer);
            std::vector<lut::Table> tables = film::tables_of_pass(source, request, solid, layout);
            std::size_t at = 0;
            for (const TableLayout& wanted : layout) {
                if (!film::is_read(wanted.role)) continue;
                lut::Table& table = film::table_of(tables, wanted, source);
                if (at == stacked.size()) {
                    stacked.push_back(std::move(table));
                } else {
                    std::ranges::copy(table.texels, std::back_inserter(stacked[at].texels));
                    stacked[at].y.texels += table.y.texels;
                }
                ++at;
            }
        }
    });
    for (lut::Table& table : stacked)
        table.error_max = table.error_mean = std::numeric_limits<double>::quiet_NaN();
    return stacked;
}

double optical_thickness_nm(const MaterialTemplate& source, const CompileOptions& options)
{
    const lut::FilmTableRequest request = film_request(source, options);
    const auto d_line = static_cast<std::size_t>(std::lround(kLineD)) - spectral::kFirstNm;
    double sum = 0.0;
    for (std::size_t i = 0; i < request.stack.layers.size(); ++i) {
        const lut::SampledLayer& layer = request.stack.layers[i];
        if (!layer.coherent) continue;
        double thickness_nm = layer.thickness_nm;
        if (request.variation && !request.variation->layer) thickness_nm *= request.variation->max;
        if (request.variation && request.variation->layer == i)
            thickness_nm = request.variation->max;
        sum += layer.n[d_line].real() * thickness_nm;
    }
    return sum;
}

std::vector<spectral::Sampled> film_fringes(const MaterialTemplate& source,
                                            const CompileOptions& options, int count,
                                            double cos_theta)
{
    const std::optional<lut::Variation> variation = film_request(source, options).variation;
    const auto at = [&](double value) {
        return film_spectrum(source, options, cos_theta, value).reflectance;
    };
    std::vector<spectral::Sampled> films;
    if (!variation) return std::vector(static_cast<std::size_t>(count), at(0.0));
    films.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        films.push_back(at(variation->max * (0.9 + 0.1 * i / (count - 1))));
    return films;
}

}  // namespace nacre::kinds
