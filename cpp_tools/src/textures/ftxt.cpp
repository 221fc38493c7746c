// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "nacre/core/limits.h"
#include "nacre/core/text_lines.h"
#include "nacre/textures/texture.h"

namespace nacre::spectral {
namespace {

constexpr std::size_t kChannels = 4;

/// Words between semicolons; an empty one where two follow each other.
std::vector<std::string_view> between_semicolons(std::string_view line)
{
    std::vector<std::string_view> words;
    for (std::size_t start = 0;;) {
        const std::size_t end = line.find(';', start);
        words.push_back(trimmed(line.substr(start, end - start)));
        if (end == std::string_view::npos) return words;
        start = end + 1;
    }
}

void read_comment(std::string_view line, std::map<std::string, std::string>& comments)
{
    const std::string_view text = trimmed(line.substr(1));
    const std::size_t colon = text.find(": ");
    if (colon != std::string_view::npos)
        comments[clean_text(text.substr(0, colon))] = clean_text(trimmed(text.substr(colon + 1)));
}

bool read_size(std::string_view line, int number, Texture& texture, FileProblems& problems)
{
    const auto words = between_semicolons(line);
    std::array<int, 2> size{};
    bool good = words.size() == size.size();
    for (std::size_t i = 0; good && i < size.size(); ++i) {
        const auto value = parse_number(words[i]);
        good = value && *value >= 1.0 && *value <= kMaxTextureSide && *value == std::floor(*value);
        if (good) size[i] = static_cast<int>(*value);
    }
    if (!good)
        problems.add(number, "size",
                     fmt::format("must be width;height, whole numbers in [1, {}] (got {})",
                                 kMaxTextureSide, excerpt(line)));
    texture.width = size[0];
    texture.height = size[1];
    return good;
}

void read_texel(std::string_view line, int number, std::vector<float>& texels,
                FileProblems& problems)
{
    const auto words = between_semicolons(line);
    if (words.size() != kChannels) {
        problems.add(number, "texel",
                     fmt::format("must be r;g;b;a (got {} numbers)", words.size()));
        return;
    }
    for (const std::string_view word : words) {
        const auto value = parse_number(word);
        const float stored = value ? static_cast<float>(*value) : 0.0F;
        if (!value || !std::isfinite(stored))
            problems.add(number, "texel",
                         fmt::format("must be finite numbers (got {})", excerpt(word)));
        texels.push_back(stored);
    }
}

}  // namespace

TextTexture read_ftxt(std::string_view text, std::string_view name)
{
    const std::string file(name);
    check_size(text, file);
    FileProblems problems(file);
    TextTexture content;
    Texture& texture = content.texture;
    texture.channels = kChannels;
    TextLines lines(text);
    bool sized = false;
    std::size_t rows = 0;
    while (const auto line = lines.next()) {
        const std::string_view words = trimmed(*line);
        if (words.empty()) continue;
        if (!sized && words.front() == '#') {
            read_comment(words, content.comments);
        } else if (!sized) {
            // Without the size nothing else can be judged.
            if (!read_size(words, lines.number(), texture, problems)) problems.throw_if_any();
            sized = true;
        } else {
            ++rows;
            read_texel(words, lines.number(), texture.texels, problems);
        }
    }
    const std::size_t wanted =
        static_cast<std::size_t>(texture.width) * static_cast<std::size_t>(texture.height);
    if (!sized)
        problems.add(lines.number(), "size", "must be width;height (got nothing)");
    else if (rows != wanted)
        problems.add(lines.number(), "texel",
                     fmt::format("must be as many as {} x {} = {} (got {})", texture.width,
                                 texture.height, wanted, rows));
    problems.throw_if_any();
    return content;
}

std::string write_ftxt(const TextTexture& content)
{
    const Texture& texture = content.texture;
    std::string text;
    for (const auto& [key, value] : content.comments) {
        if (key.find('\n') != std::string::npos || value.find('\n') != std::string::npos)
            throw InputError({{}, 0, "comments", "must be of one line each"});
        text += fmt::format("# {}: {}\n", key, value);
    }
    text += fmt::format("{};{}\n", texture.width, texture.height);
    const auto channels = static_cast<std::size_t>(texture.channels);
    for (std::size_t i = 0; i + channels <= texture.texels.size(); i += channels) {
        const float* from = texture.texels.data() + i;
        const bool grey = channels < 3;
        const std::array<float, kChannels> texel = {from[0], from[grey ? 0 : 1], from[grey ? 0 : 2],
                                                    channels < kChannels ? 1.0F : from[3]};
        for (const float value : texel)
            if (!std::isfinite(value))
                throw InputError(
                    {{}, 0, "texel", fmt::format("must be finite numbers (got {})", value)});
        fmt::format_to(std::back_inserter(text), "{};{};{};{}\n", texel[0], texel[1], texel[2],
                       texel[3]);
    }
    return text;
}

}  // namespace nacre::spectral
