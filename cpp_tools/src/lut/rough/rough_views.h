// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/parallel_for.h>

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "nacre/lut/rough_slices.h"

/// @file
/// Where rough tables are read, and what is seen there.

namespace nacre::lut {

/// Of one slice.
struct RoughSize {
    std::size_t width, height;

    [[nodiscard]] double step() const { return 1.0 / static_cast<double>(width - 1); }
    /// Of the colours, which are known half-way between the table's rows too.
    [[nodiscard]] std::size_t exact_row(std::size_t half_rows) const
    {
        return height == 1 ? 0 : half_rows;
    }
};

/// Where a rough table is read: the column of a slice, in [0, 1]; roughness times kRoughSlices; the
/// side of the surface.
struct RoughPlace {
    double column, slice;
    int side = 0;
};

/// What all texels of a row see, strip by strip. The last ones are kept, since they do not depend
/// on the film: the passes of one in bands have the same.
template <class Colours>
std::shared_ptr<const std::vector<typename Colours::View>> views_of_strips(const Colours& colours,
                                                                           RoughSize size)
{
    using Views = std::vector<typename Colours::View>;
    using Key = std::pair<std::pair<double, std::size_t>, std::size_t>;
    constexpr std::size_t kKept = 8, kStrips = Colours::kSides * kRoughSlices;
    static std::mutex mutex;
    static std::map<Key, std::shared_ptr<const Views>> known;
    const Key key{colours.surface(), size.width};
    {
        const std::scoped_lock lock(mutex);
        if (const auto found = known.find(key); found != known.end()) return found->second;
    }
    auto views = std::make_shared<Views>(kStrips * size.width);
    tbb::parallel_for(std::size_t{0}, views->size(), [&](std::size_t i) {
        const std::size_t strip = i / size.width, x = i % size.width;
        (*views)[i] = colours.see({.column = static_cast<double>(x) * size.step(),
                                   .slice = static_cast<double>(strip % kRoughSlices + 1),
                                   .side = static_cast<int>(strip / kRoughSlices)});
    });
    const std::scoped_lock lock(mutex);
    if (known.size() >= kKept) known.clear();
    known[key] = views;
    return views;
}

}  // namespace nacre::lut
