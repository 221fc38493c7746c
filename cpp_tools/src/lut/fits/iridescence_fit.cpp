// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/iridescence_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include <tbb/parallel_for.h>

#include "films/checks.h"
#include "films/colour_error.h"
#include "fits/simplex.h"
#include "nacre/core/diagnostics.h"
#include "nacre/lut/film_table.h"

namespace nacre::lut {
namespace {

using optics::KhrIridescence;
using spectral::Vec3;

constexpr int kLastDegree = 85;
constexpr int kStatedStep = 1, kFittedStep = 5;

// Bounds of the search. Colours of a film of more than two micrometres are grey in the model.
constexpr double kLeastIor = 1.0, kLargestIor = 4.0, kThickestNm = 2000.0;

/// Rings of a sphere seen from afar: each one's share of the disc.
struct Rings {
    std::vector<double> cos_theta, share;
};

Rings rings(int step_deg)
{
    Rings result;
    double sum = 0.0;
    const auto sine = [](double degrees) {
        return std::sin(std::clamp(degrees, 0.0, 90.0) * std::numbers::pi / 180.0);
    };
    for (int degrees = 0; degrees <= kLastDegree; degrees += step_deg) {
        const double inner = sine(degrees - step_deg / 2.0), outer = sine(degrees + step_deg / 2.0);
        result.cos_theta.push_back(std::cos(degrees * std::numbers::pi / 180.0));
        result.share.push_back(outer * outer - inner * inner);
        sum += result.share.back();
    }
    for (double& share : result.share) share /= sum;
    return result;
}

/// The exact colours of all rings at all values, a value's rings together.
std::vector<FilmColour> exact_colours(const FilmTableRequest& request, const Rings& sphere,
                                      const std::vector<double>& values)
{
    const std::size_t count = sphere.cos_theta.size();
    std::vector<FilmColour> colours(count * values.size());
    tbb::parallel_for(std::size_t{0}, colours.size(), [&](std::size_t i) {
        colours[i] = exact_film_colour(request, sphere.cos_theta[i % count], values[i / count]);
    });
    return colours;
}

double fraction(const std::vector<double>& values, double value)
{
    const double range = values.back() - values.front();
    return range > 0.0 ? (value - values.front()) / range : 1.0;
}

// Order of the parameters of a search.
enum Parameter : std::size_t { kIor, kMinNm, kMaxNm, kRed, kGreen, kBlue, kFactor, kParameters };
using Point = std::vector<double>;

constexpr std::array<double, kParameters> kLeast{kLeastIor, 0, 0, 0, 0, 0, 0};
constexpr std::array<double, kParameters> kLargest{
    kLargestIor, kThickestNm, kThickestNm, 1, 1, 1, 1};

IridescenceFit fit_of(const Point& p)
{
    return {.film_ior = p[kIor],
            .factor = p[kFactor],
            .film_min_nm = p[kMinNm],
            .film_max_nm = p[kMaxNm],
            .base_f0 = {p[kRed], p[kGreen], p[kBlue]}};
}

class Search {
public:
    Search(const FilmTableRequest& request, const std::vector<double>& values)
        : values_(values),
          sphere_(rings(kFittedStep)),
          exact_(exact_colours(request, sphere_, values)),
          difference_(request.weights.to_xyz_d65)
    {}

    /// Mean square of ΔE00, of the nearest point within the bounds, and a slope that leads there.
    [[nodiscard]] double operator()(const Point& point) const
    {
        Point held = point;
        double outside = 0.0;
        for (std::size_t i = 0; i < kParameters; ++i) {
            held[i] = std::clamp(point[i], kLeast[i], kLargest[i]);
            outside += std::abs(point[i] - held[i]) / kLargest[i];
        }
        const IridescenceFit fit = fit_of(held);
        double sum = 0.0;
        const std::size_t count = sphere_.cos_theta.size();
        for (std::size_t v = 0; v < values_.size(); ++v) {
            const KhrIridescence surface = surface_at(fit, values_, values_[v]);
            for (std::size_t i = 0; i < count; ++i) {
                const double error =
                    difference_(optics::khr_iridescence(surface, sphere_.cos_theta[i]),
                                exact_[v * count + i].reflectance);
                sum += sphere_.share[i] * error * error;
            }
        }
        return sum / static_cast<double>(values_.size()) + outside;
    }

    /// The F0 of a grey scale that suits each channel best, for a film of this index and thickness:
    /// channels of the model hardly depend on each other.
    [[nodiscard]] Vec3 best_base(IridescenceFit fit) const
    {
        constexpr std::array kLevels{0.0, 0.02, 0.05, 0.1, 0.2, 0.35, 0.55, 0.75, 0.95};
        Vec3 best{}, least;
        least.fill(std::numeric_limits<double>::infinity());
        for (const double level : kLevels) {
            fit.base_f0.fill(level);
            const Vec3 error = error_of_channels(fit);
            for (std::size_t c = 0; c < 3; ++c)
                if (error[c] < least[c]) {
                    least[c] = error[c];
                    best[c] = level;
                }
        }
        return best;
    }

private:
    const std::vector<double>& values_;
    Rings sphere_;
    std::vector<FilmColour> exact_;
    ColourError difference_;

