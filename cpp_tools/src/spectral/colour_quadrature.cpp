// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/colour_quadrature.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {
namespace {

Vec3 weight_at(const ColourWeights& weights, std::size_t i)
{
    return {weights.weight[0][i], weights.weight[1][i], weights.weight[2][i]};
}

constexpr int kNoNumber = -1;

int whole_number(std::string_view text)
{
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && end == text.data() + text.size() ? number : kNoNumber;
}

}  // namespace

ColourQuadrature nanometre_quadrature(const ColourWeights& weights)
{
    ColourQuadrature result;
    result.wavelength_nm.reserve(kWavelengths);
    result.weight.reserve(kWavelengths);
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        result.wavelength_nm.push_back(wavelength_nm(i));
        result.weight.push_back(weight_at(weights, i));
    }
    return result;
}

ColourQuadrature fine_quadrature(const ColourWeights& weights, double step_nm)
{
    assert(step_nm > 0.0 && step_nm <= 1.0);
    const auto steps = static_cast<std::size_t>(std::lround((kLastNm - kFirstNm) / step_nm));
    const double step = (kLastNm - kFirstNm) / static_cast<double>(steps);
    ColourQuadrature result;
    result.wavelength_nm.reserve(steps + 1);
    result.weight.reserve(steps + 1);
    for (std::size_t k = 0; k <= steps; ++k) {
        const double at = step * static_cast<double>(k);
        const auto i = std::min(static_cast<std::size_t>(at), kWavelengths - 2);
        const double part = at - static_cast<double>(i);
        const Vec3 here = weight_at(weights, i), next = weight_at(weights, i + 1);
        const double width = k == 0 || k == steps ? 0.5 * step : step;  // trapezoidal rule
        Vec3 w{};
        for (std::size_t c = 0; c < 3; ++c) w[c] = width * (here[c] + part * (next[c] - here[c]));
        result.wavelength_nm.push_back(kFirstNm + at);
        result.weight.push_back(w);
    }
    return result;
}

ColourQuadrature stepped_quadrature(const ColourWeights& weights, int step_nm, int from_nm)
{
    assert(step_nm >= 1 && step_nm <= kLargestStepNm);
    assert(from_nm >= kFirstNm && from_nm <= kLastNm);
    const auto step = static_cast<std::size_t>(step_nm);
    auto first = static_cast<std::size_t>(from_nm - kFirstNm);
    while (first < kWavelengths && weight_at(weights, first) == Vec3{}) ++first;
    ColourQuadrature result;
    result.wavelength_nm.reserve(kWavelengths / step + 1);
    result.weight.reserve(kWavelengths / step + 1);
    for (std::size_t i = first; i < kWavelengths; i += step) {
        result.wavelength_nm.push_back(wavelength_nm(i));
        Vec3 w = weight_at(weights, i);
        for (double& value : w) value *= step_nm;
        result.weight.push_back(w);
    }
    return result;
}

ColourQuadrature hierarchical_quadrature(const ColourWeights& weights, int level)
{
    assert(level >= 0 && level <= kHighestLevel);
    constexpr int first_nm = 324, samples = 512;
    const int cell = 1 << level;
    ColourQuadrature result;
    for (int from = first_nm; from < first_nm + samples; from += cell) {
        Vec3 sum{};
        for (int nm = std::max(from, kFirstNm); nm < std::min(from + cell, kLastNm + 1); ++nm) {
            const Vec3 w = weight_at(weights, static_cast<std::size_t>(nm - kFirstNm));
            for (std::size_t c = 0; c < 3; ++c) sum[c] += w[c];
        }
        if (sum == Vec3{}) continue;
        const double middle = from + 0.5 * (cell - 1);
        result.wavelength_nm.push_back(std::clamp<double>(middle, kFirstNm, kLastNm));
        result.weight.push_back(sum);
    }
    return result;
}

std::optional<ColourQuadrature> named_quadrature(std::string_view name,
                                                 const ColourWeights& weights, int from_nm)
{
    if (name == "adaptive") return std::nullopt;
    if (name == "full") return nanometre_quadrature(weights);
    if (name == "reference") return fine_quadrature(weights, 0.05);
    const std::size_t colon = name.find(':');
    const std::string_view kind = name.substr(0, colon);
    const int number = colon == name.npos ? kNoNumber : whole_number(name.substr(colon + 1));
    if (kind == "steps" && number >= 1 && number <= kLargestStepNm)
        return stepped_quadrature(weights, number, from_nm);
    if (kind == "hierarchical" && number >= 0 && number <= kHighestLevel)
        return hierarchical_quadrature(weights, number);
    throw InputError({.file = {},
                      .field = "sampling",
                      .message = fmt::format("must be adaptive, full, reference, steps:1 … "
                                             "steps:{} or hierarchical:0 … hierarchical:{} "
                                             "(got '{}')",
                                             kLargestStepNm, kHighestLevel, name)});
}

Vec3 quadrature_sum(const ColourQuadrature& quadrature, const std::vector<double>& values) noexcept
{
    assert(values.size() == quadrature.weight.size());
    Vec3 sum{};
    for (std::size_t i = 0; i < values.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += quadrature.weight[i][c] * values[i];
    return sum;
}

}  // namespace nacre::spectral
