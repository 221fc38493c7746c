// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "stacks/coherent_packet.h"

/// @file
/// Packets of coherent layers separated by incoherent ones: intensities that bounce inside an
/// incoherent layer form a geometric series (Byrnes 2016, section 6).

namespace nacre::optics::detail {

/// Layers begin … end − 1, all coherent, between two half-spaces or incoherent layers.
struct Packet {
    std::size_t begin, end;
    Complex above, below;
    Real R, T, R_back, T_back;  ///< powers, for light from above and from below
    Real pass_below;            ///< what one passage through the layer below leaves; 0 at the end
    Real R_under;               ///< reflectance of all that lies below that layer
    Real R_whole, T_whole;      ///< of this packet and all below it
};

/// From the ambient down; the last one lies on the substrate.
[[nodiscard]] std::vector<Packet> packets(const FilmStack& stack, const Incidence& incidence,
                                          Polarisation polarisation);

}  // namespace nacre::optics::detail
