// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "nacre/core/diagnostics.h"
#include "nacre/kinds/film.h"
#include "nacre/lut/table.h"

namespace nacre::kinds::film {

/// Of smooth tables. What is lost to rounding is 0.002 of ΔE00 on average, a quarter of what their
/// rows are allowed, and their files are a quarter as large.
inline constexpr int kTexelBits = 13;

/// R, and what light needs that goes on below the film, smooth and rough.
/// @param solid       solid_index() of a film on glass
/// @param texel_bits  of smooth tables
/// @throws InputError when the stack is not valid
[[nodiscard]] std::vector<lut::Table> film_tables(const lut::FilmTableRequest& request,
                                                  Interior below, std::optional<double> solid,
                                                  int texel_bits = kTexelBits);

/// Whether the film fades to the bare substrate, by its coverage.
[[nodiscard]] bool fades(const MaterialTemplate& source);

/// The same tables of the substrate alone.
[[nodiscard]] std::vector<lut::Table> bare_tables(lut::FilmTableRequest request, Interior below,
                                                  std::optional<double> solid,
                                                  int texel_bits = kTexelBits);

/// What `work` makes; problems that it has belong to the template as a whole.
template <class Work>
auto with_file(const MaterialTemplate& source, Work&& work)
{
    try {
        return work();
    } catch (const InputError& error) {
        std::vector<Diagnostic> problems(error.diagnostics().begin(), error.diagnostics().end());
        for (Diagnostic& problem : problems)
            if (problem.file.empty()) problem.file = source.file;
        throw InputError(std::move(problems));
    }
}

}  // namespace nacre::kinds::film
