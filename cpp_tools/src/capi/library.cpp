// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <mutex>
#include <set>

#include "guard.h"
#include "nacre/spectral/optical_constants.h"
#include "nacre/spectral/spectrum_library.h"

namespace nacre::capi {
namespace {

/// Text whose address stays, each once.
const char* kept(const std::string& text)
{
    static std::mutex mutex;
    static std::set<std::string> all;
    const std::lock_guard lock(mutex);
    return all.insert(text).first->c_str();
}

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
