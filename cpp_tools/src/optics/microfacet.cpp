// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/microfacet.h"

#include <algorithm>
#include <cmath>

#include "visible_normals.h"

namespace nacre::optics {
namespace {

constexpr double kGrazing = 1e-4;

// A midpoint rule over the two random numbers of a sampler; the azimuth needs one half of the
// circle.
constexpr int kAzimuths = 64, kPolar = 256;

/// Calls visit(cosine at the facet, share of the light that gets out) for points of equal weight.
template <class Visit>
void visit_facets(double cos_theta, double alpha, Visit&& visit)
{
    const double mu = std::clamp(cos_theta, kGrazing, 1.0);
    const Vector view{std::sqrt(1.0 - mu * mu), 0.0, mu};
    const double seen = 1.0 + smith_lambda(mu, alpha);
    for (int i = 0; i < kAzimuths; ++i)
        for (int j = 0; j < kPolar; ++j) {
            const Vector facet = visible_normal(view, {alpha, alpha}, (i + 0.5) / (2.0 * kAzimuths),
                                                (j + 0.5) / kPolar);
            const double cosine = dot(view, facet);
            const double up = 2.0 * cosine * facet[2] - mu;
            visit(std::clamp(cosine, 0.0, 1.0),
                  up > 0.0 ? seen / (seen + smith_lambda(up, alpha)) : 0.0);
        }
}

constexpr double kPoints = kAzimuths * kPolar;

}  // namespace

double smith_lambda(double cos_theta, double alpha) noexcept
{
    const double squared = std::max(cos_theta * cos_theta, 1e-12);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * (1.0 - squared) / squared) - 1.0);
}

double facet_weights(double cos_theta, double alpha, std::span<double> weights)
{
    std::ranges::fill(weights, 0.0);
    double sum = 0.0;
    const std::size_t last = weights.size() - 1;
    visit_facets(cos_theta, alpha, [&](double cosine, double share) {
        const double x = cosine * static_cast<double>(last);
        const std::size_t i = std::min(static_cast<std::size_t>(x), last - 1);
        const double t = x - static_cast<double>(i);
        weights[i] += (1.0 - t) * share;
        weights[i + 1] += t * share;
        sum += share;
    });
    for (double& weight : weights) weight /= sum;
    return sum / kPoints;
}

double ggx_albedo(double cos_theta, double alpha)
{
    double sum = 0.0;
    visit_facets(cos_theta, alpha, [&sum](double, double share) { sum += share; });
    return sum / kPoints;
}

}  // namespace nacre::optics
