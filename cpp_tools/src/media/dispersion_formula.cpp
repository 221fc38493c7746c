// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/dispersion_formula.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

namespace nacre::spectral {

namespace {

using Coefficients = std::span<const double>;

/// C1 + Σ C_2i λ² / (λ² − C_2i+1^power): formulas 1 (power 2) and 2 (power 1).
double sellmeier_sum(Coefficients c, double um, int power) noexcept
{
    const double um2 = um * um;
    double sum = c[0];
    for (std::size_t i = 1; i + 1 < c.size(); i += 2)
        sum += c[i] * um2 / (um2 - (power == 2 ? c[i + 1] * c[i + 1] : c[i + 1]));
    return sum;
}

/// Σ C_2i λ^C_2i+1
double power_sum(Coefficients pairs, double um) noexcept
{
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < pairs.size(); i += 2)
        sum += pairs[i] * std::pow(um, pairs[i + 1]);
    return sum;
}

/// Formula 4: C1 + C2 λ^C3 / (λ² − C4^C5) + C6 λ^C7 / (λ² − C8^C9) + Σ C10 λ^C11 + …
double mixed_sum(Coefficients c, double um) noexcept
{
    double sum = c[0] + power_sum(c.subspan(9), um);
    for (const std::size_t i : {std::size_t{1}, std::size_t{5}}) {
        // Files pad a fraction that is not there with zeros: 0^0 is 1, a pole at 1 µm.
        if (c[i] == 0.0) continue;
        sum += c[i] * std::pow(um, c[i + 1]) / (um * um - std::pow(c[i + 2], c[i + 3]));
    }
    return sum;
}

/// Formula 6: C1 + Σ C_2i / (C_2i+1 − λ⁻²)
double gas_sum(Coefficients c, double um) noexcept
{
    double sum = c[0];
    for (std::size_t i = 1; i + 1 < c.size(); i += 2) sum += c[i] / (c[i + 1] - 1.0 / (um * um));
    return sum;
}

/// Formula 7; the sixth coefficient may be left out.
double herzberger(Coefficients c, double um) noexcept
{
    const double c6 = c.size() > 5 ? c[5] : 0.0;
    const double um2 = um * um;
    const double l = 1.0 / (um2 - 0.028);
    return c[0] + c[1] * l + c[2] * l * l + um2 * (c[3] + um2 * (c[4] + um2 * c6));
}

double retro(Coefficients c, double um) noexcept
{
    const double um2 = um * um;
    const double ratio = c[0] + c[1] * um2 / (um2 - c[2]) + c[3] * um2;  // (n² − 1) / (n² + 2)
    return std::sqrt((1.0 + 2.0 * ratio) / (1.0 - ratio));
}

double exotic(Coefficients c, double um) noexcept
{
    const double offset = um - c[4];
    return std::sqrt(c[0] + c[1] / (um * um - c[2]) + c[3] * offset / (offset * offset + c[5]));
}

}  // namespace

double DispersionFormula::index_at(double um) const noexcept
{
    const Coefficients c = coefficients;
    switch (number) {
        case 1:
            return std::sqrt(1.0 + sellmeier_sum(c, um, 2));
        case 2:
            return std::sqrt(1.0 + sellmeier_sum(c, um, 1));
        case 3:
            return std::sqrt(c[0] + power_sum(c.subspan(1), um));
        case 4:
            return std::sqrt(mixed_sum(c, um));
        case 5:
            return c[0] + power_sum(c.subspan(1), um);
        case 6:
            return 1.0 + gas_sum(c, um);
        case 7:
            return herzberger(c, um);
        case 8:
            return retro(c, um);
        case 9:
            return exotic(c, um);
        default:
            return std::nan("");
    }
}

std::string coefficient_count_problem(int formula, std::size_t count)
{
    struct Rule {
        std::size_t fewest, most;
        bool pairs;  // after the first
    };
    constexpr Rule kRules[] = {
        {3, 17, true}, {3, 17, true}, {3, 17, true}, {9, 17, true}, {3, 17, true},
        {3, 17, true}, {5, 6, false}, {4, 4, false}, {6, 6, false},
    };
    const auto [fewest, most, pairs] = kRules[formula - 1];
    if (count >= fewest && count <= most && (!pairs || count % 2 == 1)) return {};
    if (pairs)
        return fmt::format("formula {} takes an odd number of coefficients, {} … {} (got {})",
                           formula, fewest, most, count);
    const std::string wanted =
        fewest == most ? fmt::format("{}", most) : fmt::format("{} … {}", fewest, most);
    return fmt::format("formula {} takes {} coefficients (got {})", formula, wanted, count);
}

}  // namespace nacre::spectral
