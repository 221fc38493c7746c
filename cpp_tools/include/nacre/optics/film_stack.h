// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "nacre/optics/fresnel.h"

/// @file
/// A stack of layers at one wavelength, and what is known of its light.

namespace nacre::optics {

inline constexpr int kMaxLayers = 64;

enum class Polarisation { s, p };

struct Layer {
    Complex n;
    double thickness_nm;
    bool coherent = true;
    /// Standard deviation of a thickness that varies within what is looked at; what is asked for is
    /// then the mean over the phases of this layer, at the attenuation of its mean thickness.
    double spread_nm = 0.0;
};

/// A stack at one wavelength, listed from the ambient (camera side) down.
struct FilmStack {
    Complex ambient;
    std::vector<Layer> layers;
    Complex substrate;
};

/// Amplitudes of the whole stack; both are measured at the outer interfaces.
struct Amplitudes {
    Complex r, t;
};

/// Power ratios of the whole stack; A = 1 − R − T.
struct PowerRatios {
    double R, T, A;
};

/// What is wrong with a stack. Fields are named as in `n[3]`, `d_nm[1]`; the caller adds file and
/// line.
struct StackProblem {
    const char* field;  ///< "n", "d_nm" or "spread_nm"
    int index;
    const char* message;
};

}  // namespace nacre::optics
