// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <variant>
#include <vector>

#include "nacre/lut/film_request.h"
#include "nacre/optics/film_model_stack.h"
#include "nacre/optics/stack_batch.h"

namespace nacre::lut {

/// What does not depend on the angle: the stack and the colour weights, laid out in blocks of
/// lanes. Blocks without any weight are left out; the last is filled up with wavelengths of none.
class SpectralBlocks {
public:
    explicit SpectralBlocks(const FilmTableRequest& request);

    struct Block {
        std::size_t first;        ///< of the wavelengths
        optics::LaneStack stack;  ///< `waves` as of the request's thicknesses; cosine not set
        optics::Lanes inverse_wavelength;
        std::array<optics::Lanes, 3> weight;
        std::array<optics::SingleLanes, 3> single_weight;
    };
    std::vector<Block> blocks;
    std::vector<bool> coherent;
    std::optional<Variation> variation;
    std::optional<Technique> technique;  ///< of a stack with layers
};

/// Colours along the second axis at one angle. One object for one thread.
class Column {
public:
    /// At normal incidence.
    explicit Column(const SpectralBlocks& spectral);

    Column& turn_to(double cos_theta);

    /// Colours at first, first + step, …, one for each element of `out`.
    void evaluate(double first, double step, std::span<FilmColour> out,
                  Precision precision = Precision::double_precision) const;

    /// Calls visit(row, block, R) with the reflectance of one block of wavelengths of one row, for
    /// `count` rows as above; in double precision.
    void visit_reflectance(double first, double step, std::size_t count,
                           const std::function<void(std::size_t row, std::size_t block,
                                                    const optics::Lanes& R)>& visit) const;

private:
    /// Folded around the varying layer, prepared for a factor on all, for incoherent layers, or by
    /// a closed form.
    using Stack = std::variant<optics::PhaseMap, optics::ScaledStack, optics::MixedStack,
                               optics::FilmModelStack>;
    std::vector<Stack> blocks_;
    const SpectralBlocks* spectral_;
    bool grazing_ = false;

    template <class Real>
    void evaluate_in(double first, double step, std::span<FilmColour> out) const;
    template <class Real>
    void rows(std::size_t block, double first, double step, std::span<optics::LanesOf<Real>> R,
              std::span<optics::LanesOf<Real>> T) const;
};

}  // namespace nacre::lut
