// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/microsurface_walk.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "facets/visible_normals.h"

namespace nacre::optics {
namespace {

/// The same numbers on every machine, unlike the distributions of the standard library.
class Uniform {
public:
    explicit Uniform(std::uint64_t seed) : engine_(seed) {}
    double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

private:
    std::mt19937_64 engine_;
};

/// Λ of any direction; −1 − Λ(−w) where it points down.
double lambda(const Vector& w, const std::array<double, 2>& alpha)
{
    const double x = alpha[0] * w[0], y = alpha[1] * w[1];
    const double root = std::sqrt(1.0 + (x * x + y * y) / (w[2] * w[2]));
    return 0.5 * (std::copysign(root, w[2]) - 1.0);
}

/// Height of the next facet on the way, as the share of the surface that lies below it; nothing
/// where the light leaves.
std::optional<double> next_height(const Vector& w, double height,
                                  const std::array<double, 2>& alpha, double u)
{
    if (std::abs(w[2]) < 1e-9) return height;
    const double passed = lambda(w, alpha);
    if (w[2] > 0.0 && u >= 1.0 - std::pow(height, passed)) return std::nullopt;
    if (passed == 0.0) return std::nullopt;
    return std::clamp(height / std::pow(1.0 - u, 1.0 / passed), 0.0, 1.0);
}

}  // namespace

void walk_microsurface(
    const MicrosurfaceWalk& walk,
    const std::function<void(std::span<const double>, const std::array<double, 3>&)>& left)
{
    Uniform random(walk.seed);
    std::vector<double> cosines;
    for (std::uint64_t path = 0; path < walk.paths; ++path) {
        Vector w{-walk.view[0], -walk.view[1], -walk.view[2]};
        double height = 1.0;
        cosines.clear();
        while (static_cast<int>(cosines.size()) <= walk.max_bounces) {
            const std::optional<double> next = next_height(w, height, walk.alpha, random());
            if (!next) {
                left(cosines, w);
                break;
            }
            height = *next;
            const Vector back{-w[0], -w[1], -w[2]};
            const double u = random(), v = random();
            const Vector facet = visible_normal(back, walk.alpha, u, v);
            const double cosine = std::clamp(dot(back, facet), 0.0, 1.0);
            cosines.push_back(cosine);
            for (std::size_t i = 0; i < 3; ++i) w[i] += 2.0 * cosine * facet[i];
            w = normalised(w);
        }
    }
}

}  // namespace nacre::optics
