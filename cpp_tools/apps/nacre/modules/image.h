// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

/// @file
/// Images in memory, and how files hold them.

namespace nacre::tool {

/// Row-major, top row first, channels interleaved.
struct Image {
    int width = 0, height = 0;
    std::vector<std::string> channels;
    std::vector<float> pixels;

    [[nodiscard]] std::size_t channel_count() const noexcept { return channels.size(); }
};

using AttributeValue = std::variant<int, std::string, std::vector<float>>;
using Attributes = std::map<std::string, AttributeValue>;

enum class Depth { floating, half, byte };

enum class Container { exr, tx, png, ftxt };

/// Of scan lines and tiles.
enum class Compression {
    zip,
    pxr24,  ///< of floats 15 bits of mantissa are kept; a quarter of the size where there are fewer
};

struct Encoding {
    Container container;
    Depth depth;
    Compression compression = Compression::zip;
};

struct LoadedImage {
    Image image;
    std::string format;            ///< `openexr`, `png` …
    std::string depth;             ///< `float`, `half`, `uint8` …
    bool display_encoded = false;  ///< sRGB curve, as 8-bit files have it
    Attributes attributes;
};

/// What A is in a file whose RGB is not multiplied by it yet.
enum class AlphaMeaning {
    coverage,  ///< RGB is multiplied by it
    number,    ///< all channels as they are stored
};

}  // namespace nacre::tool
