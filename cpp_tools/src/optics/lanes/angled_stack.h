// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "lanes/lane_fields.h"

namespace nacre::optics::detail {

/// 32 stacks and what their media make of one angle; equal media and equal layers are kept once.
class AngledStack {
public:
    /// Without an angle.
    explicit AngledStack(const LaneStack& stack);

    void turn_to(const Lanes& cos_0);

    /// Passages of the layers at `factor` times their thickness; the last one is through
    /// nothing.
    void find_trips(std::vector<LaneTrip>& trips, double factor) const;
    /// e^{iδ} of the passages, at their thickness.
    void find_half_trips(std::vector<ComplexLanes>& half_trips) const;
    /// Those above each of all crossings; null above the first.
    [[nodiscard]] std::vector<const ComplexLanes*> half_trips_of(
        const std::vector<ComplexLanes>& half_trips) const;
    /// The passage of one layer, which shares it with no other, at another thickness.
    void find_trip_of(std::size_t layer, std::vector<LaneTrip>& trips, const Lanes& waves) const;
    /// Interfaces first … last − 1, counted from the ambient's; above interface j > `first` lies
    /// layer j − 1. What lies above the first is not passed through.
    [[nodiscard]] std::vector<Crossing> crossings(const std::vector<LaneTrip>& trips,
                                                  std::size_t first, std::size_t last) const;

    [[nodiscard]] std::size_t layers() const { return passage_of_.size(); }
    [[nodiscard]] const ComplexLanes& q(std::size_t medium) const
    {
        return roots_[medium_of_[medium]].q;
    }
    [[nodiscard]] LaneEnds ends() const
    {
        return {.n_above = &n_above_,
                .n_below = &n_below_,
                .q_above = &q(0),
                .q_below = &q(layers() + 1),
                .over_square_above = &over_square_above_,
                .over_square_below = &over_square_below_};
    }
    void doubt(Lanes& out) const;

private:
    struct Passage {
        std::size_t medium;
        Lanes waves;
    };

    std::size_t keep_medium(const LaneStack& stack, std::vector<const ComplexLanes*>& known,
                            const ComplexLanes& n);
    std::size_t keep_passage(std::size_t medium, const Lanes& waves);
    void gather_loads(const LaneStack& stack);

    Lanes n_0_;
    ComplexLanes n_above_, n_below_, over_square_above_, over_square_below_;
    bool starts_in_ambient_;  ///< the half-space above is the medium in which angles are given
    std::vector<LaneMedium> media_;
    std::vector<std::size_t> medium_of_;  ///< ambient, layers, substrate
    std::vector<ComplexLanes> ratios_;    ///< of each interface
    std::vector<Passage> passages_;
    std::vector<std::size_t> passage_of_;  ///< of each layer
    std::vector<LaneRoot> roots_;          ///< of media_
    std::vector<MediumLoad> loads_;        ///< of media_
    std::vector<std::size_t> loaded_;      ///< media that layers are made of
};

}  // namespace nacre::optics::detail
