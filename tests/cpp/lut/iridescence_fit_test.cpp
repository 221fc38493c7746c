// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/iridescence_fit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "films.h"
#include "nacre/core/diagnostics.h"

namespace nacre::lut {
namespace {

FilmColours model_of(const IridescenceFit& fit, const std::vector<double>& values)
{
    return [fit, values](double cos_theta, double value) {
        return optics::khr_iridescence(surface_at(fit, values, value), cos_theta);
    };
}

TEST(SphereError, IsZeroForTheTruth)
{
    const FilmTableRequest request = test::soap_film();
    const auto truth = [&](double cos_theta, double value) {
        return exact_film_colour(request, cos_theta, value).reflectance;
    };
    const SphereError error = sphere_error(request, {200.0, 400.0}, truth);
    EXPECT_EQ(error.mean, 0.0);
    EXPECT_EQ(error.max, 0.0);
}

// Black for white is 100 of L* at every angle: the mean is one of shares, which have the sum 1.
TEST(SphereError, MeanIsWeightedByShares)
{
    FilmTableRequest matched = test::request(test::constant(1.0), {}, test::constant(1.0), {});
    const SphereError error = sphere_error(matched, {0.0}, [](double, double) {
        return spectral::Vec3{1, 1, 1};
    });
    EXPECT_NEAR(error.mean, 100.0, 1e-2);
    EXPECT_NEAR(error.max, 100.0, 1e-2);
    const SphereError passed = sphere_error(
        matched, {0.0},
        [](double, double) {
            return spectral::Vec3{1, 1, 1};
        },
        true);
    EXPECT_NEAR(passed.max, 0.0, 1e-9);
}

TEST(SurfaceAt, InterpolatesTheThickness)
{
    const IridescenceFit fit{.film_ior = 1.4,
                             .factor = 0.9,
                             .film_min_nm = 100,
                             .film_max_nm = 300,
                             .base_f0 = {0.1, 0.2, 0.3}};
    EXPECT_DOUBLE_EQ(surface_at(fit, {0.0, 25.0, 50.0}, 25.0).film_nm, 200.0);
    EXPECT_DOUBLE_EQ(surface_at(fit, {42.0}, 42.0).film_nm, 300.0);
}

// The model's own case, one clear film in air: what remains is the error of the model, not of the
// search. Parameters of the film itself are one of the points that the search could have found.
TEST(FitIridescence, BeatsTheFilmsOwnParameters)
{
    const FilmTableRequest request = test::soap_film();
    const std::vector<double> values{400.0};
    const IridescenceFit own{
        .film_ior = 1.333, .factor = 1.0, .film_min_nm = 400, .film_max_nm = 400, .base_f0 = {}};
    const SphereError of_own = sphere_error(request, values, model_of(own, values));
    const IridescenceFit fit = fit_iridescence(request, values);
    const SphereError of_fit = sphere_error(request, values, model_of(fit, values));
    EXPECT_LT(of_fit.mean, of_own.mean);
    EXPECT_GE(fit.film_ior, 1.0);
    EXPECT_GE(fit.factor, 0.0);
    EXPECT_LE(fit.factor, 1.0);
    for (const double f0 : fit.base_f0) {
        EXPECT_GE(f0, 0.0);
        EXPECT_LE(f0, 1.0);
    }
}

// A bare metal needs no film: Schlick with the metal's colour is within a few ΔE00.
TEST(FitIridescence, FindsABareMetal)
{
    const FilmTableRequest request =
        test::request(test::constant(1.0), {}, test::medium("Au/Johnson"), {});
    const IridescenceFit fit = fit_iridescence(request, {0.0});
    EXPECT_LT(sphere_error(request, {0.0}, model_of(fit, {0.0})).mean, 1.0);
}

TEST(FitIridescence, ARangeGrowsWithTheThickness)
{
    const FilmTableRequest request = test::soap_film();
    const std::vector<double> values{200.0, 300.0, 400.0};
    const IridescenceFit fit = fit_iridescence(request, values);
    EXPECT_GT(fit.film_max_nm, fit.film_min_nm);
    const SphereError error = sphere_error(request, values, model_of(fit, values));
    EXPECT_LT(error.mean, 10.0);
}

TEST(FitIridescence, IsTheSameEachTime)
{
    const FilmTableRequest request = test::soap_film();
    const IridescenceFit a = fit_iridescence(request, {250.0}),
                         b = fit_iridescence(request, {250.0});
    EXPECT_EQ(a.film_ior, b.film_ior);
    EXPECT_EQ(a.film_max_nm, b.film_max_nm);
    EXPECT_EQ(a.base_f0, b.base_f0);
}

TEST(FitIridescence, RefusesGain)
{
    const FilmTableRequest request =
        test::request(test::constant(1.0), {}, test::constant({1.5, -0.1}), {});
    EXPECT_THROW(static_cast<void>(fit_iridescence(request, {0.0})), InputError);
}

}  // namespace
}  // namespace nacre::lut
