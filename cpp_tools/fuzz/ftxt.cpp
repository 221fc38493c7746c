// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz_target.h"
#include "nacre/textures/texture.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return fuzz::run(data, size, [](std::string_view text) {
        const spectral::TextTexture content = spectral::read_ftxt(text, "input.ftxt");
        const auto texels = static_cast<std::size_t>(content.texture.width) *
                            static_cast<std::size_t>(content.texture.height);
        fuzz::require(content.texture.texels.size() == 4 * texels, "texels without a number");
        // What was read can be written, and is the same again.
        const auto again = spectral::read_ftxt(spectral::write_ftxt(content), "again.ftxt");
        fuzz::require(again.texture.texels == content.texture.texels, "other texels");
    });
}
