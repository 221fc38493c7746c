// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/develop.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bands/bands_handle.h"
#include "bands/light_from.h"
#include "base/guard.h"
#include "base/kept_text.h"
#include "nacre/bands/response.h"
#include "nacre/bands/viewer.h"
#include "nacre/spectral/named_spectrum.h"

namespace nacre::capi {
namespace {

bands::Bands bands_from(std::size_t count, const double* edges_nm, const double* wavelength_nm,
                        const unsigned char* is_line, const char* observer)
{
    require(wavelength_nm, "wavelength_nm");
    require(observer, "observer");
    const spectral::ObserverId seen_by = spectral::observer_from_name(observer);
    const std::span wavelengths(wavelength_nm, count);
    if (edges_nm == nullptr) return bands::bands_around(wavelengths, seen_by);
    std::vector<bool> lines(count);
    if (is_line != nullptr)
        for (std::size_t k = 0; k < count; ++k) lines[k] = is_line[k] != 0;
    return bands::bands_of(std::span(edges_nm, count + 1), wavelengths, lines, seen_by);
}

/// @throws InputError where a sensitivity is below 0 or not finite
spectral::Camera own_camera(const nacre_viewer& given)
{
    require(given.sensitivity, "sensitivity");
    spectral::Camera camera{.name = "camera", .sensitivity = {}};
    for (std::size_t c = 0; c < 3; ++c) {
        const spectral::Spectrum channel =
            samples_of(given.samples, given.wavelength_nm, given.sensitivity + c * given.samples,
                       "sensitivity");
        if (auto problem = spectral::kind_problem(channel, spectral::SpectrumKind::emission))
            fail("sensitivity", *problem);
        camera.sensitivity.push_back(channel);
    }
    return camera;
}

bands::Viewer viewer_from(const nacre_viewer& given, const bands::Bands& bands)
{
    bands::Viewer viewer{.observer = bands.observer,
                         .camera = {},
                         .raw = given.raw != 0,
                         .white = {},
                         .adaptation = spectral::Adaptation::bradford,
                         .exposure = given.exposure};
    if (!std::isfinite(given.exposure))
        fail("exposure", fmt::format("must be finite (got {:g})", given.exposure));
    if (given.observer != nullptr) viewer.observer = spectral::observer_from_name(given.observer);
    if (given.camera != nullptr) viewer.camera = spectral::camera(given.camera);
    if (given.samples > 0) viewer.camera = own_camera(given);
    if (viewer.raw && !viewer.camera) fail("raw", "is of a camera");
    if (given.white != nullptr)
        viewer.white = std::vector<double>(given.white, given.white + bands.size());
    if (given.adaptation != nullptr)
        viewer.adaptation = spectral::adaptation_from_name(given.adaptation);
    return viewer;
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_bands_of(size_t count, const double* edges_nm, const double* wavelength_nm,
                            const unsigned char* is_line, const char* observer, nacre_bands** bands)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        *bands =
            std::make_unique<nacre_bands>(
                nacre_bands{capi::bands_from(count, edges_nm, wavelength_nm, is_line, observer)})
                .release();
    });
}

nacre_status nacre_colours_of_bands(const nacre_bands* bands, const nacre_viewer* viewer,
                                    double* colours)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        capi::require(viewer, "viewer");
        capi::require(colours, "colours");
        for (const spectral::Vec3& colour :
             bands::colours_of_bands(bands->made, capi::viewer_from(*viewer, bands->made)))
            colours = std::copy(colour.begin(), colour.end(), colours);
    });
}

size_t nacre_camera_count(void)
{
    return nacre::spectral::camera_keys().size();
}

const char* nacre_camera_key(size_t index)
{
    const std::vector<std::string> keys = nacre::spectral::camera_keys();
    return index < keys.size() ? nacre::capi::kept(keys[index]) : nullptr;
}

nacre_status nacre_exchange_light(const nacre_bands* bands, const double* power, const char* name,
                                  const nacre_light* light, double* factors)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        capi::require(power, "power");
        capi::require(light, "light");
        capi::require(factors, "factors");
        const std::vector<double> found =
            bands::exchange(bands->made, std::span(power, bands->made.size()),
                            capi::text_or_empty(name), capi::light_from(*light));
        std::copy(found.begin(), found.end(), factors);
    });
}

nacre_status nacre_metamerism(const nacre_bands* bands, const double* first, const double* second,
                              const double* power, const char* name, const nacre_light* light,
                              double* difference, double* index)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        capi::require(first, "first");
        capi::require(second, "second");
        capi::require(power, "power");
        capi::require(light, "light");
        capi::require(difference, "difference");
        capi::require(index, "index");
        const std::size_t count = bands->made.size();
        const bands::Metamerism found = bands::metamerism(
            bands->made, std::span(first, count), std::span(second, count), std::span(power, count),
            capi::text_or_empty(name), capi::light_from(*light));
        *difference = found.difference;
        *index = found.index;
    });
}
}
