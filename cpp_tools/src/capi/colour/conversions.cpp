// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/colour.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/guard.h"
#include "colour/colour_maker.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/gamut.h"
#include "nacre/spectral/rgb_basis.h"
#include "nacre/spectral/rgb_spectrum.h"
#include "nacre/spectral/spectrum.h"

namespace nacre::capi {
namespace {

std::vector<nacre_colour> colours_of(std::size_t spectra, std::size_t count,
                                     const double* wavelength_nm, const double* values,
                                     const ColourMaker& make)
{
    const std::vector<double> wavelengths(wavelength_nm, wavelength_nm + count);
    std::vector<nacre_colour> colours(spectra);
    const auto solve = [&](std::size_t i) {
        const double* first = values + i * count;
        const spectral::Spectrum spectrum(wavelengths, std::vector(first, first + count));
        colours[i] = make(spectrum.on_grid());
    };
    // A message about the only spectrum needs no number.
    if (spectra == 1)
        solve(0);
    else
        for_each_item(spectra, solve);
    return colours;
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_spectra_to_colours(size_t spectra, size_t count, const double* wavelength_nm,
                                      const double* values, const nacre_colour_options* options,
                                      nacre_colour* colours)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(wavelength_nm, "wavelength_nm");
        capi::require(values, "values");
        capi::require(options, "options");
        capi::require(colours, "colours");
        const auto all =
            capi::colours_of(spectra, count, wavelength_nm, values, capi::ColourMaker(*options));
        std::copy(all.begin(), all.end(), colours);
    });
}

nacre_status nacre_spectrum_to_colour(size_t count, const double* wavelength_nm,
                                      const double* values, int reflectance, const char* illuminant,
                                      const char* observer, const char* space, nacre_colour* colour)
{
    if (colour == nullptr)
        return nacre::capi::guarded([] { nacre::capi::require(nullptr, "colour"); });
    const nacre_colour_options options{.illuminant = illuminant,
                                       .observer = observer,
                                       .space = space,
                                       .adaptation = nullptr,
                                       .gamut = nullptr,
                                       .reflectance = reflectance};
    return nacre_spectra_to_colours(1, count, wavelength_nm, values, &options, colour);
}

nacre_status nacre_rgb_to_spectrum(size_t count, const double* rgb, const char* space,
                                   const char* method, int emission, double* values,
                                   double* coefficients, double* error_dE00)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(rgb, "rgb");
        capi::require(space, "space");
        capi::require(method, "method");
        capi::require(values, "values");
        const auto& from = spectral::colour_space(space);
        const auto how = spectral::upsampling_from_name(method);
        if (coefficients != nullptr && how == spectral::Upsampling::smits)
            capi::fail("coefficients", "must be null with the method smits");
        const auto kind =
            emission != 0 ? spectral::SpectrumKind::emission : spectral::SpectrumKind::reflectance;
        std::vector<spectral::RisenSpectrum> all(count);
        capi::for_each_item(count, [&](std::size_t i) {
            all[i] = rgb_to_spectrum({rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]}, from, how, kind);
        });
        for (const spectral::RisenSpectrum& risen : all) {
            values = std::copy(risen.values.begin(), risen.values.end(), values);
            if (coefficients != nullptr)
                coefficients =
                    std::copy(risen.coefficients->begin(), risen.coefficients->end(), coefficients);
            if (error_dE00 != nullptr) *error_dE00++ = risen.error;
        }
    });
}

nacre_status nacre_rgb_basis(double* values)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(values, "values");
        const auto& basis = spectral::rgb_basis();
        for (size_t i = 0; i < spectral::kWavelengths; ++i)
            for (const spectral::Sampled& reflectance : basis) *values++ = reflectance[i];
    });
}
}
