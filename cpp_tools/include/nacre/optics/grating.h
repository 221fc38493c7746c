// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

/// @file
/// Plane reflection gratings in any orientation (conical mounting).

namespace nacre::optics {

using Direction = std::array<double, 3>;

enum class ProfileKind { sinusoidal, rectangular, blazed };
/// In the order of the enumeration.
inline constexpr std::array<std::string_view, 3> kProfileNames{"sinusoidal", "rectangular",
                                                               "blazed"};

/// A thin phase profile. `phase_rad` is the peak-to-valley phase 2π n h (cosθ_i + cosθ_o)/λ.
struct GratingProfile {
    ProfileKind kind = ProfileKind::sinusoidal;
    double phase_rad = 0.0;
    double duty = 0.5;  ///< fraction of the period that is raised; rectangular only
};

struct Grating {
    double pitch_nm;
    Direction grating_vector;  ///< across the grooves; only its tangential part counts
    Direction normal;
    GratingProfile profile;
};

struct DiffractedOrder {
    int order;
    std::optional<Direction> direction;  ///< unit, away from the surface; none when evanescent
    double efficiency;                   ///< share of the reflected power; 0 when evanescent
};

/// k_out∥ = k_in∥ + m (λ/d) g; `k_in` points towards the surface, its length does not matter.
/// Efficiencies: scalar theory (sinusoid J_m²(φ/2), rectangle, blaze sinc²), with the power of
/// evanescent orders spread over the propagating ones in proportion, so that the sum over all
/// orders stays 1.
/// @throws InputError that names fields as `eval grating` does: `pitch_nm`, `profile.duty`, …
[[nodiscard]] std::vector<DiffractedOrder> grating_orders(const Grating& grating,
                                                          const Direction& k_in,
                                                          double wavelength_nm, int first_order,
                                                          int last_order);

/// Scalar efficiency of one order with nothing evanescent; sums to 1 over all m.
[[nodiscard]] double scalar_efficiency(const GratingProfile& profile, int order) noexcept;

}  // namespace nacre::optics
