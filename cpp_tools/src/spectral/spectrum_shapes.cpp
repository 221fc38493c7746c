// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectrum_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/diagnostics.h"
#include "nacre/core/limits.h"

namespace nacre::spectral {

namespace {

using Problem = std::optional<std::string>;

Problem not_finite(const char* what, double value)
{
    if (std::isfinite(value)) return std::nullopt;
    return fmt::format("{} must be finite (got {:g})", what, value);
}

Problem not_positive(const char* what, double value)
{
    if (std::isfinite(value) && value > 0.0) return std::nullopt;
    return fmt::format("{} must be finite and > 0 (got {:g})", what, value);
}

struct FindProblem {
    Problem operator()(const ConstantShape& shape) const
    {
        return not_finite("the value", shape.value);
    }

    Problem operator()(const BoxShape& shape) const
    {
        if (auto problem = not_positive("the first wavelength", shape.first_nm)) return problem;
        if (auto problem = not_positive("the last wavelength", shape.last_nm)) return problem;
        if (auto problem = not_finite("the value", shape.value)) return problem;
        const double width = shape.last_nm - shape.first_nm;
        if (!(width > 0.0))
            return fmt::format("the last wavelength must be > the first (got {:g} after {:g})",
                               shape.last_nm, shape.first_nm);
        if (!(shape.edge_nm >= 0.0 && shape.edge_nm <= width))
            return fmt::format("the edge must be in [0, {:g}], the width of the box (got {:g})",
                               width, shape.edge_nm);
        return std::nullopt;
    }

    Problem operator()(const GaussianShape& shape) const
    {
        if (auto problem = not_positive("the centre", shape.centre_nm)) return problem;
        if (auto problem = not_positive("the width", shape.fwhm_nm)) return problem;
        return not_finite("the peak", shape.peak);
    }

    // A Spectrum is checked when it is made.
    Problem operator()(const LinearShape&) const { return std::nullopt; }
    Problem operator()(const SmoothShape&) const { return std::nullopt; }

    Problem operator()(const ScaledShape& shape) const
    {
        return not_finite("the factor", shape.factor);
    }
};

/// From 0 to 1 over `edge_nm` around 0, one half at 0.
double soft_step(double nm, double edge_nm) noexcept
{
    if (edge_nm == 0.0) return nm >= 0.0 ? 1.0 : 0.0;
    const double x = std::clamp(nm / edge_nm + 0.5, 0.0, 1.0);
    return 0.5 - 0.5 * std::cos(std::numbers::pi * x);
}

/// Adds a shape to a sum at given wavelengths.
struct AddShape {
    const std::vector<double>& wavelengths_nm;
    std::vector<double>& sum;

    template <class Value>
    void add(Value&& value) const
    {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += value(wavelengths_nm[i]);
    }

    void operator()(const ConstantShape& shape) const
    {
        add([&](double) { return shape.value; });
    }
    void operator()(const BoxShape& shape) const
    {
        add([&](double nm) {
            return shape.value * soft_step(nm - shape.first_nm, shape.edge_nm) *
                   soft_step(shape.last_nm - nm, shape.edge_nm);
        });
    }
    void operator()(const GaussianShape& shape) const
    {
        add([&](double nm) {
            const double x = (nm - shape.centre_nm) / shape.fwhm_nm;
            return shape.peak * std::exp(-4.0 * std::numbers::ln2 * x * x);
        });
    }
    void operator()(const LinearShape& shape) const
    {
        add_all(shape.points.values_at(wavelengths_nm, Interpolation::linear), 1.0);
    }
    void operator()(const SmoothShape& shape) const
    {
        const MonotoneCubic curve(shape.points);
        add([&](double nm) { return curve.at(nm); });
    }
    void operator()(const ScaledShape& shape) const
    {
        add_all(shape.spectrum.values_at(wavelengths_nm), shape.factor);
    }

private:
    void add_all(const std::vector<double>& values, double factor) const
    {
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += factor * values[i];
    }
};

/// The distance of the wavelengths around one of them; 0 outside their range.
double gap_at(const std::vector<double>& wavelengths_nm, double nm)
{
    const auto above = std::ranges::lower_bound(wavelengths_nm, nm);
    if (above == wavelengths_nm.end() || above == wavelengths_nm.begin()) return 0.0;
    return *above - *(above - 1);
}

/// What a sum at those wavelengths would lose of a shape without a word.
struct FindLoss {
    const std::vector<double>& wavelengths_nm;

