// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "guard.h"
#include "nacre/spectral/optical_constants.h"

namespace nacre::capi {
namespace {

const std::vector<std::string>& keys()
{
    static const std::vector<std::string> all = spectral::library_keys();
    return all;
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

size_t nacre_library_count(void)
{
    size_t count = 0;
    nacre::capi::guarded([&] { count = nacre::capi::keys().size(); });
    return count;
}

const char* nacre_library_key(size_t index)
{
    return index < nacre_library_count() ? nacre::capi::keys()[index].c_str() : nullptr;
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
