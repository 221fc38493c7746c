// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

/// @file
/// Images in and out, by OpenImageIO, which is loaded with the first (module_loader.h).

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

/// From the file name's extension and the name of a depth: float, half, byte, or empty for float,
/// byte in a PNG. @throws InputError for what no container holds.
[[nodiscard]] Encoding encoding_for(const std::filesystem::path& file, const std::string& depth);

/// The bytes of the file, the same for the same arguments: no date, no host, no program.
/// EXR is compressed scan lines; .tx is a tiled EXR without mip maps; a PNG keeps text
/// attributes only, its values are those of the pixels times 255, without a transfer curve, and its
/// alpha is a number like the others; FTXT (nacre/spectral/texture.h) has attributes as comments.
[[nodiscard]] std::string encode_image(const Image& image, const Attributes& attributes,
                                       const Encoding& encoding);

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

/// Reads all pixels as float, as they are stored. @throws InputError when the file is missing,
/// cut short or not an image.
[[nodiscard]] LoadedImage read_image(const std::filesystem::path& file,
                                     AlphaMeaning alpha = AlphaMeaning::coverage);

/// What half floats make of values, for measuring the error of a table that is stored so.
void round_to_half(std::vector<float>& values);
/// What a file of that depth makes of them.
void round_to(Depth depth, std::vector<float>& values);

}  // namespace nacre::tool