    Problem operator()(const BoxShape& shape) const
    {
        const auto inside = std::ranges::lower_bound(wavelengths_nm, shape.first_nm);
        const bool missed = inside != wavelengths_nm.end() && *inside > shape.last_nm &&
                            inside != wavelengths_nm.begin();
        if (!missed) return std::nullopt;
        return fmt::format(
            "{:g} … {:g} nm lie between two wavelengths, {} and {} nm; take a finer "
            "step",
            shape.first_nm, shape.last_nm, *(inside - 1), *inside);
    }
    Problem operator()(const GaussianShape& shape) const
    {
        const double gap = gap_at(wavelengths_nm, shape.centre_nm);
        if (shape.fwhm_nm >= gap) return std::nullopt;
        return fmt::format(
            "the width must be ≥ {:g} nm, the step of the wavelengths (got {:g}); "
            "take a wider one or a finer step",
            gap, shape.fwhm_nm);
    }
    template <class Shape>
    Problem operator()(const Shape&) const
    {
        return std::nullopt;
    }
};

}  // namespace

std::optional<std::string> shape_problem(const SpectrumShape& shape)
{
    return std::visit(FindProblem{}, shape);
}

std::vector<double> even_wavelengths(double first_nm, double last_nm, double step_nm)
{
    DiagnosticList problems;
    const auto problem = [&problems](const char* field, std::string message) {
        problems.add({.file = {}, .field = field, .message = std::move(message)});
    };
    if (!(first_nm > 0.0 && last_nm > first_nm && std::isfinite(last_nm)))
        problem("range", fmt::format("must be two wavelengths, > 0 and ascending (got {:g}:{:g})",
                                     first_nm, last_nm));
    if (!(std::isfinite(step_nm) && step_nm > 0.0))
        problem("step", fmt::format("must be finite and > 0 (got {:g})", step_nm));
    problems.throw_if_any();
    const double steps = (last_nm - first_nm) / step_nm;
    if (!(steps < static_cast<double>(kMaxSamples)))
        problem("step",
                fmt::format("must give at most {} samples (got {:g})", kMaxSamples, steps + 1.0));
    else if (const double whole = std::round(steps); whole < 1.0 || std::abs(steps - whole) > 1e-6)
        problem("step", fmt::format("must go into the range a whole number of times (got {:g} for "
                                    "{:g} … {:g} nm)",
                                    step_nm, first_nm, last_nm));
    problems.throw_if_any();
    const auto count = static_cast<std::size_t>(std::round(steps));
    std::vector<double> wavelengths;
    wavelengths.reserve(count + 1);
    for (std::size_t i = 0; i < count; ++i)
        wavelengths.push_back(first_nm + static_cast<double>(i) * step_nm);
    wavelengths.push_back(last_nm);
    return wavelengths;
}

Spectrum sum_of_shapes(const std::vector<SpectrumShape>& shapes, std::vector<double> wavelengths_nm)
{
    DiagnosticList problems;
    if (shapes.empty())
        problems.add({.file = {}, .field = "shapes", .message = "must be at least one"});
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        auto problem = shape_problem(shapes[i]);
        if (!problem) problem = std::visit(FindLoss{wavelengths_nm}, shapes[i]);
        if (problem)
            problems.add({.file = {},
                          .field = fmt::format("shapes[{}]", i),
                          .message = std::move(*problem)});
    }
    problems.throw_if_any();
    std::vector<double> sum(wavelengths_nm.size(), 0.0);
    for (const SpectrumShape& shape : shapes) std::visit(AddShape{wavelengths_nm, sum}, shape);
    for (std::size_t i = 0; i < sum.size(); ++i)
        if (!std::isfinite(sum[i]))
            throw InputError({.file = {},
                              .field = "shapes",
                              .message = fmt::format("must have a finite sum (got {:g} at {:g} nm)",
                                                     sum[i], wavelengths_nm[i])});
    return {std::move(wavelengths_nm), std::move(sum)};
}

}  // namespace nacre::spectral
