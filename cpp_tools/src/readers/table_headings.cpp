// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "table_headings.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "nacre/core/text_lines.h"

namespace nacre::spectral {

namespace {

/// Letters outside ASCII that headings have, also as one byte of Latin-1.
constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kHeadingLetters = {{
    {"\xC2\xB5", "u"},             // micro sign
    {"\xCE\xBC", "u"},             // mu
    {"\xB5", "u"},                 // micro sign, Latin-1
    {"\xCE\xBB", "lambda"},        // lambda
    {"\xCE\x9B", "lambda"},        // Lambda
    {"\xC3\xA4", "ae"},            // a with diaeresis
    {"\xC3\x84", "ae"},            // A with diaeresis
    {"\xE4", "ae"},                // a with diaeresis, Latin-1
    {"\xC3\x85", "angstrom"},      // A with ring
    {"\xE2\x84\xAB", "angstrom"},  // angstrom sign
    {"\xC5", "angstrom"},          // A with ring, Latin-1
}};

/// Words of a name in lower case ASCII.
std::vector<std::string> words_of(std::string_view name)
{
    std::vector<std::string> words(1);
    while (!name.empty()) {
        const auto letter = std::ranges::find_if(
            kHeadingLetters, [name](const auto& known) { return name.starts_with(known.first); });
        const char c = name.front();
        if (letter != kHeadingLetters.end()) {
            words.back() += letter->second;
            name.remove_prefix(letter->first.size());
            continue;
        }
        name.remove_prefix(1);
        if (c >= 'A' && c <= 'Z')
            words.back() += static_cast<char>(c + 32);
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
            words.back() += c;
        else if (std::string_view(" \t\r_()[]{}/,.:-").find(c) != std::string_view::npos)
            words.emplace_back();
        else
            words.back() += '?';
    }
    std::erase(words, std::string());
    return words;
}

std::optional<double> unit_of(std::string_view word)
{
    for (const std::string_view nm : {"nm", "nanometer", "nanometers", "nanometre", "nanometres"})
        if (word == nm) return 1.0;
    for (const std::string_view um :
         {"um", "micron", "microns", "micrometer", "micrometers", "micrometre", "micrometres"})
        if (word == um) return 1000.0;
    for (const std::string_view angstrom : {"angstrom", "angstroms"})
        if (word == angstrom) return 0.1;
    return std::nullopt;
}

bool is_wavelength(std::string_view word)
{
    constexpr std::array<std::string_view, 7> kWords = {
        "wavelength", "wavelengths", "wave", "length", "lambda", "wl", "wellenlaenge"};
    return std::ranges::find(kWords, word) != kWords.end();
}

}  // namespace

std::optional<WavelengthHeading> wavelength_heading(std::string_view name)
{
    const auto words = words_of(name);
    WavelengthHeading heading;
    for (const std::string& word : words) {
        if (const auto unit = unit_of(word)) {
            if (heading.unit_stated) return std::nullopt;
            heading.nm_per_unit = *unit;
            heading.unit_stated = true;
        } else if (!is_wavelength(word) && word != "in") {
            return std::nullopt;
        }
    }
    if (words.empty() || words.front() == "in" || words == std::vector<std::string>{"length"})
        return std::nullopt;
    heading.is_wl = words == std::vector<std::string>{"wl"};
    return heading;
}

ValueHeading value_heading(std::string_view name)
{
    ValueHeading heading{.name = clean_text(name)};
    for (const std::string_view mark : {"(%)", "[%]", "%"}) {
        const std::size_t at = heading.name.find(mark);
        if (at == std::string::npos) continue;
        heading.name.erase(at, mark.size());
        heading.per_cent = true;
        break;
    }
    for (const std::string_view word : {"(percent)", "percent", "per cent", "pct"}) {
        const std::size_t at = heading.name.size() - std::min(word.size(), heading.name.size());
        if (heading.per_cent || !same_letters(std::string_view(heading.name).substr(at), word))
            continue;
        heading.name.erase(at);
        heading.per_cent = true;
    }
    if (heading.per_cent) {
        constexpr std::string_view kLoose = " \t_-/,:";
        heading.name.erase(heading.name.find_last_not_of(kLoose) + 1);
        heading.name.erase(0,
                           std::min(heading.name.find_first_not_of(kLoose), heading.name.size()));
    }
    return heading;
}

}  // namespace nacre::spectral
