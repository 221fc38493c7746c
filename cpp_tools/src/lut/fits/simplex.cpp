// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "fits/simplex.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace nacre::lut {
namespace {

using Point = std::vector<double>;
using Function = std::function<double(const Point&)>;

// Below this spread of values ΔE00 no longer tells the corners apart.
constexpr double kSettled = 1e-7;

class Simplex {
public:
    Simplex(const Function& function, const Point& start, const Point& step) : function_(function)
    {
        add(start);
        for (std::size_t i = 0; i < start.size(); ++i) {
            Point corner = start;
            corner[i] += step[i];
            add(corner);
        }
        sort();
    }

    [[nodiscard]] int evaluations() const { return evaluations_; }
    [[nodiscard]] bool settled() const
    {
        return corners_.back().value - corners_.front().value < kSettled;
    }
    [[nodiscard]] const Minimum& best() const { return corners_.front(); }

    void step()
    {
        const Point centre = centre_without_worst();
        Minimum& worst = corners_.back();
        const Minimum reflected = at(along(centre, worst.at, -1.0));
        if (reflected.value < corners_.front().value) {
            const Minimum further = at(along(centre, worst.at, -2.0));
            worst = further.value < reflected.value ? further : reflected;
        } else if (reflected.value < corners_[corners_.size() - 2].value) {
            worst = reflected;
        } else {
            const bool outside = reflected.value < worst.value;
            const Minimum inner = at(along(centre, worst.at, outside ? -0.5 : 0.5));
            if (inner.value < std::min(reflected.value, worst.value))
                worst = inner;
            else
                shrink();
        }
        sort();
    }

private:
    const Function& function_;
    std::vector<Minimum> corners_;
    int evaluations_ = 0;

    Minimum at(Point point)
    {
        ++evaluations_;
        const double value = function_(point);
        return {std::move(point), value};
    }
    void add(const Point& point) { corners_.push_back(at(point)); }
    void sort() { std::ranges::stable_sort(corners_, {}, &Minimum::value); }

    [[nodiscard]] Point centre_without_worst() const
    {
        Point centre(corners_.front().at.size(), 0.0);
        for (std::size_t corner = 0; corner + 1 < corners_.size(); ++corner)
            for (std::size_t i = 0; i < centre.size(); ++i)
                centre[i] += corners_[corner].at[i] / static_cast<double>(centre.size());
        return centre;
    }

    static Point along(const Point& from, const Point& to, double t)
    {
        Point result = from;
        for (std::size_t i = 0; i < from.size(); ++i) result[i] = std::lerp(from[i], to[i], t);
        return result;
    }

    void shrink()
    {
        for (std::size_t corner = 1; corner < corners_.size(); ++corner)
            corners_[corner] = at(along(corners_.front().at, corners_[corner].at, 0.5));
    }
};

}  // namespace

Minimum minimise(const Function& function, const Point& start, const Point& step, int evaluations)
{
    Simplex simplex(function, start, step);
    while (simplex.evaluations() < evaluations && !simplex.settled()) simplex.step();
    return simplex.best();
}

}  // namespace nacre::lut
