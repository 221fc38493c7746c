// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "illuminant_entries.h"

#include <algorithm>

#include <fmt/format.h>

#include "nacre/spectral/illuminant.h"

namespace nacre::spectral {

namespace {

constexpr std::string_view kKeyFolder = "cie/";

}  // namespace

bool is_illuminant_key(std::string_view key)
{
    if (!key.starts_with(kKeyFolder)) return false;
    key.remove_prefix(kKeyFolder.size());
    const auto names = illuminant_names();
    return std::ranges::find(names, key) != names.end();
}

std::vector<std::string> illuminant_keys()
{
    std::vector<std::string> keys = illuminant_names();
    for (std::string& key : keys) key.insert(0, kKeyFolder);
    return keys;
}

NamedSpectrum illuminant_entry(std::string_view key)
{
    const std::string_view name = key.substr(kKeyFolder.size());
    IlluminantCitation citation = illuminant_citation(name);
    return {.key = std::string(key),
            .name = fmt::format("CIE illuminant {}", name),
            .references = std::move(citation.references),
            .licence = std::move(citation.licence),
            .comments = {},
            .tags = {"illuminant"},
            .kind = SpectrumKind::emission,
            .samples = illuminant_samples(name).value()};
}

}  // namespace nacre::spectral
