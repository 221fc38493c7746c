// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/media_library.h"

#include <fmt/format.h>

#include "entries.h"
#include "nacre/core/resources.h"
#include "nacre/media/optical_constants.h"
#include "nacre/readers/refractiveindex_yaml.h"

namespace nacre::spectral {

namespace {

Medium load_medium(std::string_view key, const EntrySource& source)
{
    if (key == "air" || key == "vacuum")
        return {.key = std::string(key),
                .name = key == "air" ? "Air" : "Vacuum",
                .references = "n = 1",
                .comments = key == "air" ? "Taken as vacuum; air has n = 1.0003." : "",
                .formula = {},
                .tags = {"gas"},
                .changes = {},
                .constants = constant_index(1.0)};
    if (!source.own)  // entry_source() found the resource
        return parse_refractiveindex_yaml(
            *find_resource(fmt::format("optical_constants/{}.yml", key)), key);
    Medium medium = parse_refractiveindex_yaml(source.text, source.name);
    if (medium.name == medium.key) medium.name = key;
    medium.key = key;
    return medium;
}

}  // namespace

const Medium& library_medium(std::string_view key)
{
    static LoadedEntries<Medium> loaded;
    return loaded.get(EntryKind::medium, key, load_medium);
}

std::vector<std::string> library_keys()
{
    return all_keys(EntryKind::medium);
}

}  // namespace nacre::spectral
