// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/microfacet.h"

#include <algorithm>
#include <cmath>

#include "facets/facet_view.h"

namespace nacre::optics {
namespace {

/// Calls visit(cosine at the facet, share of the light that gets out) for points of equal weight.
template <class Visit>
void visit_facets(const FacetView& view, Visit&& visit)
{
    view.visit([&](const Vector& facet, double cosine) {
        visit(cosine, view.leaving(2.0 * cosine * facet[2] - view.cosine()));
    });
}

}  // namespace

double facet_weights(double cos_theta, double alpha, std::span<double> weights)
{
    std::ranges::fill(weights, 0.0);
    double sum = 0.0;
    const FacetView view(cos_theta, alpha);
    visit_facets(view, [&](double cosine, double share) {
        add_between(weights, cosine, share);
        sum += share;
    });
    for (double& weight : weights) weight /= sum;
    return sum / view.points();
}

double ggx_albedo(double cos_theta, double alpha)
{
    double sum = 0.0;
    const FacetView view(cos_theta, alpha);
    visit_facets(view, [&sum](double, double share) { sum += share; });
    return sum / view.points();
}

}  // namespace nacre::optics
