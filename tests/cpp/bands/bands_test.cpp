// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/bands.h"

#include <algorithm>
#include <cmath>

#include "nacre/library/spectrum_library.h"
#include "nacre/spectral/colour.h"
#include "support/expect.h"

namespace nacre::bands {
namespace {

using spectral::ObserverId, spectral::Vec3;

constexpr const char* kLasers = "line:462@1,532@0.8,638@1.2";

std::vector<Light> lights_of(std::initializer_list<const char*> names)
{
    std::vector<Light> lights;
    for (const char* name : names) lights.push_back(named_light(name));
    return lights;
}

Bands bands_for(int count, std::initializer_list<const char*> names)
{
    return make_bands(count, lights_of(names), ObserverId::cie1931);
}

/// Of a light as it is, in tenths of a nanometre; lines by colours of the observer's nanometres.
Vec3 exact(const Light& light, ObserverId id)
{
    const spectral::Observer& observer = spectral::observer(id);
    const auto at = [](const spectral::Sampled& values, double nm) {
        const auto i = std::min<std::size_t>(static_cast<std::size_t>(nm) - 360, 469);
        const double t = nm - spectral::wavelength_nm(i);
        return (1.0 - t) * values[i] + t * values[i + 1];
    };
    Vec3 sum{};
    const auto add = [&](double nm, double value) {
        sum[0] += at(observer.x, nm) * value / observer.sum_y;
        sum[1] += at(observer.y, nm) * value / observer.sum_y;
        sum[2] += at(observer.z, nm) * value / observer.sum_y;
    };
    for (std::size_t i = 0; i < light.power.size(); ++i) add(fine_nm(i), 0.1 * light.power[i]);
    for (const auto& line : light.lines) add(line.wavelength_nm, line.power);
    return sum;
}

void expect_same_colour(const Vec3& a, const Vec3& b, double tolerance)
{
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(a[c], b[c], tolerance * b[1]) << "XYZ"[c];
}

TEST(Bands, CoverEveryWavelengthOnce)
{
    for (const int count : {3, 24, 25, 192, 300})
        for (const auto& names :
             {std::initializer_list<const char*>{}, {"D65"}, {"D65", "F11"}, {"lamp/lps"}}) {
            const Bands made = bands_for(count, names);
            ASSERT_EQ(made.size(), static_cast<std::size_t>(count));
            EXPECT_NEAR(made.bands.back().last_nm, 830.0, 1e-9);
            for (std::size_t k = 0; k < made.size(); ++k) {
                const Band& band = made.bands[k];
                EXPECT_EQ(band.first_nm, k > 0 ? made.bands[k - 1].last_nm : 360.0);
                EXPECT_GT(band.wavelength_nm, band.first_nm);
                EXPECT_LT(band.wavelength_nm, band.last_nm);
                EXPECT_FALSE(band.is_line);
            }
            const std::vector<double> ones(made.size(), 1.0);
            expect_same_colour(made.xyz(ones),
                               exact({"E", Fine(kFineWavelengths, 1.0), {}}, made.observer), 1e-7);
        }
}

TEST(Bands, HoldEqualMassesOfTheRootOfWhatTheEyeSees)
{
    const Bands made = bands_for(24, {});
    const auto& observer = spectral::observer(ObserverId::cie1931);
    std::vector<double> mass(24, 0.0);
    std::size_t k = 0;
    double sum = 0.0;
    for (std::size_t i = 0; i < kFineWavelengths; ++i) {
        if (fine_nm(i) > made.bands[k].last_nm) ++k;
        const std::size_t j = i / 10;
        const double t = fine_nm(i) - spectral::wavelength_nm(j);
        const double eye = (1.0 - t) * (observer.x[j] + observer.y[j] + observer.z[j]) +
                           t * (observer.x[j + 1] + observer.y[j + 1] + observer.z[j + 1]);
        mass[k] += std::sqrt(eye);
        sum += std::sqrt(eye);
    }
    for (const double m : mass) EXPECT_NEAR(m / sum, 1.0 / 24.0, 0.02 / 24.0);
}

TEST(Bands, AreNarrowWhereALampHasPeaks)
{
    const auto width_at = [](const Bands& made, double nm) {
        for (const Band& band : made.bands)
            if (nm < band.last_nm) return band.last_nm - band.first_nm;
        return 0.0;
    };
    EXPECT_LT(width_at(bands_for(24, {"lamp/lps"}), 589.3),
              0.2 * width_at(bands_for(24, {}), 589.3));
    // No other lamp takes that away.
    EXPECT_LT(width_at(bands_for(24, {"D65", "lamp/lps", "A"}), 589.3),
              0.4 * width_at(bands_for(24, {}), 589.3));
}

TEST(Bands, ALineHasABandOfItsOwn)
{
    const Bands made = bands_for(24, {"D65", kLasers});
    std::vector<double> lines;
    for (const Band& band : made.bands) {
        if (!band.is_line) continue;
        lines.push_back(band.wavelength_nm);
        EXPECT_NEAR(band.last_nm - band.first_nm, kLineWidthNm, 1e-9);
    }
    EXPECT_EQ(lines, (std::vector<double>{462.0, 532.0, 638.0}));
    EXPECT_EQ(made.size(), 24u);
}

TEST(Bands, LinesTooNearToBeToldApartShareOne)
{
    const Bands made = bands_for(12, {"line:589.0@2,589.6@1"});
    int lines = 0;
    for (const Band& band : made.bands)
        if (band.is_line) {
            ++lines;
            EXPECT_NEAR(band.wavelength_nm, 589.2, 1e-9);  // as strong as they are
        }
    EXPECT_EQ(lines, 1);
    EXPECT_NO_THROW(bands_for(5, {"line:360,830"}));  // at both ends of what is seen
}

TEST(Bands, RefuseToBeTooFewForTheLines)
{
    EXPECT_EQ(fewest_bands(lights_of({kLasers})), 7);
    EXPECT_EQ(bands_for(7, {kLasers}).size(), 7u);
    EXPECT_INPUT_ERROR(bands_for(6, {kLasers}),
                       "bands: must be 7 … 300, for all the lines (got 6)");
    EXPECT_INPUT_ERROR(bands_for(2, {}), "bands: must be 3 … 300 (got 2)");
    EXPECT_INPUT_ERROR(bands_for(301, {}), "got 301");
}

TEST(LightInBands, KeepsItsColour)
{
    for (const ObserverId observer : {ObserverId::cie1931, ObserverId::cie1964})
        for (const int count : {24, 48, 192}) {
            const Bands made = make_bands(count, lights_of({"D65", kLasers}), observer);
            for (const char* name : {"D65", "A", "F11", "LED-B3", "lamp/hps", "lamp/mercury",
                                     "blackbody:1500", kLasers}) {
                const Light light = named_light(name);
                const std::vector<double> power = light_in_bands(made, light);
                for (const double value : power) EXPECT_GE(value, 0.0) << name;
                SCOPED_TRACE(name);
                expect_same_colour(made.xyz(power), exact(light, observer), 1e-4);
                EXPECT_NEAR(made.xyz(power)[1] / exact(light, observer)[1], 1.0, 1e-5);
            }
        }
}

TEST(LightInBands, ALineIsInItsBandAlone)
{
    const Bands made = bands_for(24, {"D65", kLasers});
    const std::vector<double> power = light_in_bands(made, named_light(kLasers));
    for (std::size_t k = 0; k < made.size(); ++k)
        EXPECT_EQ(power[k] > 0.0, made.bands[k].is_line) << made.bands[k].wavelength_nm;
}

TEST(LightInBands, WithoutABandALineIsInThoseAroundIt)
{
    const Bands made = bands_for(48, {"D65"});
    const std::vector<double> power = light_in_bands(made, named_light("line:550"));
    double sum = 0.0, mean = 0.0;
    for (std::size_t k = 0; k < made.size(); ++k) {
        sum += power[k] * made.bands[k].xyz[1];
        mean += power[k] * made.bands[k].xyz[1] * made.bands[k].wavelength_nm;
    }
    EXPECT_NEAR(mean / sum, 550.0, 1.0);
}

TEST(LightInBands, IsNoLightWhereThereIsNone)
{
    const Bands made = bands_for(24, {});
    for (const double value : light_in_bands(made, {"dark", Fine(kFineWavelengths, 0.0), {}}))
        EXPECT_EQ(value, 0.0);
}

TEST(NamedLight, HasLinesOrPower)
{
    const Light lasers = named_light(kLasers), daylight = named_light("D65");
    EXPECT_TRUE(lasers.power.empty());
    ASSERT_EQ(lasers.lines.size(), 3u);
    EXPECT_EQ(lasers.lines[1].power, 0.8);
    EXPECT_TRUE(daylight.lines.empty());
    EXPECT_EQ(daylight.power.size(), kFineWavelengths);
    EXPECT_INPUT_ERROR((void)named_light("line:300"), "300");
    EXPECT_INPUT_ERROR((void)named_light("candle"), "candle");
}

/// Mean of wavelengths to a power.
double moment(const spectral::Sampled& weights, double centre, int power)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i)
        sum += weights[i] * std::pow(spectral::wavelength_nm(i) - centre, power);
    return sum;
}

