// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/stack_batch.h"

#include "lanes/angled_stack.h"

namespace nacre::optics {

using detail::AngledStack;
using detail::Crossing;
using detail::LaneFields;
using detail::LaneTrip;

struct PreparedStack::Work {
    AngledStack stack;
    std::vector<LaneTrip> trips;
    std::vector<Crossing> crossings;
    std::vector<ComplexLanes> half_trips;
    LaneFields fields;

    explicit Work(const LaneStack& lanes) : stack(lanes)
    {
        stack.find_trips(trips, 0.0);
        crossings = stack.crossings(trips, 0, stack.layers() + 1);
    }

    void solve(const Lanes& cos_0)
    {
        stack.turn_to(cos_0);
        stack.find_trips(trips, 1.0);
        carry_down_wave(fields, crossings);
    }
};

PreparedStack::PreparedStack(const LaneStack& stack) : work_(std::make_unique<Work>(stack)) {}
PreparedStack::PreparedStack(PreparedStack&&) noexcept = default;
PreparedStack& PreparedStack::operator=(PreparedStack&&) noexcept = default;
PreparedStack::~PreparedStack() = default;

void PreparedStack::power(const Lanes& cos_0, BatchPower& out)
{
    work_->solve(cos_0);
    work_->stack.doubt(out.doubt);
    finish_power(out.s, out.p, out.doubt, work_->fields, work_->stack.ends());
}

void PreparedStack::respond(const Lanes& cos_0, BatchPower& power, BatchAmplitudes& amplitudes)
{
    this->power(cos_0, power);
    ComplexLanes phase;
    work_->stack.find_half_trips(work_->half_trips);
    gather_phase(phase, work_->crossings, work_->stack.half_trips_of(work_->half_trips));
    finish_amplitudes(amplitudes.s, amplitudes.p, work_->fields, phase, work_->stack.ends());
}

void stack_batch(const LaneStack& stack, BatchPower& power)
{
    PreparedStack(stack).power(stack.cos_0, power);
}

void stack_batch(const LaneStack& stack, BatchPower& power, BatchAmplitudes& amplitudes)
{
    PreparedStack(stack).respond(stack.cos_0, power, amplitudes);
}

ScaledStack::ScaledStack(const LaneStack& stack) : stack_(std::make_unique<AngledStack>(stack))
{
    turn_to(stack.cos_0);
}
ScaledStack::ScaledStack(ScaledStack&&) noexcept = default;
ScaledStack& ScaledStack::operator=(ScaledStack&&) noexcept = default;
ScaledStack::~ScaledStack() = default;

void ScaledStack::turn_to(const Lanes& cos_0)
{
    stack_->turn_to(cos_0);
}

void ScaledStack::march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const
{
    std::vector<LaneTrip> trips, steps;
    stack_->find_trips(trips, first);
    stack_->find_trips(steps, step);
    const std::vector<Crossing> crossings = stack_->crossings(trips, 0, stack_->layers() + 1);
    LaneFields fields;
    BatchPower power;
    power.doubt.fill(0.0);
    for (std::size_t row = 0; row < R.size(); ++row) {
        carry_down_wave(fields, crossings);
        finish_power(power.s, power.p, power.doubt, fields, stack_->ends());
        for (std::size_t i = 0; i < kLanes; ++i) {
            R[row][i] = 0.5 * (power.s.R[i] + power.p.R[i]);
            T[row][i] = 0.5 * (power.s.T[i] + power.p.T[i]);
        }
        for (std::size_t t = 0; t < trips.size(); ++t) add_trip(trips[t], steps[t]);
    }
}

namespace {

/// Roots, ratios and trips of a march in single precision, where crossings point to.
class SingleMarch {
public:
    SingleMarch(const AngledStack& stack, double first, double step)
    {
        std::vector<LaneTrip> trips;
        stack.find_trips(trips, first);
        const std::vector<Crossing> crossings = stack.crossings(trips, 0, stack.layers() + 1);
        trips_ = in_single(trips);
        keep_media(crossings);
        for (std::size_t j = 0; j < crossings.size(); ++j)
            crossings_.push_back(
                {.q_1 = &q_[j],
                 .q_2 = &q_[j + 1],
                 .ratio = &ratios_[j],
                 .trip = &trips_[static_cast<std::size_t>(crossings[j].trip - trips.data())]});
        stack.find_trips(trips, step);
        steps_ = in_single(trips);
        detail::MeanScales scales;
        find_mean_scales(scales, stack.ends());
        scale_s_ = detail::in_single(scales.s);
        scale_p_ = detail::in_single(scales.p);
    }

    void row(SingleLanes& R, SingleLanes& T)
    {
        carry_down_wave(fields_, crossings_);
        finish_mean(R, T, fields_, scale_s_, scale_p_);
        for (std::size_t t = 0; t < trips_.size(); ++t) add_trip(trips_[t], steps_[t]);
    }

private:
    static std::vector<detail::TripOf<float>> in_single(const std::vector<LaneTrip>& trips)
    {
        std::vector<detail::TripOf<float>> result;
        result.reserve(trips.size());
        for (const LaneTrip& trip : trips)
            result.push_back({detail::in_single(trip.E), detail::in_single(trip.share)});
        return result;
    }
    void keep_media(const std::vector<Crossing>& crossings)
    {
        q_.push_back(detail::in_single(*crossings.front().q_1));
        for (const Crossing& crossing : crossings) {
            q_.push_back(detail::in_single(*crossing.q_2));
            ratios_.push_back(detail::in_single(*crossing.ratio));
        }
    }

    std::vector<detail::TripOf<float>> trips_, steps_;
    std::vector<ComplexLanesOf<float>> q_, ratios_;
    std::vector<detail::CrossingOf<float>> crossings_;
    detail::FieldsOf<float> fields_;
    SingleLanes scale_s_, scale_p_;
};

}  // namespace

void ScaledStack::march(double first, double step, std::span<SingleLanes> R,
                        std::span<SingleLanes> T) const
{
    SingleMarch march(*stack_, first, step);
    for (std::size_t row = 0; row < R.size(); ++row) march.row(R[row], T[row]);
}

}  // namespace nacre::optics
