// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectrum_shapes.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "nacre/core/limits.h"
#include "nacre/library/spectrum_library.h"
#include "support/expect.h"
#include "support/not_numbers.h"

namespace nacre::spectral {
namespace {

using test::kInf;
using test::kNan;

/// One shape at one wavelength.
double value(const SpectrumShape& shape, double nm)
{
    return sum_of_shapes({shape}, {nm, nm + 1.0}).values().front();
}

double area(const SpectrumShape& shape, double step)
{
    const Spectrum sum = sum_of_shapes({shape}, even_wavelengths(300.0, 900.0, step));
    return step * std::accumulate(sum.values().begin(), sum.values().end(), 0.0);
}

TEST(SpectrumShapes, BoxHoldsBothOfItsEnds)
{
    const BoxShape box{450.0, 650.0, 2.0};
    EXPECT_EQ(value(box, 449.999), 0.0);
    EXPECT_EQ(value(box, 450.0), 2.0);
    EXPECT_EQ(value(box, 650.0), 2.0);
    EXPECT_EQ(value(box, 650.001), 0.0);
}

TEST(SpectrumShapes, SoftBoxIsHalfAtItsEndsAndKeepsTheArea)
{
    const BoxShape box{450.0, 650.0, 2.0, 40.0};
    EXPECT_EQ(value(box, 430.0), 0.0);
    EXPECT_DOUBLE_EQ(value(box, 440.0), 1.0 - std::sqrt(0.5));  // half a cosine, a quarter of it
    EXPECT_DOUBLE_EQ(value(box, 450.0), 1.0);
    EXPECT_DOUBLE_EQ(value(box, 650.0), 1.0);
    EXPECT_EQ(value(box, 470.0), 2.0);
    EXPECT_NEAR(area(box, 0.5), 400.0, 1e-9);
    EXPECT_NEAR(area(BoxShape{450.0, 650.0, 2.0, 200.0}, 0.5), 400.0, 1e-9);
}

TEST(SpectrumShapes, GaussianHasItsPeakWidthAndArea)
{
    const GaussianShape gaussian{550.0, 40.0, 0.8};
    EXPECT_EQ(value(gaussian, 550.0), 0.8);
    EXPECT_DOUBLE_EQ(value(gaussian, 530.0), 0.4);
    EXPECT_DOUBLE_EQ(value(gaussian, 570.0), 0.4);
    EXPECT_NEAR(area(gaussian, 1.0),
                0.8 * 40.0 * std::sqrt(std::numbers::pi / (4.0 * std::log(2.0))), 1e-9);
}

TEST(SpectrumShapes, PointsReachTheirNeighboursAndEndLevel)
{
    const Spectrum points({400.0, 500.0, 520.0}, {0.1, 0.7, 0.3});
    EXPECT_EQ(value(LinearShape{points}, 380.0), 0.1);
    EXPECT_DOUBLE_EQ(value(LinearShape{points}, 450.0), 0.4);
    EXPECT_EQ(value(LinearShape{points}, 700.0), 0.3);
    EXPECT_EQ(value(SmoothShape{points}, 380.0), 0.1);
    EXPECT_EQ(value(SmoothShape{points}, 500.0), 0.7);
    EXPECT_EQ(value(SmoothShape{points}, 700.0), 0.3);
}

/// Values of scipy.interpolate.PchipInterpolator 1.15.
TEST(MonotoneCubic, AgreesWithScipy)
{
    const MonotoneCubic curve(
        Spectrum({400, 430, 500, 520, 600, 700}, {0.1, 0.7, 0.3, 0.3, 0.9, 0.95}));
    EXPECT_NEAR(curve.at(410), 0.37873015873015875, 1e-14);
    EXPECT_NEAR(curve.at(425), 0.6748015873015873, 1e-14);
    EXPECT_NEAR(curve.at(460), 0.5425655976676385, 1e-14);
    EXPECT_EQ(curve.at(510), 0.3);
    EXPECT_NEAR(curve.at(545), 0.43395610608552637, 1e-14);
    EXPECT_NEAR(curve.at(650), 0.9371112440191388, 1e-14);
    EXPECT_NEAR(curve.at(690), 0.9494720095693779, 1e-14);
    EXPECT_EQ(MonotoneCubic(Spectrum({400, 500}, {0, 1})).at(425), 0.25);

    const MonotoneCubic hill(Spectrum({400, 450, 600}, {0, 1, 0.9}));
    EXPECT_NEAR(hill.at(420), 0.5332, 1e-14);
    EXPECT_NEAR(hill.at(590), 0.9186962962962963, 1e-14);
    const MonotoneCubic steep_end(Spectrum({400, 450, 460}, {0, 1, 0}));
    EXPECT_NEAR(steep_end.at(410), 0.488, 1e-14);
    EXPECT_NEAR(steep_end.at(455), 0.65, 1e-14);
}

TEST(MonotoneCubic, StaysWithinItsNeighbours)
{
    const Spectrum points({400, 405, 430, 500, 501, 600, 700}, {0, 0.01, 1, 1, 0, 0, 0.5});
    const MonotoneCubic curve(points);
    for (std::size_t i = 0; i + 1 < points.values().size(); ++i) {
        const double low = points.wavelengths_nm()[i], high = points.wavelengths_nm()[i + 1];
        double before = points.values()[i];
        for (int step = 0; step <= 100; ++step) {
            const double now = curve.at(low + (high - low) * step / 100.0);
            const bool rises = points.values()[i + 1] >= points.values()[i];
            EXPECT_TRUE(rises ? now >= before - 1e-15 : now <= before + 1e-15)
                << low << " " << step;
            before = now;
        }
    }
}

TEST(SpectrumShapes, SpectrumOfTheLibraryIsWhatItIsOnTheGrid)
{
    const auto grid = even_wavelengths(kFirstNm, kLastNm, 1.0);
    for (const char* key : {"colorchecker/dark-skin", "lamp/hps"}) {
        const NamedSpectrum& spectrum = library_spectrum(key);
        const Spectrum sum = sum_of_shapes({ScaledShape{spectrum, 0.5}}, grid);
        const Sampled expected = spectrum.on_grid();
        for (std::size_t i = 0; i < kWavelengths; ++i)
            EXPECT_DOUBLE_EQ(sum.values()[i], 0.5 * expected[i]) << key << " " << i;
    }
}

TEST(SpectrumShapes, AddUp)
{
    const Spectrum sum = sum_of_shapes(
        {ConstantShape{0.25}, BoxShape{500, 600, 0.5}, GaussianShape{400, 10, -0.125}},
        {400, 500, 700});
    EXPECT_EQ(sum.values(), (std::vector<double>{0.125, 0.75, 0.25}));
}

TEST(SpectrumShapes, NameWhatIsWrongWithThem)
{
    const auto problem = [](const SpectrumShape& shape) {
        return shape_problem(shape).value_or("nothing");
    };
    EXPECT_EQ(problem(ConstantShape{-1.0}), "nothing");
    EXPECT_EQ(problem(ConstantShape{kNan}), "the value must be finite (got nan)");
    EXPECT_EQ(problem(BoxShape{0, 600, 1}), "the first wavelength must be finite and > 0 (got 0)");
    EXPECT_EQ(problem(BoxShape{500, kInf, 1}),
              "the last wavelength must be finite and > 0 (got inf)");
    EXPECT_EQ(problem(BoxShape{600, 500, 1}),
              "the last wavelength must be > the first (got 500 after 600)");
    EXPECT_EQ(problem(BoxShape{500, 600, kInf}), "the value must be finite (got inf)");
    EXPECT_EQ(problem(BoxShape{500, 600, 1, 101}),
              "the edge must be in [0, 100], the width of the box (got 101)");
    EXPECT_EQ(problem(BoxShape{500, 600, 1, kNan}),
              "the edge must be in [0, 100], the width of the box (got nan)");
    EXPECT_EQ(problem(GaussianShape{-5, 10, 1}), "the centre must be finite and > 0 (got -5)");
    EXPECT_EQ(problem(GaussianShape{500, 0, 1}), "the width must be finite and > 0 (got 0)");
    EXPECT_EQ(problem(GaussianShape{500, 10, kNan}), "the peak must be finite (got nan)");
    EXPECT_EQ(problem(ScaledShape{library_spectrum("lamp/hps"), kInf}),
              "the factor must be finite (got inf)");

    EXPECT_INPUT_ERROR((void)sum_of_shapes({}, {400, 500}), "shapes: must be at least one");
    EXPECT_INPUT_ERROR((void)sum_of_shapes({ConstantShape{1}, ConstantShape{kNan}}, {400, 500}),
                       "shapes[1]: the value must be finite");
    EXPECT_INPUT_ERROR((void)sum_of_shapes({ConstantShape{1e308}, ConstantShape{1e308}}, {4, 5}),
                       "shapes: must have a finite sum (got inf at 4 nm)");
}

TEST(SpectrumShapes, AreNotLostBetweenTheWavelengths)
{
    const auto sum = [](SpectrumShape shape) {
        return sum_of_shapes({std::move(shape)}, even_wavelengths(500, 600, 5));
    };
    EXPECT_INPUT_ERROR(
        (void)sum(GaussianShape{552, 4.9, 1}),
        "shapes[0]: the width must be ≥ 5 nm, the step of the wavelengths (got 4.9)");
    EXPECT_INPUT_ERROR((void)sum(BoxShape{551, 554, 1}),
                       "551 … 554 nm lie between two wavelengths, 550 and 555 nm");
    EXPECT_EQ(sum(BoxShape{551, 555, 1}).at(555), 1.0);
    EXPECT_GT(sum(GaussianShape{552, 5, 1}).at(550), 0.6);
    // Outside the range nothing is asked for.
    EXPECT_EQ(sum(GaussianShape{400, 1, 1}).at(550), 0.0);
    EXPECT_EQ(sum(BoxShape{400, 401, 1}).at(550), 0.0);
    EXPECT_EQ(sum(BoxShape{700, 701, 1}).at(550), 0.0);
}

TEST(SpectrumShapes, WavelengthsStandInEqualSteps)
{
    EXPECT_EQ(even_wavelengths(400, 402, 1), (std::vector<double>{400, 401, 402}));
    EXPECT_EQ(even_wavelengths(400, 400.3, 0.1).size(), 4U);
    EXPECT_EQ(even_wavelengths(400, 400.3, 0.1).back(), 400.3);
    EXPECT_INPUT_ERROR((void)even_wavelengths(400, 400, 1), "range: must be two wavelengths");
    EXPECT_INPUT_ERROR((void)even_wavelengths(0, 400, kNan), "(got 0:400)");
    EXPECT_INPUT_ERROR((void)even_wavelengths(0, 400, kNan), "step: must be finite and > 0");
    EXPECT_INPUT_ERROR((void)even_wavelengths(400, kInf, 1), "range: must be two wavelengths");
    EXPECT_INPUT_ERROR((void)even_wavelengths(400, 500, 30),
                       "step: must go into the range a whole number of times (got 30 for 400 … "
                       "500 nm)");
    EXPECT_INPUT_ERROR((void)even_wavelengths(400, 500, 500), "a whole number of times");
    EXPECT_INPUT_ERROR((void)even_wavelengths(400, 500, 1e-4), "at most 100000 samples");
    EXPECT_EQ(even_wavelengths(1, static_cast<double>(kMaxSamples), 1).size(), kMaxSamples);
}

}  // namespace
}  // namespace nacre::spectral
