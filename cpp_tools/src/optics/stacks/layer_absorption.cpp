// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <span>

#include "nacre/optics/multilayer.h"
#include "stacks/coherent_packet.h"
#include "stacks/incoherent_series.h"

namespace nacre::optics {
namespace {

using detail::Packet;
using detail::Real;

/// Powers that meet a packet: falling from above, rising from below.
struct Meeting {
    Real falling, rising;
};

/// Where a packet lies, and how power runs through it for a unit from above and from below; the
/// second runs upwards and is empty at the substrate.
struct PacketFlux {
    std::vector<Real> down, up;
};

PacketFlux flux_through(const Packet& packet, std::span<const Layer> inside, bool on_substrate,
                        const detail::Incidence& incidence, Polarisation polarisation)
{
    PacketFlux flux{.down = power_flux(incidence, packet.above, inside, packet.below, polarisation),
                    .up = {}};
    if (on_substrate) return flux;
    const std::vector<Layer> reversed(inside.rbegin(), inside.rend());
    flux.up = power_flux(incidence, packet.below, reversed, packet.above, polarisation);
    return flux;
}

/// Adds what the layers of a packet take of both waves; these do not interfere.
void absorb(std::span<double> absorbed, const PacketFlux& flux, const Meeting& meeting)
{
    for (std::size_t j = 0, count = absorbed.size(); j < count; ++j) {
        Real taken = meeting.falling * (flux.down[j] - flux.down[j + 1]);
        if (!flux.up.empty())
            taken += meeting.rising * (flux.up[count - 1 - j] - flux.up[count - j]);
        absorbed[j] = static_cast<double>(taken);
    }
}

}  // namespace

std::vector<double> layer_absorption(const FilmStack& stack, double cos_ambient,
                                     double wavelength_nm, Polarisation polarisation)
{
    assert(!validate(stack));
    const detail::Incidence incidence{stack.ambient, cos_ambient, wavelength_nm};
    std::vector<double> absorbed(stack.layers.size(), 0.0);

    Meeting meeting{.falling = 1, .rising = 0};
    Real entered = 0;  // the incoherent layer above
    for (const Packet& packet : detail::packets(stack, incidence, polarisation)) {
        const bool on_substrate = packet.end == stack.layers.size();
        const std::size_t count = packet.end - packet.begin;
        const PacketFlux flux =
            flux_through(packet, std::span(stack.layers).subspan(packet.begin, count), on_substrate,
                         incidence, polarisation);
        // Round trips in the incoherent layer below: P is one passage.
        const Real P = packet.pass_below, into = packet.T * meeting.falling;
        const Real top = into == 0 ? 0 : into / (1 - packet.R_back * P * P * packet.R_under);
        const Real bottom = P * top;
        meeting.rising = P * packet.R_under * bottom;

        absorb(std::span(absorbed).subspan(packet.begin, count), flux, meeting);
        // In an absorbing medium a wave and its reflection carry power together that neither
        // carries alone, so that powers balance at the faces only.
        const Real left = meeting.falling * flux.down.front() - meeting.rising * packet.T_back;
        if (packet.begin > 0) absorbed[packet.begin - 1] = static_cast<double>(entered - left);
        if (on_substrate) break;
        entered = into - meeting.rising * flux.up.front();
        meeting.falling = bottom;
    }
    return absorbed;
}

}  // namespace nacre::optics
