// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include "nacre/lut/film_request.h"
#include "nacre/optics/rgb_film.h"

/// @file
/// How close a renderer without a spectrum comes to a film, and the parameters that bring it
/// closest.

namespace nacre::lut {

/// A film in the words of KHR_materials_iridescence, over a part of its variation.
struct IridescenceFit {
    double film_ior, factor;
    double film_min_nm, film_max_nm;  ///< at the first and last value; linear in between
    spectral::Vec3 base_f0;
};

/// Of an approximation on a sphere seen from afar, angles up to 85°: mean over what the sphere
/// covers in the picture, and largest. ΔE00; colours outside the gamut count as they are.
struct SphereError {
    double mean, max;
};

/// Colour at one angle and value of the variation.
using FilmColours = std::function<spectral::Vec3(double cos_theta, double value)>;

/// What `colours` is off by, in what the film reflects or lets pass.
/// @param values  of the variation, at least one; not looked at where nothing varies
[[nodiscard]] SphereError sphere_error(const FilmTableRequest& request,
                                       const std::vector<double>& values,
                                       const FilmColours& colours, bool transmittance = false);

/// The fit at one value: a film of the thickness that interpolates its ends.
[[nodiscard]] optics::KhrIridescence surface_at(const IridescenceFit& fit,
                                                const std::vector<double>& values, double value);

/// Least mean square of ΔE00 over the sphere and all values: the best cells of a grid over index
/// and thickness, each then refined by the simplex of Nelder and Mead 1965. The same numbers for
/// the same input.
///
/// @param request  of the film, its weights those of linear Rec.709
/// @param values   one, or the ends and any between, ascending
/// @throws InputError when the stack is not valid
[[nodiscard]] IridescenceFit fit_iridescence(const FilmTableRequest& request,
                                             const std::vector<double>& values);

}  // namespace nacre::lut
