// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "nacre/optics/film_models.h"
#include "nacre/optics/stack_batch.h"

/// @file
/// The forms of film_models.h in place of the multilayer: R and T of unpolarised light at every
/// angle, one by one and in lanes.
///
/// The light comes from the mirror direction. T is what the form implies: 1 − R of a lossless film,
/// the flux of `recursion`, and of `series` its cut series of transmission, so that R + T is not 1.
/// path_difference jumps with the wavelength; its R is the mean over the wave numbers of a cell.
/// From below, light meets the film at the refracted angle with the same R and T, and R = 1 beyond
/// the critical angle; `recursion` follows it through the stack.

namespace nacre::optics {

/// What keeps a form from holding at all angles, all at once; fields as in `validate`.
///   recursion     every layer coherent and, where clear, denser than the ambient: elsewhere it has
///                 a critical angle
///   the others    one coherent clear film at least as dense as the ambient
///   airy, series  and a clear base at least as dense as the ambient
///   free_film     and the ambient below
/// @pre  a stack without problems (`validate`)
[[nodiscard]] std::vector<StackProblem> film_model_problems(FilmModel model,
                                                            const FilmStack& stack);

/// @param cell_nm  width of the cell of wavelengths
/// @pre  `film_model_problems` has none
[[nodiscard]] PowerRatios film_model_power(FilmModel model, const FilmStack& stack,
                                           double cos_ambient, double wavelength_nm,
                                           double cell_nm);

/// Lanes of one stack by a form, as a function of the thickness of one layer or of a factor on all,
/// as PhaseMap and ScaledStack are by the multilayer. One object for one thread.
class FilmModelStack {
public:
    struct Setup {
        FilmModel model;
        std::optional<std::size_t> varying;  ///< layer whose thickness is free; none: a factor
        bool from_below = false;             ///< the stack is listed from the substrate up
        Lanes half_cell;                     ///< half the width of a cell over its wavelength
    };

    /// At the angle of the stack.
    FilmModelStack(const LaneStack& stack, const Setup& setup);
    FilmModelStack(FilmModelStack&&) noexcept;
    FilmModelStack& operator=(FilmModelStack&&) noexcept;
    FilmModelStack(const FilmModelStack&) = delete;
    FilmModelStack& operator=(const FilmModelStack&) = delete;
    ~FilmModelStack();

    void turn_to(const Lanes& cos_0);

    /// At thicknesses over wavelength of the varying layer: first, first + step, …
    void march(const Lanes& first, const Lanes& step, std::span<Lanes> R, std::span<Lanes> T) const;
    /// At factors on every thickness. @pre no layer varies alone
    void march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const;

    struct Form;

private:
    std::unique_ptr<Form> form_;
};

}  // namespace nacre::optics
