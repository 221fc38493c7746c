// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/media/working_range.h"

#include <fmt/format.h>

#include <algorithm>

#include "nacre/core/diagnostics.h"
#include "nacre/spectral/colour.h"

namespace nacre::spectral {

namespace {

constexpr std::array<double, 2> kWorkingRangeNm = {kFirstNm, kLastNm};

bool covers(const OpticalConstants& medium, const std::array<double, 2>& range_nm)
{
    const auto [low, high] = medium.range_nm();
    return low <= range_nm[0] && high >= range_nm[1];
}

/// From the first of 360 nm and the data to the last of the data and 830 nm.
class HeldConstants final : public OpticalConstants {
public:
    explicit HeldConstants(OpticalConstantsPtr medium) : medium_(std::move(medium)) {}

    [[nodiscard]] Complex at(double wavelength_nm) const override
    {
        const auto [low, high] = medium_->range_nm();
        const bool working = wavelength_nm >= kFirstNm && wavelength_nm <= kLastNm;
        return medium_->at(working ? std::clamp(wavelength_nm, low, high) : wavelength_nm);
    }

    [[nodiscard]] std::array<double, 2> range_nm() const noexcept override
    {
        const auto [low, high] = medium_->range_nm();
        return {std::min<double>(low, kFirstNm), std::max<double>(high, kLastNm)};
    }

private:
    OpticalConstantsPtr medium_;
};

}  // namespace

std::optional<std::string> range_problem(const OpticalConstants& medium, RangeRule rule)
{
    const bool enough = covers(medium, kLeastRangeNm);
    const auto& needed = enough ? kWorkingRangeNm : kLeastRangeNm;
    if (enough && (rule == RangeRule::hold_ends || covers(medium, needed))) return std::nullopt;
    const auto [low, high] = medium.range_nm();
    return fmt::format("must be within the data, {:.10g} … {:.10g} nm (got {:g}); {}", low, high,
                       low > needed[0] ? needed[0] : needed[1],
                       enough ? std::string("without --strict-range (strict_range= in Python) n "
                                            "and k are held at their ends")
                              : fmt::format("what is needed is {:g} … {:g} nm, beyond which n and "
                                            "k may be held at their ends",
                                            needed[0], needed[1]));
}

OpticalConstantsPtr WorkingRange::cover(const OpticalConstantsPtr& medium)
{
    if (auto problem = range_problem(*medium, rule_))
        throw InputError({.file = {}, .field = "wavelength_nm", .message = std::move(*problem)});
    if (covers(*medium, kWorkingRangeNm)) return medium;
    OpticalConstantsPtr& held = held_[medium];
    if (!held) held = std::make_shared<HeldConstants>(medium);
    return held;
}

std::string HeldEnds::share() const
{
    constexpr double kLeast = 0.001;
    return percent < kLeast ? fmt::format("< {:g} %", kLeast) : fmt::format("{:.3g} %", percent);
}

std::string HeldEnds::note() const
{
    return fmt::format(
        "{}: n and k are held beyond {:.10g} … {:.10g} nm, {} of the luminous weight ({}, {})",
        medium, range_nm[0], range_nm[1], share(), illuminant, observer_name(observer));
}

std::optional<HeldEnds> held_ends(const Medium& medium, const Illuminant& illuminant,
                                  ObserverId observer)
{
    const OpticalConstants& constants = *medium.constants;
    if (!covers(constants, kLeastRangeNm) || covers(constants, kWorkingRangeNm))
        return std::nullopt;
    const auto range = constants.range_nm();
    Sampled beyond{};
    for (std::size_t i = 0; i < kWavelengths; ++i)
        if (wavelength_nm(i) < range[0] || wavelength_nm(i) > range[1]) beyond[i] = 1.0;
    return HeldEnds{.medium = medium.key,
                    .range_nm = range,
                    .illuminant = illuminant.name,
                    .observer = observer,
                    .percent = 100.0 * reflectance_to_xyz(beyond, illuminant, observer)[1]};
}

}  // namespace nacre::spectral
