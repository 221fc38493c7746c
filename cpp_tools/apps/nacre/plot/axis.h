// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

/// @file
/// Axes of a plot: from values to places, and the round numbers that stand beside them.

namespace nacre::tool {

class Axis {
public:
    /// From one place to the other, linear; @pre low < high
    static Axis exactly(double low, double high, double from, double to);
    /// The same from one round number to another, so that both ends have a label.
    static Axis rounded(double low, double high, double from, double to);
    /// Whole decades; what is below the lowest is drawn there. @pre 0 < low < high
    static Axis decades(double low, double high, double from, double to);

    [[nodiscard]] double place(double value) const;

    struct Tick {
        double value;
        std::string label;
    };
    [[nodiscard]] const std::vector<Tick>& ticks() const noexcept { return ticks_; }

private:
    Axis(double low, double high, double from, double to)
        : low_(low), high_(high), from_(from), to_(to)
    {}
    void label_steps(double step);

    double low_, high_, from_, to_;
    bool logarithmic_ = false;
    std::vector<Tick> ticks_;
};

}  // namespace nacre::tool
