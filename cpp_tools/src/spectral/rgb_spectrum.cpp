// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/rgb_spectrum.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "csv_table.h"
#include "nacre/core/diagnostics.h"

namespace nacre::spectral {
namespace {

constexpr double kCentreNm = 595.0, kHalfWidthNm = 235.0;
constexpr std::size_t kNodes = 16;
/// Coefficients of values that are 0 or 1 to the last bit.
constexpr double kSaturated = 1e8;
constexpr double kAcceptedError = 0.1;  ///< ΔE00

double variable(double wavelength_nm) noexcept
{
    return (wavelength_nm - kCentreNm) / kHalfWidthNm;
}

double smoothstep(double x) noexcept
{
    return x * x * (3.0 - 2.0 * x);
}

const ColourWeights& d65_weights()
{
    static const ColourWeights weights =
        reflectance_weights(cie_illuminant("D65"), ObserverId::cie1931,
                            colour_space("lin_rec709_scene"), Adaptation::bradford);
    return weights;
}

SigmoidSpectrum constant(double value) noexcept
{
    const double room = std::sqrt(value * (1.0 - value));
    const double x = room > 0.0 ? (value - 0.5) / room : std::copysign(kSaturated, value - 0.5);
    return {{0.0, 0.0, std::clamp(x, -kSaturated, kSaturated)}};
}

/// Where a value lies between the nodes of an axis.
struct Place {
    std::size_t node;
    double part;
};

Place ratio_place(double ratio) noexcept
{
    const double at = std::clamp(ratio, 0.0, 1.0) * (kNodes - 1);
    const std::size_t node = std::min(static_cast<std::size_t>(at), kNodes - 2);
    return {node, at - static_cast<double>(node)};
}

/// Coefficients by largest channel, its value, and the ratios of the others to it.
class SigmoidTable {
public:
    SigmoidTable() : table_(load_csv("cmf/rgb_coefficients_rec709.csv", 3))
    {
        for (std::size_t i = 1; i < kNodes; ++i)
            values_[i - 1] =
                std::min(smoothstep(smoothstep(static_cast<double>(i) / (kNodes - 1))), 0.9999);
    }

    [[nodiscard]] Vec3 at(const Vec3& rgb) const noexcept
    {
        const auto channel = static_cast<std::size_t>(std::ranges::max_element(rgb) - rgb.begin());
        const double largest = rgb[channel];
        const Place x = ratio_place(rgb[(channel + 1) % 3] / largest);
        const Place y = ratio_place(rgb[(channel + 2) % 3] / largest);
        const Place z = value_place(largest);
        Vec3 sum{};
        for (std::size_t corner = 0; corner < 8; ++corner) {
            const std::size_t i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
            const double weight = (i ? x.part : 1.0 - x.part) * (j ? y.part : 1.0 - y.part) *
                                  (k ? z.part : 1.0 - z.part);
            const std::size_t row =
                ((channel * values_.size() + z.node + k) * kNodes + y.node + j) * kNodes + x.node +
                i;
            for (std::size_t c = 0; c < 3; ++c) sum[c] += weight * table_.columns[c][row];
        }
        // The darker, the closer to R = 1 / 4x²: then x scales with the root of the colour.
        const double darker = std::sqrt(std::max(1.0, values_.front() / largest));
        for (double& value : sum) value *= darker;
        return sum;
    }

private:
    [[nodiscard]] Place value_place(double value) const noexcept
    {
        const auto above = std::upper_bound(values_.begin() + 1, values_.end() - 1, value);
        const auto node = static_cast<std::size_t>(above - values_.begin()) - 1;
        const double part = (value - values_[node]) / (values_[node + 1] - values_[node]);
        return {node, std::clamp(part, 0.0, 1.0)};
    }

    CsvTable table_;
    std::array<double, kNodes - 1> values_{};
};

/// What is left of the colour, and how it answers to the coefficients.
struct Residual {
    Vec3 value{};
    Mat3 slopes{};

