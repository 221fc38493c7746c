// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/oslgen/graph.h"

namespace nacre::oslgen {

/// Nodes `seen` and `cos_seen`, `further` and `further_scale`: the surfaces without a direction
/// that stand in for a brushed one, as nacre_brushed_facets() has them.
void add_brushed_facets(Graph& graph);

}  // namespace nacre::oslgen
