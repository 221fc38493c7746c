// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <vector>

#include "nacre/optics/dispersive_stack.h"
#include "nacre/optics/film_stack.h"
#include "nacre/optics/lanes.h"

/// @file
/// A dispersive stack at a list of wavelengths.

namespace nacre::optics::detail {

/// R and T of the light, one a wavelength.
struct PowerSamples {
    std::vector<double> R, T;
};

/// Of one polarisation, up to a factor that is smooth and cancels: r = b/a, T = tau/|a|².
struct AmplitudeSamples {
    std::vector<Complex> a, b;
    std::vector<double> tau;
};

class StackSamples {
public:
    /// @throws InputError, see SummedColours
    StackSamples(const DispersiveStack& stack, std::vector<double> wavelengths_nm);

    [[nodiscard]] std::size_t size() const { return wavelengths_nm_.size(); }
    [[nodiscard]] const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }

    [[nodiscard]] PowerSamples power(std::span<const double> thickness_nm,
                                     const ObliqueLight& light) const;

    /// Polarisations s and p. Empty where double precision cannot hold them.
    /// @pre every layer is coherent
    [[nodiscard]] std::array<AmplitudeSamples, 2> amplitudes(std::span<const double> thickness_nm,
                                                             double cos_ambient) const;

    /// Passage through the layers above the first one that is opaque at all wavelengths, which is
    /// as good as a substrate.
    struct Passage {
        std::size_t layers;
        std::vector<Complex> phase;  ///< Σ q_j d_j k_0, one a wavelength
        /// Σ artanh |r_j| of the interfaces (s, shortest wavelength): natural logarithm of the
        /// ratio of the largest to the smallest |a| that they can bring about together.
        double contrast;
    };
    [[nodiscard]] Passage passage(std::span<const double> thickness_nm, double cos_ambient) const;

private:
    [[nodiscard]] LaneStack lanes(std::span<const double> thickness_nm, double cos_ambient,
                                  std::size_t first, std::size_t layers) const;
    [[nodiscard]] FilmStack at(std::span<const double> thickness_nm, std::size_t wavelength,
                               std::size_t layers) const;

    std::vector<double> wavelengths_nm_;
    std::vector<bool> coherent_;
    std::vector<std::vector<Complex>> n_;  ///< [medium][wavelength]
};

}  // namespace nacre::optics::detail
