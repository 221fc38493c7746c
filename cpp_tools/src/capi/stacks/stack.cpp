// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "base/guard.h"
#include "nacre/optics/multilayer.h"
#include "nacre/optics/stack_batch.h"
#include "stacks/stack_call.h"

namespace nacre::capi {
namespace {

using optics::kLanes;
using optics::Lanes;
using optics::Polarisation;

/// Cosines in extended precision before they are rounded: near 90° nothing is lost.
void work_out_cosines(Stacks& in)
{
    constexpr long double radians = std::numbers::pi_v<long double> / 180;
    every_element(in.shape, in.steps(in.angle_deg), [&in](std::size_t i) {
        const auto degrees = static_cast<long double>(in.angle_deg.values[i]);
        in.cosines.push_back(static_cast<double>(std::cos(degrees * radians)));
        return true;
    });
}

void store_power(const Stacks& in, std::size_t item, const optics::PowerRatios& power)
{
    in.power[3 * item] = power.R;
    in.power[3 * item + 1] = power.T;
    in.power[3 * item + 2] = power.A;
}

/// Of `count` items that follow each other.
void store_powers(const Stacks& in, std::size_t first, const Lanes& R, const Lanes& T,
                  std::size_t count)
{
    double* out = in.power + 3 * first;
    for (std::size_t i = 0; i < count; ++i, out += 3) {
        out[0] = R[i];
        out[1] = T[i];
        out[2] = 1.0 - R[i] - T[i];
    }
}

void store_amplitudes(const Stacks& in, std::size_t item, Complex r, Complex t)
{
    double* out = in.amplitudes + 4 * item;
    out[0] = r.real();
    out[1] = r.imag();
    out[2] = t.real();
    out[3] = t.imag();
}

void solve_one(const Stacks& in, const Item& item, std::size_t number)
{
    optics::FilmStack stack = film_stack(in, item);
    if (in.coherence.bandwidth_nm > 0.0)
        stack = seen_in_band(std::move(stack), in.coherence.bandwidth_nm, item.wavelength_nm);
    if (in.polarisation == NACRE_UNPOLARISED) {
        store_power(in, number, stack_power_unpolarised(stack, item.cosine, item.wavelength_nm));
        return;
    }
    const auto polarisation = in.polarisation == NACRE_S ? Polarisation::s : Polarisation::p;
    store_power(in, number, stack_power(stack, item.cosine, item.wavelength_nm, polarisation));
    if (in.amplitudes == nullptr) return;
    const auto [r, t] = stack_amplitudes(stack, item.cosine, item.wavelength_nm, polarisation);
    store_amplitudes(in, number, r, t);
}

void solve_absorption(const Stacks& in, const Item& item, std::size_t number)
{
    const optics::FilmStack stack = film_stack(in, item);
    double* out = in.absorption + in.layers * number;
    const auto of = [&](Polarisation polarisation) {
        return layer_absorption(stack, item.cosine, item.wavelength_nm, polarisation);
    };
    if (in.polarisation != NACRE_UNPOLARISED) {
        std::ranges::copy(of(in.polarisation == NACRE_S ? Polarisation::s : Polarisation::p), out);
        return;
    }
    std::ranges::transform(of(Polarisation::s), of(Polarisation::p), out,
                           [](double s, double p) { return 0.5 * (s + p); });
}

void set(optics::ComplexLanes& lanes, std::size_t i, Complex value)
{
    lanes.re[i] = value.real();
    lanes.im[i] = value.imag();
}

void set_stack(optics::LaneStack& stack, std::size_t i, const Item& item)
{
    stack.n_0[i] = item.index(0).real();
    set(stack.above, i, item.index(0));
    set(stack.below, i, item.index(stack.layers.size() + 1));
    for (std::size_t j = 0; j < stack.layers.size(); ++j) {
        set(stack.layers[j].n, i, item.index(j + 1));
        stack.layers[j].waves[i] = item.d_nm[j] / item.wavelength_nm;
    }
}

/// Lanes in double precision; an item whose result would lose more than this is computed again in
/// extended precision, so that every result is good to 1e-12.
constexpr double kDoubtAllowed = 4e-13;

/// Where one item has its results and its cosine.
struct Place {
    std::size_t item = 0, cosine = 0;
};
Place operator+(Place a, Place b)
{
    return {a.item + b.item, a.cosine + b.cosine};
}

/// Items of a grid in the order in which they are solved: 32 stacks side by side, and then the same
/// stacks at the next angle.
class GridOrder {
public:
    explicit GridOrder(const Stacks& in)
    {
        const auto only_angle_moves = [&in](std::size_t axis) {
            return in.n.steps[axis] == 0 && in.wavelength_nm.steps[axis] == 0 &&
                   in.d_nm.steps[axis] == 0;
        };
        split(in, only_angle_moves);
        // A few stacks would leave most lanes idle.
        if (stacks_.count < kLanes / 2) split(in, [](std::size_t) { return false; });
    }

