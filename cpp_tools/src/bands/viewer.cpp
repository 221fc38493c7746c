// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/viewer.h"

#include <cmath>
#include <string>
#include <utility>

#include "nacre/bands/response.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/spectrum_library.h"

namespace nacre::bands {
namespace {

using spectral::Mat3, spectral::multiply;
using spectral::Vec3;

[[noreturn]] void refuse_white(std::string message)
{
    throw InputError({.file = {}, .field = "white", .message = std::move(message)});
}

/// What is white, of Y = 1; D65 where nobody says.
std::vector<double> white_of(const Viewer& viewer, const Bands& bands)
{
    std::vector<double> power =
        viewer.white ? *viewer.white : light_in_bands(bands, named_light("D65"));
    const double brightness = bands.xyz(power)[1];
    if (!(brightness > 0.0)) refuse_white("is black, which cannot be white");
    for (double& value : power) value /= brightness;
    return power;
}

/// To XYZ relative to D65, with a light as white.
Mat3 adapted(const Viewer& viewer, const std::vector<double>& light, const Bands& seen,
             std::string_view way_out)
{
    const Mat3 to_d65 = spectral::emission_to_d65(seen.observer);
    Vec3 white = multiply(to_d65, seen.xyz(light));
    const double brightness = white[1];
    for (double& value : white) value /= brightness;
    try {
        return multiply(
            spectral::adaptation(viewer.adaptation, white, spectral::d65_white(), way_out), to_d65);
    } catch (const InputError& error) {
        refuse_white(error.diagnostics().front().message);
    }
}

/// Of the library, at each band.
std::vector<std::vector<double>> reflectances(const Bands& bands)
{
    std::vector<double> nm;
    for (const Band& band : bands.bands) nm.push_back(band.wavelength_nm);
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
    std::vector<Vec3> raw = responses(bands, [&](double nm) { return camera.at(nm); });
    const Vec3 of_white = summed(white, raw);
    for (std::size_t c = 0; c < 3; ++c) {
        if (!(of_white[c] > 0.0))
            refuse_white("has no light that every channel of the camera sees");
        for (Vec3& band : raw) band[c] /= of_white[c];
    }
    return raw;
}

}  // namespace

Vec3 summed(std::span<const double> values, std::span<const Vec3> colours)
{
    Vec3 sum{};
    for (std::size_t k = 0; k < values.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += values[k] * colours[k][c];
    return sum;
}

std::vector<Vec3> colours_of_bands(const Bands& bands, const Viewer& viewer,
                                   std::string_view way_out)
{
    const Bands seen = seen_by(bands, viewer.observer);
    const std::vector<double> white = white_of(viewer, seen);
    std::vector<Vec3> colours;
    Mat3 to_d65 = viewer.white || viewer.camera ? adapted(viewer, white, seen, way_out)
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
        for (const Band& band : seen.bands) colours.push_back(band.xyz);
    }
    const double gain = std::pow(2.0, viewer.exposure);
    for (Vec3& colour : colours) {
        if (!viewer.raw) colour = multiply(to_d65, colour);
        for (double& value : colour) value *= gain;
    }
    return colours;
}

Metamerism metamerism(const Bands& bands, std::span<const double> first,
                      std::span<const double> second, std::span<const double> power,
                      std::string_view name, const Light& light)
{
    const std::vector<double> factors = exchange(bands, power, name, light);
    const Vec3 white = bands.xyz(light_in_bands(bands, light));
    const Vec3 relative = {white[0] / white[1], 1.0, white[2] / white[1]};
    const auto exchanged = [&](std::span<const double> radiance) {
        std::vector<double> values(radiance.begin(), radiance.end());
        for (std::size_t k = 0; k < values.size(); ++k) values[k] *= factors[k];
        return bands.xyz(values);
    };
    const Vec3 one = exchanged(first), other = exchanged(second);
    const Vec3 one_before = bands.xyz(first), other_before = bands.xyz(second);
    Vec3 corrected = other;
    for (std::size_t c = 0; c < 3; ++c)
        if (other_before[c] > 0.0) corrected[c] *= one_before[c] / other_before[c];
    const auto difference = [&](const Vec3& to) {
        return spectral::delta_e_2000(spectral::xyz_to_lab(one, relative),
                                      spectral::xyz_to_lab(to, relative));
    };
    return {.difference = difference(other), .index = difference(corrected)};
}

}  // namespace nacre::bands
