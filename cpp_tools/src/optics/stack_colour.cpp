// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/stack_colour.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "amplitude_series.h"

namespace nacre::optics {
namespace {

using detail::AmplitudeSeries;
using detail::BandSums;
using detail::StackSamples;
using spectral::Vec3;

/// What the last two terms may contribute to R or T in the mean: ten times what the missing ones do
/// where the series converges as fast as that of an exponential.
constexpr double kLargestDoubt = 3e-3;
/// Beyond it the sum at 1 nm costs no more.
constexpr std::size_t kMostNodes = 130;

/// A phase of ±κ over the band needs κ terms, and a few times κ^⅓ until they fall off (the Bessel
/// functions that are the coefficients of e^{iκx}), by about a factor e each; at a resonance a is
/// smaller than elsewhere, which takes as many more as the contrast has powers of e. The constants
/// are those with which films and etalons meet kLargestDoubt at once.
std::size_t nodes_for(double kappa, double contrast)
{
    return static_cast<std::size_t>(std::ceil(4.0 + kappa + 1.5 * std::cbrt(kappa) + contrast));
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

std::size_t more_nodes(std::size_t count)
{
    return count + std::max<std::size_t>(4, count / 2);
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
    std::optional<SummedColours> every_nanometre;

    const StackSamples& at_nodes(std::size_t count);
    std::size_t first_count(std::span<const double> thickness_nm, double cos_ambient);
    std::optional<StackColour> interpolated(std::size_t count, std::span<const double> thickness_nm,
                                            const ObliqueLight& light);
    StackColour summed(std::span<const double> thickness_nm, const ObliqueLight& light);
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

std::size_t AdaptiveColours::Work::first_count(std::span<const double> thickness_nm,
                                               double cos_ambient)
{
    const auto ends = at_nodes(2).passage(thickness_nm, cos_ambient);
    const double kappa = 0.5 * std::abs(ends.phase.front().real() - ends.phase.back().real());
    return nodes_for(kappa, ends.contrast) + nodes_for_media;
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

StackColour AdaptiveColours::Work::summed(std::span<const double> thickness_nm,
                                          const ObliqueLight& light)
{
    if (!every_nanometre) every_nanometre.emplace(stack, nanometre_quadrature(weights));
    return every_nanometre->at(thickness_nm, light);
}

StackColour AdaptiveColours::at(std::span<const double> thickness_nm, const ObliqueLight& light)
{
    assert(thickness_nm.size() == work_->stack.coherent.size());
    std::size_t evaluations = 0;
    std::optional<StackColour> colour;
    if (work_->coherent)
        for (std::size_t count = work_->first_count(thickness_nm, light.cos_ambient);
             !colour && count <= kMostNodes; count = more_nodes(count)) {
            colour = work_->interpolated(count, thickness_nm, light);
            evaluations += count;
        }
    if (!colour) {
        colour = work_->summed(thickness_nm, light);
        evaluations += colour->evaluations;
    }
    colour->evaluations = evaluations;
    return *colour;
}

}  // namespace nacre::optics
