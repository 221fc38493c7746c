// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/response.h"

#include <algorithm>

#include "nacre/bands/choose.h"
#include "support/expect.h"

namespace nacre::bands {
namespace {

using spectral::ObserverId, spectral::Vec3;

Bands under(std::initializer_list<const char*> names, int count,
            ObserverId observer = ObserverId::cie1931)
{
    std::vector<Light> lights;
    for (const char* name : names) lights.push_back(named_light(name));
    return make_bands(count, lights, observer);
}

void expect_same(const Bands& a, const Bands& b)
{
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(a.observer, b.observer);
    for (std::size_t k = 0; k < a.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(a.bands[k].xyz[c], b.bands[k].xyz[c], 1e-12) << k;
}

TEST(Response, OfAnEyeIsTheColourOfTheBands)
{
    const Bands bands = under({"D65", "line:589.3"}, 30);
    expect_same(seen_by(bands, ObserverId::cie1931), bands);
    const Bands wide = seen_by(bands, ObserverId::cie1964);
    EXPECT_EQ(wide.observer, ObserverId::cie1964);
    EXPECT_EQ(wide.bands[3].wavelength_nm, bands.bands[3].wavelength_nm);
    const std::vector<double> even(bands.size(), 1.0);
    EXPECT_NEAR(wide.xyz(even)[1], 1.0, 1e-6);
}

TEST(Response, SumsToTheWholeOfASensor)
{
    const Bands bands = under({"F11"}, 24);
    const auto responded = responses(bands, [](double nm) {
        return Vec3{1.0, nm, nm < 595.0 ? 1.0 : 0.0};
    });
    Vec3 sum{};
    for (const Vec3& band : responded)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += band[c];
    EXPECT_NEAR(sum[0], 470.0, 1e-9);
    EXPECT_NEAR(sum[1], 470.0 * 595.0, 1e-6);
    EXPECT_NEAR(sum[2], 235.0, 0.1 + 1e-9);
}

TEST(Response, BandsComeBackFromWhatAFileSays)
{
    const Bands bands = under({"D65", "line:450,532.5"}, 40);
    std::vector<double> edges{360.0}, wavelengths;
    std::vector<bool> is_line;
    for (const Band& band : bands.bands) {
        edges.push_back(band.last_nm);
        wavelengths.push_back(band.wavelength_nm);
        is_line.push_back(band.is_line);
    }
    expect_same(bands_of(edges, wavelengths, is_line, ObserverId::cie1931), bands);
    const auto refused = [&](const char* message) {
        EXPECT_INPUT_ERROR(
            static_cast<void>(bands_of(edges, wavelengths, is_line, ObserverId::cie1931)), message);
    };
    std::swap(edges[3], edges[4]);
    refused("edges_nm: must ascend by 0.1 nm or more");
    std::swap(edges[3], edges[4]);
    wavelengths[5] = 700.0;
    refused("wavelength_nm: must be within its band");
    edges.pop_back();
    refused("bands: must be 1 … 300 with one edge more (got 40 and 40 edges)");
}

TEST(Response, BandsAroundWavelengthsMeetHalfWay)
{
    const double nm[] = {400.0, 500.0, 540.0, 700.0};
    const Bands bands = bands_around(nm, ObserverId::cie1931);
    ASSERT_EQ(bands.size(), 4U);
    EXPECT_EQ(bands.bands[1].first_nm, 450.0);
    EXPECT_EQ(bands.bands[1].last_nm, 520.0);
    EXPECT_EQ(bands.bands[3].last_nm, 830.0);
}

// What a picture of one light shows is then as if it had been rendered under the other.
TEST(Response, AnExchangedLightIsAsIfItHadBeenThere)
{
    const Bands bands = under({"E", "D65", "F11"}, 48);
    const std::vector<double> before = light_in_bands(bands, named_light("D65"));
    std::vector<double> after = light_in_bands(bands, named_light("F11"));
    const double brighter = bands.xyz(before)[1] / bands.xyz(after)[1];
    const std::vector<double> factors = exchange(bands, before, "D65", named_light("F11"));
    for (std::size_t k = 0; k < bands.size(); ++k)
        EXPECT_NEAR(factors[k] * before[k], after[k] * brighter, 1e-12) << k;
}

TEST(Response, LightThatIsNotThereCannotBeExchanged)
{
    const Bands bands = under({"D65", "line:589.3"}, 48);
    const std::vector<double> sodium = light_in_bands(bands, named_light("line:589.3"));
    EXPECT_INPUT_ERROR(static_cast<void>(exchange(bands, sodium, "Sodium", named_light("D65"))),
                       "where Sodium has no light that could be turned into it");
    const auto factors = exchange(bands, light_in_bands(bands, named_light("D65")), "D65",
                                  named_light("line:589.3"));
    EXPECT_EQ(std::ranges::count_if(factors, [](double factor) { return factor > 0.0; }), 1);
}

}  // namespace
}  // namespace nacre::bands
