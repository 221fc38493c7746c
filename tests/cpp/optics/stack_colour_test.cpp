// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/stack_colour.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/optics/multilayer.h"
#include "support/expect.h"

namespace nacre::optics {
namespace {

using spectral::Vec3;

constexpr double kTruthStepNm = 0.05;

spectral::ColourWeights weights_under(const char* illuminant,
                                      spectral::Adaptation how = spectral::Adaptation::bradford)
{
    return spectral::reflectance_weights(spectral::named_illuminant(illuminant),
                                         spectral::ObserverId::cie1931,
                                         spectral::colour_space("lin_rec709_scene"), how);
}

double cosine(double angle_deg)
{
    return std::cos(angle_deg * std::numbers::pi / 180.0);
}

DispersiveStack stack_of(const std::vector<const char*>& keys)
{
    DispersiveStack stack;
    for (const char* key : keys) stack.media.push_back(spectral::library_medium(key).constants);
    stack.coherent.assign(keys.size() - 2, true);
    return stack;
}

double worst(const Vec3& a, const Vec3& b)
{
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// Errors over many thicknesses and angles.
struct Study {
    double error = 0.0, evaluations = 0.0;
    std::size_t most = 0, colours = 0;

    void add(AdaptiveColours& adaptive, SummedColours& truth, const std::vector<double>& d_nm,
             double angle_deg)
    {
        const ObliqueLight light{.cos_ambient = cosine(angle_deg)};
        const StackColour got = adaptive.at(d_nm, light), wanted = truth.at(d_nm, light);
        error = std::max({error, worst(got.reflectance, wanted.reflectance),
                          worst(got.transmittance, wanted.transmittance)});
        evaluations += static_cast<double>(got.evaluations);
        most = std::max(most, got.evaluations);
        ++colours;
    }
    [[nodiscard]] double mean_evaluations() const
    {
        return evaluations / static_cast<double>(colours);
    }
};

struct Both {
    AdaptiveColours adaptive;
    SummedColours truth;

    explicit Both(const DispersiveStack& stack,
                  const spectral::ColourWeights& weights = weights_under("D65"))
        : adaptive(stack, weights), truth(stack, fine_quadrature(weights, kTruthStepNm))
    {}
};

TEST(StackColour, SoapFilmsTakeSixteenWavelengths)
{
    Both soap(stack_of({"air", "water/Daimon-20C", "air"}));
    Study study;
    for (double d_nm = 50.0; d_nm <= 1500.0; d_nm += 50.0)
        for (const double angle : {0.0, 30.0, 60.0, 80.0})
            study.add(soap.adaptive, soap.truth, {d_nm}, angle);
    EXPECT_LE(study.error, 1e-3);
    EXPECT_LE(study.most, 16u);
}

/// (HL)^pairs H, a cavity of `half_waves` of L, and the same mirror again, on glass.
struct Etalon {
    std::vector<const char*> keys = {"air"};
    std::vector<double> d_nm;

    Etalon(double line_nm, int pairs, int half_waves)
    {
        const auto quarter = [line_nm](const char* key) {
            return 0.25 * line_nm / spectral::library_medium(key).constants->at(line_nm).real();
        };
        const char *high = "Nb2O5/Lemarchand", *low = "SiO2/Malitson";
        const auto add = [&](const char* key, double quarters) {
            keys.push_back(key);
            d_nm.push_back(quarters * quarter(key));
        };
        const auto mirror = [&] {
            for (int i = 0; i < pairs; ++i) {
                add(high, 1.0);
                add(low, 1.0);
            }
            add(high, 1.0);
        };
        mirror();
        add(low, 2.0 * half_waves);
        mirror();
        keys.emplace_back("N-BK7/SCHOTT");
    }
};

/// Lines of 0.2 … 7 nm; one of 2 nm is that of 3 pairs and 6 half-waves, or of 4 and 1.
TEST(StackColour, NarrowLinesAreNotLost)
{
    for (const auto& [pairs, half_waves] :
         {std::pair{1, 20}, {2, 3}, {2, 10}, {3, 1}, {3, 6}, {4, 1}, {5, 1}}) {
        SCOPED_TRACE(testing::Message() << pairs << " pairs, " << half_waves << " half-waves");
        Study study;
        for (double line_nm = 430.0; line_nm <= 670.0; line_nm += 40.0) {
            const Etalon etalon(line_nm, pairs, half_waves);
            Both both(stack_of(etalon.keys));
            for (const double angle : {0.0, 20.0, 45.0})
                study.add(both.adaptive, both.truth, etalon.d_nm, angle);
        }
        EXPECT_LE(study.error, 1e-3);
        EXPECT_LE(study.mean_evaluations(), 40.0);
    }
}

/// A line that a sum at 1 nm mostly misses: its peak is 0.003 nm wide.
TEST(StackColour, LinesMayBeNarrowerThanAnyStep)
{
    const auto medium = [](double n) { return spectral::constant_index(n); };
    const auto high = medium(2.4), low = medium(1.4);
    DispersiveStack stack{.media = {medium(1.0)}, .coherent = {}};
    std::vector<double> d_nm;
    const auto add = [&](const spectral::OpticalConstantsPtr& n, double thickness_nm) {
        stack.media.push_back(n);
        stack.coherent.push_back(true);
        d_nm.push_back(thickness_nm);
    };
    constexpr double line_nm = 549.537;
    for (int mirror = 0; mirror < 2; ++mirror) {
        for (int i = 0; i < 8; ++i) {
            add(high, line_nm / 4.0 / 2.4);
            if (i < 7) add(low, line_nm / 4.0 / 1.4);
        }
        if (mirror == 0) add(low, line_nm / 2.0 / 1.4);
    }
    stack.media.push_back(medium(1.0));

    const auto weights = weights_under("E");
    AdaptiveColours adaptive(stack, weights);
    const ObliqueLight light{.cos_ambient = 1.0};
    const StackColour got = adaptive.at(d_nm, light);
    // A Lorentz curve of height 1 adds π/2 of its width, besides what leaks through off the line.
    const auto transmittance = [&](double nm) {
        FilmStack film{.ambient = 1.0, .layers = {}, .substrate = 1.0};
        for (std::size_t j = 0; j < d_nm.size(); ++j)
            film.layers.push_back({.n = stack.media[j + 1]->at(nm), .thickness_nm = d_nm[j]});
        return stack_power(film, 1.0, nm, Polarisation::s).T;
    };
    Vec3 wanted{};
    const auto add_sum = [&](double from, double to, int steps) {
        const double h = (to - from) / steps;
        for (int k = 0; k < steps; ++k) {
            const double nm = from + (k + 0.5) * h, T = transmittance(nm);
            const auto i = static_cast<std::size_t>(nm - spectral::kFirstNm);
            const double part = nm - spectral::wavelength_nm(i);
            for (std::size_t c = 0; c < 3; ++c)
                wanted[c] +=
                    h * T * std::lerp(weights.weight[c][i], weights.weight[c][i + 1], part);
        }
    };
    add_sum(360.0, 549.0, 1890);
    add_sum(549.0, 549.5, 500);
    add_sum(549.5, 549.6, 20000);
    add_sum(549.6, 550.0, 400);
    add_sum(550.0, 830.0, 2800);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(got.transmittance[c], wanted[c], 3e-4) << "channel " << c;
    EXPECT_LE(got.evaluations, 100u);
}

/// Metals, whose tables have corners, as film and as base; water under glass beyond the critical
/// angle; opaque films.
TEST(StackColour, AnyStackIsNearTheFineSum)
{
    const std::vector<std::vector<const char*>> stacks = {
        {"air", "SiO2/Malitson", "Fe/Johnson"},
        {"air", "Ag/Johnson", "SiO2/Malitson", "Ag/Johnson", "N-BK7/SCHOTT"},
        {"air", "TiO2/Sarkar", "Au/Johnson", "water/Daimon-20C"},
        {"N-BK7/SCHOTT", "SiO2/Malitson", "N-BK7/SCHOTT"},
        {"N-BK7/SCHOTT", "Ag/Johnson", "air"}};
    for (const auto& keys : stacks) {
        SCOPED_TRACE(testing::Message() << keys[0] << ' ' << keys[1] << ' ' << keys[2]);
        Both both(stack_of(keys));
        Study study;
        for (const double d_nm : {0.0, 5.0, 40.0, 150.0, 700.0, 5000.0})
            for (const double angle : {0.0, 35.0, 60.0, 85.0})
                study.add(both.adaptive, both.truth, std::vector<double>(keys.size() - 2, d_nm),
                          angle);
        EXPECT_LE(study.error, 1.5e-3);
        EXPECT_LE(study.mean_evaluations(), 96.0);
    }
}

TEST(StackColour, PolarisationsAddUp)
{
    AdaptiveColours oil(stack_of({"air", "TiO2/Sarkar", "water/Daimon-20C"}), weights_under("D65"));
    const std::vector<double> d_nm = {420.0};
    const auto at = [&](double share) {
        return oil.at(d_nm, {.cos_ambient = cosine(60.0), .share_of_s = share}).reflectance;
    };
    const Vec3 s = at(1.0), p = at(0.0), both = at(0.5);
    EXPECT_GT(worst(s, p), 0.1);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(both[c], 0.5 * (s[c] + p[c]), 1e-12);
}

/// One line of sodium has an interval of its own, and takes few wavelengths however thick the film.
TEST(StackColour, LinesOfLampsTakeFewWavelengths)
{
    Both sodium(stack_of({"air", "water/Daimon-20C", "air"}),
                weights_under("line:589.3", spectral::Adaptation::none));
    Study study;
    for (const double d_nm : {100.0, 1000.0, 4000.0})
        study.add(sodium.adaptive, sodium.truth, {d_nm}, 30.0);
    EXPECT_LE(study.error, 1e-3);
    EXPECT_LE(study.most, 8u);
}

/// Fringes of 2 … 0.1 nm: interpolated as long as that pays, then summed as finely as they need.
TEST(StackColour, ThickFilmsKeepTheirFringes)
{
    Both soap(stack_of({"air", "water/Daimon-20C", "air"}));
    for (const double d_nm : {20e3, 60e3, 110e3, 400e3}) {
        Study study;
        for (const double part : {0.0, 0.2, 0.4, 0.6})
            study.add(soap.adaptive, soap.truth, {d_nm + 100.0 * part}, 20.0);
        EXPECT_LE(study.error, 1e-4) << d_nm;
        EXPECT_LE(study.mean_evaluations(), d_nm < 60e3 ? 400.0 : 9401.0);
    }
    const StackColour metres = soap.adaptive.at(std::vector<double>{1e300}, {.cos_ambient = 1.0});
    for (const double value : metres.reflectance) EXPECT_NEAR(value, 0.04, 0.03);
}

TEST(StackColour, IncoherentLayersAreSummedAtOneNanometre)
{
    DispersiveStack stack = stack_of({"air", "N-BK7/SCHOTT", "SiO2/Malitson", "Al/Rakic"});
    stack.coherent = {false, true};
    const auto weights = weights_under("A");
    AdaptiveColours adaptive(stack, weights);
    SummedColours summed(stack, nanometre_quadrature(weights));
    const std::vector<double> d_nm = {2e6, 300.0};
    const ObliqueLight light{.cos_ambient = cosine(20.0)};
    EXPECT_EQ(adaptive.at(d_nm, light).reflectance, summed.at(d_nm, light).reflectance);
    EXPECT_EQ(adaptive.at(d_nm, light).evaluations, spectral::kWavelengths);
}

/// The sum at 1 nm is that of the powers themselves.
TEST(StackColour, SumsAreThoseOfTheMultilayer)
{
    const DispersiveStack stack = stack_of({"air", "Ag/Johnson", "SiO2/Malitson", "Fe/Johnson"});
    const auto weights = weights_under("D65");
    const std::vector<double> d_nm = {12.0, 230.0};
    spectral::Sampled R;
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i) {
        const double nm = spectral::wavelength_nm(i);
        FilmStack film{.ambient = 1.0, .layers = {}, .substrate = stack.media[3]->at(nm)};
        for (std::size_t j = 0; j < 2; ++j)
            film.layers.push_back({.n = stack.media[j + 1]->at(nm), .thickness_nm = d_nm[j]});
        R[i] = stack_power_unpolarised(film, cosine(50.0), nm).R;
    }
    const Vec3 wanted = weights.apply(R);
    const StackColour got =
        SummedColours(stack, nanometre_quadrature(weights)).at(d_nm, {.cos_ambient = cosine(50.0)});
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got.reflectance[c], wanted[c], 1e-12);
    EXPECT_EQ(got.evaluations, spectral::kWavelengths);
}

TEST(StackColour, RefusesMediaThatDoNotFit)
{
    const auto weights = weights_under("D65");
    const auto colour = [&](const std::vector<const char*>& keys) {
        AdaptiveColours adaptive(stack_of(keys), weights);
        return adaptive.at(std::vector<double>(keys.size() - 2, 100.0), {.cos_ambient = 1.0});
    };
    EXPECT_INPUT_ERROR(colour({"Au/Johnson", "air"}), "n[0]: must not absorb in the ambient");
    EXPECT_INPUT_ERROR(colour({"air", "TiO2/Devore-o", "air"}),
                       "n[1]: must be within the data, 430 … 1530 nm");
}

}  // namespace
}  // namespace nacre::optics