    /// Of the cube roots, which lie as L* does.
    [[nodiscard]] Vec3 error_of_channels(const IridescenceFit& fit) const
    {
        Vec3 sum{};
        const std::size_t count = sphere_.cos_theta.size();
        for (std::size_t v = 0; v < values_.size(); ++v) {
            const KhrIridescence surface = surface_at(fit, values_, values_[v]);
            for (std::size_t i = 0; i < count; i += 2) {
                const Vec3 rgb = optics::khr_iridescence(surface, sphere_.cos_theta[i]);
                for (std::size_t c = 0; c < 3; ++c) {
                    const double error =
                        std::cbrt(rgb[c]) - std::cbrt(exact_[v * count + i].reflectance[c]);
                    sum[c] += sphere_.share[i] * error * error;
                }
            }
        }
        return sum;
    }
};

/// Thicknesses to start from: any where one is sought; where a range is, so many wide.
std::vector<std::array<double, 2>> thickness_grid(bool range)
{
    std::vector<std::array<double, 2>> grid;
    constexpr double kStepNm = 25.0, kCoarseNm = 100.0, kLastNm = 1500.0;
    if (!range)
        for (double nm = 0.0; nm <= kLastNm; nm += kStepNm) grid.push_back({nm, nm});
    else
        for (double from = 0.0; from <= kLastNm; from += kCoarseNm)
            for (double to = from + kCoarseNm; to <= kThickestNm; to += kCoarseNm)
                grid.push_back({from, to});
    return grid;
}

/// The best cells of the grid, best first.
std::vector<Minimum> starts(const Search& search, bool range, std::size_t count)
{
    constexpr std::array kIndices{1.1, 1.25, 1.4, 1.6, 1.8, 2.1, 2.5, 3.0};
    const auto grid = thickness_grid(range);
    std::vector<Minimum> cells(kIndices.size() * grid.size());
    tbb::parallel_for(std::size_t{0}, cells.size(), [&](std::size_t i) {
        const auto [from, to] = grid[i / kIndices.size()];
        const double index = kIndices[i % kIndices.size()];
        const Vec3 base = search.best_base({index, 1.0, from, to, {}});
        Point point{index, from, to, base[0], base[1], base[2], 1.0};
        const double value = search(point);
        cells[i] = {std::move(point), value};
    });
    std::ranges::stable_sort(cells, {}, &Minimum::value);
    cells.resize(std::min(count, cells.size()));
    return cells;
}

Minimum refined_minimum(const Search& search, const Minimum& start, bool range)
{
    constexpr int kEvaluations = 900;
    // Away from the bounds, so that the first simplex has a volume.
    Point step{0.15, 40.0, 40.0, 0.08, 0.08, 0.08, -0.15};
    for (std::size_t i = 0; i < kParameters; ++i)
        if (start.at[i] + step[i] > kLargest[i]) step[i] = -step[i];
    if (!range) step[kMinNm] = 0.0;  // stays where it is, and no value depends on it
    Minimum best = start;
    for (int pass = 0; pass < 2; ++pass) {
        best = minimise(search, best.at, step, kEvaluations);
        for (double& edge : step) edge *= 0.4;
    }
    return best;
}

}  // namespace

SphereError sphere_error(const FilmTableRequest& request, const std::vector<double>& values,
                         const FilmColours& colours, bool transmittance)
{
    check(request);
    const Rings sphere = rings(kStatedStep);
    const std::vector<FilmColour> exact = exact_colours(request, sphere, values);
    const ColourError difference(request.weights.to_xyz_d65);
    SphereError result{};
    const std::size_t count = sphere.cos_theta.size();
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const Vec3& truth = transmittance ? exact[i].transmittance : exact[i].reflectance;
        const double error =
            difference(colours(sphere.cos_theta[i % count], values[i / count]), truth);
        result.mean += sphere.share[i % count] * error / static_cast<double>(values.size());
        result.max = std::max(result.max, error);
    }
    return result;
}

KhrIridescence surface_at(const IridescenceFit& fit, const std::vector<double>& values,
                          double value)
{
    return {.film_ior = fit.film_ior,
            .film_nm = std::lerp(fit.film_min_nm, fit.film_max_nm, fraction(values, value)),
            .base_f0 = fit.base_f0,
            .factor = fit.factor};
}

IridescenceFit fit_iridescence(const FilmTableRequest& request, const std::vector<double>& values)
{
    check(request);
    constexpr std::size_t kStarts = 16;
    const bool range = values.size() > 1;
    const Search search(request, values);
    std::vector<Minimum> candidates = starts(search, range, kStarts);
    tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
        candidates[i] = refined_minimum(search, candidates[i], range);
    });
    const Minimum& best = *std::ranges::min_element(candidates, {}, &Minimum::value);
    Point held = best.at;
    for (std::size_t i = 0; i < kParameters; ++i)
        held[i] = std::clamp(held[i], kLeast[i], kLargest[i]);
    return fit_of(held);
}

}  // namespace nacre::lut
