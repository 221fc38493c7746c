// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "facets/visible_normals.h"
#include "nacre/optics/smith.h"

namespace nacre::optics {

/// The facets that a view sees, as points of equal weight: a midpoint rule over the two random
/// numbers of visible_normal(), whose azimuth needs one half of the circle. Flat facets are all
/// alike.
class FacetView {
public:
    FacetView(double cos_theta, double alpha)
        : cosine_(std::clamp(cos_theta, kGrazing, 1.0)),
          alpha_(alpha),
          toward_{std::sqrt(1.0 - cosine_ * cosine_), 0.0, cosine_},
          seen_(1.0 + smith_lambda(cosine_, alpha)),
          azimuths_(alpha > 0.0 ? kAzimuths : 1),
          polar_(alpha > 0.0 ? kPolar : 1)
    {}

    [[nodiscard]] double cosine() const { return cosine_; }
    [[nodiscard]] double points() const { return static_cast<double>(azimuths_ * polar_); }

    /// What shadowing, correlated in height, leaves of light in a direction that rises so steeply.
    [[nodiscard]] double leaving(double up) const
    {
        return up > 0.0 ? seen_ / (seen_ + smith_lambda(up, alpha_)) : 0.0;
    }

    /// Calls visit(facet, its cosine with the view).
    template <class Visit>
    void visit(Visit&& visit) const
    {
        const VisibleNormals normals(toward_, {alpha_, alpha_});
        std::array<VisibleNormals::Height, kPolar> heights;
        for (std::size_t j = 0; j < polar_; ++j)
            heights[j] =
                normals.height((static_cast<double>(j) + 0.5) / static_cast<double>(polar_));
        for (std::size_t i = 0; i < azimuths_; ++i) {
            const auto to = VisibleNormals::direction((static_cast<double>(i) + 0.5) /
                                                      (2.0 * static_cast<double>(azimuths_)));
            for (std::size_t j = 0; j < polar_; ++j) {
                const Vector facet = normals.at(to, heights[j]);
                visit(facet, std::clamp(dot(toward_, facet), 0.0, 1.0));
            }
        }
    }

private:
    static constexpr double kGrazing = 1e-4;
    static constexpr std::size_t kAzimuths = 64, kPolar = 256;

    double cosine_, alpha_;
    Vector toward_;
    double seen_;
    std::size_t azimuths_, polar_;
};

/// Adds a share between the two weights that `x` in [0, 1], from the first to the last, lies
/// nearest.
inline void add_between(std::span<double> weights, double x, double share)
{
    const double at = x * static_cast<double>(weights.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(at), weights.size() - 2);
    const double t = at - static_cast<double>(i);
    weights[i] += (1.0 - t) * share;
    weights[i + 1] += t * share;
}

}  // namespace nacre::optics
