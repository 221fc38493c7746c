// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/colour.h"

#include <cmath>

#include "colour_references.h"
#include "nacre/library/lights.h"
#include "nacre/spectral/spectrum.h"
#include "support/expect.h"

namespace nacre::spectral {
namespace {

constexpr Vec3 kSkin = {0.20654008, 0.12197225, 0.05136952};  ///< any colour

void expect_near(const Vec3& actual, const Vec3& expected, double tolerance, const char* what)
{
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(actual[c], expected[c], tolerance) << what << ", component " << c;
}

Sampled constant(double value)
{
    Sampled sampled;
    sampled.fill(value);
    return sampled;
}

Sampled bell(const reference::Bell& shape)
{
    Sampled sampled;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const double x = (wavelength_nm(i) - shape.centre_nm) / shape.width_nm;
        sampled[i] = shape.base + shape.amplitude * std::exp(-x * x);
    }
    return sampled;
}

TEST(ReflectanceToXyz, MatchesColourScienceOnTheGrid)
{
    ASSERT_GE(reference::kBells.size(), 20u);
    for (const reference::Bell& shape : reference::kBells)
        expect_near(reflectance_to_xyz(bell(shape), named_illuminant(shape.illuminant),
                                       observer_from_name(shape.observer)),
                    shape.xyz, 1e-13, shape.illuminant);
}

TEST(ReflectanceToXyz, MatchesColourScienceOnMeasuredPatches)
{
    const Illuminant d65 = named_illuminant("D65");
    for (const reference::Patch& patch : reference::kPatches) {
        std::vector<double> wavelengths;
        for (std::size_t i = 0; i < patch.values.size(); ++i)
            wavelengths.push_back(380.0 + 10.0 * static_cast<double>(i));
        const Sampled sampled = Spectrum(wavelengths, patch.values).on_grid();
        expect_near(reflectance_to_xyz(sampled, d65, ObserverId::cie1931), patch.xyz, 1e-12,
                    patch.name);
    }
}

TEST(ReflectanceToXyz, PerfectWhiteHasY1)
{
    for (const auto& name : illuminant_names())
        for (const ObserverId id : {ObserverId::cie1931, ObserverId::cie1964}) {
            const Vec3 white = white_under(named_illuminant(name), id);
            EXPECT_NEAR(white[1], 1.0, 1e-15);
            EXPECT_EQ(white, reflectance_to_xyz(constant(1.0), named_illuminant(name), id));
        }
}

TEST(EmissionToXyz, EqualEnergyHasY1AndScalesLinearly)
{
    const Vec3 one = emission_to_xyz(constant(1.0), ObserverId::cie1931);
    EXPECT_NEAR(one[1], 1.0, 1e-15);
    // Σ x̄ / Σ ȳ and Σ z̄ / Σ ȳ of the published table.
    EXPECT_NEAR(one[0], 106.865469 / 106.856917, 1e-8);
    EXPECT_NEAR(one[2], 106.892251 / 106.856917, 1e-8);
    expect_near(emission_to_xyz(constant(2.5), ObserverId::cie1931),
                {2.5 * one[0], 2.5 * one[1], 2.5 * one[2]}, 1e-14, "scaled");
}

TEST(XyzToXy, BlackHasAFiniteChromaticity)
{
    EXPECT_NEAR(xyz_to_xy({0.3, 0.4, 0.3})[0], 0.3, 1e-15);
    EXPECT_NEAR(xyz_to_xy({0.3, 0.4, 0.3})[1], 0.4, 1e-15);
    EXPECT_EQ(xyz_to_xy({0.0, 0.0, 0.0}), (std::array<double, 2>{1.0 / 3.0, 1.0 / 3.0}));
}

// colour-science 0.4.6, XYZ_to_Lab with the white (0.3127, 0.3290).
TEST(XyzToLab, MatchesColourScience)
{
    expect_near(xyz_to_lab(kSkin, d65_white()),
                {41.52787529439834, 52.63858303579486, 26.92317922201034}, 1e-12, "skin");
    expect_near(xyz_to_lab({0.001, 0.002, 0.0015}, d65_white()),
                {1.8065925925925939, -3.6905624844543876, 0.9697393039145741}, 1e-12,
                "below the linear break");
    expect_near(xyz_to_lab(d65_white(), d65_white()), {100.0, 0.0, 0.0}, 1e-12, "white");
    expect_near(xyz_to_lab({0.0, 0.0, 0.0}, d65_white()), {0.0, 0.0, 0.0}, 1e-12, "black");
}

// colour-science 0.4.6, matrix_chromatic_adaptation_VonKries from A to D65.
TEST(Adaptation, MatchesColourScience)
{
    const Vec3 white = {1.09849383083705, 1.0, 0.355907946191721};
    const Mat3 bradford = {{{0.8446708157874697, -0.1179353538397371, 0.39483692950501376},
                            {-0.13664709501422526, 1.1041295135351894, 0.12918081158821446},
                            {0.07985367045111388, -0.13490757096252193, 3.192529331025619}}};
    const Mat3 cat16 = {{{0.9506832435505792, -0.18740134941659636, 0.2628140207283055},
                         {-0.025668580387721854, 1.0323112379010648, -0.011560463155804293},
                         {-0.0027408294876850557, 0.09097539090115649, 2.8127867187406097}}};
    for (const auto& [how, expected] :
         {std::pair{Adaptation::bradford, bradford}, {Adaptation::cat16, cat16}}) {
        const Mat3 matrix = adaptation(how, white, d65_white());
        for (std::size_t row = 0; row < 3; ++row)
            expect_near(matrix[row], expected[row], 1e-12, "row");
    }
}

TEST(Adaptation, TakesOneWhiteToTheOther)
{
    const Vec3 from = {1.1, 1.0, 0.36}, to = {0.96, 1.0, 0.82};
    for (const Adaptation how : {Adaptation::bradford, Adaptation::cat16})
        expect_near(multiply(adaptation(how, from, to), from), to, 1e-14, "white");
    expect_near(multiply(adaptation(Adaptation::none, from, to), from), from, 0.0, "itself");
}

// colour-science 0.4.6, XYZ_to_RGB with matrices derived from the primaries and Bradford.
TEST(ColourSpace, MatchesColourScience)
{
    struct Case {
        const char* name;
        Vec3 rgb;
    };
    for (const Case& space :
         {Case{"lin_rec709_scene",
               {0.45625871037509486, 0.030762982261410332, 0.04090643182750731}},
          Case{"lin_rec2020_scene",
               {0.29816000368086076, 0.06027883678247416, 0.046821894763376455}},
          Case{"lin_ap1_scene", {0.29211389897660656, 0.060766565038069556, 0.04835774983898303}},
          Case{"xyz_d65", kSkin}})
        expect_near(multiply(colour_space(space.name).from_xyz_d65, kSkin), space.rgb, 1e-12,
                    space.name);
}

TEST(ColourSpace, WhiteIsOneAndTheMatricesAreInverse)
{
    for (const auto& name : colour_space_names()) {
        const ColourSpace& space = colour_space(name);
        expect_near(multiply(space.to_xyz_d65, multiply(space.from_xyz_d65, kSkin)), kSkin, 1e-15,
                    name.c_str());
        if (space.chromaticities)
            expect_near(multiply(space.from_xyz_d65, d65_white()), {1.0, 1.0, 1.0}, 1e-14,
                        name.c_str());
    }
}

// IEC 61966-2-1 and ITU-R BT.709 print the matrix to four decimals.
TEST(ColourSpace, Rec709HasThePublishedMatrix)
{
    const Mat3& matrix = colour_space("lin_rec709_scene").from_xyz_d65;
    expect_near(matrix[0], {3.2406, -1.5372, -0.4986}, 6e-4, "R");
    expect_near(matrix[1], {-0.9689, 1.8758, 0.0415}, 6e-4, "G");
    expect_near(matrix[2], {0.0557, -0.2040, 1.0570}, 6e-4, "B");
}

TEST(ColourSpace, RefusesOtherNamesWithAList)
{
    EXPECT_INPUT_ERROR((void)colour_space("sRGB"),
                       "space: must be one of lin_rec709_scene, lin_rec2020_scene, lin_ap1_scene, "
                       "xyz_d65 (got 'sRGB')");
}

// The colours are CCT_to_uv_Ohno2013(T, Duv) of colour-science 0.4.6. Its locus is integrated to
// 780 nm only, which moves it by up to 7e-7 in uv.
TEST(ColourTemperature, FindsTheNearestPointOfTheLocus)
{
    struct Case {
        double kelvin, duv;
        Vec3 xyz;
    };
    for (const auto& [kelvin, duv, xyz] :
         {Case{2000, 0.01, {1.2363482515717288, 1.0, 0.007536667319464972}},
          Case{3000, -0.02, {1.1752533726053636, 1.0, 0.6890697805178476}},
          Case{5000, 0.0, {0.9814925773395684, 1.0, 0.8625673815346392}},
          Case{6500, 0.003, {0.9516443827498288, 1.0, 1.0905096359338209}},
          Case{12000, -0.004, {1.0038037999920768, 1.0, 1.653019959323986}},
          Case{40000, 0.001, {1.0037938115758165, 1.0, 2.070945929727966}}}) {
        const auto found = colour_temperature(xyz);
        ASSERT_TRUE(found.has_value()) << kelvin;
        EXPECT_NEAR(found->cct_kelvin, kelvin, 3e-5 * kelvin);
        EXPECT_NEAR(found->duv, duv, 1e-6) << kelvin;
    }
}

TEST(ColourTemperature, OfABlackbodyIsItsTemperature)
{
    for (const double kelvin :
         {1000.0, 1004.0, 1100.0, 2856.0, 6504.0, 15000.0, 80000.0, 99950.0, 1e5}) {
        const auto found =
            colour_temperature(emission_to_xyz(blackbody(kelvin).power, ObserverId::cie1931));
        ASSERT_TRUE(found.has_value()) << kelvin;
        EXPECT_NEAR(found->cct_kelvin, kelvin, 1e-6 * kelvin);
        EXPECT_NEAR(found->duv, 0.0, 1e-9);
    }
}

TEST(ColourTemperature, IsNotGivenFarFromTheLocus)
{
    EXPECT_EQ(colour_temperature({0.1, 1.0, 0.1}), std::nullopt);  // green
    EXPECT_EQ(colour_temperature({0.0, 0.0, 0.0}), std::nullopt);
    EXPECT_EQ(colour_temperature({std::nan(""), 1.0, 1.0}), std::nullopt);
    for (const double kelvin : {800.0, 999.9, 100'010.0, 1e6})
        EXPECT_EQ(colour_temperature(emission_to_xyz(blackbody(kelvin).power, ObserverId::cie1931)),
                  std::nullopt)
            << kelvin;
}

TEST(ReflectanceWeights, WhiteIsExactlyOneInEveryRgbSpace)
{
    for (const auto& illuminant : illuminant_names())
        for (const ObserverId id : {ObserverId::cie1931, ObserverId::cie1964})
            for (const auto& name : colour_space_names()) {
                const ColourSpace& space = colour_space(name);
                const Vec3 white = space.chromaticities ? Vec3{1.0, 1.0, 1.0} : d65_white();
                const auto weights = reflectance_weights(named_illuminant(illuminant), id, space);
                expect_near(weights.apply(constant(1.0)), white, 1e-14, name.c_str());
                EXPECT_EQ(weights.space, name);
                EXPECT_EQ(weights.illuminant, illuminant);
            }
}

// The same by the long way: XYZ under the light, Bradford to D65, matrix.
TEST(ReflectanceWeights, AgreeWithXyzAdaptationAndMatrix)
{
    for (const reference::Bell& shape : reference::kBells) {
        const Illuminant light = named_illuminant(shape.illuminant);
        const ObserverId id = observer_from_name(shape.observer);
        const ColourSpace& space = colour_space("lin_ap1_scene");
        const Vec3 white = reflectance_to_xyz(constant(1.0), light, id);
        const Vec3 xyz_d65 =
            multiply(adaptation(Adaptation::bradford, white, d65_white()), shape.xyz);
        const auto weights = reflectance_weights(light, id, space);
        expect_near(weights.apply(bell(shape)), multiply(space.from_xyz_d65, xyz_d65), 1e-13,
                    shape.illuminant);
        expect_near(multiply(weights.to_xyz_d65, weights.apply(bell(shape))), xyz_d65, 1e-13,
                    shape.illuminant);
    }
}

}  // namespace
}  // namespace nacre::spectral