    [[nodiscard]] std::size_t stacks() const { return stacks_.count; }
    [[nodiscard]] std::size_t angles() const { return angles_.count; }
    [[nodiscard]] Place stack(std::size_t index) const { return stacks_.place(index); }
    [[nodiscard]] Place angle(std::size_t index) const { return angles_.place(index); }

private:
    struct Axes {
        std::vector<std::size_t> lengths;
        std::vector<Place> steps;
        std::size_t count = 1;

        [[nodiscard]] Place place(std::size_t index) const
        {
            Place result;
            for (std::size_t axis = lengths.size(); axis-- > 0; index /= lengths[axis]) {
                const std::size_t i = index % lengths[axis];
                result = result + Place{i * steps[axis].item, i * steps[axis].cosine};
            }
            return result;
        }
    };

    template <class AnglesOnly>
    void split(const Stacks& in, AnglesOnly&& angles_only)
    {
        stacks_ = angles_ = {};
        std::size_t items = in.count;
        for (std::size_t axis = 0; axis < in.shape.size(); ++axis) {
            items /= in.shape[axis];
            Axes& axes = angles_only(axis) ? angles_ : stacks_;
            axes.lengths.push_back(in.shape[axis]);
            axes.steps.push_back({items, in.cosine_steps[axis]});
            axes.count *= in.shape[axis];
        }
    }

    Axes stacks_, angles_;
};

/// 32 stacks at several angles.
class BatchSolver {
public:
    BatchSolver(const Stacks& in, const GridOrder& order, std::size_t first)
        : in_(in), order_(order), count_(std::min(kLanes, order.stacks() - first))
    {
        optics::LaneStack stack;
        stack.layers.resize(in.layers);
        for (std::size_t i = 0; i < kLanes; ++i) {
            // Lanes past the end repeat the last one.
            lanes_[i] = order.stack(first + std::min(i, count_ - 1));
            set_stack(stack, i, *ItemCursor(in, lanes_[i].item));
            one_cosine_ = one_cosine_ && lanes_[i].cosine == lanes_[0].cosine;
            side_by_side_ = side_by_side_ && (i >= count_ || lanes_[i].item == lanes_[0].item + i);
        }
        stack_.emplace(stack);
    }

    void solve(std::size_t angle)
    {
        const Place at = order_.angle(angle);
        Lanes cos_0;
        if (one_cosine_)
            cos_0.fill(in_.cosines[lanes_[0].cosine + at.cosine]);
        else
            for (std::size_t i = 0; i < kLanes; ++i)
                cos_0[i] = in_.cosines[lanes_[i].cosine + at.cosine];
        if (in_.amplitudes == nullptr)
            stack_->power(cos_0, power_);
        else
            stack_->respond(cos_0, power_, amplitudes_);
        store(at);
    }

private:
    /// Of the polarisation that was asked for.
    const optics::LanePower& chosen_power()
    {
        if (in_.polarisation != NACRE_UNPOLARISED)
            return in_.polarisation == NACRE_S ? power_.s : power_.p;
        for (std::size_t i = 0; i < kLanes; ++i) {
            mean_.R[i] = 0.5 * (power_.s.R[i] + power_.p.R[i]);
            mean_.T[i] = 0.5 * (power_.s.T[i] + power_.p.T[i]);
        }
        return mean_;
    }

    void store(Place at)
    {
        const auto& [R, T] = chosen_power();
        if (side_by_side_)
            store_powers(in_, lanes_[0].item + at.item, R, T, count_);
        else
            for (std::size_t i = 0; i < count_; ++i)
                store_power(in_, lanes_[i].item + at.item,
                            {.R = R[i], .T = T[i], .A = 1.0 - R[i] - T[i]});
        if (in_.amplitudes != nullptr) {
            const auto& [r, t] = in_.polarisation == NACRE_S ? amplitudes_.s : amplitudes_.p;
            for (std::size_t i = 0; i < count_; ++i)
                store_amplitudes(in_, lanes_[i].item + at.item, {r.re[i], r.im[i]},
                                 {t.re[i], t.im[i]});
        }
        std::int64_t doubtful = 0;  // as wide as a double: whole vectors at a time
        for (const double doubt : power_.doubt) doubtful |= doubt > kDoubtAllowed ? 1 : 0;
        if (doubtful == 0) return;
        for (std::size_t i = 0; i < count_; ++i)
            if (power_.doubt[i] > kDoubtAllowed) {
                const std::size_t item = lanes_[i].item + at.item;
                solve_one(in_, *ItemCursor(in_, item), item);
            }
    }

