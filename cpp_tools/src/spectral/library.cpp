// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <utility>

#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/spectral/optical_constants.h"

namespace nacre::spectral {

namespace {

constexpr std::string_view kFolder = "optical_constants/";
constexpr std::string_view kExtension = ".yml";

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

/// Keys that a user may have meant: every page of a book that was named, or else up to three that
/// are a few letters away.
std::vector<std::string> near_matches(std::string_view key)
{
    constexpr std::size_t kMostFarther = 3;
    const std::string_view book = key.substr(0, key.find('/'));
    std::vector<std::pair<std::size_t, std::string>> ranked;
    for (std::string& candidate : library_keys()) {
        const std::string_view its_book =
            std::string_view(candidate).substr(0, candidate.find('/'));
        const std::size_t distance =
            std::min(edit_distance(key, candidate), edit_distance(book, its_book) * 2);
        if (distance <= 2 + key.size() / 4) ranked.emplace_back(distance, std::move(candidate));
    }
    std::ranges::sort(ranked);
    const auto same_book = static_cast<std::size_t>(
        std::ranges::count_if(ranked, [](const auto& match) { return match.first == 0; }));
    const std::size_t most = std::min(std::max(kMostFarther, same_book), ranked.size());
    std::vector<std::string> matches;
    for (std::size_t i = 0; i < most; ++i) matches.push_back(std::move(ranked[i].second));
    return matches;
}

Medium load_medium(std::string_view key)
{
    if (key == "air" || key == "vacuum")
        return {.key = std::string(key),
                .name = key == "air" ? "Air" : "Vacuum",
                .references = "n = 1",
                .comments = key == "air" ? "Taken as vacuum; air has n = 1.0003." : "",
                .formula = {},
                .tags = {"gas"},
                .constants = constant_index(1.0)};
    const auto text = find_resource(fmt::format("{}{}{}", kFolder, key, kExtension));
    if (!text) {
        const auto matches = near_matches(key);
        throw InputError(
            {.file = {},
             .field = "medium",
             .message = matches.empty()
                            ? fmt::format("must be a key of the library (got '{}')", key)
                            : fmt::format("must be a key of the library, perhaps {} (got '{}')",
                                          fmt::join(matches, " or "), key)});
    }
    return parse_refractiveindex_yaml(*text, key);
}

}  // namespace

const Medium& library_medium(std::string_view key)
{
    static std::mutex mutex;
    static std::map<std::string, Medium, std::less<>> loaded;  // nodes stay where they are
    const std::lock_guard lock(mutex);
    auto found = loaded.find(key);
    if (found == loaded.end()) found = loaded.emplace(key, load_medium(key)).first;
    return found->second;
}

std::vector<std::string> library_keys()
{
    std::vector<std::string> keys = {"air", "vacuum"};
    for (std::string_view path : list_resources(kFolder)) {
        path.remove_prefix(kFolder.size());
        path.remove_suffix(kExtension.size());
        keys.emplace_back(path);
    }
    std::ranges::sort(keys);
    return keys;
}

}  // namespace nacre::spectral
