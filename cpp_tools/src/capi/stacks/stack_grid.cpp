// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "stacks/stack_grid.h"

#include <functional>
#include <numeric>

namespace nacre::capi {

std::size_t count_items(std::span<const std::size_t> shape)
{
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies{});
}

std::vector<std::size_t> compact_steps(std::span<const std::size_t> shape, Steps steps)
{
    std::vector<std::size_t> compact(shape.size(), 0);
    std::size_t elements = 1;
    for (std::size_t axis = shape.size(); axis-- > 0;) {
        if (steps[axis] == 0) continue;
        compact[axis] = elements;
        elements *= shape[axis];
    }
    return compact;
}

}  // namespace nacre::capi
