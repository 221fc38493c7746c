// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "colours/stack_samples.h"
#include "math/chebyshev.h"
#include "nacre/spectral/colour.h"

/// @file
/// Reflectance and transmittance as quotients of series, and their sums against colour weights.

namespace nacre::optics::detail {

/// Colour weights over the wavelengths that matter: all but 1e-4 of each channel at either end,
/// which the last wavelength inside stands for.
class BandWeights {
public:
    explicit BandWeights(const spectral::ColourWeights& weights);

    [[nodiscard]] double first_nm() const { return first_nm_; }
    [[nodiscard]] std::size_t size() const { return weight_.size(); }
    [[nodiscard]] double wavelength_nm(std::size_t i) const
    {
        return first_nm_ + static_cast<double>(i);
    }
    [[nodiscard]] double last_nm() const { return wavelength_nm(size() - 1); }

    /// Of the sum at 1 nm; the ends hold what lies outside.
    [[nodiscard]] const spectral::Vec3& operator[](std::size_t i) const { return weight_[i]; }
    /// Mean over the channels of |weight| over its sum.
    [[nodiscard]] double importance(std::size_t i) const { return importance_[i]; }
    /// Linear between i and i + 1, without what lies outside; part in [0, 1].
    [[nodiscard]] spectral::Vec3 density(std::size_t i, double part) const;

private:
    double first_nm_;
    std::vector<spectral::Vec3> weight_, inside_;
    std::vector<double> importance_;
};

/// T_k at each nanometre of a band: rows are made when they are first asked for.
class ChebyshevRows {
public:
    ChebyshevRows(const WavenumberBand& band, const BandWeights& weights);

    /// `count` rows of `stride()` values; from `size` of the weights on they are padding.
    [[nodiscard]] const double* rows(std::size_t count);
    [[nodiscard]] std::size_t stride() const { return x_.size(); }

private:
    std::vector<double> x_, rows_;
};

struct BandSums {
    spectral::Vec3 reflectance{}, transmittance{};
    /// Mean of what the last two terms of the series contribute to R or T.
    double doubt = 0.0;
};

/// One polarisation.
class AmplitudeSeries {
public:
    explicit AmplitudeSeries(const AmplitudeSamples& samples);

    [[nodiscard]] BandSums sums(const WavenumberBand& band, const BandWeights& weights,
                                ChebyshevRows& rows) const;

private:
    std::vector<Complex> a_, b_;
    std::vector<double> tau_;
};

}  // namespace nacre::optics::detail
