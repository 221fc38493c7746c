// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>

#include "nacre/media/optical_constants.h"
#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/observer.h"

/// @file
/// Media over 360 … 830 nm, the range of every colour.
///
/// Many data end at 400 or 700 nm. Under D65 0.04 % of the luminous weight, S(λ) ȳ(λ), lies beyond,
/// so by default n and k are held there as they are at the nearest end, and whoever uses them says
/// so with that share. One wavelength outside of the data stays an error of OpticalConstants::at().

namespace nacre::spectral {

/// What data have to cover, whatever the rule.
inline constexpr std::array<double, 2> kLeastRangeNm = {400.0, 700.0};

enum class RangeRule {
    hold_ends,  ///< data of 400 … 700 nm do
    strict,     ///< data must cover 360 … 830 nm
};

/// Why a medium cannot be used over 360 … 830 nm by the rule; nothing where it can.
[[nodiscard]] std::optional<std::string> range_problem(const OpticalConstants& medium,
                                                       RangeRule rule);

/// Gives media over 360 … 830 nm by one rule. A medium that covers that is itself; one that is
/// given twice is one object both times.
class WorkingRange {
public:
    explicit WorkingRange(RangeRule rule) noexcept : rule_(rule) {}

    /// @throws InputError with range_problem()
    [[nodiscard]] OpticalConstantsPtr cover(const OpticalConstantsPtr& medium);

private:
    RangeRule rule_;
    std::map<OpticalConstantsPtr, OpticalConstantsPtr> held_;
};

/// A medium with held ends.
struct HeldEnds {
    std::string medium;              ///< key
    std::array<double, 2> range_nm;  ///< of its data
    std::string illuminant;
    ObserverId observer;
    double percent;  ///< of the luminous weight, outside of the data

    /// `0.04 %`, or `< 0.001 %`
    [[nodiscard]] std::string share() const;
    /// `BaTiO3/Wemple-o: n and k are held beyond 400 … 700 nm, 0.04 % of the luminous weight (D65,
    /// cie1931)`
    [[nodiscard]] std::string note() const;
};

/// Nothing where the data cover 360 … 830 nm, or less than 400 … 700 nm.
[[nodiscard]] std::optional<HeldEnds> held_ends(const Medium& medium, const Illuminant& illuminant,
                                                ObserverId observer);

}  // namespace nacre::spectral
