// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "near_keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <compare>
#include <numeric>
#include <utility>

#include "nacre/core/limits.h"

namespace nacre::spectral {

namespace {

/// Edit distance (Levenshtein) without regard to case.
std::size_t edit_distance(std::string_view a, std::string_view b)
{
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t substituted = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({substituted, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

struct RankedKey {
    std::size_t distance;
    std::string key;

    auto operator<=>(const RankedKey&) const = default;
};

std::vector<std::string> first_keys(const std::vector<RankedKey>& ranked, std::size_t most)
{
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < std::min(most, ranked.size()); ++i) keys.push_back(ranked[i].key);
    return keys;
}

/// Keys that a user may have meant: those of one or two slips or of that page, or else every page
/// of a book that was named, or else up to three that are a few letters away.
std::vector<std::string> near_matches(std::string_view key, const std::vector<std::string>& keys)
{
    constexpr std::size_t kSlips = 2, kMostFarther = 3, kMostPages = 24;
    const std::string_view book = key.substr(0, key.find('/'));
    std::vector<RankedKey> slips, ranked;
    for (const std::string& candidate : keys) {
        const std::string_view its_book =
            std::string_view(candidate).substr(0, candidate.find('/'));
        const std::size_t whole = edit_distance(key, candidate);
        const std::size_t distance = std::min(whole, edit_distance(book, its_book) * 2);
        // D65 for cie/D65, red for colorchecker/red.
        const std::string_view page = std::string_view(candidate).substr(candidate.rfind('/') + 1);
        if (whole <= kSlips)
            slips.push_back({whole, candidate});
        else if (edit_distance(key, page) == 0)
            slips.push_back({kSlips, candidate});
        if (distance <= 2 + key.size() / 4) ranked.push_back({distance, candidate});
    }
    std::ranges::sort(slips);
    std::ranges::sort(ranked);
    if (!slips.empty()) return first_keys(slips, kMostFarther);
    const auto same_book =
        static_cast<std::size_t>(std::ranges::count(ranked, std::size_t{0}, &RankedKey::distance));
    return first_keys(ranked, std::clamp(same_book, kMostFarther, kMostPages));
}

}  // namespace

std::string unknown_key_message(std::string_view key, const std::vector<std::string>& keys)
{
    // A distance costs as much as both lengths multiplied: what is longer than any key has no near
    // one.
    const std::string_view shown = key.substr(0, kMaxKeyBytes);
    const auto matches = near_matches(shown, keys);
    return matches.empty() ? fmt::format("must be a key of the library (got '{}')", shown)
                           : fmt::format("must be a key of the library, perhaps {} (got '{}')",
                                         fmt::join(matches, " or "), shown);
}

}  // namespace nacre::spectral