    const Stacks& in_;
    const GridOrder& order_;
    std::size_t count_;
    std::array<Place, kLanes> lanes_{};
    bool one_cosine_ = true;    ///< all lanes are at the same angle
    bool side_by_side_ = true;  ///< their results follow each other
    std::optional<optics::PreparedStack> stack_;
    optics::BatchPower power_;
    optics::LanePower mean_;
    optics::BatchAmplitudes amplitudes_;
};

template <class Solve>
void one_by_one(const Stacks& in, Solve&& solve_item)
{
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, in.count, 16), [&](const auto& range) {
        ItemCursor cursor(in, range.begin());
        for (std::size_t item = range.begin(); item < range.end(); ++item, cursor.advance())
            solve_item(in, *cursor, item);
    });
}

/// Each item has a place of its own in the results, so that threads do not meet.
void solve(const Stacks& in)
{
    if (in.absorption != nullptr) one_by_one(in, solve_absorption);
    if (!in.fully_coherent()) {
        one_by_one(in, solve_one);
        return;
    }
    constexpr std::size_t kAngles = 64;  ///< well above what preparing the stacks costs
    const GridOrder order(in);
    const std::size_t batches = (order.stacks() + kLanes - 1) / kLanes;
    const std::size_t ranges = (order.angles() + kAngles - 1) / kAngles;
    const auto solve_tile = [&](std::size_t tile) {
        BatchSolver solver(in, order, tile / ranges * kLanes);
        const std::size_t first = tile % ranges * kAngles;
        for (std::size_t a = first; a < std::min(first + kAngles, order.angles()); ++a)
            solver.solve(a);
    };
    const std::size_t tiles = batches * ranges;
    if (tiles < 8)
        for (std::size_t tile = 0; tile < tiles; ++tile) solve_tile(tile);
    else
        tbb::parallel_for(std::size_t{0}, tiles, solve_tile);
}

void check_and_solve(Stacks stacks)
{
    stacks.cosine_steps = compact_steps(stacks.shape, stacks.steps(stacks.angle_deg));
    check(stacks);
    if (stacks.count == 0) return;
    work_out_cosines(stacks);
    solve(stacks);
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_stack(size_t count, size_t layers, const double* n, const double* d_nm,
                         const double* angle_deg, const double* wavelength_nm,
                         const nacre_coherence* coherence, nacre_polarisation polarisation,
                         double* power, double* amplitudes, double* absorption)
{
    return nacre::capi::guarded([&] {
        const size_t step = 1;
        nacre::capi::check_and_solve(
            {.shape = {&count, 1},
             .layers = layers,
             .n = {n, &step},
             .d_nm = {d_nm, &step},
             .angle_deg = {angle_deg, &step},
             .wavelength_nm = {wavelength_nm, &step},
             .coherence = coherence == nullptr ? nacre_coherence{} : *coherence,
             .polarisation = polarisation,
             .power = power,
             .amplitudes = amplitudes,
             .absorption = absorption});
    });
}

nacre_status nacre_stack_grid(size_t axes, const size_t* shape, size_t layers, nacre_grid_array n,
                              nacre_grid_array d_nm, nacre_grid_array angle_deg,
                              nacre_grid_array wavelength_nm, const nacre_coherence* coherence,
                              nacre_polarisation polarisation, double* power, double* amplitudes,
                              double* absorption)
{
    return nacre::capi::guarded([&] {
        if (axes > 0) {
            nacre::capi::require(shape, "shape");
            for (const auto& [array, field] : {std::pair{&n, "n"},
                                               {&d_nm, "d_nm"},
                                               {&angle_deg, "angle_deg"},
                                               {&wavelength_nm, "wavelength_nm"}})
                nacre::capi::require(array->steps, field);
        }
        nacre::capi::check_and_solve(
            {.shape = {shape, axes},
             .layers = layers,
             .n = n,
             .d_nm = d_nm,
             .angle_deg = angle_deg,
             .wavelength_nm = wavelength_nm,
             .coherence = coherence == nullptr ? nacre_coherence{} : *coherence,
             .polarisation = polarisation,
             .power = power,
             .amplitudes = amplitudes,
             .absorption = absorption});
    });
}
}
