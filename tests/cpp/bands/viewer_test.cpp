// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/viewer.h"

#include <numeric>

#include "nacre/bands/response.h"
#include "support/expect.h"

namespace nacre::bands {
namespace {

using spectral::ObserverId, spectral::Vec3;

Bands made(const char* light)
{
    const Light lights[] = {named_light("E"), named_light(light)};
    return make_bands(48, lights, ObserverId::cie1931);
}

std::vector<double> power(const Bands& bands, const char* light)
{
    std::vector<double> found = light_in_bands(bands, named_light(light));
    const double brightness = bands.xyz(found)[1];
    for (double& value : found) value /= brightness;
    return found;
}

void expect_near(const Vec3& found, const Vec3& expected, double tolerance)
{
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], tolerance) << c;
}

/// One that sees what the eye sees.
spectral::Camera eye_as_camera()
{
    const spectral::Observer& eye = spectral::observer(ObserverId::cie1931);
    std::vector<double> nm(eye.x.size());
    std::iota(nm.begin(), nm.end(), double{spectral::kFirstNm});
    spectral::Camera camera{.name = "eye", .sensitivity = {}};
    for (const spectral::Sampled& channel : {eye.x, eye.y, eye.z})
        camera.sensitivity.emplace_back(nm, std::vector(channel.begin(), channel.end()));
    return camera;
}

TEST(Viewer, AnEyeThatAdaptsToNothingSeesTheColoursOfBands)
{
    const Bands bands = made("F11");
    const std::vector<Vec3> colours = colours_of_bands(bands, {});
    for (std::size_t k = 0; k < bands.size(); ++k)
        expect_near(colours[k], bands.bands[k].xyz, 1e-15);
    const std::vector<Vec3> brighter = colours_of_bands(bands, {.exposure = 1.0});
    EXPECT_DOUBLE_EQ(brighter[9][1], 2.0 * colours[9][1]);
}

TEST(Viewer, WhatIsWhiteIsAdaptedTo)
{
    const Bands bands = made("A");
    const std::vector<double> white = power(bands, "A");
    for (const ObserverId observer : {ObserverId::cie1931, ObserverId::cie1964}) {
        const auto colours = colours_of_bands(bands, {.observer = observer, .white = white});
        const Vec3 seen = summed(white, colours);
        expect_near({seen[0] / seen[1], 1.0, seen[2] / seen[1]}, spectral::d65_white(), 1e-12);
    }
    // However bright the light is that is said to be white, a picture stays as bright.
    std::vector<double> bright = white;
    for (double& value : bright) value *= 7.0;
    const Vec3 seen = summed(white, colours_of_bands(bands, {.white = bright}));
    expect_near(seen, summed(white, colours_of_bands(bands, {.white = white})), 1e-12);
}

TEST(Viewer, ACameraIsBalancedAndTakenToColours)
{
    const Bands bands = made("D65");
    const spectral::Camera nikon = spectral::camera("nikon-d5100");
    const std::vector<double> d65 = power(bands, "D65"), incandescent = power(bands, "A");
    expect_near(summed(d65, colours_of_bands(bands, {.camera = nikon})), spectral::d65_white(),
                1e-12);
    const Viewer raw{.camera = nikon, .raw = true, .white = incandescent};
    expect_near(summed(incandescent, colours_of_bands(bands, raw)), {1.0, 1.0, 1.0}, 1e-12);
}

// The matrix that fits the library's reflectances best is exact then, for whatever light there is.
TEST(Viewer, ACameraThatSeesAsTheEyeDoesShowsWhatItSees)
{
    const Bands bands = made("F11");
    const std::vector<Vec3> by_eye = colours_of_bands(bands, {.white = power(bands, "D65")});
    const std::vector<Vec3> by_camera = colours_of_bands(bands, {.camera = eye_as_camera()});
    const std::vector<double> light = power(bands, "F11");
    expect_near(summed(light, by_camera), summed(light, by_eye), 1e-4);
}

TEST(Viewer, BlackIsNotWhite)
{
    const Bands bands = made("line:700");
    const auto refused = [&](const Viewer& viewer, const char* message) {
        EXPECT_INPUT_ERROR(static_cast<void>(colours_of_bands(bands, viewer)), message);
    };
    refused({.white = std::vector(bands.size(), 0.0)}, "white: is black, which cannot be white");
    const std::vector<double> red = power(bands, "line:700");
    refused({.white = red}, "white: must have a white that can be adapted");
    refused({.camera = eye_as_camera(), .white = red, .adaptation = spectral::Adaptation::none},
            "white: has no light that every channel of the camera sees");
}

// Two lamps of one colour: what they light is alike until the light has another spectrum.
TEST(Viewer, MetamersPartUnderAnotherLight)
{
    const Bands bands = made("F11");
    const std::vector<double> even = power(bands, "E");
    std::vector<double> grey(even), comb(even);
    // Of each three bands that follow each other, one more and one less, so that XYZ stay.
    const std::size_t at = 20;
    const auto& [a, b, c, d] = std::tie(bands.bands[at].xyz, bands.bands[at + 1].xyz,
                                        bands.bands[at + 2].xyz, bands.bands[at + 3].xyz);
    const auto determinant = [](const Vec3& p, const Vec3& q, const Vec3& r) {
        return p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
               p[2] * (q[0] * r[1] - q[1] * r[0]);
    };
    const double w[] = {determinant(b, c, d), -determinant(a, c, d), determinant(a, b, d),
                        -determinant(a, b, c)};
    double most = 0.0;
    for (const double part : w) most = std::max(most, std::abs(part));
    for (std::size_t i = 0; i < 4; ++i) comb[at + i] += 0.5 * even[at] * w[i] / most;
    expect_near(bands.xyz(comb), bands.xyz(grey), 1e-12);

    const auto apart = [&](const std::vector<double>& first, const std::vector<double>& second,
                           const char* light) {
        return metamerism(bands, first, second, even, "E", named_light(light));
    };
    EXPECT_NEAR(apart(grey, comb, "E").difference, 0.0, 1e-9);
    EXPECT_GT(apart(grey, comb, "F11").difference, 1.0);
    EXPECT_NEAR(apart(grey, comb, "F11").index, apart(grey, comb, "F11").difference, 1e-9);
    EXPECT_NEAR(apart(grey, grey, "F11").difference, 0.0, 1e-12);

    // Half as bright is another colour under any light, and no metamer.
    std::vector<double> half(grey);
    for (double& value : half) value *= 0.5;
    EXPECT_GT(apart(grey, half, "A").difference, 10.0);
    EXPECT_NEAR(apart(grey, half, "A").index, 0.0, 1e-9);
}

}  // namespace
}  // namespace nacre::bands
