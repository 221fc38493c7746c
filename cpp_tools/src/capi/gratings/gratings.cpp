// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "base/guard.h"
#include "nacre/capi/gratings.h"
#include "nacre/optics/film_models.h"
#include "nacre/optics/grating.h"

namespace nacre::capi {
namespace {

optics::ProfileKind profile_kind(std::string_view name)
{
    const std::span names = optics::kProfileNames;
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        fail("profile.kind",
             fmt::format("must be {} or {} (got {})",
                         fmt::join(names.first(names.size() - 1), ", "), names.back(), name));
    return static_cast<optics::ProfileKind>(found - names.begin());
}

optics::Direction direction(const double (&values)[3])
{
    return {values[0], values[1], values[2]};
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_grating_orders(const nacre_grating* grating, int first, int last,
                                  double* directions, double* efficiencies)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(grating, "grating");
        capi::require(grating->profile, "profile.kind");
        capi::require(directions, "directions");
        capi::require(efficiencies, "efficiencies");
        const optics::Grating asked{.pitch_nm = grating->pitch_nm,
                                    .grating_vector = capi::direction(grating->grating_vector),
                                    .normal = capi::direction(grating->normal),
                                    .profile = {.kind = capi::profile_kind(grating->profile),
                                                .phase_rad = grating->phase_rad,
                                                .duty = grating->duty}};
        const auto orders = optics::grating_orders(asked, capi::direction(grating->k_in),
                                                   grating->wavelength_nm, first, last);
        for (const optics::DiffractedOrder& order : orders) {
            const auto none = optics::Direction{0.0, 0.0, 0.0};
            const auto out = order.direction.value_or(none);
            directions = std::copy(out.begin(), out.end(), directions);
            *efficiencies++ = order.efficiency;
        }
    });
}

nacre_status nacre_slit_intensity(size_t count, const double* slits, double* intensity)
{
    using namespace nacre;
    return capi::guarded([&] {
        if (count == 0) return;
        capi::require(slits, "slits");
        capi::require(intensity, "intensity");
        std::vector<double> results(count);
        capi::for_each_item(count, [&](std::size_t i) {
            const double *of = slits + 4 * i, angle_deg = of[2];
            if (!(angle_deg >= -90.0 && angle_deg <= 90.0))
                capi::fail("angle_deg", fmt::format("must be in [-90, 90] (got {})", angle_deg));
            const double sine = std::sin(angle_deg * std::numbers::pi / 180.0);
            results[i] = optics::slit_intensity(of[0], of[1], sine, of[3]);
        });
        std::copy(results.begin(), results.end(), intensity);
    });
}
}
