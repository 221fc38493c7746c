// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "stacks/incoherent_series.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "stacks/partial_coherence.h"

namespace nacre::optics::detail {
namespace {

/// What one passage through a layer leaves of an intensity.
Real single_pass(const Incidence& incidence, const Layer& layer)
{
    const Real rate = 4 * std::numbers::pi_v<Real> / static_cast<Real>(incidence.wavelength_nm) *
                      normal_index(incidence, layer.n).imag();
    return std::exp(-rate * static_cast<Real>(layer.thickness_nm));
}

void respond_both_ways(Packet& packet, const Incidence& incidence, std::span<const Layer> layers,
                       Polarisation polarisation)
{
    const std::vector<Layer> reversed(layers.rbegin(), layers.rend());
    const MeanPower down =
        mean_response(incidence, packet.above, layers, packet.below, polarisation);
    const MeanPower up =
        mean_response(incidence, packet.below, reversed, packet.above, polarisation);
    packet.R = down.R;
    packet.T = down.T;
    packet.R_back = up.R;
    packet.T_back = up.T;
}

///     R ← R_f + T_f T_b P² R / (1 − R_b P² R),   T ← T_f P T / (1 − R_b P² R).
void add_what_lies_below(Packet& packet, const Packet& under)
{
    packet.R_under = under.R_whole;
    packet.R_whole = packet.R;
    packet.T_whole = 0;
    // Nothing gets in: the quotients of a totally reflecting face would be 0/0.
    if (packet.T == 0) return;
    const Real pass = packet.pass_below, returned = pass * pass * under.R_whole;
    const Real series = 1 - packet.R_back * returned;
    packet.R_whole += packet.T * packet.T_back * returned / series;
    packet.T_whole = packet.T * pass * under.T_whole / series;
}

}  // namespace

std::vector<Packet> packets(const FilmStack& stack, const Incidence& incidence,
                            Polarisation polarisation)
{
    const std::span<const Layer> layers = stack.layers;
    std::vector<Packet> result;
    for (std::size_t begin = 0;;) {
        std::size_t end = begin;
        while (end < layers.size() && layers[end].coherent) ++end;
        const bool last = end == layers.size();
        Packet packet{};
        packet.begin = begin;
        packet.end = end;
        packet.above = begin == 0 ? stack.ambient : layers[begin - 1].n;
        packet.below = last ? stack.substrate : layers[end].n;
        packet.pass_below = last ? 0 : single_pass(incidence, layers[end]);
        respond_both_ways(packet, incidence, layers.subspan(begin, end - begin), polarisation);
        result.push_back(packet);
        if (last) break;
        begin = end + 1;
    }
    Packet& bottom = result.back();
    bottom.R_whole = bottom.R;
    bottom.T_whole = bottom.T;
    for (std::size_t j = result.size() - 1; j-- > 0;) add_what_lies_below(result[j], result[j + 1]);
    return result;
}

}  // namespace nacre::optics::detail
