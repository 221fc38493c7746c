// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/schlick_fit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "films.h"
#include "nacre/optics/microfacet.h"
#include "rough_truth.h"

namespace nacre::lut {
namespace {

using test::constant;

FilmTableRequest film(std::complex<double> n, std::complex<double> substrate)
{
    return test::request(constant(1.0), {{constant(n), 100.0, true}}, constant(substrate),
                         Variation{0, 100.0, 600.0});
}

SchlickFit fit(const FilmTableRequest& request)
{
    return fit_schlick(request, bake_film_tables(request).reflectance);
}

/// Σ c_k (1 − cosθ)^e_k of a row of the table.
spectral::Vec3 reflectance(const SchlickFit& fit, int row, double cosine)
{
    spectral::Vec3 sum{};
    const auto width = static_cast<std::size_t>(fit.coefficients.x.texels);
    for (std::size_t k = 0; k < fit.exponents.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] +=
                static_cast<double>(
                    fit.coefficients.texels[3 * (static_cast<std::size_t>(row) * width + k) + c]) *
                std::pow(1.0 - cosine, fit.exponents[k]);
    return sum;
}

TEST(SchlickFit, IsWithinWhatItStates)
{
    for (const auto& request :
         {film(1.33, 1.0), film(2.2, {2.7, 3.3}), film({2.0, 0.3}, {0.2, 3.0})}) {
        const SchlickFit found = fit(request);
        std::printf("%zu terms, max %.4f rms %.5f\n", found.exponents.size(), found.error_max,
                    found.error_rms);
        EXPECT_LE(found.error_max, 0.01);
        ASSERT_EQ(found.exponents.front(), 0.0);
        EXPECT_EQ(static_cast<std::size_t>(found.coefficients.x.texels), found.exponents.size());
        for (const int row : {0, found.coefficients.y.texels / 2})
            for (const double cosine : {0.06, 0.31, 0.77, 1.0}) {
                const auto exact =
                    exact_film_colour(request, cosine, found.coefficients.y.at(row)).reflectance;
                const auto fitted = reflectance(found, row, cosine);
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_NEAR(fitted[c], exact[c], found.error_max + 1e-3);
            }
    }
}

/// Silicon on 2 µm of oxide: least squares leave 0.0110 at the thinnest, which levelling mends.
TEST(SchlickFit, LevelsTheErrorsThatLeastSquaresLeave)
{
    const IndexOnGrid silicon = test::medium("Si/Green-2008");
    const FilmTableRequest request = test::request(
        constant(1.0), {{silicon, 220.0, true}, {test::medium("SiO2/Malitson"), 2000.0, true}},
        silicon, Variation{0, 20.0, 300.0});
    const SchlickFit found = fit(request);
    std::printf("%zu terms, max %.4f rms %.5f\n", found.exponents.size(), found.error_max,
                found.error_rms);
    EXPECT_LE(found.error_max, 0.01);
    const Table& table = found.coefficients;
    for (const int row : {0, table.y.texels - 1})
        for (int i = 2; i <= 40; ++i) {
            const double cosine = i / 40.0;
            const auto exact = exact_film_colour(request, cosine, table.y.at(row)).reflectance;
            const auto fitted = reflectance(found, row, cosine);
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_NEAR(fitted[c], exact[c], found.error_max + 1e-3);
        }
}

TEST(SchlickFit, BareSubstrateHasTheSameExponents)
{
    const SchlickFit found = fit(film(2.2, 1.5));
    ASSERT_EQ(found.bare.size(), found.exponents.size());
    double normal = found.bare[0][1], grazing = 0.0;
    for (std::size_t k = 0; k < found.exponents.size(); ++k)
        grazing += found.bare[k][1] * std::pow(0.95, found.exponents[k]);
    EXPECT_NEAR(normal, 0.04, 1e-3);
    EXPECT_NEAR(grazing, 0.7, 0.1);
}

/// One bounce; further ones are the same for both techniques, see rough_tables_test.cpp.
TEST(SchlickFit, SummedLobesAgreeWithLightThatWalks)
{
    const FilmTableRequest request = film(2.2, {2.7, 3.3});
    const SchlickFit found = fit(request);
    test::Errors once;
    std::vector<double> weights(513);
    for (const int row : {3, found.coefficients.y.texels / 2}) {
        const test::RoughTruth truth(request, found.coefficients.y.at(row));
        for (const double alpha : {0.02, 0.1, 0.3, 0.55, 0.8})
            for (const double cos_theta : {0.25, 0.6, 0.95}) {
                const double albedo = optics::facet_weights(cos_theta, alpha, weights);
                spectral::Vec3 colour{};
                for (std::size_t i = 0; i < weights.size(); ++i) {
                    const auto R = reflectance(found, row, static_cast<double>(i) / 512.0);
                    for (std::size_t c = 0; c < 3; ++c) colour[c] += albedo * weights[i] * R[c];
                }
                once.add(test::delta_e(request, colour,
                                       truth.albedo(cos_theta, {alpha, alpha}, 20'000).once));
            }
    }
    std::printf("dE00 mean %.3f max %.3f\n", once.mean(), once.max);
    EXPECT_LT(once.mean(), 0.3);
}

}  // namespace
}  // namespace nacre::lut
