// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "lanes/angled_stack.h"

#include <algorithm>

namespace nacre::optics::detail {
namespace {

bool equal(const ComplexLanes& a, const ComplexLanes& b)
{
    return a.re == b.re && a.im == b.im;
}

bool is_zero(const Lanes& lanes)
{
    return std::all_of(lanes.begin(), lanes.end(), [](double value) { return value == 0.0; });
}

void set_to_nothing(LaneTrip& trip)
{
    trip.E.re.fill(1.0);
    trip.E.im.fill(0.0);
    trip.share.fill(1.0);
}

}  // namespace

AngledStack::AngledStack(const LaneStack& stack)
    : n_0_(stack.n_0),
      n_above_(stack.above),
      n_below_(stack.below),
      starts_in_ambient_(n_above_.re == n_0_ && is_zero(n_above_.im))
{
    std::vector<const ComplexLanes*> order{&stack.above}, known;
    for (const LaneLayer& layer : stack.layers) order.push_back(&layer.n);
    order.push_back(&stack.below);

    for (const ComplexLanes* n : order) medium_of_.push_back(keep_medium(stack, known, *n));
    ratios_.resize(order.size() - 1);
    for (std::size_t j = 0; j < ratios_.size(); ++j)
        prepare_interface(ratios_[j], *order[j], *order[j + 1]);
    for (std::size_t j = 0; j < stack.layers.size(); ++j)
        passage_of_.push_back(keep_passage(medium_of_[j + 1], stack.layers[j].waves));
    roots_.resize(media_.size());
    if (starts_in_ambient_) prepare_ambient_root(roots_[0]);
    gather_loads(stack);

    ComplexLanes one;
    one.re.fill(1.0);
    one.im.fill(0.0);
    prepare_interface(over_square_above_, one, n_above_);
    prepare_interface(over_square_below_, one, n_below_);
}

std::size_t AngledStack::keep_medium(const LaneStack& stack,
                                     std::vector<const ComplexLanes*>& known, const ComplexLanes& n)
{
    for (std::size_t m = 0; m < known.size(); ++m)
        if (equal(*known[m], n)) return m;
    known.push_back(&n);
    prepare_medium(media_.emplace_back(), n, stack.n_0);
    return known.size() - 1;
}

std::size_t AngledStack::keep_passage(std::size_t medium, const Lanes& waves)
{
    for (std::size_t p = 0; p < passages_.size(); ++p)
        if (passages_[p].medium == medium && passages_[p].waves == waves) return p;
    passages_.push_back({medium, waves});
    return passages_.size() - 1;
}

void AngledStack::gather_loads(const LaneStack& stack)
{
    loads_.resize(media_.size());
    for (MediumLoad& load : loads_) load.waves.fill(0.0);
    for (std::size_t j = 0; j < stack.layers.size(); ++j) {
        MediumLoad& load = loads_[medium_of_[j + 1]];
        load.layers += 1.0;
        for (std::size_t i = 0; i < kLanes; ++i) load.waves[i] += stack.layers[j].waves[i];
    }
    for (std::size_t m = 0; m < loads_.size(); ++m)
        if (loads_[m].layers > 0) loaded_.push_back(m);
}

void AngledStack::turn_to(const Lanes& cos_0)
{
    if (starts_in_ambient_) find_ambient_root(roots_[0], n_0_, cos_0);
    for (std::size_t m = starts_in_ambient_ ? 1 : 0; m < media_.size(); ++m)
        find_root(roots_[m], media_[m], n_0_, cos_0);
}

void AngledStack::find_trips(std::vector<LaneTrip>& trips, double factor) const
{
    if (trips.size() != passages_.size() + 1) {
        trips.resize(passages_.size() + 1);
        set_to_nothing(trips.back());
    }
    for (std::size_t p = 0; p < passages_.size(); ++p)
        find_trip(trips[p], roots_[passages_[p].medium], passages_[p].waves, factor);
}

void AngledStack::find_half_trips(std::vector<ComplexLanes>& half_trips) const
{
    half_trips.resize(passages_.size());
    for (std::size_t p = 0; p < passages_.size(); ++p)
        find_half_trip(half_trips[p], roots_[passages_[p].medium], passages_[p].waves);
}

std::vector<const ComplexLanes*> AngledStack::half_trips_of(
    const std::vector<ComplexLanes>& half_trips) const
{
    std::vector<const ComplexLanes*> result{nullptr};
    for (const std::size_t passage : passage_of_) result.push_back(&half_trips[passage]);
    return result;
}

void AngledStack::find_trip_of(std::size_t layer, std::vector<LaneTrip>& trips,
                               const Lanes& waves) const
{
    find_trip(trips[passage_of_[layer]], roots_[medium_of_[layer + 1]], waves, 1.0);
}

std::vector<Crossing> AngledStack::crossings(const std::vector<LaneTrip>& trips, std::size_t first,
                                             std::size_t last) const
{
    std::vector<Crossing> result;
    for (std::size_t j = first; j < last; ++j)
        result.push_back({.q_1 = &q(j),
                          .q_2 = &q(j + 1),
                          .ratio = &ratios_[j],
                          .trip = j == first ? &trips.back() : &trips[passage_of_[j - 1]]});
    return result;
}

void AngledStack::doubt(Lanes& out) const
{
    if (loaded_.size() == 1) {
        set_doubt(out, roots_[loaded_[0]], loads_[loaded_[0]]);
        return;
    }
    Lanes squares;
    out.fill(0.0);
    squares.fill(0.0);
    for (const std::size_t m : loaded_) add_doubt(out, squares, roots_[m], loads_[m]);
    // Of up to nine the sum is never more than three times the root of the sum of squares.
    constexpr std::size_t kMostUnlimited = 9;
    if (loaded_.size() > kMostUnlimited) limit_doubt(out, squares);
}

}  // namespace nacre::optics::detail
