// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "lanes/angled_stack.h"
#include "nacre/optics/stack_batch.h"

// The series of intensities of incoherent_series.cpp, on lanes.

namespace nacre::optics {

namespace detail {

/// A packet of coherent layers, for light from one side.
struct OneWay {
    AngledStack stack;
    std::size_t varying;  ///< layer whose thickness is free, counted on the way; kNone

    BatchPower power{};  ///< where nothing varies
};

}  // namespace detail

namespace {

using detail::AngledStack;
using detail::Crossing;
using detail::LaneFields;
using detail::LaneTrip;
using detail::OneWay;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

/// What one passage through a layer leaves of an intensity.
void single_pass(Lanes& pass, const LaneStack& stack, const LaneLayer& layer)
{
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::complex<double> n(layer.n.re[i], layer.n.im[i]);
        const double n_0 = stack.n_0[i], across = n_0 * stack.cos_0[i];
        const std::complex<double> q = std::sqrt((n - n_0) * (n + n_0) + across * across);
        pass[i] = std::exp(-4.0 * std::numbers::pi * q.imag() * layer.waves[i]);
    }
}

/// Power ratios of one polarisation, from the substrate up to some depth.
struct Intensities {
    Lanes R, T;
};

void add_packet(Intensities& sum, const LanePower& down, const LanePower& up, const Lanes& pass)
{
    for (std::size_t i = 0; i < kLanes; ++i) {
        if (down.T[i] == 0.0) {  // total reflection: the quotients below would be 0/0
            sum.R[i] = down.R[i];
            sum.T[i] = 0.0;
            continue;
        }
        const double returned = pass[i] * pass[i] * sum.R[i];
        const double series = 1.0 - up.R[i] * returned;
        sum.R[i] = down.R[i] + down.T[i] * up.T[i] * returned / series;
        sum.T[i] = down.T[i] * pass[i] * sum.T[i] / series;
    }
}

/// How the passages of a packet begin and what they gain by row.
struct Marching {
    std::vector<LaneTrip> trips, steps;
    std::vector<Crossing> crossings;

    Marching(const OneWay& way, double first, double step)
    {
        way.stack.find_trips(trips, first);
        way.stack.find_trips(steps, step);
        crossings = way.stack.crossings(trips, 0, way.stack.layers() + 1);
    }
    Marching(const OneWay& way, const Lanes& first, const Lanes& step)
    {
        way.stack.find_trips(trips, 1.0);
        way.stack.find_trips(steps, 0.0);
        way.stack.find_trip_of(way.varying, trips, first);
        way.stack.find_trip_of(way.varying, steps, step);
        crossings = way.stack.crossings(trips, 0, way.stack.layers() + 1);
    }
    void respond(const OneWay& way, BatchPower& power) const
    {
        LaneFields fields;
        carry_down_wave(fields, crossings);
        power.doubt.fill(0.0);
        finish_power(power.s, power.p, power.doubt, fields, way.stack.ends());
    }
    void advance()
    {
        for (std::size_t t = 0; t < trips.size(); ++t) add_trip(trips[t], steps[t]);
    }
};

}  // namespace

/// Packets from the substrate up; the first lies on it.
struct MixedStack::Work {
    struct Packet {
        detail::OneWay down, up;
        bool varies;
        Lanes pass_below{};  ///< what one passage through the layer below leaves
    };
    LaneStack stack;
    std::optional<std::size_t> varying;
    std::vector<Packet> packets;
    std::vector<std::size_t> panes;  ///< the incoherent layer below each packet but the first

    Work(const LaneStack& lanes, const std::vector<bool>& coherent,
         std::optional<std::size_t> layer)
        : stack(lanes), varying(layer)
    {
        // A thickness that no layer has keeps the passage of the varying one apart.
        if (varying) stack.layers[*varying].waves.fill(-1.0);
        ComplexLanes below = stack.below;
        for (std::size_t end = stack.layers.size();;) {
            std::size_t begin = end;
            while (begin > 0 && coherent[begin - 1]) --begin;
            add(begin, end, begin == 0 ? stack.above : stack.layers[begin - 1].n, below);
            if (begin == 0) return;
            panes.push_back(begin - 1);
            below = stack.layers[begin - 1].n;
            end = begin - 1;
        }
    }

