// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/spectra.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/ranges.h>

#include "base/guard.h"
#include "library/spectrum_kind.h"
#include "nacre/library/lights.h"
#include "nacre/library/user_library.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/named_spectrum.h"
#include "nacre/spectral/observer.h"

struct nacre_spectra {
    std::vector<nacre::spectral::NamedSpectrum> all;
    std::vector<std::string> tags;  ///< of each, one a line
};

namespace nacre::capi {
namespace {

using spectral::NamedSpectrum;

std::string_view text_of(const char* text, std::size_t bytes)
{
    require(text, "text");
    return {text, bytes};
}

spectral::ReadAs read_as(const char* kind, double scale)
{
    if (!(scale >= 0.0) || std::isinf(scale))
        fail("scale",
             fmt::format("must be finite and > 0, or 0 for that of the file (got {:g})", scale));
    spectral::ReadAs said;
    if (!text_or_empty(kind).empty()) said.kind = kind_from(kind);
    if (scale > 0.0) said.scale = scale;
    return said;
}

std::vector<std::string> lines_of(const char* text)
{
    std::vector<std::string> lines;
    std::string_view rest = text == nullptr ? std::string_view() : std::string_view(text);
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        if (end > 0) lines.emplace_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return lines;
}

NamedSpectrum spectrum_from(const nacre_spectrum& given, const char* tags)
{
    require(given.wavelength_nm, "wavelength_nm");
    require(given.values, "values");
    NamedSpectrum spectrum{
        .key = text_or_empty(given.key),
        .name = text_or_empty(given.name),
        .references = text_or_empty(given.references),
        .licence = text_or_empty(given.licence),
        .comments = text_or_empty(given.comments),
        .tags = lines_of(tags),
        .kind = kind_from(given.kind),
        .samples = {std::vector(given.wavelength_nm, given.wavelength_nm + given.count),
                    std::vector(given.values, given.values + given.count)}};
    if (auto problem = spectral::kind_problem(spectrum.samples, *spectrum.kind))
        fail("values", *problem);
    return spectrum;
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_illuminant(const char* name, double* power)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(name, "name");
        capi::require(power, "power");
        const spectral::Illuminant light = spectral::named_illuminant(name);
        std::copy(light.power.begin(), light.power.end(), power);
    });
}

nacre_status nacre_colour_matching(const char* observer, double* xyz)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(observer, "observer");
        capi::require(xyz, "xyz");
        const auto& functions = spectral::observer(spectral::observer_from_name(observer));
        for (size_t i = 0; i < spectral::kWavelengths; ++i)
            for (const auto* function : {&functions.x, &functions.y, &functions.z})
                *xyz++ = (*function)[i];
    });
}

nacre_status nacre_colour_temperature(size_t count, const double* XYZ, double* cct_K, double* duv)
{
    using namespace nacre;
    return capi::guarded([&] {
        if (count == 0) return;
        capi::require(XYZ, "XYZ");
        capi::require(cct_K, "cct_K");
        capi::require(duv, "duv");
        constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
        for (size_t i = 0; i < count; ++i) {
            const spectral::Vec3 xyz{XYZ[3 * i], XYZ[3 * i + 1], XYZ[3 * i + 2]};
            const bool lit = xyz[0] + xyz[1] + xyz[2] > 0.0;
            const auto found = lit ? spectral::colour_temperature(xyz) : std::nullopt;
            cct_K[i] = found ? found->cct_kelvin : kNone;
            duv[i] = found ? found->duv : kNone;
        }
    });
}

nacre_status nacre_read_spectra(const char* text, size_t bytes, const char* file, const char* kind,
                                double scale, nacre_spectra** spectra)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(file, "file");
        capi::require(spectra, "spectra");
        const spectral::ReadAs said = capi::read_as(kind, scale);
        auto read = std::make_unique<nacre_spectra>();
        read->all = spectral::read_spectra(capi::text_of(text, bytes), file, said);
        for (const auto& spectrum : read->all)
            read->tags.push_back(fmt::format("{}", fmt::join(spectrum.tags, "\n")));
        *spectra = read.release();
    });
}

size_t nacre_spectra_count(const nacre_spectra* spectra)
{
    return spectra == nullptr ? 0 : spectra->all.size();
}

nacre_status nacre_spectra_at(const nacre_spectra* spectra, size_t index, nacre_spectrum* spectrum,
                              const char** tags)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(spectra, "spectra");
        capi::require(spectrum, "spectrum");
        if (index >= spectra->all.size())
            capi::fail("index", fmt::format("must be < {} (got {})", spectra->all.size(), index));
        const spectral::NamedSpectrum& found = spectra->all[index];
        *spectrum = {.key = found.key.c_str(),
                     .name = found.name.c_str(),
                     .kind = found.kind ? spectral::spectrum_kind_name(*found.kind).data() : "",
                     .references = found.references.c_str(),
                     .licence = found.licence.c_str(),
                     .comments = found.comments.c_str(),
                     .count = found.samples.values().size(),
                     .wavelength_nm = found.samples.wavelengths_nm().data(),
                     .values = found.samples.values().data()};
        if (tags != nullptr) *tags = spectra->tags[index].c_str();
    });
}

void nacre_spectra_free(nacre_spectra* spectra)
{
    delete spectra;  // NOLINT(cppcoreguidelines-owning-memory): the caller's handle
}

nacre_status nacre_library_add_spectra(size_t count, const nacre_spectrum* spectra,
                                       const char* const* tags, int replace)
{
    using namespace nacre;
    return capi::guarded([&] {
        if (count == 0) return;
        capi::require(spectra, "spectra");
        std::vector<spectral::UserEntry> entries;
        capi::for_each_item(count, [&](size_t i) {
            const auto spectrum =
                capi::spectrum_from(spectra[i], tags == nullptr ? nullptr : tags[i]);
            entries.push_back({spectral::EntryKind::spectrum, spectrum.key,
                               spectral::write_library_spectrum(spectrum)});
        });
        (void)spectral::save_user_entries(entries, replace != 0);
    });
}

nacre_status nacre_library_add_medium(const char* key, const char* text, size_t bytes,
                                      const char* file, const char* references, int replace)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(key, "key");
        capi::require(file, "file");
        const std::string citation = capi::text_or_empty(references);
        std::vector<std::string> changes;  // the entry has them: nacre_library_words_of()
        (void)spectral::save_user_entries(
            {{spectral::EntryKind::medium, key,
              spectral::refractiveindex_yaml_of_file(capi::text_of(text, bytes), file, citation,
                                                     changes)}},
            replace != 0);
    });
}
}
