// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace nacre::bands {

/// The x ≥ 0 with the least ½ xᵀ G x − bᵀ x: block principal pivoting (L. F. Portugal, J. J.
/// Júdice, L. N. Vicente, Mathematics of Computation 63, 1994), which exchanges all that is
/// infeasible at once and falls back to one at a time where that does not get on.
/// @pre G is symmetric and positive definite
[[nodiscard]] Eigen::VectorXd nonnegative_minimum(const Eigen::MatrixXd& g,
                                                  const Eigen::VectorXd& b);

}  // namespace nacre::bands
