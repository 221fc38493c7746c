// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/stack_colour.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "colours/amplitude_series.h"

namespace nacre::optics {
namespace {

using detail::AmplitudeSeries;
using detail::BandSums;
using detail::StackSamples;
using spectral::Vec3;

/// What the last two terms may contribute to R or T in the mean: ten times what the missing ones do
/// where the series converges as fast as that of an exponential.
constexpr double kLargestDoubt = 3e-3;
/// Beyond it a sum costs no more.
constexpr double kMostNodes = 600.0;
constexpr int kMostTries = 3;
/// Round trip between wavelengths of a sum, in radians: a fringe has six of them.
constexpr double kLargestTurn = 1.0;
constexpr double kFinestStepNm = 0.05;
constexpr double kLargestPhase = 1e9;  ///< of metres, where phases mean nothing any more

/// A phase of ±κ over the band needs κ terms, and a few times κ^⅓ until they fall off (the Bessel
/// functions that are the coefficients of e^{iκx}), by about a factor e each; at a resonance a is
/// smaller than elsewhere, which takes as many more as the contrast has powers of e. The constants
/// are those with which films and etalons meet kLargestDoubt at once.
double nodes_for(double kappa, double contrast)
{
    return std::ceil(4.0 + kappa + 1.5 * std::cbrt(kappa) + contrast);
}

/// Mean error |Δn|/|n| at which a medium counts as interpolated.
constexpr double kSmoothIndex = 6e-4;
/// Nodes whose smoothness the constant of nodes_for() already has room for.
constexpr std::size_t kPlainNodes = 3;
/// From here on corners of a table are what is left.
constexpr std::size_t kMostMediumNodes = 64;

/// How many more nodes a medium takes than a clear one: bands of absorption, and the corners that
/// tables have.
std::size_t more_nodes_for(const spectral::OpticalConstants& medium,
                           const detail::WavenumberBand& band, const detail::BandWeights& weights)
{
    std::vector<spectral::Complex> n(weights.size());
    for (std::size_t i = 0; i < n.size(); ++i) n[i] = medium.at(weights.wavelength_nm(i));
    std::size_t count = kPlainNodes;
    for (; count < kMostMediumNodes; count += 1 + count / 8) {
        std::vector<spectral::Complex> values;
        for (const double nm : band.nodes_nm(count)) values.push_back(medium.at(nm));
        const auto series = detail::chebyshev_coefficients(values);
        double error = 0.0;
        for (std::size_t i = 0; i < n.size(); ++i) {
            const double x = band.x(weights.wavelength_nm(i));
            error += weights.importance(i) * std::abs(detail::chebyshev_sum(series, x) - n[i]) /
                     std::abs(n[i]);
        }
        if (error <= kSmoothIndex) break;
    }
    return count - kPlainNodes;
}

double more_nodes(double count)
{
    return count + std::max(4.0, std::floor(0.5 * count));
}

}  // namespace

struct SummedColours::Work {
    spectral::ColourQuadrature quadrature;
    StackSamples samples;
};

SummedColours::SummedColours(const DispersiveStack& stack,
                             const spectral::ColourQuadrature& quadrature)
    : work_(std::make_unique<Work>(Work{quadrature, StackSamples(stack, quadrature.wavelength_nm)}))
{}
SummedColours::SummedColours(SummedColours&&) noexcept = default;
SummedColours& SummedColours::operator=(SummedColours&&) noexcept = default;
SummedColours::~SummedColours() = default;

StackColour SummedColours::at(std::span<const double> thickness_nm, const ObliqueLight& light)
{
    const detail::PowerSamples power = work_->samples.power(thickness_nm, light);
    return {.reflectance = quadrature_sum(work_->quadrature, power.R),
            .transmittance = quadrature_sum(work_->quadrature, power.T),
            .evaluations = work_->samples.size()};
}

struct AdaptiveColours::Work {
    Work(DispersiveStack stack_, const spectral::ColourWeights& weights_)
        : stack(std::move(stack_)),
          weights(weights_),
          band_weights(weights_),
          band(band_weights.first_nm(), band_weights.last_nm()),
          rows(band, band_weights),
          coherent(std::ranges::find(stack.coherent, false) == stack.coherent.end())
    {
        if (!coherent) return;
        (void)at_nodes(2);  // says which medium has no data
        const std::set<spectral::OpticalConstantsPtr> media(stack.media.begin(), stack.media.end());
        for (const auto& medium : media)
            nodes_for_media =
                std::max(nodes_for_media, more_nodes_for(*medium, band, band_weights));
    }

