// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/spectrum_library.h"

#include <fmt/format.h>

#include "illuminant_table.h"
#include "nacre/core/file_io.h"
#include "nacre/core/resources.h"
#include "shipped.h"

namespace nacre::spectral {

namespace {

NamedSpectrum load_spectrum(std::string_view key)
{
    if (is_illuminant_key(key)) return illuminant_entry(key);
    NamedSpectrum spectrum = [key] {
        if (const auto own = user_library_file(EntryKind::spectrum, key))
            return read_library_spectrum(read_text(*own), own->string());
        // entry_identity() found the resource.
        return read_library_spectrum(*find_resource(fmt::format("spectra/{}.csv", key)), key);
    }();
    spectrum.key = key;
    if (spectrum.name.empty()) spectrum.name = key;
    return spectrum;
}

}  // namespace

const NamedSpectrum& library_spectrum(std::string_view key)
{
    static LoadedEntries<NamedSpectrum> loaded;
    return loaded.get(EntryKind::spectrum, key, load_spectrum);
}

std::vector<std::string> library_spectrum_keys()
{
    return all_keys(EntryKind::spectrum);
}

}  // namespace nacre::spectral
