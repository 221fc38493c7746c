// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

/// @file
/// Textures as plain numbers, and FTXT, their text form.

namespace nacre::spectral {

/// Row-major, top row first, channels interleaved.
struct Texture {
    int width = 0, height = 0, channels = 0;
    std::vector<float> texels;  ///< height × width × channels

    [[nodiscard]] const float* at(std::size_t x, std::size_t y) const noexcept
    {
        return texels.data() +
               (y * static_cast<std::size_t>(width) + x) * static_cast<std::size_t>(channels);
    }
    [[nodiscard]] float* at(std::size_t x, std::size_t y) noexcept
    {
        return texels.data() +
               (y * static_cast<std::size_t>(width) + x) * static_cast<std::size_t>(channels);
    }
};

/// Largest side of a texture in a text file.
inline constexpr int kMaxTextureSide = 65536;

/// FTXT: a line `width;height`, then a texel a line, `r;g;b;a`, top row first. Lines before the
/// first that start with `#` are comments; `# KEY: value` says what the texture holds.
struct TextTexture {
    Texture texture;                              ///< four channels
    std::map<std::string, std::string> comments;  ///< by KEY
};

/// All or nothing: too few texels, or too many, are an error.
/// @throws InputError with all that is wrong, each with its line; a text above kMaxTextBytes
[[nodiscard]] TextTexture read_ftxt(std::string_view text, std::string_view file);

/// Numbers in the shortest form that reads back as the same float. One channel becomes r = g = b,
/// and a is 1 where there is no fourth.
/// @throws InputError for a number that is not finite, or comments of more than one line
[[nodiscard]] std::string write_ftxt(const TextTexture& content);

}  // namespace nacre::spectral
