// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "guard.h"
#include "nacre/optics/multilayer.h"
#include "nacre/optics/stack_batch.h"
#include "stack_grid.h"

namespace nacre::capi {
namespace {

using optics::Complex;
using optics::kLanes;
using optics::Polarisation;

/// Where the data of one item are.
struct Item {
    const double *n, *d_nm;
    double angle_deg, wavelength_nm, cosine;

    [[nodiscard]] Complex index(std::size_t medium) const
    {
        return {n[2 * medium], n[2 * medium + 1]};
    }
};

/// The arrays of a call.
struct Stacks {
    std::span<const std::size_t> shape;
    std::size_t layers;
    nacre_grid_array n, d_nm, angle_deg, wavelength_nm;
    const unsigned char* coherent;
    nacre_polarisation polarisation;
    double *power, *amplitudes;

    std::size_t count = count_items(shape);
    std::vector<double> cosines{};  ///< of every angle, once
    std::vector<std::size_t> cosine_steps{};

    [[nodiscard]] Steps steps(const nacre_grid_array& array) const
    {
        return {array.steps, shape.size()};
    }
    [[nodiscard]] bool shared(const nacre_grid_array& array) const
    {
        const Steps all = steps(array);
        return std::all_of(all.begin(), all.end(), [](std::size_t step) { return step == 0; });
    }
    [[nodiscard]] bool all_coherent() const
    {
        return coherent == nullptr || std::all_of(coherent, coherent + layers,
                                                  [](unsigned char flag) { return flag != 0; });
    }
};

/// Walks over the items.
class ItemCursor {
public:
    ItemCursor(const Stacks& in, std::size_t item)
        : in_(&in),
          cursor_(in.shape,
                  {in.steps(in.n), in.steps(in.d_nm), in.steps(in.angle_deg),
                   in.steps(in.wavelength_nm), in.cosine_steps},
                  item)
    {}
    [[nodiscard]] Item operator*() const
    {
        const std::size_t cosine = cursor_.offset(4);
        return {.n = in_->n.values + 2 * (in_->layers + 2) * cursor_.offset(0),
                .d_nm = in_->d_nm.values + in_->layers * cursor_.offset(1),
                .angle_deg = in_->angle_deg.values[cursor_.offset(2)],
                .wavelength_nm = in_->wavelength_nm.values[cursor_.offset(3)],
                .cosine = cosine < in_->cosines.size() ? in_->cosines[cosine] : 1.0};
    }
    void advance() { cursor_.advance(); }

private:
    const Stacks* in_;
    GridCursor<5> cursor_;
};

optics::FilmStack film_stack(const Stacks& in, const Item& item)
{
    optics::FilmStack stack{.ambient = item.index(0), .layers = {}, .substrate = {}};
    for (std::size_t j = 0; j < in.layers; ++j)
        stack.layers.push_back({.n = item.index(j + 1),
                                .thickness_nm = item.d_nm[j],
                                .coherent = in.coherent == nullptr || in.coherent[j] != 0});
    stack.substrate = item.index(in.layers + 1);
    return stack;
}

bool good_angle(double degrees)
{
    return degrees >= 0.0 && degrees < 90.0;
}
bool good_wavelength(double nm)
{
    return std::isfinite(nm) && nm > 0.0;
}

void check_item(const Stacks& in, const Item& item, std::size_t number)
{
    const auto refuse = [number](const std::string& field, const std::string& message) {
        fail(field, fmt::format("{} (item {})", message, number));
    };
    if (!good_angle(item.angle_deg))
        refuse("angle_deg", fmt::format("must be in [0, 90) (got {})", item.angle_deg));
    if (!good_wavelength(item.wavelength_nm))
        refuse("wavelength_nm", fmt::format("must be finite and > 0 (got {})", item.wavelength_nm));
    const auto problem = validate(film_stack(in, item));
    if (!problem) return;
    const auto index = static_cast<std::size_t>(problem->index);
    const bool of_index = problem->field[0] == 'n';
    const Complex n = of_index ? item.index(index) : Complex{};
    const std::string got =
        of_index ? fmt::format("{}{:+}i", n.real(), n.imag()) : fmt::format("{}", item.d_nm[index]);
    refuse(fmt::format("{}[{}]", problem->field, index),
           fmt::format("{} (got {})", problem->message, got));
}

/// Whether every element is good, each looked at once however many items share it.
bool all_good(const Stacks& in)
{
    const std::vector<double> no_thickness(in.layers, 0.0);
    const auto good_media = [&](std::size_t element) {
        Item item{};
        item.n = in.n.values + 2 * (in.layers + 2) * element;
        item.d_nm = no_thickness.data();
        return !validate(film_stack(in, item));
    };
    const auto good_thicknesses = [&](std::size_t element) {
        const double* d_nm = in.d_nm.values + in.layers * element;
        return std::all_of(d_nm, d_nm + in.layers,
                           [](double d) { return std::isfinite(d) && d >= 0.0; });
    };
    const auto every = [&in](const nacre_grid_array& array, auto&& good) {
        return every_element(in.shape, in.steps(array), good);
    };
    return every(in.angle_deg, [&](std::size_t i) { return good_angle(in.angle_deg.values[i]); }) &&
           every(in.wavelength_nm,
                 [&](std::size_t i) { return good_wavelength(in.wavelength_nm.values[i]); }) &&
           every(in.n, good_media) && every(in.d_nm, good_thicknesses);
}

void check(const Stacks& in)
{
    if (in.layers > optics::kMaxLayers)
        fail("d_nm",
             fmt::format("must have at most {} layers (got {})", optics::kMaxLayers, in.layers));
    if (in.count == 0) return;
    require(in.n.values, "n");
    if (in.layers > 0) require(in.d_nm.values, "d_nm");
    require(in.angle_deg.values, "angle_deg");
    require(in.wavelength_nm.values, "wavelength_nm");
    require(in.power, "power");
    if (in.polarisation < NACRE_S || in.polarisation > NACRE_UNPOLARISED)
        fail("polarisation", "must be s, p or u");
    if (in.amplitudes != nullptr && (in.polarisation == NACRE_UNPOLARISED || !in.all_coherent()))
        fail("amplitudes", "exist for s or p and coherent layers only");
    if (all_good(in)) return;
    ItemCursor cursor(in, 0);
    for (std::size_t item = 0; item < in.count; ++item, cursor.advance())
        check_item(in, *cursor, item);
}

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

void store_amplitudes(const Stacks& in, std::size_t item, Complex r, Complex t)
{
    if (in.amplitudes == nullptr) return;
    double* out = in.amplitudes + 4 * item;
    out[0] = r.real();
    out[1] = r.imag();
    out[2] = t.real();
    out[3] = t.imag();
}

void solve_one(const Stacks& in, const Item& item, std::size_t number)
{
    const optics::FilmStack stack = film_stack(in, item);
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

void set(optics::ComplexLanes& lanes, std::size_t i, Complex value)
{
    lanes.re[i] = value.real();
    lanes.im[i] = value.imag();
}

void set_media(optics::LaneStack& stack, std::size_t i, const Item& item)
{
    stack.n_0[i] = item.index(0).real();
    set(stack.above, i, item.index(0));
    set(stack.below, i, item.index(stack.layers.size() + 1));
    for (std::size_t j = 0; j < stack.layers.size(); ++j)
        set(stack.layers[j].n, i, item.index(j + 1));
}

optics::PowerRatios power(const optics::LaneResponse& response, std::size_t i)
{
    return {.R = response.R[i], .T = response.T[i], .A = 1.0 - response.R[i] - response.T[i]};
}

void store(const Stacks& in, std::size_t item, const optics::BatchResponse& response, std::size_t i)
{
    const optics::PowerRatios s = power(response.s, i), p = power(response.p, i);
    if (in.polarisation == NACRE_UNPOLARISED) {
        store_power(in, item,
                    {.R = 0.5 * (s.R + p.R), .T = 0.5 * (s.T + p.T), .A = 0.5 * (s.A + p.A)});
        return;
    }
    const auto& chosen = in.polarisation == NACRE_S ? response.s : response.p;
    store_power(in, item, in.polarisation == NACRE_S ? s : p);
    store_amplitudes(in, item, {chosen.r.re[i], chosen.r.im[i]}, {chosen.t.re[i], chosen.t.im[i]});
}

/// Lanes in double precision; an item whose result would lose more than this is computed again in
/// extended precision, so that every result is good to 1e-12.
constexpr double kDoubtAllowed = 4e-14;

/// Batches of lanes, one after the other.
class BatchSolver {
public:
    explicit BatchSolver(const Stacks& in) : in_(in), shared_media_(in.shared(in.n))
    {
        stack_.layers.resize(in.layers);
        if (!shared_media_) return;
        const Item any = *ItemCursor(in, 0);
        for (std::size_t i = 0; i < kLanes; ++i) set_media(stack_, i, any);
    }

    /// Items first … last − 1, at most kLanes; lanes past the end repeat the last one.
    void solve(ItemCursor& cursor, std::size_t first, std::size_t last)
    {
        const std::size_t count = last - first;
        for (std::size_t i = 0; i < count; ++i, cursor.advance()) items_[i] = *cursor;
        std::fill(items_.begin() + static_cast<std::ptrdiff_t>(count), items_.end(),
                  items_[count - 1]);
        fill();
        stack_batch(stack_, response_);
        for (std::size_t i = 0; i < count; ++i) {
            if (response_.doubt[i] <= kDoubtAllowed)
                store(in_, first + i, response_, i);
            else
                solve_one(in_, items_[i], first + i);
        }
    }

private:
    void fill()
    {
        for (std::size_t i = 0; i < kLanes; ++i) {
            stack_.cos_0[i] = items_[i].cosine;
            if (!shared_media_) set_media(stack_, i, items_[i]);
        }
        for (std::size_t j = 0; j < in_.layers; ++j)
            for (std::size_t i = 0; i < kLanes; ++i)
                stack_.layers[j].waves[i] = items_[i].d_nm[j] / items_[i].wavelength_nm;
    }

    const Stacks& in_;
    bool shared_media_;
    std::array<Item, kLanes> items_{};
    optics::LaneStack stack_;
    optics::BatchResponse response_;
};

void solve_range(const Stacks& in, std::size_t first, std::size_t last)
{
    ItemCursor cursor(in, first);
    if (!in.all_coherent()) {
        for (std::size_t item = first; item < last; ++item, cursor.advance())
            solve_one(in, *cursor, item);
        return;
    }
    BatchSolver solver(in);
    for (; first < last; first += kLanes)
        solver.solve(cursor, first, std::min(first + kLanes, last));
}

/// Each item has a place of its own in the results, so that threads do not meet.
void solve(const Stacks& in)
{
    constexpr std::size_t kRange = 16 * kLanes;  ///< well above what starting a task costs
    const std::size_t ranges = (in.count + kRange - 1) / kRange;
    const auto solve_one_range = [&in](std::size_t range) {
        solve_range(in, range * kRange, std::min((range + 1) * kRange, in.count));
    };
    if (ranges == 1)
        solve_one_range(0);
    else
        tbb::parallel_for(std::size_t{0}, ranges, solve_one_range);
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
                         const unsigned char* coherent, nacre_polarisation polarisation,
                         double* power, double* amplitudes)
{
    return nacre::capi::guarded([&] {
        const size_t step = 1;
        nacre::capi::check_and_solve({.shape = {&count, 1},
                                      .layers = layers,
                                      .n = {n, &step},
                                      .d_nm = {d_nm, &step},
                                      .angle_deg = {angle_deg, &step},
                                      .wavelength_nm = {wavelength_nm, &step},
                                      .coherent = coherent,
                                      .polarisation = polarisation,
                                      .power = power,
                                      .amplitudes = amplitudes});
    });
}

nacre_status nacre_stack_grid(size_t axes, const size_t* shape, size_t layers, nacre_grid_array n,
                              nacre_grid_array d_nm, nacre_grid_array angle_deg,
                              nacre_grid_array wavelength_nm, const unsigned char* coherent,
                              nacre_polarisation polarisation, double* power, double* amplitudes)
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
        nacre::capi::check_and_solve({.shape = {shape, axes},
                                      .layers = layers,
                                      .n = n,
                                      .d_nm = d_nm,
                                      .angle_deg = angle_deg,
                                      .wavelength_nm = wavelength_nm,
                                      .coherent = coherent,
                                      .polarisation = polarisation,
                                      .power = power,
                                      .amplitudes = amplitudes});
    });
}
}
