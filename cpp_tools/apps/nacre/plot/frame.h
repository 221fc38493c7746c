// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "plot/axis.h"
#include "plot/canvas.h"

/// @file
/// One page: title, curves over wavelength, a swatch with numbers, a citation.

namespace nacre::tool {

inline constexpr int kPlotWidth = 900, kPlotHeight = 540;
inline constexpr int kPlotPixels = 2;  ///< of a PNG, a unit

/// Where the curves are drawn, and the swatch.
inline constexpr Box kPlotArea = {76.0, 88.0, 632.0, 420.0};
inline constexpr Box kSwatchArea = {714.0, 88.0, 876.0, 188.0};

struct Curve {
    std::string label;
    std::vector<double> values;  ///< at the wavelengths of the plot
    Axis axis;
    Paint paint;
    bool numbered =
        true;  ///< whether its axis is written: the first to the left, another to the right
};

struct Fact {
    std::string name, value;
    std::optional<Paint> paint = {};  ///< of a curve that it tells
};

struct Plot {
    std::string title, subtitle, citation;
    std::vector<double> wavelengths_nm;
    std::vector<Curve> curves;  ///< one or more, at most two of them numbered
    bool filled = false;        ///< the visible spectrum below the first one, else on a strip
    std::optional<Paint> swatch;
    std::string caption;  ///< of the swatch
    std::vector<Fact> facts;
};

/// By the extension, .svg or .png. @throws InputError for any other one.
void check_plot_file(const std::filesystem::path& file);

/// @throws InputError when the file cannot be written.
void write_plot(const std::filesystem::path& file, const Plot& plot);

}  // namespace nacre::tool
