// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include "nacre/lut/table.h"
#include "nacre/optics/film_models.h"
#include "nacre/spectral/colour.h"

/// @file
/// A film whose colours are wanted, and what they come to.

namespace nacre::lut {

using IndexOnGrid = std::array<std::complex<double>, spectral::kWavelengths>;

struct SampledLayer {
    IndexOnGrid n;
    double thickness_nm;
    bool coherent = true;
};

/// A dispersive stack on the 1 nm grid, from the ambient down.
struct SampledStack {
    IndexOnGrid ambient;
    std::vector<SampledLayer> layers;
    IndexOnGrid substrate;
};

/// What the second axis changes: one layer's thickness, or a factor on all coherent layers.
struct Variation {
    std::optional<std::size_t> layer;  ///< index of the layer; none: thickness scale
    double min, max;                   ///< nm, or a factor
};

/// A form of film_models.h in place of the multilayer.
struct Technique {
    optics::FilmModel model;
    bool from_below = false;  ///< the stack is listed from the substrate up
};

/// Of the arithmetic that is done once a texel and wavelength.
enum class Precision {
    double_precision,
    single_precision,  ///< colours good to 1e-5, in half to two thirds of the time
};

struct FilmTableRequest {
    SampledStack stack;
    std::optional<Variation> variation;  ///< none: one row
    std::optional<Technique> technique;  ///< none: the multilayer, as is a stack without layers
    spectral::ColourWeights weights;
    double tolerance = 0.1;                  ///< ΔE00 between texels; decides the size
    int max_texels = 4096;                   ///< per axis
    bool accept_error = false;               ///< of the largest table, where it is over tolerance
    bool transmittance = false;              ///< also bake T
    std::optional<std::array<int, 2>> size;  ///< width, height; overrides the tolerance
    /// False: the errors are NaN, and a bake costs a fifth.
    /// @pre true or `size` is set
    bool measure_error = true;
    /// Texels are rounded to so many bits (rounded_texel) before errors are measured.
    int texel_bits = kFloatBits;
    /// Single precision: where errors are not measured, no layer is incoherent and there is no
    /// technique; else double.
    Precision precision = Precision::double_precision;
    /// Called with 0…1 while baking, from one thread at a time; returning false cancels.
    std::function<bool(double)> progress;
};

struct FilmTables {
    Table reflectance;
    std::optional<Table> transmittance;
};

/// At one angle and value of the variation.
struct FilmColour {
    spectral::Vec3 reflectance, transmittance;
};

}  // namespace nacre::lut
