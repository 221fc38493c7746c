// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nacre/spectral/named_spectrum.h"

/// @file
/// Spectra made by hand: a sum of simple shapes, sampled in equal steps.

namespace nacre::spectral {

struct ConstantShape {
    double value;
};

/// `value` from `first_nm` to `last_nm`, both included, and 0 elsewhere. Where `edge_nm` > 0, the
/// value rises over so many nanometres around `first_nm` along half a cosine, has its half there,
/// and falls likewise around `last_nm`: the area is that of the hard box.
struct BoxShape {
    double first_nm, last_nm, value;
    double edge_nm = 0.0;
};

/// peak · exp(−4 ln 2 ((λ − centre) / fwhm)²)
struct GaussianShape {
    double centre_nm, fwhm_nm, peak;
};

/// Straight between control points; outside them the value of the nearest one.
struct LinearShape {
    Spectrum points;
};

/// Smooth through control points and monotone wherever they are, so that it never leaves the range
/// of its neighbours; outside them the value of the nearest one.
struct SmoothShape {
    Spectrum points;
};

/// Another spectrum times a factor, interpolated as NamedSpectrum::on_grid() has it; outside its
/// samples the value of the nearest one.
struct ScaledShape {
    NamedSpectrum spectrum;
    double factor = 1.0;
};

using SpectrumShape =
    std::variant<ConstantShape, BoxShape, GaussianShape, LinearShape, SmoothShape, ScaledShape>;

/// What is wrong with the numbers of a shape; nothing for a good one. Values may be negative: it is
/// the sum that has to suit its kind.
[[nodiscard]] std::optional<std::string> shape_problem(const SpectrumShape& shape);

/// first, first + step, … last.
/// @throws InputError unless 0 < first < last, the step is > 0 and goes into the range a whole
///         number of times, and there are no more than kMaxSamples wavelengths.
[[nodiscard]] std::vector<double> even_wavelengths(double first_nm, double last_nm, double step_nm);

/// The sum of all shapes at each wavelength.
/// @throws InputError for no shapes, for a shape that has a problem, for a box or a Gaussian so
///         narrow that it falls between the wavelengths, and for a sum that is not finite.
[[nodiscard]] Spectrum sum_of_shapes(const std::vector<SpectrumShape>& shapes,
                                     std::vector<double> wavelengths_nm);

/// Piecewise cubic Hermite interpolation that keeps monotone data monotone: slopes are weighted
/// harmonic means of the secants beside them and 0 where those differ in sign (Fritsch and Butland
/// 1984, SIAM J. Sci. Stat. Comput. 5, 300), at the ends the slope of the parabola through three
/// points, held within the region of Fritsch and Carlson (1980, SIAM J. Numerical Analysis 17,
/// 238).
class MonotoneCubic {
public:
    explicit MonotoneCubic(Spectrum points);

    /// Outside the points the value of the nearest one.
    [[nodiscard]] double at(double wavelength_nm) const;

private:
    Spectrum points_;
    std::vector<double> slopes_;
};

}  // namespace nacre::spectral
