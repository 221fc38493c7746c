// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/schlick_fit.h"

#include <tbb/parallel_for.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <unsupported/Eigen/LevenbergMarquardt>
#include <unsupported/Eigen/NumericalDiff>

#include "films/sizing.h"
#include "nacre/lut/film_table.h"

namespace nacre::lut {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr int kFewestTerms = 6, kMostTerms = 16, kMoreTerms = 2;
// Powers are nearly dependent, and the best fits have coefficients of thousands that cancel. Small
// ones come first: renderers share samples out by estimates of each term's albedo, whose errors
// grow with the coefficients, and lose light where the sum of the estimates is not positive.
constexpr std::array kRidges{3e-4, 1e-4, 3e-5};
// Of the colours at all thicknesses: further components are below what a fit reaches.
constexpr Eigen::Index kComponents = 24;
constexpr int kLevelSteps = 60;
constexpr double kLeastGrowth = 0.02;
constexpr double kLeastExponent = 0.3, kLargestExponent = 400.0;

/// (1 − cosθ)^e, one column for each exponent; e_0 = 0.
MatrixXd powers(const VectorXd& versines, const VectorXd& log_exponents)
{
    MatrixXd result(versines.size(), log_exponents.size() + 1);
    result.col(0).setOnes();
    for (Eigen::Index k = 0; k < log_exponents.size(); ++k)
        result.col(k + 1) = versines.array().pow(std::exp(log_exponents[k]));
    return result;
}

MatrixXd coefficients(const MatrixXd& basis, const MatrixXd& values, double ridge)
{
    const Eigen::Index terms = basis.cols();
    MatrixXd held(basis.rows() + terms, terms), wanted(held.rows(), values.cols());
    held << basis, ridge * MatrixXd::Identity(terms, terms);
    wanted << values, MatrixXd::Zero(terms, values.cols());
    return held.householderQr().solve(wanted);
}

/// What is left of the values for given exponents; the coefficients follow from them (Golub and
/// Pereyra 1973).
struct Residual : Eigen::DenseFunctor<double> {
    const VectorXd& versines;
    const MatrixXd& target;
    double ridge;

