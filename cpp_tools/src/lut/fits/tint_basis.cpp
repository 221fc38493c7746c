// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/tint_basis.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "nacre/spectral/matrix.h"
#include "nacre/spectral/wavelengths.h"

namespace nacre::lut {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

// Of the conditions, against the smoothness: met to nine digits. They are the first rows, without
// which a QR decomposition of rows so unequal is not accurate (Powell and Reid 1969).
constexpr double kConditionWeight = 1e5;
constexpr double kZero = 1e-12, kGradient = 1e-6;
// A metal that is darker than this in a channel is taken for a grey one.
constexpr double kLeastTint = 1e-3;

/// Least-squares problem for the shares y, three spectra one after the other: they are smooth, add
/// up to 1 in every cell, and the mean of weight_k · reflectance · y_c is the metal's colour for
/// k = c and else 0.
struct ShareProblem {
    MatrixXd rows;
    VectorXd values;
};

ShareProblem share_problem(const WavelengthCells& cells, const spectral::Vec3& tint)
{
    const auto n = static_cast<Index>(cells.nm.size());
    ShareProblem problem{MatrixXd::Zero(3 * (n - 1) + n + 9, 3 * n),
                         VectorXd::Zero(3 * (n - 1) + n + 9)};
    Index row = 0;
    for (Index i = 0; i < n; ++i, ++row) {
        for (Index c = 0; c < 3; ++c) problem.rows(row, c * n + i) = kConditionWeight;
        problem.values[row] = kConditionWeight;
    }
    for (Index c = 0; c < 3; ++c)
        for (std::size_t k = 0; k < 3; ++k, ++row) {
            for (Index i = 0; i < n; ++i) {
                const auto at = static_cast<std::size_t>(i);
                problem.rows(row, c * n + i) = kConditionWeight * cells.weight[at][k] *
                                               cells.reflectance[at] / static_cast<double>(n);
            }
            if (static_cast<Index>(k) == c) problem.values[row] = kConditionWeight * tint[k];
        }
    for (Index c = 0; c < 3; ++c)
        for (Index i = 0; i + 1 < n; ++i, ++row) {
            const auto at = static_cast<std::size_t>(i);
            const double slope = 1.0 / std::sqrt(cells.nm[at + 1] - cells.nm[at]);
            problem.rows(row, c * n + i) = -slope;
            problem.rows(row, c * n + i + 1) = slope;
        }
    return problem;
}

/// Least squares with x ≥ 0: Lawson and Hanson 1974, Solving Least Squares Problems, ch. 23. They
/// begin with nothing; here all are there first, and what comes out negative leaves at once, which
/// is nearly the answer.
class NonNegative {
public:
    explicit NonNegative(ShareProblem problem)
        : problem_(std::move(problem)), held_(static_cast<std::size_t>(problem_.rows.cols()), false)
    {
        while (true) {
            x_ = solution();
            bool all = true;
            for (Index i = 0; i < x_.size(); ++i)
                if (x_[i] < 0.0) hold(i), all = false;
            if (all) break;
        }
    }

    VectorXd solve()
    {
        for (Index round = 0; round < 3 * x_.size(); ++round) {
            const VectorXd uphill =
                problem_.rows.transpose() * (problem_.values - problem_.rows * x_);
            Index best = -1;
            for (Index i = 0; i < x_.size(); ++i)
                if (held(i) && (best < 0 || uphill[i] > uphill[best])) best = i;
            if (best < 0 || !(uphill[best] > kGradient)) break;
            held_[static_cast<std::size_t>(best)] = false;
            step_to_a_solution(best);
        }
        return x_;
    }

private:
    ShareProblem problem_;
    std::vector<bool> held_;  ///< at 0
    VectorXd x_;

    [[nodiscard]] bool held(Index i) const { return held_[static_cast<std::size_t>(i)]; }
    void hold(Index i) { held_[static_cast<std::size_t>(i)] = true; }

    /// Least squares of those that are not held.
    [[nodiscard]] VectorXd solution() const
    {
        std::vector<Index> open;
        for (Index i = 0; i < problem_.rows.cols(); ++i)
            if (!held(i)) open.push_back(i);
        VectorXd result = VectorXd::Zero(problem_.rows.cols());
        result(open) = problem_.rows(Eigen::all, open).colPivHouseholderQr().solve(problem_.values);
        return result;
    }

    /// Towards the solution as far as nothing becomes negative; what reaches 0 is held. `fresh` was
    /// let go just now.
    void step_to_a_solution(Index fresh)
    {
        while (true) {
            const VectorXd target = solution();
            if (!(target[fresh] > 0.0)) {  // by rounding alone
                hold(fresh);
                x_[fresh] = 0.0;
                return;
            }
            double share = 1.0;
            for (Index i = 0; i < x_.size(); ++i)
                if (target[i] < 0.0) share = std::min(share, x_[i] / (x_[i] - target[i]));
            x_ += share * (target - x_);
            if (share == 1.0) return;
            for (Index i = 0; i < x_.size(); ++i)
                if (target[i] < 0.0 && x_[i] <= kZero) {
                    hold(i);
                    x_[i] = 0.0;
                }
        }
    }
};

double mean_between(const spectral::Sampled& values, double first_nm, double last_nm)
{
    const auto index = [](double nm) {
        const double at = std::clamp(nm - spectral::kFirstNm, 0.0,
                                     static_cast<double>(spectral::kWavelengths - 1));
        return static_cast<std::size_t>(std::lround(at));
    };
    const std::size_t first = index(first_nm), last = index(last_nm);
    double sum = 0.0;
    for (std::size_t i = first; i <= last; ++i) sum += values[i];
    return sum / static_cast<double>(last - first + 1);
}

}  // namespace

std::vector<spectral::Vec3> tint_basis(const WavelengthCells& cells)
{
    const std::size_t n = cells.nm.size();
    WavelengthCells metal = cells;
    spectral::Vec3 tint{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            tint[k] += cells.weight[i][k] * cells.reflectance[i] / static_cast<double>(n);
    if (std::ranges::min(tint) < kLeastTint) {
        metal.reflectance.assign(n, 1.0);
        tint = {1.0, 1.0, 1.0};
    }
    const VectorXd y = NonNegative(share_problem(metal, tint)).solve();
    std::vector<spectral::Vec3> basis(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t c = 0; c < 3; ++c)
            basis[i][c] = metal.reflectance[i] * y[static_cast<Index>(c * n + i)] / tint[c];
    return basis;
}

std::vector<spectral::Vec3> tint_basis(const spectral::WavelengthSampling& sampling,
                                       const spectral::ColourWeights& weights,
                                       const spectral::Sampled& reflectance)
{
    const spectral::Mat3 to_rec709 = spectral::multiply(
        spectral::colour_space("lin_rec709_scene").from_xyz_d65, weights.to_xyz_d65);
    WavelengthCells cells;
    for (std::size_t i = 0; i < sampling.weight.size(); ++i) {
        const double from = sampling.edges_nm[i], to = sampling.edges_nm[i + 1];
        cells.nm.push_back(0.5 * (from + to));
        cells.weight.push_back(spectral::multiply(to_rec709, sampling.weight[i]));
        cells.reflectance.push_back(mean_between(reflectance, from, to));
    }
    std::vector<spectral::Vec3> basis = tint_basis(cells);
    // tint_709 · b = (M tint) · b = tint · (Mᵀ b)
    const spectral::Mat3 dual = spectral::transposed(to_rec709);
    for (spectral::Vec3& triple : basis) triple = spectral::multiply(dual, triple);
    return basis;
}

}  // namespace nacre::lut
