// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/lut/rough_glass_tables.h"

#include <gtest/gtest.h>

#include <cmath>

#include "films.h"

namespace nacre::lut {
namespace {

using test::constant;

constexpr double kIndex = 1.5;  // of test::on_glass

/// Texels of a rough table of glass, by what is seen there.
class Texels {
public:
    explicit Texels(const Table& table) : table_(table) {}

    [[nodiscard]] int width() const { return table_.x.texels / (table_.slices * table_.sides); }
    [[nodiscard]] double operator()(int strip, int x, int y, std::size_t channel) const
    {
        const auto i = static_cast<std::size_t>(y * table_.x.texels + strip * width() + x);
        return table_.texels[3 * i + channel];
    }
    [[nodiscard]] optics::GlassView view(int strip, int x) const
    {
        return glass_view(static_cast<double>(x) / (width() - 1),
                          (strip % kRoughSlices + 1.0) / kRoughSlices, kIndex,
                          strip / kRoughSlices);
    }

private:
    const Table& table_;
};

constexpr int kStrips = kGlassSides * kRoughSlices;

TEST(RoughGlassTables, InsideColumnsBreakAtTheCriticalAngle)
{
    const auto cosine = [](double x) { return glass_view(x, 0.5, kIndex, 1).cos_theta; };
    EXPECT_NEAR(cosine(0.0), 0.0, 1e-12);
    EXPECT_NEAR(cosine(0.5), std::sqrt(1.0 - 1.0 / (kIndex * kIndex)), 1e-12);
    EXPECT_NEAR(cosine(1.0), 1.0, 1e-12);
    EXPECT_EQ(glass_view(0.3, 0.5, kIndex, 0).cos_theta, 0.3);
    EXPECT_EQ(glass_view(0.3, 0.5, kIndex, 0).alpha, 0.25);
    // Glass of the lower index reflects nothing totally inside.
    EXPECT_NEAR(glass_view(0.9, 0.5, 0.75, 1).cos_theta, std::sqrt(1.0 - 0.36 / 0.5625), 1e-12);
}

TEST(RoughGlassTables, ClearFilmsKeepAllLightOnBothSides)
{
    const FilmTableRequest request = test::on_glass(2.2);
    const RoughTables rough = bake_rough_glass_tables(request, bake_film_tables(request), kIndex);
    EXPECT_EQ(rough.reflectance.sides, kGlassSides);
    EXPECT_FALSE(rough.further);
    const Texels R(rough.reflectance), T(*rough.transmittance);
    double lost = 0.0;
    int count = 0;
    for (int strip = 0; strip < kStrips; ++strip)
        for (int x = 0; x < R.width(); x += 3) {
            const optics::GlassFacets seen = optics::glass_facets(R.view(strip, x), 2);
            for (const int y : {0, rough.reflectance.y.texels - 1}) {
                const double r = R(strip, x, y, 1), t = T(strip, x, y, 1);
                const double rounding =
                    seen.mirror * test::half_step(r, rough.reflectance.texel_bits) +
                    seen.window * test::half_step(t, rough.transmittance->texel_bits);
                const double kept = seen.mirror * r + seen.window * t;
                ASSERT_NEAR(kept, 1.0, rounding + 2e-5) << strip << ' ' << x << ' ' << y;
                lost += 1.0 - kept;
                ++count;
            }
        }
    EXPECT_NEAR(lost / count, 0.0, 2e-5);
    std::printf("dE00 mean %.3f max %.3f\n", rough.reflectance.error_mean,
                rough.reflectance.error_max);
    EXPECT_LT(rough.reflectance.error_mean, 0.5);
    EXPECT_LT(rough.transmittance->error_mean, 0.5);
}

/// Of bare glass both lobes grow by one factor, which makes up for what one bounce loses.
TEST(RoughGlassTables, BareGlassIsItsOwnLobes)
{
    FilmTableRequest request = test::request(constant(1.0), {}, constant(kIndex), std::nullopt);
    request.transmittance = true;
    request.size = std::array<int, 2>{513, 1};
    const RoughTables rough = bake_rough_glass_tables(request, bake_film_tables(request), kIndex);
    const Texels R(rough.reflectance), T(*rough.transmittance);
    const std::vector<Table> lobes = bake_lobe_tables(kIndex, R.width());
    ASSERT_EQ(lobes[1].name(), "lobe_R_rough");
    ASSERT_EQ(lobes[3].name(), "lobe_T_rough");
    const Texels reflected(lobes[1]), passed(lobes[3]);
    ASSERT_EQ(lobes[1].texels.size(), rough.reflectance.texels.size());
    for (int strip = 0; strip < kStrips; ++strip)
        for (int x = 0; x < R.width(); x += 16) {
            const optics::GlassFacets seen = optics::glass_facets(R.view(strip, x), 2);
            const double rounds = 1.0 / (seen.clear_mirror + seen.clear_window);
            EXPECT_NEAR(R(strip, x, 0, 0), rounds * reflected(strip, x, 0, 0), 5e-3);
            EXPECT_NEAR(T(strip, x, 0, 0), rounds * passed(strip, x, 0, 0), 5e-3);
        }
    EXPECT_NEAR(lobes[0].texels.back(), 0.04, 1e-6);  // ((n − 1)/(n + 1))²
    EXPECT_NEAR(lobes[2].texels.back(), 0.96, 1e-6);
    EXPECT_NEAR(lobes[0].texels.front(), 1.0, 1e-3);  // grazing
}

/// A grey film that loses the share a in a bounce: 1/(1 − going on) as much as leaves at first,
/// which is less than all, and more than one bounce sends.
TEST(RoughGlassTables, AbsorbingFilmsLoseMoreTheMoreTheyAreMet)
{
    const FilmTableRequest request = test::on_glass({1.8, 1.5});
    const FilmTables smooth = bake_film_tables(request);
    const RoughTables rough = bake_rough_glass_tables(request, smooth, kIndex);
    const Texels R(rough.reflectance), T(*rough.transmittance);
    const int last = R.width() - 1;
    const auto kept = [&](int strip) {
        const optics::GlassFacets seen = optics::glass_facets(R.view(strip, last), 2);
        return seen.mirror * R(strip, last, 0, 1) + seen.window * T(strip, last, 0, 1);
    };
    const std::size_t end = 3 * static_cast<std::size_t>(smooth.reflectance.x.texels) - 2;
    const double flat = smooth.reflectance.texels[end] + smooth.transmittance->texels[end];
    EXPECT_NEAR(kept(0), flat, 2e-3);
    for (int slice = 1; slice < kRoughSlices; ++slice) EXPECT_LT(kept(slice), kept(slice - 1));
    const auto roughest = optics::glass_facets(R.view(kRoughSlices - 1, last), 2);
    EXPECT_GT(kept(kRoughSlices - 1), flat * std::min(roughest.mirror, roughest.window));
}

}  // namespace
}  // namespace nacre::lut