TEST(FilmWeights, ReadAtAWavelengthWhereFringesAreWide)
{
    const Light light = named_light("D65");
    const Bands made = make_bands(24, {&light, 1}, ObserverId::cie1931);
    for (std::size_t k = 0; k < made.size(); ++k) {
        const spectral::Sampled weights = film_weights(made, k, 400.0);
        EXPECT_LE(std::ranges::count_if(weights, [](double weight) { return weight != 0.0; }), 4);
        EXPECT_NEAR(moment(weights, 0.0, 0), 1.0, 1e-12);
        for (const int power : {1, 2, 3})
            EXPECT_NEAR(moment(weights, made.bands[k].wavelength_nm, power), 0.0, 1e-9) << k;
    }
}

TEST(FilmWeights, AreAMeanWhereFringesAreNarrow)
{
    const Light light = named_light("D65");
    const Bands made = make_bands(24, {&light, 1}, ObserverId::cie1931);
    for (std::size_t k = 0; k < made.size(); ++k) {
        const spectral::Sampled weights = film_weights(made, k, 1e5);
        double sum = 0.0, centre = 0.0;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            sum += weights[i];
            centre += weights[i] * spectral::wavelength_nm(i);
            const double nm = spectral::wavelength_nm(i);
            if (nm < made.bands[k].first_nm - 1.0 || nm > made.bands[k].last_nm + 1.0) {
                EXPECT_EQ(weights[i], 0.0);
            }
        }
        EXPECT_NEAR(sum, 1.0, 1e-12);
        EXPECT_NEAR(centre, made.bands[k].wavelength_nm, 1e-6);  // its middle to the eye
    }
}

TEST(FilmWeights, OfALineAreAtTheLine)
{
    const Light light = named_light("line:589.3");
    const Bands made = make_bands(24, {&light, 1}, ObserverId::cie1931);
    const auto line = std::ranges::find_if(made.bands, &Band::is_line);
    ASSERT_NE(line, made.bands.end());
    const spectral::Sampled weights =
        film_weights(made, static_cast<std::size_t>(line - made.bands.begin()), 1e5);
    EXPECT_NEAR(moment(weights, 0.0, 0), 1.0, 1e-12);
    for (const int power : {1, 2, 3}) EXPECT_NEAR(moment(weights, 589.3, power), 0.0, 1e-9);
}

}  // namespace
}  // namespace nacre::bands
