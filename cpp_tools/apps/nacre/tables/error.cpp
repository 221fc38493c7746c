// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "tables/error.h"

#include <algorithm>
#include <cmath>

#include <tbb/parallel_for.h>

#include "colour/target.h"
#include "nacre/lut/film_table.h"

namespace nacre::tool {
namespace {

using spectral::Vec3;

/// Enough probes to meet every fringe of a table, few enough for a table of 4096 x 4096.
constexpr int kMaxProbes = 512;

/// Positions of the probes along an axis, in texels: between neighbours, evenly chosen.
std::vector<double> probe_positions(int texels)
{
    if (texels == 1) return {0.0};
    const int cells = texels - 1, count = std::min(cells, kMaxProbes);
    std::vector<double> positions;
    positions.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const std::int64_t cell = std::int64_t{i} * cells / count;
        positions.push_back(static_cast<double>(cell) + 0.5);
    }
    return positions;
}

double value_at(const lut::Axis& axis, double texel)
{
    return axis.texels == 1 ? axis.min
                            : axis.min + (axis.max - axis.min) * texel / (axis.texels - 1);
}

Vec3 bilinear(const lut::Table& table, double x, double y)
{
    const auto width = static_cast<std::size_t>(table.x.texels);
    const auto i = static_cast<std::size_t>(x), j = static_cast<std::size_t>(y);
    const std::size_t i1 = std::min(i + 1, width - 1);
    const std::size_t j1 = std::min(j + 1, static_cast<std::size_t>(table.y.texels) - 1);
    const double fx = x - std::floor(x), fy = y - std::floor(y);
    Vec3 result{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto texel = [&](std::size_t column, std::size_t row) {
            return static_cast<double>(table.texels[(row * width + column) * 3 + c]);
        };
        result[c] = (1 - fy) * ((1 - fx) * texel(i, j) + fx * texel(i1, j)) +
                    fy * ((1 - fx) * texel(i, j1) + fx * texel(i1, j1));
    }
    return result;
}

}  // namespace

void measure_error(lut::Table& table, const lut::FilmTableRequest& request,
                   const spectral::ColourSpace& space)
{
    const Vec3 white = spectral::d65_white();
    const auto lab = [&](const Vec3& rgb) {
        return spectral::xyz_to_lab(multiply(space.to_xyz_d65, rgb), white);
    };
    const std::vector<double> columns = probe_positions(table.x.texels);
    const std::vector<double> rows = probe_positions(table.y.texels);
    std::vector<double> errors(columns.size() * rows.size());
    tbb::parallel_for(std::size_t{0}, errors.size(), [&](std::size_t probe) {
        const double x = columns[probe % columns.size()], y = rows[probe / columns.size()];
        const lut::FilmColour exact =
            lut::exact_film_colour(request, value_at(table.x, x), value_at(table.y, y));
        const Vec3& colour =
            table.quantity == "transmittance" ? exact.transmittance : exact.reflectance;
        errors[probe] = spectral::delta_e_2000(lab(bilinear(table, x, y)), lab(colour));
    });
    double sum = 0.0;
    for (const double error : errors) sum += error;
    table.error_max = *std::max_element(errors.begin(), errors.end());
    table.error_mean = sum / static_cast<double>(errors.size());
}

}  // namespace nacre::tool