    DispersiveStack stack;
    spectral::ColourWeights weights;
    detail::BandWeights band_weights;
    detail::WavenumberBand band;
    detail::ChebyshevRows rows;
    bool coherent;
    std::size_t nodes_for_media = 0;
    std::map<std::size_t, StackSamples> samples;  ///< by the number of nodes
    std::map<int, SummedColours> summed_at;       ///< by wavelengths in a nanometre

    const StackSamples& at_nodes(std::size_t count);
    std::optional<StackColour> interpolated(std::size_t count, std::span<const double> thickness_nm,
                                            const ObliqueLight& light);
    StackColour summed(double kappa, std::span<const double> thickness_nm,
                       const ObliqueLight& light);
    StackColour solve(std::span<const double> thickness_nm, const ObliqueLight& light);
};

AdaptiveColours::AdaptiveColours(DispersiveStack stack, const spectral::ColourWeights& weights)
    : work_(std::make_unique<Work>(std::move(stack), weights))
{}
AdaptiveColours::AdaptiveColours(AdaptiveColours&&) noexcept = default;
AdaptiveColours& AdaptiveColours::operator=(AdaptiveColours&&) noexcept = default;
AdaptiveColours::~AdaptiveColours() = default;

const StackSamples& AdaptiveColours::Work::at_nodes(std::size_t count)
{
    const auto found = samples.find(count);
    if (found != samples.end()) return found->second;
    return samples.emplace(count, StackSamples(stack, band.nodes_nm(count))).first->second;
}

/// Nothing where the series has not converged, or has no amplitudes.
std::optional<StackColour> AdaptiveColours::Work::interpolated(std::size_t count,
                                                               std::span<const double> thickness_nm,
                                                               const ObliqueLight& light)
{
    const auto amplitudes = at_nodes(count).amplitudes(thickness_nm, light.cos_ambient);
    if (amplitudes[0].a.empty()) return std::nullopt;
    StackColour colour{};
    double doubt = 0.0;
    for (std::size_t p = 0; p < 2; ++p) {
        const double share = p == 0 ? light.share_of_s : 1.0 - light.share_of_s;
        if (share == 0.0) continue;
        const BandSums sums = AmplitudeSeries(amplitudes[p]).sums(band, band_weights, rows);
        for (std::size_t c = 0; c < 3; ++c) {
            colour.reflectance[c] += share * sums.reflectance[c];
            colour.transmittance[c] += share * sums.transmittance[c];
        }
        doubt += share * sums.doubt;
    }
    if (!(doubt <= kLargestDoubt)) return std::nullopt;
    return colour;
}

/// Every nanometre, or at more wavelengths where fringes are finer than that.
StackColour AdaptiveColours::Work::summed(double kappa, std::span<const double> thickness_nm,
                                          const ObliqueLight& light)
{
    const double turn = 4.0 * kappa / (band.last_nm() - band.first_nm());
    const int steps =
        static_cast<int>(std::ceil(std::clamp(turn / kLargestTurn, 1.0, 1.0 / kFinestStepNm)));
    auto found = summed_at.find(steps);
    if (found == summed_at.end()) {
        const auto quadrature =
            steps == 1 ? nanometre_quadrature(weights) : fine_quadrature(weights, 1.0 / steps);
        found = summed_at.emplace(steps, SummedColours(stack, quadrature)).first;
    }
    return found->second.at(thickness_nm, light);
}

StackColour AdaptiveColours::Work::solve(std::span<const double> thickness_nm,
                                         const ObliqueLight& light)
{
    if (!coherent) return summed(0.0, thickness_nm, light);
    const detail::StackSamples::Passage ends = at_nodes(2).passage(thickness_nm, light.cos_ambient);
    const double difference = std::abs(ends.phase.front().real() - ends.phase.back().real());
    const double kappa = difference < kLargestPhase ? 0.5 * difference : kLargestPhase;
    double count = nodes_for(kappa, ends.contrast) + static_cast<double>(nodes_for_media);
    std::size_t evaluations = 0;
    for (int i = 0; i < kMostTries && count <= kMostNodes; ++i, count = more_nodes(count)) {
        const auto nodes = static_cast<std::size_t>(count);
        evaluations += nodes;
        if (auto colour = interpolated(nodes, thickness_nm, light)) {
            colour->evaluations = evaluations;
            return *colour;
        }
    }
    StackColour colour = summed(kappa, thickness_nm, light);
    colour.evaluations += evaluations;
    return colour;
}

StackColour AdaptiveColours::at(std::span<const double> thickness_nm, const ObliqueLight& light)
{
    assert(thickness_nm.size() == work_->stack.coherent.size());
    return work_->solve(thickness_nm, light);
}

}  // namespace nacre::optics
