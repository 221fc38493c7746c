// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/rough_glass.h"

#include <algorithm>
#include <cmath>

#include "nacre/optics/fresnel.h"
#include "nacre/optics/microfacet.h"
#include "visible_normals.h"

namespace nacre::optics {
namespace {

constexpr double kGrazingView = 1e-4;

/// Points of a midpoint rule, as in microfacet.cpp; flat facets are all alike.
struct FacetRule {
    int azimuths, polar;

    explicit FacetRule(double alpha) : azimuths(alpha > 0.0 ? 64 : 1), polar(alpha > 0.0 ? 256 : 1)
    {}
    [[nodiscard]] double share() const { return 1.0 / (azimuths * polar); }
};

/// cos of the refracted light, relative index `eta` = n_t / n_i; 0 where all is reflected.
double refracted_cosine(double cosine, double eta)
{
    return std::sqrt(std::max(0.0, 1.0 - (1.0 - cosine * cosine) / (eta * eta)));
}

double unpolarised_fresnel(double cosine, double refracted, double eta)
{
    if (refracted == 0.0) return 1.0;
    const double s = (cosine - eta * refracted) / (cosine + eta * refracted);
    const double p = (eta * cosine - refracted) / (eta * cosine + refracted);
    return 0.5 * (s * s + p * p);
}

/// A share between the two nearest columns.
void add(std::vector<double>& weights, double x, double share)
{
    const std::size_t i = std::min(static_cast<std::size_t>(x), weights.size() - 2);
    const double t = x - static_cast<double>(i);
    weights[i] += (1.0 - t) * share;
    weights[i + 1] += t * share;
}

}  // namespace

GlassFacets glass_facets(const GlassView& view, std::size_t columns)
{
    const double mu = std::clamp(view.cos_theta, kGrazingView, 1.0);
    const double eta = view.inside ? 1.0 / view.index : view.index;
    const Vector toward{std::sqrt(1.0 - mu * mu), 0.0, mu};
    const double seen = 1.0 + smith_lambda(mu, view.alpha);
    const FacetRule rule(view.alpha);
    const double share = rule.share();
    const auto leaving = [&](double up) {
        return up > 0.0 ? share * seen / (seen + smith_lambda(up, view.alpha)) : 0.0;
    };
    const std::vector<double> none(columns);
    GlassFacets result{.met = none, .reflected = none, .passed = none};
    for (int i = 0; i < rule.azimuths; ++i)
        for (int j = 0; j < rule.polar; ++j) {
            const Vector facet =
                visible_normal(toward, {view.alpha, view.alpha}, (i + 0.5) / (2.0 * rule.azimuths),
                               (j + 0.5) / rule.polar);
            const double cosine = std::clamp(dot(toward, facet), 0.0, 1.0);
            const double refracted = refracted_cosine(cosine, eta);
            const double up = leaving(2.0 * cosine * facet[2] - mu);
            // The refracted direction is (cosine / eta − refracted) facet − toward / eta.
            const double down =
                refracted > 0.0 ? leaving(mu / eta - (cosine / eta - refracted) * facet[2]) : 0.0;
            const double x = (view.inside ? refracted : cosine) * static_cast<double>(columns - 1);
            add(result.met, x, share);
            add(result.reflected, x, up);
            add(result.passed, x, down);
            const double F = unpolarised_fresnel(cosine, refracted, eta);
            result.mirror += up;
            result.window += down;
            result.clear_mirror += F * up;
            result.clear_window += (1.0 - F) * down;
        }
    return result;
}

}  // namespace nacre::optics
