// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nonnegative.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <vector>

namespace nacre::bands {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

Eigen::VectorXd nonnegative_minimum(const MatrixXd& g, const VectorXd& b)
{
    constexpr int kFullExchanges = 3;  // that may fail to get on before one at a time
    const Index n = b.size();
    const double least = -1e-10 * b.cwiseAbs().maxCoeff();
    std::vector<char> free(static_cast<std::size_t>(n), 1);
    Index fewest = n + 1;
    int patience = kFullExchanges;
    for (;;) {
        std::vector<Index> kept;
        for (Index i = 0; i < n; ++i)
            if (free[static_cast<std::size_t>(i)]) kept.push_back(i);
        VectorXd x = VectorXd::Zero(n);
        if (!kept.empty()) {
            const MatrixXd part = g(kept, kept);
            const VectorXd solved = part.ldlt().solve(VectorXd(b(kept)));
            for (Index i = 0; i < solved.size(); ++i)
                x[kept[static_cast<std::size_t>(i)]] = solved[i];
        }
        const VectorXd gradient = g * x - b;
        std::vector<Index> infeasible;
        for (Index i = 0; i < n; ++i)
            if (free[static_cast<std::size_t>(i)] ? x[i] < 0.0 : gradient[i] < least)
                infeasible.push_back(i);
        const auto left = static_cast<Index>(infeasible.size());
        if (left == 0) return x;
        if (left < fewest) {
            fewest = left;
            patience = kFullExchanges;
        } else if (patience > 0) {
            --patience;
        } else {
            infeasible = {infeasible.back()};  // Murty's rule, which ends
        }
        for (const Index i : infeasible) free[static_cast<std::size_t>(i)] ^= 1;
    }
}

}  // namespace nacre::bands
