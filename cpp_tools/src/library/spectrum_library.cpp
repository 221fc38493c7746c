// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/spectrum_library.h"

#include <fmt/format.h>

#include "entries.h"
#include "illuminant_entries.h"
#include "nacre/core/resources.h"
#include "nacre/readers/spectrum_files.h"

namespace nacre::spectral {

namespace {

NamedSpectrum load_spectrum(std::string_view key, const EntrySource& source)
{
    if (is_illuminant_key(key)) return illuminant_entry(key);
    NamedSpectrum spectrum =
        source.own ? read_library_spectrum(source.text, source.name)
                   // entry_source() found the resource.
                   : read_library_spectrum(*find_resource(fmt::format("spectra/{}.csv", key)), key);
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
