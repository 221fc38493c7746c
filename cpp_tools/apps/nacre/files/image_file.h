// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "modules/image.h"

/// @file
/// Images in and out, by OpenImageIO, which is loaded with the first (modules/module_loader.h).

namespace nacre::tool {

/// From the file name's extension and the name of a depth: float, half, byte, or empty for float,
/// byte in a PNG. @throws InputError for what no container holds.
[[nodiscard]] Encoding encoding_for(const std::filesystem::path& file, const std::string& depth);

/// The bytes of the file, the same for the same arguments: no date, no host, no program.
/// EXR is compressed scan lines; .tx is a tiled EXR without mip maps; a PNG keeps text
/// attributes only, its values are those of the pixels times 255, without a transfer curve, and its
/// alpha is a number like the others; FTXT (nacre/spectral/texture.h) has attributes as comments.
[[nodiscard]] std::string encode_image(const Image& image, const Attributes& attributes,
                                       const Encoding& encoding);

/// Reads all pixels as float, as they are stored. @throws InputError when the file is missing,
/// cut short or not an image.
[[nodiscard]] LoadedImage read_image(const std::filesystem::path& file,
                                     AlphaMeaning alpha = AlphaMeaning::coverage);

/// Empty where there is none, or one that is no text.
[[nodiscard]] std::string text_attribute(const LoadedImage& loaded, const char* name);

/// What half floats make of values, for measuring the error of a table that is stored so.
void round_to_half(std::vector<float>& values);
/// What a file of that depth makes of them.
void round_to(Depth depth, std::vector<float>& values);

}  // namespace nacre::tool
