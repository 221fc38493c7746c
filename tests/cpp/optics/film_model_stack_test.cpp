// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/film_model_stack.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "stacks.h"

namespace nacre::optics {
namespace {

using test::between;

constexpr double kCellNm = 1.0;

/// One stack in all lanes, its light at wavelengths 10 nm apart.
struct Spread {
    FilmStack stack;
    double cos_0;

    [[nodiscard]] static double wavelength(std::size_t lane)
    {
        return 400.0 + 10.0 * static_cast<double>(lane);
    }
    /// @param from_below  listed from the substrate up, and the angle is that below
    [[nodiscard]] LaneStack lanes(bool from_below = false) const
    {
        LaneStack result;
        result.layers.resize(stack.layers.size());
        for (std::size_t i = 0; i < kLanes; ++i) {
            const Complex above = from_below ? stack.substrate : stack.ambient;
            const Complex below = from_below ? stack.ambient : stack.substrate;
            result.n_0[i] = above.real();
            result.cos_0[i] = cos_0;
            put(result.above, i, above);
            put(result.below, i, below);
            for (std::size_t j = 0; j < stack.layers.size(); ++j) {
                const Layer& layer = stack.layers[from_below ? stack.layers.size() - 1 - j : j];
                put(result.layers[j].n, i, layer.n);
                result.layers[j].waves[i] = layer.thickness_nm / wavelength(i);
            }
        }
        return result;
    }
    static void put(ComplexLanes& lanes, std::size_t i, Complex value)
    {
        lanes.re[i] = value.real();
        lanes.im[i] = value.imag();
    }
};

FilmModelStack::Setup setup(FilmModel model, std::optional<std::size_t> varying)
{
    FilmModelStack::Setup result{.model = model, .varying = varying, .half_cell = {}};
    for (std::size_t i = 0; i < kLanes; ++i)
        result.half_cell[i] = 0.5 * kCellNm / Spread::wavelength(i);
    return result;
}

/// Largest difference of the lanes, at a few factors on every thickness, to one by one.
double largest_difference(FilmModel model, const Spread& at)
{
    constexpr std::size_t kRows = 7;
    constexpr double kFirst = 0.5, kStep = 0.25;
    std::vector<Lanes> R(kRows), T(kRows);
    FilmModelStack(at.lanes(), setup(model, std::nullopt)).march(kFirst, kStep, R, T);
    double largest = 0.0;
    for (std::size_t row = 0; row < kRows; ++row) {
        FilmStack stack = at.stack;
        for (Layer& layer : stack.layers)
            layer.thickness_nm *= kFirst + static_cast<double>(row) * kStep;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const PowerRatios power =
                film_model_power(model, stack, at.cos_0, Spread::wavelength(i), kCellNm);
            largest =
                std::max({largest, std::abs(R[row][i] - power.R), std::abs(T[row][i] - power.T)});
        }
    }
    return largest;
}

Spread any_film(Complex base)
{
    return {{1.0, {{*between(1.05, 3.0), *between(0.0, 2000.0)}}, base}, *between(0.01, 1.0)};
}

RC_GTEST_PROP(FilmModelStack, LanesAreTheFormsOneByOne, ())
{
    const Spread clear = any_film(*between(1.05, 3.0));
    for (const FilmModel model : {FilmModel::airy, FilmModel::series, FilmModel::etalon})
        RC_ASSERT(largest_difference(model, clear) < 1e-11);
    RC_ASSERT(largest_difference(FilmModel::free_film, any_film(1.0)) < 1e-11);
    RC_ASSERT(largest_difference(FilmModel::opaque_base, any_film(*test::index_of_any())) < 1e-11);
}

RC_GTEST_PROP(FilmModelStack, RecursionInLanesIsTheMultilayer, ())
{
    Spread at = any_film(*test::index_of_any());
    at.stack.layers.push_back({{*between(1.05, 3.0), *between(0.0, 2.0)}, *between(0.0, 200.0)});
    at.stack.layers.push_back({*between(1.05, 3.0), *between(0.0, 500.0)});
    constexpr std::size_t kRows = 5;
    std::vector<Lanes> R(kRows), T(kRows);
    Lanes first, step;
    for (std::size_t i = 0; i < kLanes; ++i) {
        first[i] = 30.0 / Spread::wavelength(i);
        step[i] = 40.0 / Spread::wavelength(i);
    }
    FilmModelStack(at.lanes(), setup(FilmModel::recursion, 1)).march(first, step, R, T);
    for (std::size_t row = 0; row < kRows; ++row) {
        at.stack.layers[1].thickness_nm = 30.0 + 40.0 * static_cast<double>(row);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const PowerRatios power =
                stack_power_unpolarised(at.stack, at.cos_0, Spread::wavelength(i));
            RC_ASSERT(std::abs(R[row][i] - power.R) < 1e-11);
            RC_ASSERT(std::abs(T[row][i] - power.T) < 1e-11);
        }
    }
}

