// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/lut/film_table.h"
#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/observer.h"

/// @file
/// Requests for the tests of film tables.

namespace nacre::lut::test {

inline IndexOnGrid constant(std::complex<double> n)
{
    IndexOnGrid grid;
    grid.fill(n);
    return grid;
}

/// What a texel may be off by for its rounding.
inline double half_step(double texel, int bits)
{
    const int exponent = std::max(std::ilogb(texel == 0.0 ? 1e-9 : texel), -5);
    return std::ldexp(0.5, exponent - bits);
}

inline IndexOnGrid medium(const std::string& key)
{
    return spectral::library_medium(key).constants->on_grid();
}

inline spectral::ColourWeights weights(const std::string& space = "lin_rec709_scene")
{
    return spectral::reflectance_weights(spectral::named_illuminant("D65"),
                                         spectral::ObserverId::cie1931,
                                         spectral::colour_space(space));
}

inline FilmTableRequest request(IndexOnGrid ambient, std::vector<SampledLayer> layers,
                                IndexOnGrid substrate, std::optional<Variation> variation)
{
    FilmTableRequest asked;
    asked.stack = {ambient, std::move(layers), substrate};
    asked.variation = variation;
    asked.weights = weights();
    return asked;
}

/// Water between air, 20 … 700 nm.
inline FilmTableRequest soap_film()
{
    const IndexOnGrid air = constant(1.0);
    auto asked =
        request(air, {{medium("water/Daimon-20C"), 300.0, true}}, air, Variation{0, 20.0, 700.0});
    asked.transmittance = true;
    return asked;
}

/// Oxide on titanium under a thickness in nm.
inline FilmTableRequest anodised()
{
    return request(constant(1.0), {{medium("TiO2/Sarkar"), 100.0, true}}, medium("Ti/Johnson"),
                   Variation{0, 20.0, 160.0});
}

/// Quarter-wave mirror of seven layers, scaled as a whole.
inline FilmTableRequest mirror()
{
    std::vector<SampledLayer> layers;
    for (int i = 0; i < 7; ++i)
        layers.push_back(i % 2 == 0 ? SampledLayer{medium("TiO2/Sarkar"), 57.0, true}
                                    : SampledLayer{medium("SiO2/Malitson"), 94.0, true});
    auto asked = request(constant(1.0), layers, constant(1.52), Variation{{}, 0.8, 1.2});
    asked.transmittance = true;
    asked.tolerance = 0.3;
    return asked;
}

/// 50 … 400 nm of a medium on clear glass of index 1.5.
inline FilmTableRequest on_glass(std::complex<double> n)
{
    auto asked = request(constant(1.0), {{constant(n), 100.0, true}}, constant(1.5),
                         Variation{0, 50.0, 400.0});
    asked.transmittance = true;
    return asked;
}

/// A film on a pane that is not coherent.
inline FilmTableRequest coated_pane()
{
    return request(constant(1.0),
                   {{medium("SiO2/Malitson"), 100.0, true}, {constant(1.9), 1e6, false}},
                   constant(1.0), Variation{0, 0.0, 300.0});
}

/// The bilinear reading of a table, as a renderer does it.
inline spectral::Vec3 read(const Table& table, double x, double y)
{
    const auto place = [](const Axis& axis, double value) {
        const double at =
            axis.texels < 2 ? 0.0 : (value - axis.min) / (axis.max - axis.min) * (axis.texels - 1);
        const int low = std::clamp(static_cast<int>(at), 0, std::max(0, axis.texels - 2));
        return std::pair{low, at - low};
    };
    const auto [column, u] = place(table.x, x);
    const auto [row, v] = place(table.y, y);
    const auto texel = [&](int across, int down, std::size_t channel) {
        const int i = std::min(column + across, table.x.texels - 1);
        const int j = std::min(row + down, table.y.texels - 1);
        return static_cast<double>(
            table.texels[3 * static_cast<std::size_t>(j * table.x.texels + i) + channel]);
    };
    spectral::Vec3 colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = (1 - v) * ((1 - u) * texel(0, 0, c) + u * texel(1, 0, c)) +
                    v * ((1 - u) * texel(0, 1, c) + u * texel(1, 1, c));
    return colour;
}

/// ΔE00 of two colours of the request's space, against D65.
inline double delta_e(const FilmTableRequest& asked, const spectral::Vec3& a,
                      const spectral::Vec3& b)
{
    const auto lab = [&](const spectral::Vec3& colour) {
        return spectral::xyz_to_lab(spectral::multiply(asked.weights.to_xyz_d65, colour),
                                    spectral::d65_white());
    };
    return spectral::delta_e_2000(lab(a), lab(b));
}

/// Mean and largest of many errors.
struct Errors {
    double max = 0.0, sum = 0.0;
    int count = 0;

    void add(double error)
    {
        max = std::max(max, error);
        sum += error;
        ++count;
    }
    [[nodiscard]] double mean() const { return sum / count; }
};

}  // namespace nacre::lut::test
