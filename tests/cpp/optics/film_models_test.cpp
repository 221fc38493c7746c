// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/film_models.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <numbers>

#include "stacks.h"
#include "support/expect.h"

namespace nacre::optics {
namespace {

using std::numbers::pi;
using test::between;

constexpr Complex kSteel{2.9, 3.1};

double exact(const SingleFilm& film, const Incidence& light)
{
    const FilmStack stack{film.n_ambient, {{film.n_film, film.thickness_nm}}, film.n_base};
    return stack_power(stack, light.cos_ambient, light.wavelength_nm, light.polarisation).R;
}

Polarisation any_polarisation()
{
    return *rc::gen::element(Polarisation::s, Polarisation::p);
}

/// Air above, so that nothing is reflected totally.
SingleFilm any_single_film(Complex base)
{
    return {1.0, *between(1.05, 3.0), base, *between(0.0, 2000.0)};
}

Incidence any_light()
{
    return {*between(0.01, 1.0), *between(360.0, 830.0), any_polarisation()};
}

RC_GTEST_PROP(FilmModels, AiryIsTheMultilayer, ())
{
    const SingleFilm film = any_single_film(*between(1.05, 3.0));
    const Incidence light = any_light();
    RC_ASSERT(std::abs(airy_reflectance(film, light) - exact(film, light)) < 1e-12);
}

RC_GTEST_PROP(FilmModels, OpaqueBaseIsTheMultilayer, ())
{
    const SingleFilm film = any_single_film(*test::index_of_any());
    const Incidence light = any_light();
    RC_ASSERT(std::abs(opaque_base_reflectance(film, light) - exact(film, light)) < 1e-12);
}

RC_GTEST_PROP(FilmModels, FreeFilmAndEtalonAreTheMultilayer, ())
{
    const SingleFilm film = any_single_film(1.0);
    const Incidence light = any_light();
    const double reflected = exact(film, light);
    RC_ASSERT(std::abs(free_film_reflectance(film, light) - reflected) < 1e-12);

    const auto top = fresnel_amplitudes(1.0, film.n_film, light.cos_ambient,
                                        forward_cosine(1.0, film.n_film, light.cos_ambient));
    const double mirror = std::norm(light.polarisation == Polarisation::s ? top.r_s : top.r_p);
    const double phase = round_trip_phase(film, light.cos_ambient, light.wavelength_nm);
    RC_ASSERT(std::abs(etalon_transmittance(mirror, phase) - (1.0 - reflected)) < 1e-11);
}

RC_GTEST_PROP(FilmModels, RecursionIsTheMultilayer, ())
{
    const LitStack lit = *test::lit_stack(test::index_of_any(), test::index_of_any());
    for (const Polarisation which : {Polarisation::s, Polarisation::p}) {
        const Incidence light{lit.cos_ambient, lit.wavelength_nm, which};
        const auto [r, t] = recursion_amplitudes(lit.stack, light);
        const auto exact = stack_amplitudes(lit.stack, lit.cos_ambient, lit.wavelength_nm, which);
        RC_ASSERT(std::abs(r - exact.r) < 1e-12);
        RC_ASSERT(std::abs(t - exact.t) < 1e-12);
        const PowerRatios power = recursion_power(lit.stack, light);
        const PowerRatios reference =
            stack_power(lit.stack, lit.cos_ambient, lit.wavelength_nm, which);
        RC_ASSERT(std::abs(power.T - reference.T) < 1e-12);
        RC_ASSERT(std::abs(power.A - reference.A) < 1e-12);
    }
}

TEST(FilmModels, RecursionEndsAtTheCriticalAngle)
{
    const FilmStack stack{2.0, {{1.0, 57.0}}, 1.5};
    const Incidence light{std::sqrt(0.75), 550.0, Polarisation::s};
    EXPECT_INPUT_ERROR((void)recursion_amplitudes(stack, light),
                       "n[1]: must not be at its critical angle");
    // A little off it the form holds on either side, and behind it light still tunnels.
    for (const double cosine : {std::sqrt(0.75) - 1e-6, std::sqrt(0.75) + 1e-6, 0.8}) {
        const Incidence near{cosine, 550.0, Polarisation::s};
        EXPECT_NEAR(recursion_power(stack, near).R,
                    stack_power(stack, cosine, 550.0, Polarisation::s).R, 1e-12);
    }
    FilmStack apart = stack;
    apart.layers[0].coherent = false;
    EXPECT_INPUT_ERROR((void)recursion_amplitudes(apart, {0.9, 550.0, Polarisation::s}),
                       "n[1]: must be coherent and without a spread");
    EXPECT_INPUT_ERROR((void)recursion_amplitudes({2.0, {{1.0, -57.0}}, 1.5}, light), "d_nm[0]");
}

// With e^{iΔ} in place of its square, a slip of the pen in print, a film has half its thickness.
TEST(FilmModels, RecursionTakesTheWholeRoundTrip)
{
    const Incidence light{1.0, 550.0, Polarisation::s};
    const FilmStack quarter{1.0, {{2.4, 550.0 / 2.4 / 4}}, 1.5};
    const FilmStack half{1.0, {{2.4, 550.0 / 2.4 / 2}}, 1.5};
    const double bright = (2.4 * 2.4 - 1.5) / (2.4 * 2.4 + 1.5);
    EXPECT_NEAR(recursion_power(quarter, light).R, bright * bright, 1e-14);
    EXPECT_NEAR(recursion_power(half, light).R, 0.04, 1e-14);
}

RC_GTEST_PROP(FilmModels, SeriesStaysWithinItsBound, ())
{
    const SingleFilm film = any_single_film(*between(1.05, 3.0));
    const Incidence light = any_light();
    const double error = std::abs(series_reflectance(film, light) - exact(film, light));
    RC_ASSERT(error <= series_error_bound(film, light) + 1e-13);
}

// The figures that the documentation gives: a soap film hardly shows the cut, a film of high index
// on a dense base does.
TEST(FilmModels, ErrorOfTheSeries)
{
    const auto worst = [](const SingleFilm& base, double cosine) {
        double largest = 0.0;
        for (int d = 0; d <= 1000; ++d) {
            SingleFilm film = base;
            film.thickness_nm = d;
            for (const Polarisation which : {Polarisation::s, Polarisation::p}) {
                const Incidence light{cosine, 550.0, which};
                const double error = series_reflectance(film, light) - exact(film, light);
                largest = std::max(largest, std::abs(error));
            }
        }
        return largest;
    };
    EXPECT_NEAR(worst({1.0, 1.33, 1.0, 0.0}, 1.0), 3.04e-5, 1e-7);
    EXPECT_NEAR(worst({1.0, 2.4, 3.5, 0.0}, 1.0), 9.41e-4, 1e-6);
}

// r12 of a metal is complex: with the sign of the other time factor the fringes move.
TEST(FilmModels, OpaqueBaseHasTheSignOfThisTimeFactor)
{
    const Incidence light{1.0, 550.0, Polarisation::s};
    const SingleFilm film{1.0, 2.2, kSteel, 60.0};
    const double r01 = (1.0 - 2.2) / (1.0 + 2.2);
    const Complex other_sign = std::conj((2.2 - kSteel) / (2.2 + kSteel));
    const double phase = round_trip_phase(film, 1.0, 550.0);
    const Complex once = other_sign * std::polar(1.0, phase);
    EXPECT_NEAR(opaque_base_reflectance(film, light), exact(film, light), 1e-14);
    EXPECT_GT(std::abs(std::norm((r01 + once) / (1.0 + r01 * once)) - exact(film, light)), 0.05);
}

// All light is in the first term of the series, and nothing of it is lost (a published form of this
// sum drops r01 + t01 t10 r12 cosδ to r01 cosδ, which is not even R = r01² for a matched base).
TEST(FilmModels, SeriesOfAMatchedBaseIsTheSurface)
{
    const Incidence light{0.7, 550.0, Polarisation::p};
    for (const double d_nm : {0.0, 100.0, 317.0}) {
        const SingleFilm film{1.0, 1.5, 1.5, d_nm};
        EXPECT_NEAR(series_reflectance(film, light), exact(film, light), 1e-15);
    }
}

TEST(FilmModels, BlackFilmKeepsItsDigits)
{
    const Incidence light{1.0, 550.0, Polarisation::s};
    const double thin = free_film_reflectance({1.0, 1.33, 1.0, 1e-9}, light);
    // R → (π d (n² − 1)/λ)² for a film much thinner than a wavelength.
    const double limit = std::pow(pi * 1e-9 * (1.33 * 1.33 - 1.0) / 550.0, 2);
    EXPECT_NEAR(thin / limit, 1.0, 1e-12);
}

RC_GTEST_PROP(FilmModels, UvFormIsComplexFresnel, ())
{
    const Complex base = *test::index_of_any();
    const double ambient = *between(1.0, 2.5), cosine = *between(0.001, 1.0);
    const UvForm uv = uv_interface(ambient, base, cosine);
    const Complex cos_base = forward_cosine(ambient, base, cosine);
    const FresnelAmplitudes direct = fresnel_amplitudes(ambient, base, cosine, cos_base);
    RC_ASSERT(std::abs(Complex(uv.u, uv.v) - cos_base) < 1e-9);
    RC_ASSERT(std::abs(uv.r_s - direct.r_s) < 1e-9);
    RC_ASSERT(std::abs(uv.r_p - direct.r_p) < 1e-9);
}

TEST(FilmModels, UvFormReflectsTotally)
{
    const UvForm uv = uv_interface(1.5, 1.0, std::cos(pi / 3));
    EXPECT_EQ(uv.u, 0.0);
    EXPECT_GT(uv.v, 0.0);
    EXPECT_NEAR(std::abs(uv.r_s), 1.0, 1e-15);
    EXPECT_NEAR(std::abs(uv.r_p), 1.0, 1e-15);
}

// 2 n d cosθ_light cosθ_view: bands of another spacing than interference, 2 n d cosθ.
TEST(FilmModels, PathDifferenceCountsWavelengths)
{
    const SingleFilm film{1.0, 1.5, 1.5, 550.0};  // three half waves: 2·1.5·550/550 = 3
    EXPECT_NEAR(path_difference_bands(film, 1.0, 1.0, 550.0), 0.0, 1e-12);
    const double inside = std::sqrt(1.0 - 0.75 / 2.25);  // θ = 60° in air
    const double waves = 3.0 * inside * inside;
    EXPECT_NEAR(path_difference_bands(film, 0.5, 0.5, 550.0), waves - std::floor(waves), 1e-12);
    EXPECT_NEAR(path_difference_bands(film, 1.0, 0.5, 550.0),
                3.0 * inside - std::floor(3.0 * inside), 1e-12);
}

TEST(FilmModels, SlitsHaveZerosAndMaxima)
{
    constexpr double b = 2000.0, d = 6000.0, lambda = 500.0;
    EXPECT_EQ(slit_intensity(b, d, 0.0, lambda), 1.0);
    EXPECT_NEAR(slit_intensity(b, 0.0, lambda / b, lambda), 0.0, 1e-30);
    EXPECT_NEAR(slit_intensity(b, d, 0.5 * lambda / d, lambda), 0.0, 1e-30);
    // First side maximum of a single slit: tan x = x at x = 4.4934.
    EXPECT_NEAR(slit_intensity(b, 0.0, 4.493409457909064 / pi * lambda / b, lambda),
                0.04719044922581119, 1e-15);
    // Where the double slit peaks, the single slit is the envelope.
    EXPECT_NEAR(slit_intensity(b, d, lambda / d, lambda),
                slit_intensity(b, 0.0, lambda / d, lambda), 1e-15);
}

TEST(FilmModels, EachFormNamesItsDomain)
{
    const Incidence normal{1.0, 550.0, Polarisation::s};
    const Incidence steep{0.1, 550.0, Polarisation::s};
    const SingleFilm on_metal{1.0, 2.2, kSteel, 60.0}, in_glass{1.5, 1.33, 1.0, 60.0};
    EXPECT_INPUT_ERROR((void)airy_reflectance(on_metal, normal), "n[2]: must have k = 0");
    EXPECT_INPUT_ERROR((void)series_reflectance(on_metal, normal), "n[2]: must have k = 0");
    EXPECT_INPUT_ERROR((void)free_film_reflectance(on_metal, normal), "n[2]: must equal n[0]");
    EXPECT_INPUT_ERROR((void)airy_reflectance(in_glass, steep), "critical angle of the film");
    EXPECT_INPUT_ERROR((void)opaque_base_reflectance(in_glass, steep),
                       "critical angle of the film");
    EXPECT_INPUT_ERROR((void)airy_reflectance({1.5, 2.0, 1.0, 10.0}, steep),
                       "critical angle of the base");
    EXPECT_INPUT_ERROR((void)airy_reflectance({1.0, 1.5, 1.5, -1.0}, normal), "d_nm[0]");
    EXPECT_INPUT_ERROR((void)airy_reflectance({1.0, -1.5, 1.5, 1.0}, normal), "n[1]: must be > 0");
    EXPECT_INPUT_ERROR((void)airy_reflectance({1.0, 1.5, 1.5, 1.0}, {0.0, 550.0, Polarisation::s}),
                       "angle_deg");
    EXPECT_INPUT_ERROR((void)airy_reflectance({1.0, 1.5, 1.5, 1.0}, {1.0, NAN, Polarisation::s}),
                       "wavelength_nm");
    EXPECT_INPUT_ERROR((void)etalon_transmittance(1.0, 0.0), "mirror_reflectance");
    EXPECT_INPUT_ERROR((void)uv_interface(1.0, {1.0, -0.1}, 1.0), "n[1]: must have k ≥ 0");
    EXPECT_INPUT_ERROR((void)slit_intensity(0.0, 0.0, 0.0, 550.0), "width_nm");
    EXPECT_INPUT_ERROR((void)slit_intensity(100.0, 50.0, 0.0, 550.0), "spacing_nm");
}

}  // namespace
}  // namespace nacre::optics
