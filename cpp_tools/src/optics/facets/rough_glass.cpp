// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/rough_glass.h"

#include <algorithm>
#include <cmath>

#include "facets/facet_view.h"

namespace nacre::optics {
namespace {

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

}  // namespace

GlassFacets glass_facets(const GlassView& view, std::size_t columns)
{
    const double eta = view.inside ? 1.0 / view.index : view.index;
    const FacetView facets(view.cos_theta, view.alpha);
    const double mu = facets.cosine(), share = 1.0 / facets.points();
    const std::vector<double> none(columns);
    GlassFacets result{.met = none, .reflected = none, .passed = none};
    facets.visit([&](const Vector& facet, double cosine) {
        const double refracted = refracted_cosine(cosine, eta);
        const double up = share * facets.leaving(2.0 * cosine * facet[2] - mu);
        // The refracted direction is (cosine / eta − refracted) facet − toward / eta.
        const double down =
            refracted > 0.0
                ? share * facets.leaving(mu / eta - (cosine / eta - refracted) * facet[2])
                : 0.0;
        const double x = view.inside ? refracted : cosine;
        add_between(result.met, x, share);
        add_between(result.reflected, x, up);
        add_between(result.passed, x, down);
        const double F = unpolarised_fresnel(cosine, refracted, eta);
        result.mirror += up;
        result.window += down;
        result.clear_mirror += F * up;
        result.clear_window += (1.0 - F) * down;
    });
    return result;
}

}  // namespace nacre::optics
