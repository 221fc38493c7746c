// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "colour/target.h"
#include "files/image_file.h"
#include "nacre/lut/table.h"
#include "nacre/media/working_range.h"

/// @file
/// Tables as images, with their axes, units and provenance inside.

namespace nacre::tool {

inline constexpr int kTableSchema = 1;

/// What a table was baked for.
struct TableProvenance {
    std::string stack;  ///< JSON, in the form that `bake stack` reads
    std::vector<spectral::HeldEnds> held;
    std::string illuminant;
    spectral::ObserverId observer = spectral::ObserverId::cie1931;
    spectral::Adaptation adaptation = spectral::Adaptation::bradford;
    spectral::ColourSpace space;
    bool built_in_space = true;
};

[[nodiscard]] Image table_image(const lut::Table& table);
[[nodiscard]] Attributes table_attributes(const lut::Table& table,
                                          const TableProvenance& provenance);

/// JSON of one axis: name, unit, min, max, mapping.
[[nodiscard]] std::string axes_json(const std::vector<lut::Axis>& axes);

}  // namespace nacre::tool