    void add(std::size_t begin, std::size_t end, const ComplexLanes& above,
             const ComplexLanes& below)
    {
        LaneStack packet{.n_0 = stack.n_0,
                         .cos_0 = stack.cos_0,
                         .above = above,
                         .below = below,
                         .layers = {stack.layers.begin() + static_cast<std::ptrdiff_t>(begin),
                                    stack.layers.begin() + static_cast<std::ptrdiff_t>(end)}};
        const bool inside = varying && *varying >= begin && *varying < end;
        OneWay down{.stack = AngledStack(packet), .varying = inside ? *varying - begin : kNone};
        std::swap(packet.above, packet.below);
        std::ranges::reverse(packet.layers);
        OneWay up{.stack = AngledStack(packet), .varying = inside ? end - 1 - *varying : kNone};
        packets.push_back({.down = std::move(down),
                           .up = std::move(up),
                           .varies = varying ? inside : begin < end});
    }

    void turn_to(const Lanes& cos_0)
    {
        stack.cos_0 = cos_0;
        for (std::size_t p = 0; p < packets.size(); ++p) {
            Packet& packet = packets[p];
            if (p == 0)
                packet.pass_below.fill(1.0);  // nothing returns from there: R = 0
            else
                single_pass(packet.pass_below, stack, stack.layers[panes[p - 1]]);
            for (OneWay* way : {&packet.down, &packet.up}) {
                way->stack.turn_to(cos_0);
                if (!packet.varies) Marching(*way, 1.0, 0.0).respond(*way, way->power);
            }
        }
    }

    /// @param first, step  factors, or thicknesses over wavelength of the varying layer
    template <class Value>
    void march(const Value& first, const Value& step, std::span<Lanes> R, std::span<Lanes> T) const
    {
        std::vector<Marching> down, up;
        for (const Packet& packet : packets) {
            if (!packet.varies) continue;
            down.emplace_back(packet.down, first, step);
            up.emplace_back(packet.up, first, step);
        }
        for (std::size_t row = 0; row < R.size(); ++row) solve_row(down, up, R[row], T[row]);
    }

    void solve_row(std::vector<Marching>& down, std::vector<Marching>& up, Lanes& R, Lanes& T) const
    {
        Intensities s, p;
        s.R.fill(0.0);
        s.T.fill(1.0);
        p = s;
        BatchPower from_above, from_below;
        std::size_t next = 0;
        for (const Packet& packet : packets) {
            const BatchPower *falling = &packet.down.power, *rising = &packet.up.power;
            if (packet.varies) {
                down[next].respond(packet.down, from_above);
                up[next].respond(packet.up, from_below);
                down[next].advance();
                up[next++].advance();
                falling = &from_above;
                rising = &from_below;
            }
            add_packet(s, falling->s, rising->s, packet.pass_below);
            add_packet(p, falling->p, rising->p, packet.pass_below);
        }
        for (std::size_t i = 0; i < kLanes; ++i) {
            R[i] = 0.5 * (s.R[i] + p.R[i]);
            T[i] = 0.5 * (s.T[i] + p.T[i]);
        }
    }
};

MixedStack::MixedStack(const LaneStack& stack, const std::vector<bool>& coherent,
                       std::optional<std::size_t> varying)
    : work_(std::make_unique<Work>(stack, coherent, varying))
{
    turn_to(stack.cos_0);
}
MixedStack::MixedStack(MixedStack&&) noexcept = default;
MixedStack& MixedStack::operator=(MixedStack&&) noexcept = default;
MixedStack::~MixedStack() = default;

void MixedStack::turn_to(const Lanes& cos_0)
{
    work_->turn_to(cos_0);
}

void MixedStack::march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const
{
    work_->march(first, step, R, T);
}

void MixedStack::march(const Lanes& first, const Lanes& step, std::span<Lanes> R,
                       std::span<Lanes> T) const
{
    work_->march(first, step, R, T);
}

}  // namespace nacre::optics
