// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "develop/regions.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "library/plot.h"
#include "nacre/bands/viewer.h"
#include "nacre/core/diagnostics.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;
using spectral::Vec3;

/// Whole numbers with commas in between; nothing for anything else.
std::optional<std::vector<std::size_t>> whole_numbers(const std::string& text)
{
    std::vector<std::size_t> numbers;
    const char *at = text.data(), *const end = text.data() + text.size();
    while (true) {
        std::size_t number = 0;
        const auto [next, error] = std::from_chars(at, end, number);
        if (error != std::errc{}) return std::nullopt;
        numbers.push_back(number);
        if (next == end) return numbers;
        if (*next != ',') return std::nullopt;
        at = next + 1;
    }
}

/// What light both places show under a light, in each band of the first part.
class Metamerism {
public:
    Metamerism(const SpectralPicture& picture, const Mixture& mixture)
        : bands_(&picture.bands), layer_(mixture.parts.front().layer)
    {
        if (layer_->power.empty() || mixture.parts.size() > 1)
            throw InputError({{},
                              0,
                              "--under",
                              fmt::format("needs lamps of one light; those of {} are of several",
                                          picture.file)});
        power_ = layer_->power;
        for (std::size_t k = 0; k < power_.size(); ++k)
            power_[k] *= mixture.parts.front().factors[k];
    }

    ordered_json of(const Place& a, const Place& b, const std::string& name) const
    {
        const auto [difference, index] = bands::metamerism(*bands_, a.radiance, b.radiance, power_,
                                                           layer_->light, bands::named_light(name));
        return {{"light", name}, {"dE00", difference}, {"index", index}};
    }

private:
    const bands::Bands* bands_;
    const Layer* layer_;
    std::vector<double> power_;
};

ordered_json entry_of(const Place& place, const SpectralPicture& picture)
{
    const Vec3 xyz = picture.bands.xyz(place.radiance);
    ordered_json xy = nullptr;
    if (xyz[0] + xyz[1] + xyz[2] > 0.0) xy = spectral::xyz_to_xy(xyz);
    return {{"region", {place.region.x, place.region.y, place.region.width, place.region.height}},
            {"XYZ", xyz},
            {"xy", xy},
            {"rgb", place.rgb}};
}

std::string text_of(const ordered_json& result)
{
    const auto three = [](const ordered_json& values) {
        return fmt::format("{:.5g} {:.5g} {:.5g}", values[0].get<double>(), values[1].get<double>(),
                           values[2].get<double>());
    };
    std::string text;
    for (const ordered_json& place : result["regions"]) {
        const ordered_json& at = place["region"];
        text += fmt::format("{},{} of {} x {}: XYZ {}, rgb {}\n", at[0].get<int>(),
                            at[1].get<int>(), at[2].get<int>(), at[3].get<int>(),
                            three(place["XYZ"]), three(place["rgb"]));
    }
    for (const ordered_json& light : result["under"])
        text += fmt::format("under {}: ΔE00 {:.3g}, index of metamerism {:.3g}\n",
                            light["light"].get<std::string>(), light["dE00"].get<double>(),
                            light["index"].get<double>());
    return text;
}

}  // namespace

Region region_from(const std::string& text, const char* option, const SpectralPicture& picture)
{
    const auto numbers = whole_numbers(text);
    if (!numbers || (numbers->size() != 2 && numbers->size() != 4))
        throw InputError(
            {{},
             0,
             option,
             fmt::format("must be X,Y or X,Y,W,H from 0 at the top left (got '{}')", text)});
    const bool is_pixel = numbers->size() == 2;
    const Region region{(*numbers)[0], (*numbers)[1], is_pixel ? 1 : (*numbers)[2],
                        is_pixel ? 1 : (*numbers)[3]};
    const auto width = static_cast<std::size_t>(picture.image.width);
    const auto height = static_cast<std::size_t>(picture.image.height);
    const bool fits = region.x < width && region.y < height && region.width > 0 &&
                      region.height > 0 && region.width <= width - region.x &&
                      region.height <= height - region.y;
    if (!fits)
        throw InputError({{},
                          0,
                          option,
                          fmt::format("must be within {}, which is {} x {} (got {})", picture.file,
                                      width, height, text)});
    return region;
}

std::vector<double> mean_radiance(const SpectralPicture& picture, const Mixture& mixture,
                                  const Region& region)
{
    std::vector<double> sum(picture.bands.size(), 0.0);
    for (std::size_t y = region.y; y < region.y + region.height; ++y)
        for (std::size_t x = region.x; x < region.x + region.width; ++x) {
            const std::vector<double> values = mixture.radiance(picture, picture.pixel(x, y));
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += values[k];
        }
    const auto pixels = static_cast<double>(region.width * region.height);
    for (double& value : sum) value /= pixels;
    return sum;
}

spectral::NamedSpectrum spectrum_of(const Place& place, const SpectralPicture& picture)
{
    std::vector<double> nm;
    for (const bands::Band& band : picture.bands.bands) nm.push_back(band.wavelength_nm);
    return {.key = {},
            .name = place.text,
            .references = {},
            .licence = {},
            .comments = {},
            .tags = {},
            .kind = spectral::SpectrumKind::emission,
            .samples = {std::move(nm), place.radiance}};
}

/// Of curves after the first.
constexpr std::array kFurther = {Paint{0.75, 0.22, 0.13}, Paint{0.10, 0.50, 0.24},
                                 Paint{0.50, 0.25, 0.60}, Paint{0.80, 0.48, 0.05},
                                 Paint{0.05, 0.50, 0.55}};

Plot plot_of_places(const std::vector<spectral::NamedSpectrum>& places, const std::string& title)
{
    Plot plot = plot_of(places.front());
    plot.title = std::filesystem::path(title).filename().string();
    plot.subtitle = places.front().name;
    double most = 0.0;
    for (const spectral::NamedSpectrum& place : places)
        most = std::max(most, std::ranges::max(place.samples.values()));
    const Axis axis = Axis::rounded(0.0, most > 0.0 ? most : 1.0, kPlotArea.bottom, kPlotArea.top);
    plot.curves.front().axis = axis;
    plot.curves.front().label = "radiance per nm";
    const bool both_numbered = places.size() == 2;
    for (std::size_t i = 1; i < places.size(); ++i)
        plot.curves.push_back({places[i].name, places[i].values_at(plot.wavelengths_nm), axis,
                               kFurther[(i - 1) % kFurther.size()], both_numbered});
    if (both_numbered) plot.subtitle += fmt::format("  and  {}", places[1].name);
    if (places.size() > 2) {
        plot.subtitle = fmt::format("{} places", places.size());
        for (std::size_t i = 0; i < places.size(); ++i)
            plot.facts.push_back({fmt::format("{}", i + 1), places[i].name, plot.curves[i].paint});
    }
    return plot;
}

std::string report(bool as_json, const std::vector<Place>& places, const SpectralPicture& picture,
                   const Mixture& mixture, const std::vector<std::string>& under,
                   const spectral::ColourSpace& space)
{
    ordered_json result = {{"space", space.name},
                           {"regions", ordered_json::array()},
                           {"under", ordered_json::array()}};
    for (const Place& place : places) result["regions"].push_back(entry_of(place, picture));
    if (!under.empty()) {
        const Metamerism metamerism(picture, mixture);
        for (const std::string& light : under)
            result["under"].push_back(metamerism.of(places[0], places[1], light));
    }
    return as_json ? result.dump() + "\n" : text_of(result);
}

}  // namespace nacre::tool
