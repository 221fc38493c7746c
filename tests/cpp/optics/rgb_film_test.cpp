// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/rgb_film.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "nacre/optics/fresnel.h"

namespace nacre::optics {
namespace {

using spectral::Vec3;

double schlick(double f0, double cos_theta)
{
    return f0 + (1.0 - f0) * std::pow(1.0 - cos_theta, 5.0);
}

double unpolarised(Complex n, double cos_theta)
{
    const FresnelAmplitudes r =
        fresnel_amplitudes(1.0, n, cos_theta, forward_cosine(1.0, n, cos_theta));
    return (std::norm(r.r_s) + std::norm(r.r_p)) / 2.0;
}

TEST(KhrIridescence, FactorZeroIsSchlick)
{
    const KhrIridescence surface{
        .film_ior = 1.4, .film_nm = 300, .base_f0 = {0.9, 0.5, 0.04}, .factor = 0.0};
    for (const double cosine : {1.0, 0.6, 0.1})
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(khr_iridescence(surface, cosine)[c], schlick(surface.base_f0[c], cosine),
                        1e-14);
}

// Past many fringes the Gaussians have died out, and what is left is the series of both faces
// without interference: R12 + T12² R23/(1 − R12 R23).
TEST(KhrIridescence, ThickFilmAddsIntensities)
{
    const double n = 1.5, cosine = 0.7;
    const KhrIridescence surface{.film_ior = n, .film_nm = 50000, .base_f0 = {0.5, 0.25, 0.81}};
    const double top = schlick(std::pow((n - 1.0) / (n + 1.0), 2), cosine);
    const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (n * n));
    const Vec3 colour = khr_iridescence(surface, cosine);
    for (std::size_t c = 0; c < 3; ++c) {
        const double root = std::sqrt(surface.base_f0[c] + 1e-4);
        const double base = (1.0 + root) / (1.0 - root);
        const double bottom = schlick(std::pow((base - n) / (base + n), 2), inside);
        EXPECT_NEAR(colour[c], top + (1 - top) * (1 - top) * bottom / (1 - top * bottom), 1e-12);
    }
}

// Without a path the faces of a film in air cancel, but for the white of the extension's matrix:
// equal-energy white becomes (1.20, 0.95, 0.91), a tenth off 1 where it is below.
TEST(KhrIridescence, FilmInAirVanishesWithItsThickness)
{
    const double both_faces = 2.0 * std::pow(0.33 / 2.33, 2);
    const Vec3 colour = khr_iridescence({.film_ior = 1.33, .film_nm = 0, .base_f0 = {}}, 1.0);
    for (const double channel : colour) EXPECT_NEAR(channel, 0.0, 0.1 * both_faces);
}

// A film whose index is the root of the base's cancels green where it is a quarter wave thick, and
// is not seen there as a half wave. F0 0.04 is n = 1.5.
TEST(KhrIridescence, QuarterWaveFilmCancelsGreen)
{
    const double n = std::sqrt(1.5), quarter_nm = 550.0 / (4.0 * n);
    const auto green = [n](double nm) {
        return khr_iridescence({.film_ior = n, .film_nm = nm, .base_f0 = {0.04, 0.04, 0.04}},
                               1.0)[1];
    };
    EXPECT_LT(green(quarter_nm), 0.1 * green(2.0 * quarter_nm));
    EXPECT_NEAR(green(2.0 * quarter_nm), 0.04, 0.01);
}

// Values of the code that the extension prints, evaluated in Python with 64-bit numbers.
TEST(KhrIridescence, MatchesTheExtension)
{
    const Vec3 colour = khr_iridescence(
        {.film_ior = 1.3, .film_nm = 400, .base_f0 = {0.9, 0.6, 0.3}, .factor = 1.0}, 0.8);
    EXPECT_NEAR(colour[0], 0.816026935803, 1e-9);
    EXPECT_NEAR(colour[1], 0.507241617106, 1e-9);
    EXPECT_NEAR(colour[2], 0.292224935132, 1e-9);
}

// A film of the base's own index has one face: Fresnel, the same in every channel. What the
// series leaves out of the higher orders is nothing, as there is no lower face.
TEST(MaterialXFilm, MatchedFilmIsTheBase)
{
    for (const double cosine : {1.0, 0.5, 0.2}) {
        const Vec3 colour = materialx_film(
            {.film_ior = 1.5, .film_nm = 300, .base_n = {1.5, 1.5, 1.5}, .base_k = {}}, cosine);
        const double expected = unpolarised(1.5, cosine);
        // Equal-energy white in the RGB of CIE 1931, whose matrix has rows of sum 1 to 4 digits.
        for (const double channel : colour) EXPECT_NEAR(channel, expected, 1e-4);
    }
}

// Values of the shader in MaterialX 1.39.5
// (libraries/pbrlib/genglsl/lib/mx_microfacet_specular.glsl), evaluated in Python with 64-bit
// numbers: a base like titanium under 250 nm of 1.5, beyond the Brewster angle.
TEST(MaterialXFilm, MatchesTheShader)
{
    const Vec3 colour = materialx_film(
        {.film_ior = 1.5, .film_nm = 250, .base_n = {2.5, 2.3, 2.0}, .base_k = {3.3, 3.0, 2.6}},
        0.4);
    EXPECT_NEAR(colour[0], 0.596383576351, 1e-9);
    EXPECT_NEAR(colour[1], 0.515468299615, 1e-9);
    EXPECT_NEAR(colour[2], 0.330476738158, 1e-9);
}

}  // namespace
}  // namespace nacre::optics
