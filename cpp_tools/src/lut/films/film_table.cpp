// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/film_table.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "films/checks.h"
#include "films/row_errors.h"
#include "films/sizing.h"
#include "nacre/core/diagnostics.h"

namespace nacre::lut {
namespace {

/// Positions along an axis that also come half-way between texels: 2·texels − 1, or 1.
std::size_t half_steps(int texels)
{
    return static_cast<std::size_t>(2 * texels - 1);
}

/// Errors found at some probes between texels.
struct ProbeErrors {
    ErrorStatistics reflectance{}, transmittance{};
    double along_angle = 0.0, along_variation = 0.0;

    void add(const ProbeErrors& other)
    {
        reflectance.add(other.reflectance);
        transmittance.add(other.transmittance);
        along_angle = std::max(along_angle, other.along_angle);
        along_variation = std::max(along_variation, other.along_variation);
    }
};

/// How far off a table is between its texels.
struct TableErrors : ProbeErrors {
    RowErrors rows;

    explicit TableErrors(RowErrors none) : rows(std::move(none)) {}
    [[nodiscard]] double largest(bool with_transmittance) const
    {
        return with_transmittance ? std::max(reflectance.max, transmittance.max) : reflectance.max;
    }
};

/// The texels of both quantities as they are stored.
struct Baked {
    TableSize size;
    int texel_bits;
    std::vector<float> reflectance, transmittance;
    TableErrors errors;

