// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "nacre/lut/film_table.h"
#include "nacre/optics/microsurface_walk.h"
#include "nacre/optics/multilayer.h"

namespace nacre::lut::test {

/// Reflectance of a stack at 471 wavelengths over the facet's cosine, and what a rough surface of
/// it reflects by following light from facet to facet: no table, no lobe, colours formed at the
/// end.
class RoughTruth {
public:
    RoughTruth(const FilmTableRequest& request, double value)
        : weights_(request.weights), reflectance_((kSteps + 1) * spectral::kWavelengths)
    {
        optics::FilmStack stack;
        for (const SampledLayer& layer : request.stack.layers)
            stack.layers.push_back({.n = {}, .thickness_nm = layer.thickness_nm});
        if (request.variation && request.variation->layer)
            stack.layers[*request.variation->layer].thickness_nm = value;
        for (std::size_t w = 0; w < spectral::kWavelengths; ++w) {
            stack.ambient = request.stack.ambient[w];
            stack.substrate = request.stack.substrate[w];
            for (std::size_t i = 0; i < stack.layers.size(); ++i)
                stack.layers[i].n = request.stack.layers[i].n[w];
            for (std::size_t i = 0; i <= kSteps; ++i)
                reflectance_[i * spectral::kWavelengths + w] =
                    i == 0 ? 1.0
                           : optics::stack_power_unpolarised(stack, static_cast<double>(i) / kSteps,
                                                             spectral::wavelength_nm(w))
                                 .R;
        }
    }

    /// Directional albedo as a colour: after one bounce, and after all.
    struct Albedo {
        spectral::Vec3 once, all;
    };
    [[nodiscard]] Albedo albedo(double cos_theta, std::array<double, 2> alpha,
                                std::uint64_t paths) const
    {
        spectral::Sampled once{}, all{}, product{};
        optics::walk_microsurface({.view = {std::sqrt(1.0 - cos_theta * cos_theta), 0.0, cos_theta},
                                   .alpha = alpha,
                                   .paths = paths},
                                  [&](std::span<const double> cosines, const auto&) {
                                      product.fill(1.0);
                                      for (const double c : cosines) multiply(product, c);
                                      add(all, product);
                                      if (cosines.size() == 1) add(once, product);
                                  });
        for (std::size_t w = 0; w < spectral::kWavelengths; ++w) {
            once[w] /= static_cast<double>(paths);
            all[w] /= static_cast<double>(paths);
        }
        return {weights_.apply(once), weights_.apply(all)};
    }

private:
    static constexpr std::size_t kSteps = 1024;

    /// Wavelengths lie side by side, so that one facet costs a pass over them.
    void multiply(spectral::Sampled& product, double cosine) const
    {
        const double x = cosine * kSteps;
        const std::size_t i = std::min(static_cast<std::size_t>(x), kSteps - 1);
        const double t = x - static_cast<double>(i);
        const double* values = &reflectance_[i * spectral::kWavelengths];
        for (std::size_t w = 0; w < spectral::kWavelengths; ++w)
            product[w] *= (1.0 - t) * values[w] + t * values[spectral::kWavelengths + w];
    }
    static void add(spectral::Sampled& sum, const spectral::Sampled& product)
    {
        for (std::size_t w = 0; w < spectral::kWavelengths; ++w) sum[w] += product[w];
    }

    spectral::ColourWeights weights_;
    std::vector<double> reflectance_;
};

}  // namespace nacre::lut::test
