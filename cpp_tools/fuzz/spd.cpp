// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz_target.h"
#include "nacre/readers/spectrum_files.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return fuzz::run(data, size, [](std::string_view text) {
        for (const auto& spectrum : spectral::read_spd(text, "input.spd"))
            fuzz::require(spectrum.samples.values().size() >= 2, "a spectrum without samples");
    });
}
