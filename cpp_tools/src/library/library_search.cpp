// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/library_search.h"

#include <algorithm>
#include <cctype>
#include <initializer_list>

#include "nacre/core/diagnostics.h"
#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"

namespace nacre::spectral {

namespace {

bool contains(const std::string& text, const std::string& part)
{
    const auto same = [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) ==
               std::tolower(static_cast<unsigned char>(b));
    };
    return part.empty() ||
           std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

bool any_contains(std::initializer_list<const std::string*> texts,
                  const std::vector<std::string>& tags, const std::string& part)
{
    return std::ranges::any_of(texts, [&](const auto* text) { return contains(*text, part); }) ||
           std::ranges::any_of(tags, [&](const auto& tag) { return contains(tag, part); });
}

bool is_tagged(const std::vector<std::string>& tags, const std::string& tag)
{
    return tag.empty() || std::ranges::find(tags, tag) != tags.end();
}

template <class Entry>
std::vector<std::string> find(std::vector<std::string> keys, const Entry& entry,
                              const LibrarySearch& search)
{
    std::erase_if(keys, [&](const std::string& key) {
        try {
            return !matches(entry(key), search);
        } catch (const InputError&) {
            return !search.tag.empty() || !contains(key, search.text);
        }
    });
    return keys;
}

}  // namespace

bool matches(const Medium& medium, const LibrarySearch& search)
{
    return is_tagged(medium.tags, search.tag) &&
           any_contains({&medium.key, &medium.name, &medium.formula, &medium.references},
                        medium.tags, search.text);
}

bool matches(const NamedSpectrum& spectrum, const LibrarySearch& search)
{
    return is_tagged(spectrum.tags, search.tag) &&
           any_contains({&spectrum.key, &spectrum.name, &spectrum.references}, spectrum.tags,
                        search.text);
}

std::vector<std::string> find_media(const LibrarySearch& search)
{
    return find(library_keys(), library_medium, search);
}

std::vector<std::string> find_spectra(const LibrarySearch& search)
{
    return find(library_spectrum_keys(), library_spectrum, search);
}

}  // namespace nacre::spectral
