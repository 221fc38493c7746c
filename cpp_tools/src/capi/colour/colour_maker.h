// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "nacre/capi/colour.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/gamut.h"

namespace nacre::capi {

/// Bradford where nothing is said.
spectral::Adaptation adaptation_or_bradford(const char* name);

/// What is the same for all spectra of a call.
class ColourMaker {
public:
    /// @throws InputError for a name that is not known, and where one is missing
    explicit ColourMaker(const nacre_colour_options& options);

    [[nodiscard]] nacre_colour operator()(const spectral::Sampled& values) const;

    /// Of a reflectance under the light, of an emission.
    [[nodiscard]] nacre_colour from_xyz(const spectral::Vec3& xyz) const;

    [[nodiscard]] const spectral::Illuminant& light() const { return light_; }
    [[nodiscard]] spectral::ObserverId observer() const { return observer_; }

private:
    void set_light(spectral::Illuminant light, spectral::Adaptation how);

    bool reflectance_;
    spectral::ObserverId observer_{};
    const spectral::ColourSpace* space_ = nullptr;
    spectral::GamutMapping gamut_{};
    spectral::Illuminant light_{};
    spectral::Vec3 white_{};
    spectral::Mat3 to_d65_{};
};

}  // namespace nacre::capi
