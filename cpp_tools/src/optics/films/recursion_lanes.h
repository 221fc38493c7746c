// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "lanes/lane_fields.h"
#include "nacre/optics/lanes.h"

namespace nacre::optics::detail {

/// `recursion_power` of film_models.h in lanes, unpolarised.
class RecursionLanes {
public:
    /// @param varying  layer whose thickness march() changes
    RecursionLanes(const LaneStack& stack, std::optional<std::size_t> varying);

    void turn_to(const Lanes& cos_0);
    /// At thicknesses over wavelength of the varying layer.
    void march(const Lanes& first, const Lanes& step, std::span<Lanes> R, std::span<Lanes> T) const;
    /// At factors on every thickness.
    void march_all(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const;

    /// Coefficients of one polarisation.
    struct Faces {
        std::vector<ComplexLanes> r;  ///< of each interface, from the top
        Lanes passed;                 ///< |product of all t|² times the ratio of the fluxes
    };

private:
    LaneStack stack_;
    std::size_t varying_;
    std::vector<LaneRoot> roots_;  ///< n cosθ of each layer
    Faces s_, p_;

    void turn_lane(std::size_t lane, double cos_0);
    void march_trips(std::vector<LaneTrip>& trips, std::span<const LaneTrip> steps,
                     std::size_t first_moving, std::span<Lanes> R, std::span<Lanes> T) const;
};

}  // namespace nacre::optics::detail
