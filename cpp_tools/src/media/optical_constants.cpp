// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/optical_constants.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "nacre/core/diagnostics.h"

namespace nacre::spectral {

namespace {

class GridConstants final : public OpticalConstants {
public:
    explicit GridConstants(const std::array<Complex, kWavelengths>& n) : n_(n) {}

    [[nodiscard]] Complex at(double nm) const override
    {
        if (!(nm >= kFirstNm && nm <= kLastNm))
            throw InputError({.file = {},
                              .field = "n",
                              .message = fmt::format("must be within {} … {} nm (got {:.10g})",
                                                     kFirstNm, kLastNm, nm)});
        const auto i = std::min(static_cast<std::size_t>(nm - kFirstNm), kWavelengths - 2);
        return n_[i] + (nm - wavelength_nm(i)) * (n_[i + 1] - n_[i]);
    }

    [[nodiscard]] std::array<double, 2> range_nm() const noexcept override
    {
        return {kFirstNm, kLastNm};
    }

private:
    std::array<Complex, kWavelengths> n_;
};

/// An index by a closed formula in µm that holds everywhere, and a constant k.
class FormulaConstants final : public OpticalConstants {
public:
    FormulaConstants(std::string name, std::function<double(double)> n_of_um, double k)
        : name_(std::move(name)), n_of_um_(std::move(n_of_um)), k_(k)
    {}

    [[nodiscard]] Complex at(double wavelength_nm) const override
    {
        const double n = n_of_um_(wavelength_nm / 1000.0);
        if (!(n > 0.0) || !std::isfinite(n))
            throw InputError(
                {.file = {},
                 .field = name_,
                 .message = fmt::format("must give an index n > 0 at {:.10g} nm (got {})",
                                        wavelength_nm, n)});
        return {n, k_};
    }

    [[nodiscard]] std::array<double, 2> range_nm() const noexcept override
    {
        return {0.0, std::numeric_limits<double>::infinity()};
    }

private:
    std::string name_;
    std::function<double(double)> n_of_um_;
    double k_;
};

void check(DiagnosticList& problems, bool good, std::string field, const char* rule, double got)
{
    if (!good)
        problems.add({.file = {},
                      .field = std::move(field),
                      .message = fmt::format("must be {} (got {})", rule, got)});
}

void check_finite(DiagnosticList& problems, const std::string& field,
                  const std::vector<double>& list)
{
    for (std::size_t i = 0; i < list.size(); ++i)
        check(problems, std::isfinite(list[i]), fmt::format("{}[{}]", field, i), "finite", list[i]);
}

void check_k(DiagnosticList& problems, double k)
{
    check(problems, k >= 0.0 && std::isfinite(k), "k", "finite and ≥ 0", k);
}

}  // namespace

std::array<Complex, kWavelengths> OpticalConstants::on_grid() const
{
    std::array<Complex, kWavelengths> index;
    for (std::size_t i = 0; i < kWavelengths; ++i) index[i] = at(wavelength_nm(i));
    return index;
}

OpticalConstantsPtr constant_index(Complex n)
{
    DiagnosticList problems;
    check(problems, n.real() > 0.0 && std::isfinite(n.real()), "n", "finite and > 0", n.real());
    check_k(problems, n.imag());
    problems.throw_if_any();
    return std::make_shared<FormulaConstants>(
        "n", [n](double) { return n.real(); }, n.imag());
}

OpticalConstantsPtr index_on_grid(const std::array<Complex, kWavelengths>& n)
{
    DiagnosticList problems;
    for (std::size_t i = 0; i < n.size(); ++i) {
        const std::string at = fmt::format(" at {:g} nm", wavelength_nm(i));
        const double re = n[i].real(), im = n[i].imag();
        check(problems, re > 0.0 && std::isfinite(re), ("n" + at).c_str(), "finite and > 0", re);
        check(problems, im >= 0.0 && std::isfinite(im), ("k" + at).c_str(), "finite and ≥ 0", im);
    }
    problems.throw_if_any();
    return std::make_shared<GridConstants>(n);
}

OpticalConstantsPtr cauchy(double a, double b, double c, double k)
{
    DiagnosticList problems;
    check_finite(problems, "cauchy", {a, b, c});
    check_k(problems, k);
    problems.throw_if_any();
    return std::make_shared<FormulaConstants>(
        "cauchy",
        [a, b, c](double um) {
            const double inverse2 = 1.0 / (um * um);
            return a + (b + c * inverse2) * inverse2;
        },
        k);
}

OpticalConstantsPtr sellmeier(std::vector<double> b, std::vector<double> c)
{
    constexpr std::size_t kMostTerms = 6;
    DiagnosticList problems;
    if (b.empty() || b.size() > kMostTerms || b.size() != c.size())
        problems.add({.file = {},
                      .field = "sellmeier",
                      .message = fmt::format("must have as many b as c, 1 … {} (got {} and {})",
                                             kMostTerms, b.size(), c.size())});
    check_finite(problems, "sellmeier.b", b);
    check_finite(problems, "sellmeier.c", c);
    problems.throw_if_any();
    return std::make_shared<FormulaConstants>(
        "sellmeier",
        [b = std::move(b), c = std::move(c)](double um) {
            double n2 = 1.0;
            for (std::size_t i = 0; i < b.size(); ++i) n2 += b[i] * um * um / (um * um - c[i]);
            return std::sqrt(n2);
        },
        0.0);
}

OpticalConstantsPtr abbe(double n_d, double v_d)
{
    DiagnosticList problems;
    check(problems, n_d > 1.0 && std::isfinite(n_d), "abbe.n_d", "finite and > 1", n_d);
    check(problems, v_d > 0.0 && std::isfinite(v_d), "abbe.v_d", "finite and > 0", v_d);
    problems.throw_if_any();

    // V_d = (n_d − 1) / (n_F − n_C) fixes b; n(d) = n_d fixes a. Lines: ISO 7944, in µm.
    constexpr double kF = 0.4861327, kD = 0.5875618, kC = 0.6562725;
    const double b = (n_d - 1.0) / (v_d * (1.0 / (kF * kF) - 1.0 / (kC * kC)));
    return cauchy(n_d - b / (kD * kD), b);
}

}  // namespace nacre::spectral
