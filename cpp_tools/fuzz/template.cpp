// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz_target.h"
#include "nacre/kinds/read_template.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return nacre::fuzz::run(data, size, [](std::string_view text) {
        (void)nacre::kinds::parse_template(text, "input.toml");
    });
}