    [[nodiscard]] double square() const noexcept
    {
        return value[0] * value[0] + value[1] * value[1] + value[2] * value[2];
    }
};

Residual residual(const Vec3& c, const Vec3& rgb, const ColourWeights& weights) noexcept
{
    Residual result;
    for (std::size_t i = 0; i < kWavelengths; ++i) {
        const double t = variable(wavelength_nm(i));
        const double x = (c[0] * t + c[1]) * t + c[2];
        const double root = std::sqrt(1.0 + x * x);
        const double slope = 0.5 / (root * root * root);
        for (std::size_t a = 0; a < 3; ++a) {
            const double weight = weights.weight[a][i];
            result.value[a] += weight * (0.5 + 0.5 * x / root);
            result.slopes[a][0] += weight * slope * t * t;
            result.slopes[a][1] += weight * slope * t;
            result.slopes[a][2] += weight * slope;
        }
    }
    for (std::size_t a = 0; a < 3; ++a) result.value[a] -= rgb[a];
    return result;
}

/// Solves (JᵀJ + damping · its diagonal) step = Jᵀ residual.
Vec3 damped_step(const Residual& at, double damping) noexcept
{
    Mat3 normal{};
    Vec3 gradient{};
    for (std::size_t a = 0; a < 3; ++a) {
        for (std::size_t b = 0; b < 3; ++b) {
            gradient[b] += at.slopes[a][b] * at.value[a];
            for (std::size_t d = 0; d < 3; ++d) normal[b][d] += at.slopes[a][b] * at.slopes[a][d];
        }
    }
    for (std::size_t b = 0; b < 3; ++b) normal[b][b] *= 1.0 + damping;
    return multiply(inverse(normal), gradient);
}

bool finite(const Vec3& v) noexcept
{
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

/// Levenberg 1944, Marquardt 1963.
Vec3 meet_colour(Vec3 c, const Vec3& rgb)
{
    constexpr int kMostSteps = 120;
    constexpr double kMet = 1e-13;
    const ColourWeights& weights = d65_weights();
    Residual here = residual(c, rgb, weights);
    double damping = 1e-6;
    for (int step = 0; step < kMostSteps && here.square() > kMet * kMet; ++step) {
        const Vec3 by = damped_step(here, damping);
        const Vec3 trial = {c[0] - by[0], c[1] - by[1], c[2] - by[2]};
        const Residual there = finite(trial) ? residual(trial, rgb, weights) : here;
        if (there.square() < here.square()) {
            c = trial;
            here = there;
            damping *= 0.2;
        } else {
            damping = 8.0 * damping + 1e-12;
        }
    }
    return c;
}

Vec3 grey_of(const Vec3& rgb)
{
    const Vec3& luminance = d65_weights().to_xyz_d65[1];
    const double y = luminance[0] * rgb[0] + luminance[1] * rgb[1] + luminance[2] * rgb[2];
    return constant(std::clamp(y, 1e-6, 1.0 - 1e-6)).c;
}

[[noreturn]] void refuse(const Vec3& rgb, const std::string& why)
{
    throw InputError({.file = {},
                      .field = "rgb",
                      .message = fmt::format("must be the colour of a smooth reflectance, {} (got "
                                             "{:.6g}, {:.6g}, {:.6g} in lin_rec709_scene)",
                                             why, rgb[0], rgb[1], rgb[2])});
}

}  // namespace

double SigmoidSpectrum::at(double wavelength_nm) const noexcept
{
    const double t = variable(wavelength_nm);
    const double x = (c[0] * t + c[1]) * t + c[2];
    return 0.5 + 0.5 * x / std::sqrt(1.0 + x * x);
}

Sampled SigmoidSpectrum::on_grid() const noexcept
{
    Sampled values;
    for (std::size_t i = 0; i < kWavelengths; ++i) values[i] = at(wavelength_nm(i));
    return values;
}

Vec3 SigmoidSpectrum::by_nanometre() const noexcept
{
    const double a = c[0] / (kHalfWidthNm * kHalfWidthNm), b = c[1] / kHalfWidthNm;
    return {a, b - 2.0 * a * kCentreNm, (a * kCentreNm - b) * kCentreNm + c[2]};
}

SigmoidSpectrum read_sigmoid_table(const Vec3& rgb)
{
    static const SigmoidTable table;
    if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return constant(rgb[0]);
    return {table.at(rgb)};
}

SigmoidSpectrum sigmoid_spectrum(const Vec3& rgb)
{
    if (!finite(rgb)) refuse(rgb, "finite");
    const auto [least, most] = std::ranges::minmax(rgb);
    const bool tabulated = least >= 0.0 && most <= 1.0;
    if (tabulated && least == most) return constant(least);
    SigmoidSpectrum best{meet_colour(tabulated ? read_sigmoid_table(rgb).c : grey_of(rgb), rgb)};
    double error = round_trip_error(rgb, best.on_grid());
    if (tabulated && error > 1e-6) {
        const SigmoidSpectrum other{meet_colour(grey_of(rgb), rgb)};
        const double other_error = round_trip_error(rgb, other.on_grid());
        if (other_error < error) {
            best = other;
            error = other_error;
        }
    }
    if (!(error <= kAcceptedError))
        refuse(rgb, fmt::format("of which the nearest found is ΔE00 {:.3g} away", error));
    return best;
}

double round_trip_error(const Vec3& rgb, const Sampled& reflectance)
{
    const ColourWeights& weights = d65_weights();
    const auto lab = [&weights](const Vec3& colour) {
        return xyz_to_lab(multiply(weights.to_xyz_d65, colour), d65_white());
    };
    return delta_e_2000(lab(rgb), lab(weights.apply(reflectance)));
}

}  // namespace nacre::spectral
