// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/colour.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "guard.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/gamut.h"
#include "nacre/spectral/rgb_spectrum.h"
#include "nacre/spectral/spectrum.h"

namespace nacre::capi {
namespace {

using spectral::Vec3;

Vec3 multiply(const spectral::Mat3& matrix, const Vec3& vector)
{
    Vec3 product{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            product[row] += matrix[row][column] * vector[column];
    return product;
}

/// What is the same for all spectra of a call.
class ColourMaker {
public:
    explicit ColourMaker(const nacre_colour_options& options)
        : reflectance_(options.reflectance != 0)
    {
        require(options.observer, "observer");
        require(options.space, "space");
        if (reflectance_) require(options.illuminant, "illuminant");
        observer_ = spectral::observer_from_name(options.observer);
        space_ = &spectral::colour_space(options.space);
        gamut_ = options.gamut ? spectral::gamut_mapping_from_name(options.gamut)
                               : spectral::GamutMapping::keep;
        if (gamut_ != spectral::GamutMapping::keep && !space_->chromaticities)
            fail("gamut", "must be keep in a space that is not RGB");
        const auto how = options.adaptation ? spectral::adaptation_from_name(options.adaptation)
                                            : spectral::Adaptation::bradford;
        if (reflectance_) set_light(spectral::named_illuminant(options.illuminant), how);
    }

    [[nodiscard]] nacre_colour operator()(const spectral::Sampled& values) const
    {
        const Vec3 xyz = reflectance_ ? reflectance_to_xyz(values, light_, observer_)
                                      : spectral::emission_to_xyz(values, observer_);
        const Vec3 lab = spectral::xyz_to_lab(xyz, white_);
        const Vec3 rgb = map_to_gamut(
            multiply(space_->from_xyz_d65, reflectance_ ? multiply(to_d65_, xyz) : xyz), gamut_,
            space_->to_xyz_d65[1]);
        nacre_colour colour{};
        std::copy(xyz.begin(), xyz.end(), colour.XYZ);
        std::copy(lab.begin(), lab.end(), colour.Lab);
        std::copy(rgb.begin(), rgb.end(), colour.rgb);
        return colour;
    }

private:
    void set_light(spectral::Illuminant light, spectral::Adaptation how)
    {
        light_ = std::move(light);
        spectral::Sampled perfect;
        perfect.fill(1.0);
        white_ = reflectance_to_xyz(perfect, light_, observer_);
        to_d65_ = spectral::adaptation(how, white_, spectral::d65_white());
    }

    bool reflectance_;
    spectral::ObserverId observer_{};
    const spectral::ColourSpace* space_ = nullptr;
    spectral::GamutMapping gamut_{};
    spectral::Illuminant light_{};
    Vec3 white_ = spectral::d65_white();
    spectral::Mat3 to_d65_{};
};

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
}
