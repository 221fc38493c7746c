// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "fuzz_target.h"
#include "nacre/readers/refractiveindex_yaml.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    return nacre::fuzz::run(data, size, [](std::string_view text) {
        const auto medium = nacre::spectral::parse_refractiveindex_yaml(text, "input.yml");
        const auto [first, last] = medium.constants->range_nm();
        for (const double nm : {first, std::lerp(first, last, 0.5), last}) {
            const auto n = medium.constants->at(nm);  // or an InputError: a formula may fail
            nacre::fuzz::require(n.real() > 0.0 && n.imag() >= 0.0, "an index out of its range");
        }
    });
}
