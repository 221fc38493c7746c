// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "nacre/capi/stacks.h"
#include "nacre/optics/multilayer.h"
#include "stacks/stack_grid.h"

/// @file
/// Arguments of nacre_stack() and nacre_stack_grid().

namespace nacre::capi {

using optics::Complex;

/// Where the data of one item are.
struct Item {
    const double *n, *d_nm;
    double angle_deg, wavelength_nm, cosine;

    [[nodiscard]] Complex index(std::size_t medium) const
    {
        return {n[2 * medium], n[2 * medium + 1]};
    }
};

/// The arrays of a call.
struct Stacks {
    std::span<const std::size_t> shape;
    std::size_t layers;
    nacre_grid_array n, d_nm, angle_deg, wavelength_nm;
    nacre_coherence coherence;
    nacre_polarisation polarisation;
    double *power, *amplitudes, *absorption;

    std::size_t count = count_items(shape);
    std::vector<double> cosines{};  ///< of every angle, once
    std::vector<std::size_t> cosine_steps{};

    [[nodiscard]] Steps steps(const nacre_grid_array& array) const
    {
        return {array.steps, shape.size()};
    }
    [[nodiscard]] bool coherent(std::size_t layer) const
    {
        return coherence.coherent == nullptr || coherence.coherent[layer] != 0;
    }
    [[nodiscard]] double spread_nm(std::size_t layer) const
    {
        return coherence.spread_nm == nullptr ? 0.0 : coherence.spread_nm[layer];
    }
    [[nodiscard]] bool any_spread() const
    {
        for (std::size_t j = 0; j < layers; ++j)
            if (spread_nm(j) != 0.0) return true;
        return coherence.bandwidth_nm > 0.0;
    }
    [[nodiscard]] bool fully_coherent() const
    {
        for (std::size_t j = 0; j < layers; ++j)
            if (!coherent(j)) return false;
        return !any_spread();
    }
};

/// Walks over the items.
class ItemCursor {
public:
    ItemCursor(const Stacks& in, std::size_t item)
        : in_(&in),
          cursor_(in.shape,
                  {in.steps(in.n), in.steps(in.d_nm), in.steps(in.angle_deg),
                   in.steps(in.wavelength_nm), in.cosine_steps},
                  item)
    {}
    [[nodiscard]] Item operator*() const
    {
        const std::size_t cosine = cursor_.offset(4);
        return {.n = in_->n.values + 2 * (in_->layers + 2) * cursor_.offset(0),
                .d_nm = in_->d_nm.values + in_->layers * cursor_.offset(1),
                .angle_deg = in_->angle_deg.values[cursor_.offset(2)],
                .wavelength_nm = in_->wavelength_nm.values[cursor_.offset(3)],
                .cosine = cosine < in_->cosines.size() ? in_->cosines[cosine] : 1.0};
    }
    void advance() { cursor_.advance(); }

private:
    const Stacks* in_;
    GridCursor<5> cursor_;
};

[[nodiscard]] optics::FilmStack film_stack(const Stacks& in, const Item& item);

/// @throws InputError that names field, value and item
void check(const Stacks& in);

}  // namespace nacre::capi
