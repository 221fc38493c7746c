// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "modules/image.h"

/// @file
/// What the module `images` gives: OpenImageIO, and no more of it than the tool needs.

namespace nacre::tool {

/// All throw std::runtime_error, whose text lacks the file's name.
struct ImageCodec {
    static constexpr const char* kModule = "images";
    static constexpr const char* kLibrary =
        "OpenImageIO (Debian and Ubuntu: apt-get install openimageio-tools)";

    /// Of EXR, .tx and PNG.
    std::string (*encode)(const Image& image, const Attributes& attributes,
                          const Encoding& encoding);
    LoadedImage (*decode)(const std::string& file, AlphaMeaning alpha);
    void (*round_to_half)(std::vector<float>& values);
    /// RGB of each value in [0, 1], from black over red to yellow: matplotlib's `inferno`.
    std::vector<float> (*inferno)(std::vector<float> values);
};

}  // namespace nacre::tool
