// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/inner_tables.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "films/checks.h"
#include "films/sizing.h"

namespace nacre::lut {
namespace {

constexpr std::size_t kPoints = 48;
constexpr double kLineD = 587.5618;

struct Node {
    double at, weight;
};

/// Gauss-Legendre nodes of [0, 1], by Newton's method on P_n.
std::array<Node, kPoints> gauss_legendre()
{
    std::array<Node, kPoints> nodes{};
    for (std::size_t i = 0; i < kPoints; ++i) {
        double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (kPoints + 0.5));
        double slope = 0.0;
        for (int step = 0; step < 8; ++step) {
            double last = 1.0, value = x;
            for (std::size_t n = 2; n <= kPoints; ++n) {
                const double k = static_cast<double>(n);
                last = std::exchange(value, ((2.0 * k - 1.0) * x * value - (k - 1.0) * last) / k);
            }
            slope = kPoints * (x * value - last) / (x * x - 1.0);
            x -= value / slope;
        }
        nodes[i] = {0.5 * (1.0 + x), 1.0 / ((1.0 - x * x) * slope * slope)};
    }
    return nodes;
}

/// Directions in the substrate, cosθ, with weights that sum to 1 over the cosine-weighted
/// hemisphere. Below the critical angle the variable is the cosine c in the ambient,
/// 2 cosθ dcosθ = 2 c dc / n²; beyond it the decay q = √(n² sin²θ − 1), the same with q: in both
/// R has no root at the border. The indices of the d line decide where that is.
std::vector<Node> directions(double relative_index)
{
    const double n_squared = relative_index * relative_index;
    std::vector<Node> result;
    for (const auto [x, weight] : gauss_legendre()) {
        if (n_squared <= 1.0) {
            result.push_back({x, 2.0 * x * weight});
            continue;
        }
        const double inside = std::sqrt(1.0 - (1.0 - x * x) / n_squared);
        result.push_back({inside, 2.0 * x * weight / n_squared});
        const double last = std::sqrt(n_squared - 1.0), q = x * last;
        result.push_back(
            {std::sqrt(1.0 - (1.0 + q * q) / n_squared), 2.0 * q * last * weight / n_squared});
    }
    return result;
}

void add_scaled(FilmColour& sum, const FilmColour& colour, double weight)
{
    for (std::size_t c = 0; c < 3; ++c) {
        sum.reflectance[c] += weight * colour.reflectance[c];
        sum.transmittance[c] += weight * colour.transmittance[c];
    }
}

/// Hemispherical means at `count` equal steps of the variation, as shares: what light finds on its
/// way back and forth has the colour of the light once, in the film's own T.
std::vector<FilmColour> means(const FilmTableRequest& from_below, std::size_t count)
{
    const auto d_line = static_cast<std::size_t>(std::lround(kLineD)) - spectral::kFirstNm;
    const SampledStack& stack = from_below.stack;
    const std::vector<Node> nodes =
        directions(stack.ambient[d_line].real() / stack.substrate[d_line].real());
    const double first = from_below.variation ? from_below.variation->min : 0.0;
    const double step =
        count > 1 ? (from_below.variation->max - first) / static_cast<double>(count - 1) : 0.0;
    const SpectralBlocks spectral(from_below);
    std::vector<std::vector<FilmColour>> columns(nodes.size(), std::vector<FilmColour>(count));
    tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
        Column(spectral).turn_to(nodes[i].at).evaluate(first, step, columns[i]);
    });
    std::vector<FilmColour> result(count);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t row = 0; row < count; ++row)
            add_scaled(result[row], columns[i][row], nodes[i].weight);
    const spectral::Vec3 white = from_below.weights.white();
    for (FilmColour& colour : result)
        for (std::size_t c = 0; c < 3; ++c) {
            colour.reflectance[c] /= white[c];
            colour.transmittance[c] /= white[c];
        }
    return result;
}

Table make_table(const FilmTableRequest& request, int height, bool transmittance,
                 const std::vector<FilmColour>& exact)
{
    const auto& variation = request.variation;
    const bool scale = variation && !variation->layer;
    Table table{.role = {transmittance ? TableOf::T_inner : TableOf::R_inner},
                .quantity = transmittance ? "transmittance" : "reflectance",
                .x = {"cos_theta", "1", 0.0, 1.0, 1},
                .y = {scale ? "thickness_scale" : "thickness_nm", scale ? "1" : "nm",
                      variation ? variation->min : 0.0, variation ? variation->max : 0.0, height},
                .channels = {"R", "G", "B"},
                .texels = {}};
    const auto value = [transmittance](const FilmColour& colour) {
        return transmittance ? colour.transmittance : colour.reflectance;
    };
    const ColourError difference(request.weights.to_xyz_d65);
    ErrorStatistics errors;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const spectral::Vec3 colour = value(exact[i]);
        if (i % 2 == 0) {
            for (const double channel : colour) table.texels.push_back(static_cast<float>(channel));
            continue;
        }
        errors.add(difference(value(midpoint(exact[i - 1], exact[i + 1])), colour));
    }
    table.error_max = request.measure_error ? errors.max : kNotMeasured;
    table.error_mean = request.measure_error ? errors.mean() : kNotMeasured;
    return table;
}

}  // namespace

FilmTableRequest seen_from_below(FilmTableRequest request)
{
    SampledStack& stack = request.stack;
    std::swap(stack.ambient, stack.substrate);
    std::ranges::reverse(stack.layers);
    if (request.technique) request.technique->from_below = !request.technique->from_below;
    if (request.variation && request.variation->layer)
        request.variation->layer = stack.layers.size() - 1 - *request.variation->layer;
    return request;
}

InnerTables bake_inner_tables(const FilmTableRequest& request, int height)
{
    check(request);
    const std::size_t rows = request.variation ? static_cast<std::size_t>(height) : 1;
    const std::vector<FilmColour> exact = means(seen_from_below(request), 2 * rows - 1);
    const auto table = [&](bool transmittance) {
        return make_table(request, static_cast<int>(rows), transmittance, exact);
    };
    return {table(false), table(true)};
}

}  // namespace nacre::lut
