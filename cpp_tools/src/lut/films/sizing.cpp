// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "films/sizing.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/diagnostics.h"

namespace nacre::lut {
namespace {

constexpr int kFirstWidth = 17, kFirstHeight = 33;
constexpr std::size_t kLinesAcross = 32;

/// Largest error half-way between `width` columns, on a few rows.
double error_along_angle(Baker& baker, int width)
{
    const bool varies = baker.request.variation.has_value();
    const std::size_t rows = varies ? kLinesAcross : 1;
    const double step =
        varies ? (baker.last_value() - baker.first_value()) / static_cast<double>(rows - 1) : 0.0;

    const auto points = static_cast<std::size_t>(2 * width - 1);
    std::vector<std::vector<FilmColour>> columns(points, std::vector<FilmColour>(rows));
    baker.progress.stage(0.05, points);
    tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
        const double cos_theta = static_cast<double>(i) / static_cast<double>(points - 1);
        baker.column(cos_theta).evaluate(baker.first_value(), step, columns[i]);
        baker.progress.step();
    });

    double largest = 0.0;
    const auto first =
        static_cast<std::size_t>(kLeastCountedCosine * static_cast<double>(width - 1));
    for (std::size_t i = 2 * first + 1; i < points; i += 2)
        for (std::size_t row = 0; row < rows; ++row)
            largest = std::max(largest,
                               baker.difference(midpoint(columns[i - 1][row], columns[i + 1][row]),
                                                columns[i][row]));
    return largest;
}

/// Largest error half-way between `height` rows, on a few columns.
double error_along_variation(Baker& baker, int height)
{
    const auto points = static_cast<std::size_t>(2 * height - 1);
    const double step =
        (baker.last_value() - baker.first_value()) / static_cast<double>(points - 1);
    std::vector<double> largest(kLinesAcross, 0.0);
    baker.progress.stage(0.05, kLinesAcross);
    tbb::parallel_for(std::size_t{0}, kLinesAcross, [&](std::size_t i) {
        std::vector<FilmColour> column(points);
        const double along = static_cast<double>(i) / (kLinesAcross - 1);
        const double cos_theta = kLeastCountedCosine + (1.0 - kLeastCountedCosine) * along;
        baker.column(cos_theta).evaluate(baker.first_value(), step, column);
        for (std::size_t row = 1; row < points; row += 2)
            largest[i] =
                std::max(largest[i],
                         baker.difference(midpoint(column[row - 1], column[row + 1]), column[row]));
        baker.progress.step();
    });
    return *std::max_element(largest.begin(), largest.end());
}

/// Texels of one axis that keep its error within `share`, or as many as there may be.
int texels_for(Baker& baker, double share, int first, double (*error_along)(Baker&, int))
{
    const FilmTableRequest& request = baker.request;
    int texels = std::min(request.max_texels, first);
    for (;;) {
        const double error = error_along(baker, texels);
        if (error <= share) return texels;
        if (texels == request.max_texels) {
            if (error > request.tolerance && !request.accept_error)
                refuse_tolerance(request, error);
            return texels;
        }
        texels = refined(texels, error, share, request.max_texels);
    }
}

}  // namespace

void Progress::stage(double share, std::size_t steps)
{
    per_step_ = (1.0 - done_) * share / static_cast<double>(std::max<std::size_t>(steps, 1));
}

void Progress::step()
{
    if (!report_) return;
    const std::lock_guard lock(mutex_);
    done_ = std::min(1.0, done_ + per_step_);
    if (!report_(done_)) throw Cancelled{};
}

double Baker::difference(const FilmColour& a, const FilmColour& b) const
{
    const double reflected = error(a.reflectance, b.reflectance);
    if (!request.transmittance) return reflected;
    return std::max(reflected, error(a.transmittance, b.transmittance));
}

FilmColour mix(const FilmColour& a, const FilmColour& b, double t) noexcept
{
    FilmColour mixed{};
    for (std::size_t c = 0; c < 3; ++c) {
        mixed.reflectance[c] = std::lerp(a.reflectance[c], b.reflectance[c], t);
        mixed.transmittance[c] = std::lerp(a.transmittance[c], b.transmittance[c], t);
    }
    return mixed;
}

FilmColour midpoint(const FilmColour& a, const FilmColour& b) noexcept
{
    return mix(a, b, 0.5);
}

int refined(int texels, double error, double allowed, int limit)
{
    const double factor = std::clamp(1.05 * std::sqrt(error / allowed), 1.1, 4.0);
    const double steps = std::ceil((texels - 1) * factor);
    return static_cast<int>(std::min<double>(limit, steps + 1.0));
}

void refuse_tolerance(const FilmTableRequest& request, double error)
{
    throw InputError(Diagnostic{
        {},
        0,
        "tolerance",
        fmt::format("a table of at most {} texels per axis reaches ΔE00 {:.3g}, not {:g}; "
                    "raise the tolerance or narrow the range",
                    request.max_texels, error, request.tolerance)});
}

TableSize estimate_size(Baker& baker)
{
    const bool varies = baker.request.variation.has_value();
    const double share = (varies ? 0.45 : 0.9) * baker.request.tolerance;
    TableSize size{texels_for(baker, share, kFirstWidth, error_along_angle), 1};
    if (varies) size.height = texels_for(baker, share, kFirstHeight, error_along_variation);
    return size;
}

}  // namespace nacre::lut
