// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/held_media.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "nacre/kinds/media_reader.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"

namespace nacre::kinds {

std::vector<spectral::HeldEnds> held_media(const MaterialTemplate& source,
                                           const CompileOptions& options)
{
    MediaReader reader(source.file, options.range);
    std::vector<const spectral::Medium*> media;
    for (const material::MediumSpec* spec : source.kind->media()) {
        const auto* named = std::get_if<material::LibraryMedium>(&spec->value);
        if (!named || !reader.constants(*spec)) continue;
        const spectral::Medium* medium = &spectral::library_medium(named->key);
        if (std::ranges::find(media, medium) == media.end()) media.push_back(medium);
    }
    reader.throw_if_any();
    const spectral::Illuminant light = spectral::named_illuminant(options.illuminant);
    std::vector<spectral::HeldEnds> held;
    for (const spectral::Medium* medium : media)
        if (auto ends = held_ends(*medium, light, options.observer))
            held.push_back(std::move(*ends));
    return held;
}

}  // namespace nacre::kinds
