// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/camera.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "csv_table.h"
#include "nacre/core/diagnostics.h"

namespace nacre::spectral {

namespace {

struct Shipped {
    std::string_view key, name, path;
};
constexpr Shipped kShipped[] = {
    {"nikon-d5100", "Nikon D5100", "cameras/nikon_d5100.csv"},
    {"sigma-sd1-merrill", "Sigma SD1 Merrill", "cameras/sigma_sd1_merrill.csv"},
};

}  // namespace

Vec3 Camera::at(double wavelength_nm) const
{
    Vec3 result{};
    for (std::size_t c = 0; c < result.size(); ++c) {
        const Spectrum& of = sensitivity[c];
        if (wavelength_nm >= of.first_nm() && wavelength_nm <= of.last_nm())
            result[c] = of.at(wavelength_nm);
    }
    return result;
}

std::vector<std::string> camera_keys()
{
    std::vector<std::string> keys;
    for (const Shipped& shipped : kShipped) keys.emplace_back(shipped.key);
    return keys;
}

Camera camera(std::string_view key)
{
    const auto* found = std::ranges::find(kShipped, key, &Shipped::key);
    if (found == std::end(kShipped))
        throw InputError({.file = {},
                          .field = "camera",
                          .message = fmt::format("must be one of {} (got '{}')",
                                                 fmt::join(camera_keys(), ", "), key)});
    const CsvTable table = load_csv(found->path, 4);
    Camera result{.name = std::string(found->name), .sensitivity = {}};
    for (std::size_t c = 0; c < 3; ++c)
        result.sensitivity.emplace_back(table.columns[0], table.columns[c + 1]);
    return result;
}

}  // namespace nacre::spectral
