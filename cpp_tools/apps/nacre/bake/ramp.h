// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "nacre/kinds/template.h"
#include "tables/options.h"

/// @file
/// Exact colours of a film over its thickness at one angle, as text.

namespace nacre::tool {

struct RampOptions {
    std::string quantity = "reflectance";  ///< or `transmittance`
    double angle_deg = 0.0;
    std::size_t size = 256;
};

/// --angle, --size and --quantity.
void add_ramp_options(CLI::App& command, RampOptions& options);

enum class RampFormat { cube, spi1d, csv };

/// From the extension. @throws InputError for any other
[[nodiscard]] RampFormat ramp_format(const std::string& output);

/// @throws InputError unless the material is a film in which something varies
[[nodiscard]] std::string ramp_text(const kinds::MaterialTemplate& source,
                                    const RampOptions& options, const ResolvedTableOptions& table,
                                    RampFormat format);

}  // namespace nacre::tool