    [[nodiscard]] FilmColour texel(std::size_t x, std::size_t y) const
    {
        FilmColour colour{};
        const std::size_t at = 3 * (y * static_cast<std::size_t>(size.width) + x);
        for (std::size_t c = 0; c < 3; ++c) {
            colour.reflectance[c] = static_cast<double>(reflectance[at + c]);
            colour.transmittance[c] = static_cast<double>(transmittance[at + c]);
        }
        return colour;
    }
    /// Texels of a column by their row.
    [[nodiscard]] auto column(std::size_t x) const
    {
        return [this, x](std::size_t y) { return texel(x, y); };
    }
    void set_texel(std::size_t x, std::size_t y, const FilmColour& colour)
    {
        const std::size_t at = 3 * (y * static_cast<std::size_t>(size.width) + x);
        for (std::size_t c = 0; c < 3; ++c) {
            reflectance[at + c] = stored(colour.reflectance[c]);
            transmittance[at + c] = stored(colour.transmittance[c]);
        }
    }

private:
    [[nodiscard]] float stored(double value) const
    {
        return static_cast<float>(texel_bits < kFloatBits ? rounded_texel(value, texel_bits)
                                                          : value);
    }
};

FilmColour lerp(const FilmColour& a, const FilmColour& b, double t) noexcept
{
    FilmColour result{};
    for (std::size_t c = 0; c < 3; ++c) {
        result.reflectance[c] = (1.0 - t) * a.reflectance[c] + t * b.reflectance[c];
        result.transmittance[c] = (1.0 - t) * a.transmittance[c] + t * b.transmittance[c];
    }
    return result;
}

double probe(ProbeErrors& errors, const Baker& baker, double cos_theta,
             const FilmColour& interpolated, const FilmColour& exact)
{
    if (cos_theta < kLeastCountedCosine) return 0.0;
    const double R = baker.error(interpolated.reflectance, exact.reflectance);
    errors.reflectance.add(R);
    if (!baker.request.transmittance) return R;
    const double T = baker.error(interpolated.transmittance, exact.transmittance);
    errors.transmittance.add(T);
    return std::max(R, T);
}

double half_step(const Baker& baker, int height)
{
    if (height < 2) return 0.0;
    return (baker.last_value() - baker.first_value()) / static_cast<double>(2 * height - 2);
}

/// Colours of one angle at the rows of a table and half-way between them.
using HalfRows = std::vector<FilmColour>;

HalfRows exact_half_rows(const Baker& baker, TableSize size, double cos_theta)
{
    HalfRows exact(half_steps(size.height));
    baker.column(cos_theta).evaluate(baker.first_value(), half_step(baker, size.height), exact);
    return exact;
}

/// Errors half-way between the rows of a column, whose texel of row y is texel(y).
template <class Texel>
ProbeErrors check_column(const Baker& baker, RowErrors& rows, double cos_theta,
                         const HalfRows& exact, const Texel& texel)
{
    ProbeErrors errors;
    for (std::size_t i = 1; i < exact.size(); i += 2) {
        const FilmColour between = midpoint(texel(i / 2), texel(i / 2 + 1));
        const double error = probe(errors, baker, cos_theta, between, exact[i]);
        errors.along_variation = std::max(errors.along_variation, error);
        rows.add(i, cos_theta, error, kTexelWeight);
    }
    return errors;
}

/// Errors half-way between two columns, at the rows and half-way between them.
template <class Left, class Right>
ProbeErrors check_midway(const Baker& baker, RowErrors& rows, double cos_theta,
                         const HalfRows& exact, const Left& left, const Right& right,
                         std::int64_t weight = kMidwayWeight)
{
    ProbeErrors errors;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const std::size_t y = i / 2, up = y + i % 2;
        const FilmColour low = midpoint(left(y), right(y)), high = midpoint(left(up), right(up));
        const double error = probe(errors, baker, cos_theta, midpoint(low, high), exact[i]);
        if (i % 2 == 0) errors.along_angle = std::max(errors.along_angle, error);
        rows.add(i, cos_theta, error, weight);
    }
    return errors;
}

/// Texels of column `x`, and the errors half-way between its rows.
ProbeErrors bake_column(const Baker& baker, Baked& baked, std::size_t x)
{
    const double cos_theta = static_cast<double>(x) / (baked.size.width - 1);
    const HalfRows exact = exact_half_rows(baker, baked.size, cos_theta);
    for (std::size_t i = 0; i < exact.size(); i += 2) baked.set_texel(x, i / 2, exact[i]);
    return check_column(baker, baked.errors.rows, cos_theta, exact, baked.column(x));
}

/// Errors half-way between columns x and x + 1.
ProbeErrors check_strip(const Baker& baker, Baked& baked, std::size_t x)
{
    const double cos_theta = (static_cast<double>(x) + 0.5) / (baked.size.width - 1);
    const HalfRows exact = exact_half_rows(baker, baked.size, cos_theta);
    return check_midway(baker, baked.errors.rows, cos_theta, exact, baked.column(x),
                        baked.column(x + 1));
}

/// Errors at one more point of each cell of the strip between columns x and x + 1. The position in
/// the cell changes from strip to strip by the golden ratio, so that nothing hides between the
/// half-way probes.
ProbeErrors check_elsewhere(const Baker& baker, const Baked& baked, std::size_t x)
{
    const auto wander = [x](double ratio) {
        const double walked = 0.5 + static_cast<double>(x) * ratio;
        return walked - std::floor(walked);
    };
    const double u = wander(0.7548776662466927);  // R2 sequence: 1/g, 1/g² of g³ = g + 1
    const double v = baked.size.height > 1 ? wander(0.5698402909980532) : 0.0;
    const std::size_t rows = std::max<std::size_t>(1, half_steps(baked.size.height) / 2);
    const double step = 2.0 * half_step(baker, baked.size.height);

    std::vector<FilmColour> exact(rows);
    const double cos_theta = (static_cast<double>(x) + u) / (baked.size.width - 1);
    baker.column(cos_theta).evaluate(baker.first_value() + v * step, step, exact);
    ProbeErrors errors;
    for (std::size_t y = 0; y < rows; ++y) {
        const std::size_t up = std::min(y + 1, static_cast<std::size_t>(baked.size.height) - 1);
        const FilmColour low = lerp(baked.texel(x, y), baked.texel(x + 1, y), u);
        const FilmColour high = lerp(baked.texel(x, up), baked.texel(x + 1, up), u);
        probe(errors, baker, cos_theta, lerp(low, high, v), exact[y]);
    }
    return errors;
}

/// Texels of column `x`.
void fill_column(const Baker& baker, Baked& baked, std::size_t x)
{
    const auto height = static_cast<std::size_t>(baked.size.height);
    std::vector<FilmColour> exact(height);
    const double cos_theta = static_cast<double>(x) / (baked.size.width - 1);
    baker.column(cos_theta).evaluate(baker.first_value(), 2.0 * half_step(baker, baked.size.height),
                                     exact, baker.request.precision);
    for (std::size_t y = 0; y < height; ++y) baked.set_texel(x, y, exact[y]);
}

/// Bakes and, if asked to, measures. The errors are added up in the order of the columns, so that
/// their mean does not depend on which thread was first.
Baked bake(Baker& baker, TableSize size)
{
    const auto width = static_cast<std::size_t>(size.width);
    Baked baked{.size = size,
                .texel_bits = baker.request.texel_bits,
                .reflectance = {},
                .transmittance = {},
                .errors = TableErrors(RowErrors(half_steps(size.height),
                                                kStripWeight * static_cast<double>(width - 1)))};
    baked.reflectance.resize(3 * width * static_cast<std::size_t>(size.height));
    baked.transmittance.resize(baked.reflectance.size());

    if (!baker.request.measure_error) {
        baker.progress.stage(0.9, width);
        tbb::parallel_for(std::size_t{0}, width, [&](std::size_t x) {
            fill_column(baker, baked, x);
            baker.progress.step();
        });
        return baked;
    }
    std::vector<ProbeErrors> errors(3 * width - 2);
    baker.progress.stage(0.9, errors.size());
    const auto each = [&](std::size_t count, std::size_t offset, auto&& measure) {
        tbb::parallel_for(std::size_t{0}, count, [&](std::size_t x) {
            errors[offset + x] = measure(baker, baked, x);
            baker.progress.step();
        });
    };
    each(width, 0, bake_column);
    each(width - 1, width, check_strip);
    each(width - 1, 2 * width - 1, check_elsewhere);

    for (const ProbeErrors& column : errors) baked.errors.add(column);
    return baked;
}

/// The mean error of a row, as a share of the tolerance: at the default of 0.1 a film of any one
/// thickness is within ΔE00 0.01 of the exact colours on average.
constexpr double kMeanShare = 0.09;

/// A larger size for a table some row of which is off by too much on average, or nothing.
std::optional<TableSize> larger_for_rows(const FilmTableRequest& request, TableSize size,
                                         const RowErrors& rows)
{
    const double at_rows = rows.largest(0), between = rows.largest(1);
    const double mean = std::max(at_rows, between), allowed = kMeanShare * request.tolerance;
    if (mean <= allowed) return std::nullopt;

    const bool wider = size.width < request.max_texels;
    const bool higher = size.height >= 2 && size.height < request.max_texels;
    if (!wider && !higher) return std::nullopt;
    // On the rows themselves only the angle is interpolated.
    const bool angle = !higher || (wider && at_rows >= between - at_rows);
    int& texels = angle ? size.width : size.height;
    texels = refined(texels, mean, allowed, request.max_texels);
    return size;
}

/// The next size to try where some probe is over the tolerance, or a row by more than its share on
/// average: of the axis that is to blame. Nothing if the size will do or cannot grow.
std::optional<TableSize> larger(const FilmTableRequest& request, TableSize size,
                                const TableErrors& errors)
{
    const double error = errors.largest(request.transmittance);
    if (error <= request.tolerance) return larger_for_rows(request, size, errors.rows);
    const bool angle = size.height < 2 || errors.along_angle >= errors.along_variation;
    int& texels = angle ? size.width : size.height;
    if (texels == request.max_texels) return std::nullopt;
    texels = refined(texels, error, request.tolerance, request.max_texels);
    return size;
}

/// What bake() finds half-way between columns x and x + 1 and on them.
ProbeErrors sample_strip(const Baker& baker, TableSize size, std::size_t x, RowErrors& rows)
{
    const auto angle = [&](double column) { return column / (size.width - 1); };
    const auto exact = [&](double cos_theta) { return exact_half_rows(baker, size, cos_theta); };
    const auto texels = [](const HalfRows& of) {
        return [&of](std::size_t y) { return of[2 * y]; };
    };

    const auto first = static_cast<double>(x);
    const double left = angle(first), midway = angle(first + 0.5), right = angle(first + 1.0);
    const HalfRows on_left = exact(left), on_right = exact(right);
    // A strip has half of each of its columns: all weights are doubled, to stay whole.
    ProbeErrors errors = check_midway(baker, rows, midway, exact(midway), texels(on_left),
                                      texels(on_right), 2 * kMidwayWeight);
    errors.add(check_column(baker, rows, left, on_left, texels(on_left)));
    errors.add(check_column(baker, rows, right, on_right, texels(on_right)));
    return errors;
}

/// What a table of a size would be off by, from some of its strips: for a fraction of the work.
TableErrors sample_errors(Baker& baker, TableSize size)
{
    constexpr std::size_t kFewestStrips = 16, kShare = 8;
    const auto all = static_cast<std::size_t>(size.width - 1);
    const std::size_t count = std::min(all, std::max(kFewestStrips, all / kShare));
    const auto strip = [&](std::size_t i) { return (2 * i + 1) * all / (2 * count); };
    double weight = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        weight +=
            4.0 * kStripWeight * (static_cast<double>(strip(i)) + 0.5) / static_cast<double>(all);

    TableErrors found(RowErrors(half_steps(size.height), weight));
    std::vector<ProbeErrors> errors(count);
    baker.progress.stage(0.05, count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        errors[i] = sample_strip(baker, size, strip(i), found.rows);
        baker.progress.step();
    });
    for (const ProbeErrors& of_strip : errors) found.add(of_strip);
    return found;
}

