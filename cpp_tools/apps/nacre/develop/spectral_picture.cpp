// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "develop/spectral_picture.h"

#include <algorithm>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nacre/bands/response.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/text_lines.h"

namespace nacre::tool {
namespace {

using Json = nlohmann::json;

constexpr const char* kBands = "nacre:bands";
constexpr const char* kLights = "nacre:lights";
constexpr int kVersion = 1;
/// Names have three decimals.
constexpr double kSameNm = 2e-3;

/// Where in a pixel the channels of each layer are, by wavelength.
using Found = std::map<std::string, std::map<double, std::size_t>>;

/// The wavelength of `S0.589,294nm`; nothing for any other name.
std::optional<double> wavelength_of(std::string_view channel)
{
    constexpr std::string_view kPrefix = "S0.", kUnit = "nm";
    if (!channel.starts_with(kPrefix) || !channel.ends_with(kUnit)) return std::nullopt;
    std::string number(channel.substr(kPrefix.size(), channel.size() - kPrefix.size() - 2));
    std::ranges::replace(number, ',', '.');
    return parse_number(number);
}

Found channels_by_layer(const Image& image)
{
    Found found;
    for (std::size_t i = 0; i < image.channel_count(); ++i) {
        const std::string& name = image.channels[i];
        const std::size_t at = name.rfind("S0.");
        if (at == std::string::npos || (at > 0 && name[at - 1] != '.')) continue;
        const std::string layer = at == 0 ? "" : name.substr(0, at - 1);
        if (const auto nm = wavelength_of(std::string_view(name).substr(at))) found[layer][*nm] = i;
    }
    return found;
}

class Reader {
public:
    explicit Reader(const std::string& file) : file_(file) {}

    SpectralPicture read()
    {
        LoadedImage loaded = read_image(file_);
        const Found found = channels_by_layer(loaded.image);
        if (!found.contains(""))
            refuse("", "has no spectra: channels must be called as S0.550,000nm is");
        SpectralPicture picture{
            .file = file_, .image = std::move(loaded.image), .bands = {}, .layers = {}};
        picture.bands = bands_from(text_attribute(loaded, kBands), found.at(""));
        for (const auto& [name, channels] : found)
            picture.layers.push_back(layer_from(name, channels, picture.bands));
        read_lights(text_attribute(loaded, kLights), picture);
        return picture;
    }

private:
    const std::string& file_;

    [[noreturn]] void refuse(const std::string& field, std::string message) const
    {
        throw InputError({file_, 0, field, std::move(message)});
    }

    /// What `make` returns; what it throws names the file and the attribute.
    template <class Make>
    auto said(const char* attribute, const Make& make) const
    {
        try {
            return make();
        } catch (const Json::exception&) {
            refuse(attribute, "cannot be read; was it written by Nacre?");
        } catch (const InputError& error) {
            const Diagnostic& first = error.diagnostics().front();
            refuse(fmt::format("{}.{}", attribute, first.field), first.message);
        }
    }

    [[nodiscard]] bands::Bands bands_from(const std::string& text,
                                          const std::map<double, std::size_t>& channels) const
    {
        if (text.empty()) {
            std::vector<double> nm;
            nm.reserve(channels.size());
            for (const auto& [wavelength, channel] : channels) nm.push_back(wavelength);
            return said("channels",
                        [&nm] { return bands::bands_around(nm, spectral::ObserverId::cie1931); });
        }
        return said(kBands, [&] {
            const Json bands = Json::parse(text);
            if (bands.at("version") > kVersion)
                refuse(kBands, fmt::format("is of version {}, made by a newer Nacre; this one "
                                           "knows {}",
                                           bands.at("version").dump(), kVersion));
            return bands::bands_of(
                bands.at("edges_nm").get<std::vector<double>>(),
                bands.at("wavelength_nm").get<std::vector<double>>(),
                bands.at("is_line").get<std::vector<bool>>(),
                spectral::observer_from_name(bands.at("observer").get<std::string>()));
        });
    }

    [[nodiscard]] Layer layer_from(const std::string& name,
                                   const std::map<double, std::size_t>& channels,
                                   const bands::Bands& bands) const
    {
        Layer layer{.name = name, .channels = {}, .light = {}, .power = {}};
        for (const bands::Band& band : bands.bands) {
            const auto found = channels.lower_bound(band.wavelength_nm - kSameNm);
            if (found == channels.end() || found->first > band.wavelength_nm + kSameNm)
                refuse(name, fmt::format("has no channel of {:.3f} nm", band.wavelength_nm));
            layer.channels.push_back(found->second);
        }
        if (channels.size() != bands.size())
            refuse(name, fmt::format("has {} channels of spectra, for {} bands", channels.size(),
                                     bands.size()));
        return layer;
    }

    void read_lights(const std::string& text, SpectralPicture& picture) const
    {
        if (text.empty()) return;
        said(kLights, [&] {
            for (const Json& entry : Json::parse(text)) {
                const auto layer = std::ranges::find(
                    picture.layers, entry.at("layer").get<std::string>(), &Layer::name);
                if (layer == picture.layers.end())
                    refuse(kLights, fmt::format("speaks of {}, of which there are no channels",
                                                entry.at("layer").dump()));
                layer->light = entry.at("light").get<std::string>();
                layer->power = entry.at("power").get<std::vector<double>>();
                if (layer->power.size() != picture.bands.size())
                    refuse(kLights, fmt::format("{} must have {} powers (got {})", layer->light,
                                                picture.bands.size(), layer->power.size()));
            }
        });
    }
};

}  // namespace

SpectralPicture read_spectral_picture(const std::string& file)
{
    return Reader(file).read();
}

}  // namespace nacre::tool
