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

/// What is white, of Y = 1; D65 where nobody says.
std::vector<double> white_of(const Viewer& viewer, const Bands& bands)
{
    std::vector<double> power =
        viewer.white ? *viewer.white : bands::light_in_bands(bands, bands::named_light("D65"));
    const double brightness = bands.xyz(power)[1];
    for (double& value : power) value /= brightness;
    return power;
}

/// To XYZ relative to D65, with a light as white.
Mat3 adapted(const Viewer& viewer, const std::vector<double>& light, const Bands& seen)
{
    const Mat3 to_d65 = spectral::emission_to_d65(seen.observer);
    Vec3 white = multiply(to_d65, seen.xyz(light));
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

/// What each channel has of a band, 1 of `white`.
std::vector<Vec3> balanced(const spectral::Camera& camera, const std::vector<double>& white,
                           const Bands& bands)
{
    std::vector<Vec3> raw = bands::responses(bands, [&](double nm) { return camera.at(nm); });
    const Vec3 of_white = summed(white, raw);
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(of_white[c] > 0.0))
            throw InputError({.file = {},
                              .field = "--white",
                              .message = "has no light that every channel of the camera sees"});
        for (Vec3& band : raw) band[c] /= of_white[c];
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
    const std::vector<double> white = white_of(viewer, seen);
    std::vector<Vec3> colours;
    Mat3 to_d65 = viewer.white || viewer.camera ? adapted(viewer, white, seen)
                                                : spectral::emission_to_d65(seen.observer);
    if (viewer.camera) {
        colours = balanced(*viewer.camera, white, seen);
        std::vector<Vec3> from, to;
        for (std::vector<double> surface : reflectances(seen)) {
            for (std::size_t k = 0; k < surface.size(); ++k) surface[k] *= white[k];
            from.push_back(summed(surface, colours));
            to.push_back(multiply(to_d65, seen.xyz(surface)));
        }
        to_d65 = fitted(from, to, spectral::d65_white());
    } else {
        for (const bands::Band& band : seen.bands) colours.push_back(band.xyz);
    }
    const Mat3 matrix = multiply(space.from_xyz_d65, to_d65);
    const double gain = std::pow(2.0, viewer.exposure);
    for (Vec3& colour : colours) {
        if (!viewer.raw) colour = multiply(matrix, colour);
        for (double& value : colour) value *= gain;
    }
    return colours;
}

}  // namespace nacre::tool