/// Bakes at the estimated size and enlarges it until every probe is within the tolerance, and no
/// row is off by more than its share on average.
Baked bake_to_tolerance(Baker& baker)
{
    const FilmTableRequest& request = baker.request;
    TableSize size = estimate_size(baker);
    while (const auto next = larger(request, size, sample_errors(baker, size))) size = *next;
    for (;;) {
        Baked baked = bake(baker, size);
        const std::optional<TableSize> next = larger(request, size, baked.errors);
        if (next) {
            size = *next;
            continue;
        }
        const double error = baked.errors.largest(request.transmittance);
        if (error > request.tolerance && !request.accept_error) refuse_tolerance(request, error);
        return baked;
    }
}

Table make_table(const Baker& baker, const Baked& baked, bool transmittance)
{
    const auto& variation = baker.request.variation;
    const ErrorStatistics& error =
        transmittance ? baked.errors.transmittance : baked.errors.reflectance;
    const bool scale = variation && !variation->layer;
    const bool measured = baker.request.measure_error;
    return {.role = {transmittance ? TableOf::T : TableOf::R},
            .quantity = transmittance ? "transmittance" : "reflectance",
            .x = {"cos_theta", "1", 0.0, 1.0, baked.size.width},
            .y = {scale ? "thickness_scale" : "thickness_nm", scale ? "1" : "nm",
                  baker.first_value(), baker.last_value(), baked.size.height},
            .channels = {"R", "G", "B"},
            .texels = transmittance ? baked.transmittance : baked.reflectance,
            .error_max = measured ? error.max : kNotMeasured,
            .error_mean = measured ? error.mean() : kNotMeasured,
            .texel_bits = baked.texel_bits};
}

}  // namespace

