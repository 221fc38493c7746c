// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <fmt/ranges.h>

#include "base/guard.h"
#include "base/kept_text.h"
#include "nacre/capi/library.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/library_search.h"
#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/media/optical_constants.h"

namespace nacre::capi {
namespace {

/// The keys of one kind, as the calling thread saw them last.
class KeyList {
public:
    explicit KeyList(std::vector<std::string> (*keys)()) : keys_(keys) {}

    size_t count() noexcept
    {
        size_t result = 0;
        guarded([&] {
            std::vector<const char*> found;
            for (const std::string& key : keys_()) found.push_back(kept(key));
            listed_ = std::move(found);
            result = listed_.size();
        });
        return result;
    }

    const char* at(size_t index) noexcept
    {
        if (listed_.empty()) (void)count();
        return index < listed_.size() ? listed_[index] : nullptr;
    }

private:
    std::vector<std::string> (*keys_)();
    std::vector<const char*> listed_;
};

std::vector<const char*>& found_keys()
{
    thread_local std::vector<const char*> keys;
    return keys;
}

/// @throws InputError for a number that is no kind
bool is_media(int kind)
{
    if (kind != NACRE_MEDIA && kind != NACRE_SPECTRA)
        throw InputError(
            {.file = {},
             .field = "kind",
             .message = "must be 0 for media or 1 for spectra (got " + std::to_string(kind) + ")"});
    return kind == NACRE_MEDIA;
}

KeyList& media()
{
    thread_local KeyList list(spectral::library_keys);
    return list;
}

KeyList& spectra()
{
    thread_local KeyList list(spectral::library_spectrum_keys);
    return list;
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

size_t nacre_library_count(void)
{
    return nacre::capi::media().count();
}

const char* nacre_library_key(size_t index)
{
    return nacre::capi::media().at(index);
}

size_t nacre_library_spectrum_count(void)
{
    return nacre::capi::spectra().count();
}

const char* nacre_library_spectrum_key(size_t index)
{
    return nacre::capi::spectra().at(index);
}

nacre_status nacre_library_spectrum(const char* key, nacre_spectrum* spectrum)
{
    return nacre::capi::guarded([&] {
        nacre::capi::require(key, "key");
        nacre::capi::require(spectrum, "spectrum");
        const nacre::spectral::NamedSpectrum& found = nacre::spectral::library_spectrum(key);
        *spectrum = {.key = found.key.c_str(),
                     .name = found.name.c_str(),
                     .kind = nacre::spectral::spectrum_kind_name(*found.kind).data(),
                     .references = found.references.c_str(),
                     .licence = found.licence.c_str(),
                     .comments = found.comments.c_str(),
                     .count = found.samples.values().size(),
                     .wavelength_nm = found.samples.wavelengths_nm().data(),
                     .values = found.samples.values().data()};
    });
}

nacre_status nacre_library_medium(const char* key, nacre_medium* medium)
{
    return nacre::capi::guarded([&] {
        nacre::capi::require(key, "key");
        nacre::capi::require(medium, "medium");
        const nacre::spectral::Medium& found = nacre::spectral::library_medium(key);
        const auto [first, last] = found.constants->range_nm();
        *medium = {.key = found.key.c_str(),
                   .name = found.name.c_str(),
                   .references = found.references.c_str(),
                   .comments = found.comments.c_str(),
                   .first_nm = first,
                   .last_nm = last};
    });
}

nacre_status nacre_library_search(int kind, const char* text, const char* tag, size_t* count)
{
    return nacre::capi::guarded([&] {
        nacre::capi::require(count, "count");
        const nacre::spectral::LibrarySearch search = {nacre::capi::text_or_empty(text),
                                                       nacre::capi::text_or_empty(tag)};
        const auto keys = nacre::capi::is_media(kind) ? nacre::spectral::find_media(search)
                                                      : nacre::spectral::find_spectra(search);
        std::vector<const char*> found;
        found.reserve(keys.size());
        for (const std::string& key : keys) found.push_back(nacre::capi::kept(key));
        nacre::capi::found_keys() = std::move(found);
        *count = nacre::capi::found_keys().size();
    });
}

const char* nacre_library_found(size_t index)
{
    const auto& keys = nacre::capi::found_keys();
    return index < keys.size() ? keys[index] : nullptr;
}

nacre_status nacre_library_words_of(int kind, const char* key, nacre_library_words* words)
{
    return nacre::capi::guarded([&] {
        nacre::capi::require(key, "key");
        nacre::capi::require(words, "words");
        const bool medium = nacre::capi::is_media(kind);
        const auto& tags = medium ? nacre::spectral::library_medium(key).tags
                                  : nacre::spectral::library_spectrum(key).tags;
        const std::string formula =
            medium ? nacre::spectral::library_medium(key).formula : std::string();
        const std::vector<std::string> changes =
            medium ? nacre::spectral::library_medium(key).changes : std::vector<std::string>();
        *words = {.formula = nacre::capi::kept(formula),
                  .tags = nacre::capi::kept(fmt::format("{}", fmt::join(tags, "\n"))),
                  .changes = nacre::capi::kept(fmt::format("{}", fmt::join(changes, "\n")))};
    });
}

nacre_status nacre_library_index(const char* key, size_t count, const double* wavelength_nm,
                                 double* n)
{
    return nacre::capi::guarded([&] {
        nacre::capi::require(key, "key");
        if (count > 0) {
            nacre::capi::require(wavelength_nm, "wavelength_nm");
            nacre::capi::require(n, "n");
        }
        const nacre::spectral::Medium& found = nacre::spectral::library_medium(key);
        std::vector<std::complex<double>> values;
        for (size_t i = 0; i < count; ++i) values.push_back(found.constants->at(wavelength_nm[i]));
        for (size_t i = 0; i < count; ++i) {
            n[2 * i] = values[i].real();
            n[2 * i + 1] = values[i].imag();
        }
    });
}
}
