// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "develop/view.h"

#include <cmath>

#include "colour/target.h"
#include "nacre/bands/response.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/spectrum_library.h"

namespace nacre::tool {
namespace {

using bands::Bands;
using spectral::Mat3;
using spectral::Vec3;

std::vector<double> daylight(const Bands& bands)
{
    std::vector<double> power = bands::light_in_bands(bands, bands::named_light("D65"));
    const double brightness = bands.xyz(power)[1];
    for (double& value : power) value /= brightness;
    return power;
}

/// To XYZ relative to D65, with `white` as white; the identity where nothing is.
Mat3 adapted(const Viewer& viewer, const Bands& seen)
{
    const Mat3 to_d65 = spectral::emission_to_d65(seen.observer);
    if (!viewer.white) return to_d65;
    Vec3 white = multiply(to_d65, seen.xyz(*viewer.white));
    const double brightness = white[1];
    for (double& value : white) value /= brightness;
    return multiply(
        spectral::adaptation(viewer.adaptation, white, spectral::d65_white(), kWithoutCat), to_d65);
}

/// Of the library, at each band.
std::vector<std::vector<double>> reflectances(const Bands& bands)
{
    std::vector<double> nm;
    for (const bands::Band& band : bands.bands) nm.push_back(band.wavelength_nm);
    std::vector<std::vector<double>> found;
    for (const std::string& key : spectral::library_spectrum_keys()) {
        const spectral::NamedSpectrum spectrum = spectral::library_spectrum(key);
        if (spectrum.kind == spectral::SpectrumKind::reflectance)
            found.push_back(spectrum.values_at(nm));
    }
    return found;
}

/// Least squares of `to` over `from`, both relative to white, which is met exactly: of a row
/// (a, b, w − a − b), w that of white, a and b are free.
Mat3 fitted(const std::vector<Vec3>& from, const std::vector<Vec3>& to, const Vec3& white)
{
    Mat3 matrix{};
    for (std::size_t row = 0; row < 3; ++row) {
        double aa = 0.0, ab = 0.0, bb = 0.0, ay = 0.0, by = 0.0;
        for (std::size_t i = 0; i < from.size(); ++i) {
            const double a = from[i][0] - from[i][2], b = from[i][1] - from[i][2];
            const double y = to[i][row] - white[row] * from[i][2];
            aa += a * a, ab += a * b, bb += b * b, ay += a * y, by += b * y;
        }
        const double determinant = aa * bb - ab * ab;
        const double a = (ay * bb - by * ab) / determinant;
        const double b = (by * aa - ay * ab) / determinant;
        matrix[row] = {a, b, white[row] - a - b};
    }
    return matrix;
}

std::vector<Vec3> of_camera(const Bands& bands, const Viewer& viewer)
{
    const std::vector<double> white = viewer.white.value_or(daylight(bands));
    std::vector<Vec3> raw =
        bands::responses(bands, [&](double nm) { return viewer.camera->at(nm); });
    const Vec3 of_white = summed(white, raw);
    const double brightness = bands.xyz(white)[1];
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(of_white[c] > 0.0))
            throw InputError({.file = {},
                              .field = "--white",
                              .message = "has no light that every channel of the camera sees"});
        for (Vec3& band : raw) band[c] *= brightness / of_white[c];
    }
    return raw;
}

}  // namespace

Vec3 summed(const std::vector<double>& values, const std::vector<Vec3>& colours)
{
    Vec3 sum{};
    for (std::size_t k = 0; k < values.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += values[k] * colours[k][c];
    return sum;
}

std::vector<Vec3> colours_of_bands(const Bands& bands, const Viewer& viewer,
                                   const spectral::ColourSpace& space)
{
    const Bands seen = bands::seen_by(bands, viewer.observer);
    Mat3 matrix = multiply(space.from_xyz_d65, adapted(viewer, seen));
    std::vector<Vec3> colours;
    if (viewer.camera) {
        colours = of_camera(seen, viewer);
        const std::vector<double> white = viewer.white.value_or(daylight(seen));
        Viewer eye = viewer;
        eye.white = white;
        const Mat3 to_d65 = adapted(eye, seen);
        std::vector<Vec3> from, to;
        for (std::vector<double> surface : reflectances(seen)) {
            for (std::size_t k = 0; k < surface.size(); ++k) surface[k] *= white[k];
            from.push_back(summed(surface, colours));
            to.push_back(multiply(to_d65, seen.xyz(surface)));
        }
        const double brightness = seen.xyz(white)[1];
        for (std::vector<Vec3>* values : {&from, &to})
            for (Vec3& value : *values)
                for (double& channel : value) channel /= brightness;
        matrix = multiply(space.from_xyz_d65, fitted(from, to, spectral::d65_white()));
    } else {
        for (const bands::Band& band : seen.bands) colours.push_back(band.xyz);
    }
    const double gain = std::pow(2.0, viewer.exposure);
    for (Vec3& colour : colours) {
        if (!viewer.raw) colour = multiply(matrix, colour);
        for (double& value : colour) value *= gain;
    }
    return colours;
}

}  // namespace nacre::tool
