// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/illuminant.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "csv_table.h"
#include "nacre/core/diagnostics.h"
#include "nacre/spectral/spectrum.h"

namespace nacre::spectral {

namespace {

[[noreturn]] void throw_range(const char* field, double low, double high, double got)
{
    throw InputError({.file = {},
                      .field = field,
                      .message = fmt::format("must be within {} … {} K (got {})", low, high, got)});
}

[[noreturn]] void throw_line_problem(std::string message)
{
    throw InputError({.file = {}, .field = "illuminant", .message = std::move(message)});
}

}  // namespace

Spectrum blackbody_samples(double kelvin)
{
    constexpr double kLowest = 100.0, kHighest = 1e6, kC2 = 1.4388e-2, kReferenceNm = 560.0;
    if (!(kelvin >= kLowest && kelvin <= kHighest))
        throw_range("blackbody_K", kLowest, kHighest, kelvin);

    // As a ratio to 560 nm, in logarithms: exp(c2 / λT) alone overflows for cool bodies.
    const auto log_radiance = [kelvin](double nm) {
        const double x = kC2 / (nm * 1e-9 * kelvin);
        return -5.0 * std::log(nm / kReferenceNm) - (x + std::log(-std::expm1(-x)));
    };
    constexpr int kFrom = 300, kTo = 900;
    std::vector<double> wavelengths, power;
    const double reference = log_radiance(kReferenceNm);
    for (int nm = kFrom; nm <= kTo; ++nm) {
        wavelengths.push_back(nm);
        power.push_back(100.0 * std::exp(log_radiance(nm) - reference));
    }
    return {std::move(wavelengths), std::move(power)};
}

Spectrum daylight_samples(double kelvin)
{
    constexpr double kLowest = 4000.0, kHighest = 25000.0, kBreak = 7000.0;
    if (!(kelvin >= kLowest && kelvin <= kHighest))
        throw_range("daylight_K", kLowest, kHighest, kelvin);

    // CIE 015:2018, equations 4.8 to 4.13.
    const double t = 1000.0 / kelvin;
    const double x = kelvin <= kBreak ? ((-4.6070 * t + 2.9678) * t + 0.09911) * t + 0.244063
                                      : ((-2.0064 * t + 1.9018) * t + 0.24748) * t + 0.237040;
    const double y = (-3.000 * x + 2.870) * x - 0.275;
    const double m = 0.0241 + 0.2562 * x - 0.7341 * y;
    // Rounded to three decimals, as the published tables of the D illuminants are.
    const double m1 = std::nearbyint((-1.3515 - 1.7703 * x + 5.9114 * y) / m * 1000.0) / 1000.0;
    const double m2 = std::nearbyint((0.0300 - 31.4424 * x + 30.0717 * y) / m * 1000.0) / 1000.0;

    CsvTable table = load_csv("spd/cie_daylight_components.csv", 4);
    const auto& s1 = table.columns[2];
    const auto& s2 = table.columns[3];
    std::vector<double> power = std::move(table.columns[1]);
    for (std::size_t i = 0; i < power.size(); ++i) power[i] += m1 * s1[i] + m2 * s2[i];
    return {std::move(table.columns[0]), std::move(power)};
}

Illuminant line_spectrum(const std::vector<SpectralLine>& lines)
{
    if (lines.empty()) throw_line_problem("must have at least one line");
    Illuminant illuminant{.name = "lines", .power = {}};
    for (const auto& [nm, power] : lines) {
        if (!(nm >= kFirstNm && nm <= kLastNm))
            throw_line_problem(fmt::format("must have its lines within {} … {} nm (got {})",
                                           kFirstNm, kLastNm, nm));
        if (!(power > 0.0) || !std::isfinite(power))
            throw_line_problem(
                fmt::format("must have lines of a finite power > 0 (got {})", power));
        // Shared by the two neighbours as their distances say: every sum over the grid then equals
        // the value at the line, linear in between.
        const double below = std::floor(nm);
        const auto i = static_cast<std::size_t>(below - kFirstNm);
        illuminant.power[i] += power * (1.0 - (nm - below));
        if (nm > below) illuminant.power[i + 1] += power * (nm - below);
    }
    return illuminant;
}

Spectrum line_samples(const std::vector<SpectralLine>& lines)
{
    // On the grid, and nothing on its either side.
    std::vector<double> wavelengths, power(kWavelengths + 2);
    for (int nm = kFirstNm - 1; nm <= kLastNm + 1; ++nm) wavelengths.push_back(nm);
    const Sampled grid = line_spectrum(lines).power;
    std::ranges::copy(grid, power.begin() + 1);
    return {std::move(wavelengths), std::move(power)};
}

// The CIE defines its illuminants between the published samples by linear interpolation.

Illuminant blackbody(double kelvin)
{
    return {.name = fmt::format("blackbody {} K", kelvin),
            .power = blackbody_samples(kelvin).on_grid(Interpolation::linear)};
}

Illuminant daylight(double kelvin)
{
    return {.name = fmt::format("daylight {} K", kelvin),
            .power = daylight_samples(kelvin).on_grid(Interpolation::linear)};
}

}  // namespace nacre::spectral
