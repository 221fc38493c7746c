// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace nacre::spectral {

struct YamlNode {
    enum class Kind { null, text, list, map };

    Kind kind = Kind::null;
    int line = 0;  ///< 1-based; of a block (`|`) that of its indicator; 0 of an empty document
    std::string text;
    std::vector<const YamlNode*> items;
    std::vector<std::pair<const YamlNode*, const YamlNode*>> entries;

    [[nodiscard]] bool is_text() const noexcept { return kind == Kind::text; }
    [[nodiscard]] bool is_list() const noexcept { return kind == Kind::list; }
    /// The first value of a key; null where there is none, or this is no map.
    [[nodiscard]] const YamlNode* find(std::string_view key) const noexcept;
};

/// The first document of a YAML text. Aliases are shared, so a node may be part of itself.
class YamlTree {
public:
    static constexpr int kMostLevels = 64;

    /// Bytes that are no UTF-8 and control characters become `?`: what people write in comments is
    /// no reason to refuse their numbers.
    /// @throws InputError with file and line for what is no YAML, or deeper than kMostLevels
    YamlTree(std::string_view text, const std::string& file);

    [[nodiscard]] const YamlNode& root() const noexcept { return nodes_.front(); }

private:
    std::deque<YamlNode> nodes_;
};

}  // namespace nacre::spectral
