// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nonnegative.h"

#include <gtest/gtest.h>

#include <random>

namespace nacre::bands {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

TEST(Nonnegative, IsThePlainMinimumWhereThatIsPositive)
{
    MatrixXd g(2, 2);
    g << 2.0, 0.5, 0.5, 1.0;
    const VectorXd expected = Eigen::Vector2d(1.0, 3.0);
    EXPECT_LT((nonnegative_minimum(g, g * expected) - expected).norm(), 1e-12);
}

TEST(Nonnegative, StaysAtZeroWhereItWouldGoBelow)
{
    const MatrixXd g = MatrixXd::Identity(3, 3);
    const VectorXd x = nonnegative_minimum(g, Eigen::Vector3d(1.0, -2.0, 0.5));
    EXPECT_LT((x - Eigen::Vector3d(1.0, 0.0, 0.5)).norm(), 1e-15);
}

// The conditions of Karush, Kuhn and Tucker, which are sufficient: G is positive definite.
TEST(Nonnegative, NoFeasibleStepGoesDown)
{
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 50; ++trial) {
        const int n = 2 + trial;
        MatrixXd rows(n + 3, n);
        VectorXd targets(n + 3);
        for (double& value : rows.reshaped()) value = normal(random);
        for (double& value : targets) value = normal(random);
        const MatrixXd g = rows.transpose() * rows + 1e-6 * MatrixXd::Identity(n, n);
        const VectorXd b = rows.transpose() * targets;
        const VectorXd x = nonnegative_minimum(g, b), gradient = g * x - b;
        for (int i = 0; i < n; ++i) {
            EXPECT_GE(x[i], 0.0);
            EXPECT_NEAR(x[i] > 0.0 ? gradient[i] : std::min(gradient[i], 0.0), 0.0, 1e-7);
        }
    }
}

}  // namespace
}  // namespace nacre::bands
