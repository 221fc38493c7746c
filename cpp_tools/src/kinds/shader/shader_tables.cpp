// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/shader_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "base/path_wavelengths.h"
#include "grating/fields.h"
#include "nacre/kinds/compile_options.h"
#include "nacre/lut/tint_basis.h"
#include "nacre/oslgen/literals.h"

namespace nacre::kinds {
namespace {

constexpr int kCumulativeStepNm = 5;

/// Σ of the colour weights from 360 nm up to every fifth nm, trapezoidal, 1 at 830 nm.
std::vector<spectral::Vec3> cumulative_weights(const spectral::ColourWeights& weights)
{
    std::vector<spectral::Vec3> result(1 + (spectral::kWavelengths - 1) / kCumulativeStepNm);
    for (std::size_t c = 0; c < 3; ++c) {
        const spectral::Sampled& weight = weights.weight[c];
        double sum = 0.0;
        for (std::size_t i = 1; i < spectral::kWavelengths; ++i) {
            sum += 0.5 * (weight[i - 1] + weight[i]);
            if (i % kCumulativeStepNm == 0) result[i / kCumulativeStepNm][c] = sum;
        }
        for (spectral::Vec3& colour : result) colour[c] /= sum;
    }
    return result;
}

constexpr const char* kText = R"(// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Written by write_osl_headers; do not edit. Colours are {space}, {illuminant}, {observer}.

#define NACRE_FIRST_NM {first}
#define NACRE_LAST_NM {last}

// A path's wavelength: see nacre_wavelength.h.
#define NACRE_CELLS {cells}
#define NACRE_EDGES {edges}
#define NACRE_WAVELENGTH_EDGES {edge_list}
#define NACRE_WAVELENGTH_WEIGHT {weight_list}

// What a grey metal leaves of light of each cell, by its colour: see nacre_at_wavelength.
#define NACRE_TINT_BASIS {basis_list}

// Colour of all light from the first wavelength up to every {step}th nm; a perfect white is (1, 1, 1).
#define NACRE_CUMULATIVE_SIZE {cumulative}
#define NACRE_CUMULATIVE_WEIGHT {cumulative_list}

color nacre_cumulative(color cumulative[], float offset_nm)
{{
    float x = offset_nm / {step}.0;
    int i = clamp((int)x, 0, NACRE_CUMULATIVE_SIZE - 2);
    return mix(cumulative[i], cumulative[i + 1], x - i);
}}
)";

}  // namespace

std::string colour_tables_header(const spectral::ColourWeights& weights)
{
    const spectral::WavelengthSampling sampling = path_wavelengths(weights);
    const std::vector<spectral::Vec3> cumulative = cumulative_weights(weights);
    spectral::Sampled grey{};
    grey.fill(1.0);
    const std::vector<spectral::Vec3> basis = lut::tint_basis(sampling, weights, grey);
    using fmt::arg;
    return fmt::format(
        fmt::runtime(kText), arg("space", weights.space), arg("illuminant", weights.illuminant),
        arg("observer", spectral::observer_name(weights.observer)),
        arg("first", spectral::kFirstNm), arg("last", spectral::kLastNm),
        arg("cells", spectral::kWavelengthCells), arg("edges", spectral::kWavelengthCells + 1),
        arg("step", kCumulativeStepNm), arg("cumulative", cumulative.size()),
        arg("edge_list", oslgen::array_literal(sampling.edges_nm, " \\")),
        arg("weight_list", oslgen::array_literal(sampling.weight, " \\")),
        arg("basis_list", oslgen::array_literal(basis, " \\")),
        arg("cumulative_list", oslgen::array_literal(cumulative, " \\")));
}

std::string constants_header()
{
    std::string text =
        "// SPDX-FileCopyrightText: Nacre contributors\n"
        "// SPDX-License-Identifier: BSD-3-Clause\n"
        "#pragma once\n\n"
        "// Written by write_osl_headers; do not edit. `nacre compile` puts the values in place of "
        "the names.\n\n";
    const auto define = [&](std::string_view name, const std::string& value) {
        text += fmt::format("#define NACRE_{} {}\n", name, value);
    };
    std::string options;
    for (std::size_t i = 0; i < optics::kProfileNames.size(); ++i) {
        std::string name(optics::kProfileNames[i]);
        options += fmt::format("{}{}:{}", i == 0 ? "" : "|", name, i);
        std::ranges::transform(name, name.begin(), [](char c) { return std::toupper(c); });
        define(name, std::to_string(i));
    }
    define("LAST_PROFILE", std::to_string(optics::kProfileNames.size() - 1));
    define("PROFILES", fmt::format("\"{}\"", options));
    define("PITCH_MIN_NM", oslgen::literal(grating::kPitch.info.bounds.min));
    define("PITCH_MAX_NM", oslgen::literal(grating::kPitch.info.bounds.max));
    define("DEPTH_MAX_NM", oslgen::literal(grating::kDepth.info.bounds.max));
    define("ORDERS_MAX", std::to_string(static_cast<int>(grating::kOrders.info.bounds.max)));
    return text;
}

spectral::ColourWeights default_colour_weights()
{
    return CompileOptions().weights();
}

}  // namespace nacre::kinds