/// From the glass, also beyond its critical angle.
TEST(FilmModelStack, FromBelowAiryAndRecursionAreTheMultilayer)
{
    const FilmStack stack{1.0, {{1.38, 250.0}}, 1.52};
    const FilmStack turned{1.52, {{1.38, 250.0}}, 1.0};
    for (const double cosine : {1.0, 0.9, 0.76, 0.7, 0.3, 0.05})
        for (const FilmModel model : {FilmModel::airy, FilmModel::recursion}) {
            FilmModelStack::Setup below = setup(model, std::nullopt);
            below.from_below = true;
            std::vector<Lanes> R(1), T(1);
            FilmModelStack(Spread{stack, cosine}.lanes(true), below).march(1.0, 0.0, R, T);
            for (std::size_t i = 0; i < kLanes; ++i) {
                const PowerRatios power =
                    stack_power_unpolarised(turned, cosine, Spread::wavelength(i));
                EXPECT_NEAR(R[0][i], power.R, 1e-12) << cosine;
                EXPECT_NEAR(T[0][i], power.T, 1e-12) << cosine;
            }
        }
}

/// Against a sum over many points of the cell, at a thickness with many jumps inside it.
TEST(FilmModelStack, BandsAreMeansOverTheCell)
{
    constexpr int kPoints = 200'000;
    for (const double thickness : {0.0, 137.0, 5e3, 4e5}) {
        const Spread at{{1.0, {{1.4, thickness}}, 1.0}, 0.6};
        std::vector<Lanes> R(1), T(1);
        FilmModelStack(at.lanes(), setup(FilmModel::path_difference, 0))
            .march(at.lanes().layers[0].waves, {}, R, T);
        for (const std::size_t i : {std::size_t{0}, std::size_t{17}, kLanes - 1}) {
            const double nm = Spread::wavelength(i);
            const double low = 1.0 / (nm + 0.5), high = 1.0 / (nm - 0.5);
            double sum = 0.0;
            for (int k = 0; k < kPoints; ++k)
                sum += path_difference_bands({1.0, 1.4, 1.0, thickness}, 0.6, 0.6,
                                             1.0 / (low + (high - low) * (k + 0.5) / kPoints));
            EXPECT_NEAR(R[0][i], sum / kPoints, 2e-5) << thickness << ' ' << nm;
            EXPECT_DOUBLE_EQ(T[0][i], 1.0 - R[0][i]);
            EXPECT_NEAR(R[0][i], path_difference_mean({1.0, 1.4, 1.0, thickness}, 0.6, nm, kCellNm),
                        1e-12);
        }
    }
}

/// Most at grazing incidence, where the faces reflect strongly.
TEST(FilmModelStack, SeriesDoesNotConserveEnergy)
{
    const FilmStack stack{1.0, {{2.4, 115.0}}, 3.5};
    const PowerRatios cut = film_model_power(FilmModel::series, stack, 1.0, 550.0, kCellNm);
    const PowerRatios whole = stack_power_unpolarised(stack, 1.0, 550.0);
    EXPECT_NEAR(cut.R - whole.R, -9.39e-4, 1e-5);
    EXPECT_NEAR(cut.R + cut.T + cut.A, 1.0, 1e-15);
    const FilmStack soap{1.0, {{1.33, 200.0}}, 1.0};
    EXPECT_GT(std::abs(film_model_power(FilmModel::series, soap, 0.1, 550.0, kCellNm).A), 0.05);
    EXPECT_NEAR(film_model_power(FilmModel::series, soap, 1.0, 550.0, kCellNm).A, 0.0, 1e-4);
}

TEST(FilmModelStack, ProblemsNameWhatIsOutsideTheDomain)
{
    const auto problems = [](FilmModel model, const FilmStack& stack) {
        std::vector<std::string> texts;
        for (const StackProblem& problem : film_model_problems(model, stack))
            texts.push_back(std::string(problem.field) + std::to_string(problem.index) + ' ' +
                            problem.message);
        return texts;
    };
    using Texts = std::vector<std::string>;
    const FilmStack on_metal{1.0, {{1.5, 100.0}}, {2.9, 3.1}};
    EXPECT_EQ(problems(FilmModel::airy, on_metal), (Texts{"n2 must have k = 0"}));
    EXPECT_EQ(problems(FilmModel::opaque_base, on_metal), Texts{});
    EXPECT_EQ(problems(FilmModel::free_film, on_metal),
              (Texts{"n2 must equal that of the ambient"}));
    const FilmStack under_water{1.33, {{{1.2, 0.1}, 100.0, false}}, 1.0};
    EXPECT_EQ(problems(FilmModel::series, under_water),
              (Texts{"d_nm0 must be coherent", "n1 must have k = 0",
                     "n1 must not be below that of the ambient",
                     "n2 must not be below that of the ambient"}));
    const FilmStack two{1.33, {{1.2, 100.0}, {{1.2, 0.1}, 10.0}}, 1.0};
    EXPECT_EQ(problems(FilmModel::etalon, two),
              (Texts{"d_nm0 must be the only layer: the film is a single one"}));
    EXPECT_EQ(problems(FilmModel::recursion, two),
              (Texts{"n1 must be larger than that of the ambient, or absorb"}));
}

}  // namespace
}  // namespace nacre::optics
