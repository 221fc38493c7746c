// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/templates.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "bands/bands_handle.h"
#include "base/guard.h"
#include "colour/colour_maker.h"
#include "nacre/kinds/film_bands.h"
#include "nacre/kinds/film_preview.h"
#include "nacre/kinds/read_template.h"
#include "tables/result.h"
#include "templates/compile_options.h"

namespace nacre::capi {

kinds::CompileOptions compile_options(const char* text, const char* file, const ColourNames& colour)
{
    for (const auto& [pointer, field] : {std::pair{text, "text"},
                                         {file, "file"},
                                         {colour.illuminant, "illuminant"},
                                         {colour.observer, "observer"},
                                         {colour.space, "space"}})
        require(pointer, field);
    kinds::CompileOptions options;
    options.illuminant = colour.illuminant;
    options.observer = spectral::observer_from_name(colour.observer);
    options.space = colour.space;
    options.adaptation = adaptation_or_bradford(colour.adaptation);
    return options;
}

namespace {

std::vector<kinds::TableLayout> layout_from(size_t count, const nacre_table_size* sizes)
{
    if (count > 0) require(sizes, "sizes");
    std::vector<kinds::TableLayout> layout;
    for (const nacre_table_size& size : std::span(sizes, count)) {
        require(size.name, "sizes.name");
        const auto role = table_role(size.name);
        if (!role)
            fail("sizes.name", fmt::format("must be the name of a table (got \"{}\")", size.name));
        layout.push_back({*role, {size.width, size.height}});
    }
    return layout;
}

/// Where colours do not matter.
kinds::CompileOptions plain_options(const char* text, const char* file)
{
    require(text, "text");
    require(file, "file");
    return {};
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_preview_template(const char* text, const char* file, const char* illuminant,
                                    const char* observer, const char* space, const char* adaptation,
                                    size_t count, const nacre_table_size* sizes,
                                    nacre_result** result)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(result, "result");
        const auto options =
            capi::compile_options(text, file, {illuminant, observer, space, adaptation});
        const std::vector<kinds::TableLayout> layout = capi::layout_from(count, sizes);
        auto made = std::make_unique<nacre_result>();
        made->tables = kinds::preview_tables(kinds::parse_template(text, file), options, layout);
        *result = made.release();
    });
}

nacre_status nacre_band_tables(const char* text, const char* file, const nacre_bands* bands,
                               size_t passes, const size_t* band, size_t count,
                               const nacre_table_size* sizes, nacre_result** result)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(bands, "bands");
        capi::require(result, "result");
        if (passes > 0) capi::require(band, "band");
        const kinds::CompileOptions options = capi::plain_options(text, file);
        const std::vector<kinds::TableLayout> layout = capi::layout_from(count, sizes);
        const kinds::MaterialTemplate source = kinds::parse_template(text, file);
        const double thickness_nm = kinds::optical_thickness_nm(source, options);
        std::vector<kinds::BandPass> weights(passes);
        for (size_t i = 0; i < 3 * passes; ++i) {
            if (band[i] >= bands->made.size())
                capi::fail("band",
                           fmt::format("must be below {} (got {})", bands->made.size(), band[i]));
            weights[i / 3][i % 3] = bands::film_weights(bands->made, band[i], thickness_nm);
        }
        auto made = std::make_unique<nacre_result>();
        made->tables = kinds::band_tables(source, options, weights, layout);
        *result = made.release();
    });
}

nacre_status nacre_template_optical_thickness(const char* text, const char* file,
                                              double* thickness_nm)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(thickness_nm, "thickness_nm");
        const kinds::CompileOptions options = capi::plain_options(text, file);
        *thickness_nm = kinds::optical_thickness_nm(kinds::parse_template(text, file), options);
    });
}

nacre_status nacre_template_fringes(const char* text, const char* file, size_t count,
                                    double angle_deg, double* reflectance)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(reflectance, "reflectance");
        constexpr size_t kMost = 100'000;
        if (count < 2 || count > kMost)
            capi::fail("count", fmt::format("must be 2 to {} (got {})", kMost, count));
        if (!(angle_deg >= 0.0 && angle_deg < 90.0))
            capi::fail("angle_deg",
                       fmt::format("must be from 0 to below 90 (got {:g})", angle_deg));
        const kinds::CompileOptions options = capi::plain_options(text, file);
        const std::vector<spectral::Sampled> films =
            kinds::film_fringes(kinds::parse_template(text, file), options, static_cast<int>(count),
                                std::cos(angle_deg * std::numbers::pi / 180.0));
        for (const spectral::Sampled& film : films)
            reflectance = std::ranges::copy(film, reflectance).out;
    });
}

nacre_status nacre_template_spectrum(const char* text, const char* file, const char* illuminant,
                                     const char* observer, const char* space,
                                     const char* adaptation, double value, double angle_deg,
                                     double* reflectance, double* transmittance, double* colours)
{
    using namespace nacre;
    return capi::guarded([&] {
        for (const auto& [pointer, field] : {std::pair{reflectance, "reflectance"},
                                             {transmittance, "transmittance"},
                                             {colours, "colours"}})
            capi::require(pointer, field);
        if (!(angle_deg >= 0.0 && angle_deg < 90.0))
            capi::fail("angle_deg", fmt::format("must be in [0, 90) (got {})", angle_deg));
        if (!(std::isfinite(value) && value >= 0.0))
            capi::fail("value", fmt::format("must be ≥ 0 and finite (got {})", value));
        const auto options =
            capi::compile_options(text, file, {illuminant, observer, space, adaptation});
        const kinds::FilmSpectrum spectrum =
            kinds::film_spectrum(kinds::parse_template(text, file), options,
                                 std::cos(angle_deg * std::numbers::pi / 180.0), value);
        std::ranges::copy(spectrum.reflectance, reflectance);
        std::ranges::copy(spectrum.transmittance, transmittance);
        std::ranges::copy(spectrum.colour.reflectance, colours);
        std::ranges::copy(spectrum.colour.transmittance, colours + 3);
    });
}
}
