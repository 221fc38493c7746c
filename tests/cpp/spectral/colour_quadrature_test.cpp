// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/colour_quadrature.h"
#include "nacre/library/lights.h"

#include <cmath>

#include "support/expect.h"

namespace nacre::spectral {
namespace {

ColourWeights weights_under(const char* illuminant)
{
    return reflectance_weights(named_illuminant(illuminant), ObserverId::cie1931,
                               colour_space("lin_rec709_scene"));
}

template <class Function>
Vec3 colour(const ColourQuadrature& quadrature, Function reflectance)
{
    std::vector<double> values;
    for (const double nm : quadrature.wavelength_nm) values.push_back(reflectance(nm));
    return quadrature_sum(quadrature, values);
}

double white(double)
{
    return 1.0;
}
/// About one fringe every 60 nm at 550 nm.
double fringes(double nm)
{
    return 0.5 + 0.5 * std::cos(2.0 * 3.14159265358979 * 5000.0 / nm);
}

void expect_near(const Vec3& a, const Vec3& b, double tolerance)
{
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

double distance(const Vec3& a, const Vec3& b)
{
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

TEST(ColourQuadrature, OneNanometreIsTheSumOfTheWeights)
{
    const ColourWeights weights = weights_under("D65");
    Sampled reflectance;
    for (std::size_t i = 0; i < kWavelengths; ++i) reflectance[i] = fringes(wavelength_nm(i));
    const ColourQuadrature quadrature = nanometre_quadrature(weights);
    EXPECT_EQ(quadrature.wavelength_nm.size(), kWavelengths);
    expect_near(colour(quadrature, fringes), weights.apply(reflectance), 1e-14);
    expect_near(colour(stepped_quadrature(weights, 1), fringes), weights.apply(reflectance), 1e-14);
    expect_near(colour(hierarchical_quadrature(weights, 0), fringes), weights.apply(reflectance),
                1e-14);
}

TEST(ColourQuadrature, FineStepsConverge)
{
    const ColourWeights weights = weights_under("D65");
    const ColourQuadrature finest = fine_quadrature(weights, 0.025),
                           fine = fine_quadrature(weights, 0.05);
    EXPECT_EQ(fine.wavelength_nm.size(), 9401u);
    EXPECT_EQ(fine.wavelength_nm.back(), kLastNm);
    expect_near(colour(fine, white), {1.0, 1.0, 1.0}, 2e-6);
    expect_near(colour(fine, fringes), colour(finest, fringes), 1e-7);
    expect_near(colour(fine, fringes), colour(nanometre_quadrature(weights), fringes), 2e-4);
}

TEST(ColourQuadrature, SteppingGetsWorseAndTintsWhite)
{
    const ColourWeights weights = weights_under("D65");
    const Vec3 truth = colour(fine_quadrature(weights, 0.05), fringes);
    EXPECT_LT(distance(colour(stepped_quadrature(weights, 8), fringes), truth), 0.01);
    EXPECT_GT(distance(colour(stepped_quadrature(weights, 64), fringes), truth), 0.05);
    EXPECT_GT(distance(colour(stepped_quadrature(weights, 64), white), {1.0, 1.0, 1.0}), 0.05);
    EXPECT_EQ(stepped_quadrature(weights, kLargestStepNm).wavelength_nm,
              (std::vector<double>{360.0, 488.0, 616.0, 744.0}));
}

TEST(ColourQuadrature, StepsBeginWhereThereIsSomethingToSum)
{
    const auto first = [](const char* illuminant, int from_nm) {
        const auto quadrature = stepped_quadrature(weights_under(illuminant), 64, from_nm);
        return quadrature.wavelength_nm.empty() ? 0.0 : quadrature.wavelength_nm.front();
    };
    EXPECT_EQ(first("D65", 450), 450.0);
    EXPECT_EQ(first("study/box", kFirstNm), 450.0);  // 1 from there on
    EXPECT_EQ(first("study/box", 500), 500.0);
    EXPECT_EQ(first("study/box", 700), 0.0);  // nothing from 651 nm on
}

TEST(ColourQuadrature, HierarchyKeepsWhiteUnderAnyLight)
{
    for (const char* illuminant : {"D65", "F11", "line:435.8@1,546.1@0.8"})
        for (int level = 0; level <= kHighestLevel; ++level) {
            const auto quadrature = hierarchical_quadrature(weights_under(illuminant), level);
            expect_near(colour(quadrature, white), {1.0, 1.0, 1.0}, 1e-12);
            EXPECT_LE(quadrature.weight.size(), 512u >> level) << level;
        }
    EXPECT_EQ(hierarchical_quadrature(weights_under("D65"), 7).wavelength_nm.size(), 4u);
    EXPECT_EQ(hierarchical_quadrature(weights_under("D65"), 8).wavelength_nm,
              (std::vector<double>{451.5, 707.5}));
}

}  // namespace
}  // namespace nacre::spectral