    Residual(const VectorXd& at, const MatrixXd& values, int terms, double held)
        : DenseFunctor<double>(terms - 1, static_cast<int>(values.size())),
          versines(at),
          target(values),
          ridge(held)
    {}
    int operator()(const VectorXd& log_exponents, VectorXd& residual) const
    {
        const VectorXd held =
            log_exponents.array().max(std::log(kLeastExponent)).min(std::log(kLargestExponent));
        const MatrixXd basis = powers(versines, held);
        const MatrixXd left = basis * coefficients(basis, target, ridge) - target;
        residual = Eigen::Map<const VectorXd>(left.data(), left.size());
        // Outside the bounds the slope leads back.
        residual[0] += (log_exponents - held).norm();
        return 0;
    }
};

VectorXd fitted_exponents(const VectorXd& versines, const MatrixXd& target, int terms, double ridge)
{
    VectorXd log_exponents =
        VectorXd::LinSpaced(terms - 1, std::log(1.0), std::log(kFewestTerms * 7.0));
    Residual residual(versines, target, terms, ridge);
    Eigen::NumericalDiff<Residual> slopes(residual);
    Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Residual>> search(slopes);
    search.setMaxfev(Eigen::Index{60} * terms);
    search.minimize(log_exponents);
    log_exponents =
        log_exponents.array().max(std::log(kLeastExponent)).min(std::log(kLargestExponent));
    std::sort(log_exponents.begin(), log_exponents.end());
    return log_exponents;
}

/// Colours at the angles that count, one column for each row of the table and channel.
struct Samples {
    VectorXd versines;
    MatrixXd values;
};

Samples samples(const Table& table)
{
    const auto width = static_cast<Eigen::Index>(table.x.texels);
    // One that may lie below the least cosine, so that all above it is between samples.
    const auto first =
        static_cast<Eigen::Index>(kLeastCountedCosine * static_cast<double>(width - 1));
    Samples result{.versines = VectorXd(width - first),
                   .values = MatrixXd(width - first, Eigen::Index{3} * table.y.texels)};
    for (Eigen::Index x = first; x < width; ++x) {
        result.versines[x - first] = 1.0 - static_cast<double>(x) / static_cast<double>(width - 1);
        for (Eigen::Index y = 0; y < table.y.texels; ++y)
            for (Eigen::Index c = 0; c < 3; ++c)
                result.values(x - first, 3 * y + c) =
                    table.texels[static_cast<std::size_t>(3 * (y * width + x) + c)];
    }
    return result;
}

/// The main components of all colours, by their weight: exponents that fit them fit all.
MatrixXd main_components(const MatrixXd& values)
{
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(values * values.transpose());
    const Eigen::Index count = std::min(kComponents, values.rows());
    MatrixXd result(values.rows(), count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Index at = values.rows() - 1 - i;
        const double weight =
            std::sqrt(std::max(0.0, eigen.eigenvalues()[at]) / static_cast<double>(values.cols()));
        result.col(i) = weight * eigen.eigenvectors().col(at);
    }
    return result;
}

struct Fit {
    VectorXd log_exponents;
    MatrixXd coefficients;  ///< terms × (3 · rows)
    double error_max, error_rms, ridge;
};

/// As the renderer has the coefficients, and what they leave.
void measure(Fit& fit, const MatrixXd& basis, const MatrixXd& values)
{
    fit.coefficients = fit.coefficients.cast<float>().cast<double>();
    const MatrixXd left = basis * fit.coefficients - values;
    fit.error_max = left.cwiseAbs().maxCoeff();
    fit.error_rms = std::sqrt(left.squaredNorm() / static_cast<double>(left.size()));
}

Fit fit(const Samples& at, const MatrixXd& components, int terms, double ridge)
{
    Fit result{.log_exponents = fitted_exponents(at.versines, components, terms, ridge),
               .coefficients = {},
               .error_max = 0.0,
               .error_rms = 0.0,
               .ridge = ridge};
    const MatrixXd basis = powers(at.versines, result.log_exponents);
    result.coefficients = coefficients(basis, at.values, ridge);
    measure(result, basis, at.values);
    return result;
}

/// Coefficients of one colour whose largest error is as small as can be, by weights that grow where
/// the error is large (Lawson 1961); none if it does not fall below that of `start`.
std::optional<VectorXd> levelled(const MatrixXd& basis, const VectorXd& values,
                                 const VectorXd& start, double ridge, double allowed)
{
    VectorXd errors = (basis * start - values).cwiseAbs();
    VectorXd weights = VectorXd::Ones(values.size());
    double least = errors.maxCoeff();
    std::optional<VectorXd> best;
    for (int i = 0; i < kLevelSteps && least > allowed; ++i) {
        // An error of nothing must not make its angle's weight 0 for good.
        weights.array() *= errors.array() / errors.maxCoeff() + kLeastGrowth;
        weights *= static_cast<double>(weights.size()) / weights.sum();
        const VectorXd roots = weights.cwiseSqrt();
        const VectorXd next =
            coefficients(roots.asDiagonal() * basis, roots.cwiseProduct(values), ridge);
        errors = (basis * next - values).cwiseAbs();
        if (errors.maxCoeff() >= least) continue;
        least = errors.maxCoeff();
        best = next;
    }
    return best;
}

/// Levels the errors of the colours that least squares leave above what is allowed.
void level(Fit& fit, const Samples& at, double allowed)
{
    const MatrixXd basis = powers(at.versines, fit.log_exponents);
    const VectorXd largest =
        (basis * fit.coefficients - at.values).cwiseAbs().colwise().maxCoeff().transpose();
    tbb::parallel_for(Eigen::Index{0}, largest.size(), [&](Eigen::Index k) {
        if (largest[k] <= allowed) return;
        if (const auto better =
                levelled(basis, at.values.col(k), fit.coefficients.col(k), fit.ridge, allowed))
            fit.coefficients.col(k) = *better;
    });
    measure(fit, basis, at.values);
}

Fit best_fit(const Samples& at, double allowed)
{
    const MatrixXd components = main_components(at.values);
    std::optional<Fit> best;
    for (const double ridge : kRidges)
        for (int terms = kFewestTerms; terms <= kMostTerms; terms += kMoreTerms) {
            Fit next = fit(at, components, terms, ridge);
            if (!best || next.error_max < best->error_max) best = std::move(next);
            if (best->error_max <= allowed) return *best;
        }
    level(*best, at, allowed);
    return *best;
}

FilmTableRequest quick(FilmTableRequest request, int width, int height)
{
    request.size = std::array<int, 2>{width, height};
    request.measure_error = false;
    request.transmittance = false;
    request.progress = nullptr;
    return request;
}

Table coefficient_table(const Table& values, const Fit& fit)
{
    const auto terms = static_cast<int>(fit.coefficients.rows());
    Table table{.role = {TableOf::R, TableContent::powers},
                .quantity = "schlick_coefficients",
                .x = {"term", "1", 0.0, static_cast<double>(terms - 1), terms},
                .y = values.y,
                .channels = values.channels,
                .texels = {},
                .error_max = fit.error_max,
                .error_mean = fit.error_rms,
                .error_unit = "1"};
    for (int y = 0; y < values.y.texels; ++y)
        for (int k = 0; k < terms; ++k)
            for (int c = 0; c < 3; ++c)
                table.texels.push_back(static_cast<float>(fit.coefficients(k, 3 * y + c)));
    return table;
}

}  // namespace

SchlickFit fit_schlick(const FilmTableRequest& request, const Table& smooth, double allowed)
{
    // Twice as fine as the table, so that no error hides between its texels.
    const int width = 2 * smooth.x.texels - 1;
    const int height = smooth.y.texels == 1 ? 1 : std::max(17, (smooth.y.texels + 2) / 3);
    const Table film = bake_film_tables(quick(request, width, height)).reflectance;
    const Fit found = best_fit(samples(film), allowed);

    FilmTableRequest without = request;
    without.stack.layers.clear();
    without.variation.reset();
    const Table bare = bake_film_tables(quick(without, width, 1)).reflectance;
    const Samples bare_at = samples(bare);
    const MatrixXd bare_coefficients =
        coefficients(powers(bare_at.versines, found.log_exponents), bare_at.values, found.ridge);

    SchlickFit result{.exponents = {0.0},
                      .coefficients = coefficient_table(film, found),
                      .bare = {},
                      .error_max = found.error_max,
                      .error_rms = found.error_rms};
    for (const double log_exponent : found.log_exponents)
        result.exponents.push_back(std::exp(log_exponent));
    for (Eigen::Index k = 0; k < bare_coefficients.rows(); ++k)
        result.bare.push_back(
            {bare_coefficients(k, 0), bare_coefficients(k, 1), bare_coefficients(k, 2)});
    return result;
}

}  // namespace nacre::lut