FilmTables bake_film_tables(const FilmTableRequest& request)
{
    check(request);
    try {
        Baker baker(request);
        const Baked baked = request.size ? bake(baker, {(*request.size)[0], (*request.size)[1]})
                                         : bake_to_tolerance(baker);
        FilmTables tables{.reflectance = make_table(baker, baked, false), .transmittance = {}};
        if (request.transmittance) tables.transmittance = make_table(baker, baked, true);
        return tables;
    } catch (const Progress::Cancelled&) {
        throw InputError(Diagnostic{{}, 0, {}, "cancelled"});
    }
}

FilmColour exact_film_colour(const FilmTableRequest& request, double cos_theta,
                             double variation_value)
{
    const SpectralBlocks spectral(request);
    FilmColour colour{};
    Column(spectral).turn_to(cos_theta).evaluate(variation_value, 0.0, {&colour, 1});
    return colour;
}

std::vector<FilmColour> exact_film_ramp(const FilmTableRequest& request, double cos_theta,
                                        std::size_t count)
{
    const Variation& along = *request.variation;
    const SpectralBlocks spectral(request);
    std::vector<FilmColour> ramp(count);
    Column(spectral).turn_to(cos_theta).evaluate(
        along.min, (along.max - along.min) / static_cast<double>(count - 1), ramp);
    return ramp;
}

}  // namespace nacre::lut
