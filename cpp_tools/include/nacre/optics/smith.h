// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// Smith's shadowing and masking of GGX microfacets (Walter et al. 2007).

namespace nacre::optics {

/// Smith's Λ: the masked share of a direction is Λ/(1 + Λ).
[[nodiscard]] double smith_lambda(double cos_theta, double alpha) noexcept;

}  // namespace nacre::optics
