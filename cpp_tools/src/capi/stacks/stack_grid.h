// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nacre::capi {

/// How far one array moves along each axis of a grid, in elements; 0 where it stays.
using Steps = std::span<const std::size_t>;

/// Number of items of a grid with these axes.
[[nodiscard]] std::size_t count_items(std::span<const std::size_t> shape);

/// Steps of an array that holds, without gaps, every element of one with `steps`.
[[nodiscard]] std::vector<std::size_t> compact_steps(std::span<const std::size_t> shape,
                                                     Steps steps);

/// Whether `good(offset)` holds for all elements of an array, each asked once, in order.
template <class Good>
bool every_element(std::span<const std::size_t> shape, Steps steps, Good&& good,
                   std::size_t offset = 0)
{
    if (shape.empty()) return good(offset);
    const std::size_t count = steps.front() == 0 ? 1 : shape.front();
    for (std::size_t i = 0; i < count; ++i)
        if (!every_element(shape.subspan(1), steps.subspan(1), good, offset + i * steps.front()))
            return false;
    return true;
}

/// Walks over the items of a grid, last axis first, and knows where `Arrays` arrays are.
template <std::size_t Arrays>
class GridCursor {
public:
    GridCursor(std::span<const std::size_t> shape, const Steps (&steps)[Arrays], std::size_t item)
        : shape_(shape), index_(shape.size())
    {
        for (std::size_t a = 0; a < Arrays; ++a) steps_[a] = steps[a];
        for (std::size_t axis = shape.size(); axis-- > 0; item /= shape[axis]) {
            index_[axis] = item % shape[axis];
            for (std::size_t a = 0; a < Arrays; ++a) offset_[a] += index_[axis] * steps_[a][axis];
        }
    }

    [[nodiscard]] std::size_t offset(std::size_t array) const { return offset_[array]; }

    void advance()
    {
        for (std::size_t axis = shape_.size(); axis-- > 0;) {
            const bool wraps = ++index_[axis] == shape_[axis];
            for (std::size_t a = 0; a < Arrays; ++a) {
                offset_[a] += steps_[a][axis];
                if (wraps) offset_[a] -= shape_[axis] * steps_[a][axis];
            }
            if (!wraps) return;
            index_[axis] = 0;
        }
    }

private:
    std::span<const std::size_t> shape_;
    std::vector<std::size_t> index_;
    Steps steps_[Arrays];
    std::size_t offset_[Arrays] = {};
};

}  // namespace nacre::capi
