// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/spectrum_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/limits.h"
#include "nacre/textures/spectral_channels.h"
#include "nacre/textures/spectrum_texture.h"

namespace nacre::tool {
namespace {

using nlohmann::json;
using spectral::NamedSpectrum;
using spectral::SpectrumKind;
using spectral::Texture;
using spectral::TextureSamples;

/// Attributes of one file, which may be somebody's own.
class Header {
public:
    Header(const LoadedImage& loaded, const std::string& file) : loaded_(loaded), file_(file) {}

    [[nodiscard]] std::string text(const std::string& name) const
    {
        const auto found = loaded_.attributes.find("nacre:" + name);
        if (found == loaded_.attributes.end()) return {};
        const auto* value = std::get_if<std::string>(&found->second);
        return value ? *value : std::string();
    }

    /// A whole number in [1, kMaxSpectra]; nothing where there is no such attribute.
    [[nodiscard]] std::optional<std::size_t> count(const std::string& name) const
    {
        const auto found = loaded_.attributes.find("nacre:" + name);
        if (found == loaded_.attributes.end()) return std::nullopt;
        const auto* number = std::get_if<int>(&found->second);
        const json value =
            number ? json(*number) : json::parse(text(name), nullptr, /*allow_exceptions=*/false);
        if (!value.is_number_integer() || value < 1 || value > kMaxSpectra)
            fail(name, fmt::format("must be a whole number in [1, {}]", kMaxSpectra));
        return value.get<std::size_t>();
    }

    /// One for each of `wanted`; empty where there is no such attribute.
    template <class Value>
    [[nodiscard]] std::vector<Value> list(const std::string& name, std::size_t wanted) const
    {
        if (!loaded_.attributes.contains("nacre:" + name)) return {};
        try {
            auto values = json::parse(text(name)).get<std::vector<Value>>();
            if (values.size() == wanted) return values;
        } catch (const json::exception&) {
            // The message below says what is wanted.
        }
        fail(name, fmt::format("must be a JSON array of {}", wanted));
    }

    [[noreturn]] void fail(const std::string& name, std::string message) const
    {
        throw InputError({file_, 0, "nacre:" + name, std::move(message)});
    }

private:
    const LoadedImage& loaded_;
    const std::string& file_;
};

Texture texture_of(const Image& image)
{
    return {.width = image.width,
            .height = image.height,
            .channels = static_cast<int>(image.channel_count()),
            .texels = image.pixels};
}

NamedSpectrum spectrum_of(std::string name, const TextureSamples& samples, double maximum,
                          std::optional<SpectrumKind> kind)
{
    std::vector<double> values(samples.begin(), samples.end());
    for (double& value : values) value *= maximum;
    return named_spectrum(std::move(name), spectral::kTextureFirstNm, std::move(values), kind);
}

std::optional<SpectrumKind> kind_from(const std::string& name)
{
    for (const auto kind : {SpectrumKind::emission, SpectrumKind::reflectance})
        if (name == spectral::spectrum_kind_name(kind)) return kind;
    return std::nullopt;
}

/// What all kinds of textures say of each of their spectra.
struct Labels {
    std::vector<std::string> names, kinds;
    std::vector<double> maximum;

    Labels(const Header& header, std::size_t count)
        : names(header.list<std::string>("names", count)),
          kinds(header.list<std::string>("kinds", count)),
          maximum(header.list<double>("maximum", count))
    {
        if (names.empty())
            for (std::size_t i = 0; i < count; ++i) names.push_back(fmt::format("{}", i + 1));
        if (kinds.empty()) kinds.assign(count, "");
        if (maximum.empty()) maximum.assign(count, 1.0);
    }
};

std::vector<NamedSpectrum> of_spectra(const LoadedImage& loaded, const Header& header,
                                      const std::string& layout_name)
{
    using spectral::SpectrumLayout;
    const auto layout = layout_name == "single" ? SpectrumLayout::single : SpectrumLayout::packed;
    const std::size_t width = spectral::texels_per_spectrum(layout);
    const auto columns = header.count("columns").value_or(
        std::max<std::size_t>(static_cast<std::size_t>(loaded.image.width) / width, 1));
    const std::size_t count = header.count("count").value_or(
        std::min(columns * static_cast<std::size_t>(loaded.image.height), kMaxSpectra));
    const Labels labels(header, count);
    const auto samples = spectral::unpack_spectra(texture_of(loaded.image), layout, columns, count);
    std::vector<NamedSpectrum> spectra;
    for (std::size_t i = 0; i < count; ++i)
        spectra.push_back(spectrum_of(labels.names[i], samples[i], labels.maximum[i],
                                      kind_from(labels.kinds[i])));
    return spectra;
}

std::vector<NamedSpectrum> of_materials(const LoadedImage& loaded, const Header& header)
{
    Texture texture = texture_of(loaded.image);
    const auto count = static_cast<std::size_t>(texture.height);
    const Labels labels(header, count);
    // Bytes hold no limits above 1: they are in the attribute.
    const auto limits = header.list<std::vector<double>>("limits", count);
    for (std::size_t row = 0; row < limits.size(); ++row) {
        if (limits[row].size() != 4 || texture.width <= 513 || texture.channels != 4)
            header.fail("limits", "must be n min, n max, k min, k max of each row of RGBA");
        std::ranges::transform(limits[row], texture.at(spectral::kTextureSamples + 1, row),
                               [](double v) { return static_cast<float>(v); });
    }
    const auto materials = spectral::unpack_materials(texture);
    std::vector<NamedSpectrum> spectra;
    for (std::size_t i = 0; i < count; ++i) {
        const std::string& name = labels.names[i];
        spectra.push_back(spectrum_of(name + " reflectance", materials[i].intensity,
                                      labels.maximum[i], SpectrumKind::reflectance));
        spectra.push_back(spectrum_of(name + " n", materials[i].n, 1.0, std::nullopt));
        spectra.push_back(spectrum_of(name + " k", materials[i].k, 1.0, std::nullopt));
    }
    return spectra;
}

std::vector<NamedSpectrum> of_lights(const LoadedImage& loaded, const Header& header)
{
    const std::size_t count =
        header.count("count").value_or(4 * static_cast<std::size_t>(loaded.image.height));
    const Labels labels(header, count);
    const auto lights = spectral::unpack_lights(texture_of(loaded.image), count);
    std::vector<NamedSpectrum> spectra;
    for (std::size_t i = 0; i < count; ++i)
        spectra.push_back(spectrum_of(labels.names[i], lights[i].power, labels.maximum[i],
                                      SpectrumKind::emission));
    return spectra;
}

std::vector<NamedSpectrum> of_matching_functions(const LoadedImage& loaded, const Header& header)
{
    const Image& image = loaded.image;
    if (image.width != static_cast<int>(spectral::kWavelengths) || image.channel_count() < 3)
        header.fail("quantity", fmt::format("colour_matching_functions must be {} texels of RGB",
                                            spectral::kWavelengths));
    auto maximum = header.list<double>("maximum", 3);
    if (maximum.empty()) maximum.assign(3, 1.0);
    std::vector<NamedSpectrum> spectra;
    for (const std::size_t channel : {0U, 1U, 2U}) {
        std::vector<double> values;
        for (std::size_t i = 0; i < spectral::kWavelengths; ++i)
            values.push_back(maximum[channel] * image.pixels[i * image.channel_count() + channel]);
        spectra.push_back(named_spectrum(std::string(1, "xyz"[channel]), spectral::kFirstNm,
                                         std::move(values), std::nullopt));
    }
    return spectra;
}

/// Channels of one kind, by wavelength.
using ChannelMap = std::map<double, std::size_t>;

NamedSpectrum spectrum_of_pixel(const Image& image, std::size_t pixel, const ChannelMap& channels,
                                SpectrumKind kind)
{
    std::vector<double> wavelengths, values;
    for (const auto& [nm, channel] : channels) {
        wavelengths.push_back(nm);
        values.push_back(image.pixels[pixel * image.channel_count() + channel]);
    }
    NamedSpectrum spectrum = named_spectrum({}, 1.0, {0.0, 0.0}, kind);
    spectrum.samples = {std::move(wavelengths), std::move(values)};
    return spectrum;
}

std::map<SpectrumKind, ChannelMap> spectral_channels(const Image& image, const std::string& file)
{
    std::map<SpectrumKind, ChannelMap> kinds;
    for (std::size_t i = 0; i < image.channel_count(); ++i)
        if (const auto channel = spectral::parse_spectral_channel(image.channels[i]))
            kinds[channel->kind].emplace(channel->wavelength_nm, i);
    for (const auto& [kind, channels] : kinds)
        if (channels.size() < 2)
            throw InputError({file, 0, "", "must have channels of two wavelengths or more"});
    return kinds;
}

std::vector<NamedSpectrum> of_pixels(const Image& image, const std::vector<Pixel>& pixels,
                                     const std::string& file)
{
    const auto kinds = spectral_channels(image, file);
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<NamedSpectrum> spectra;
    for (const Pixel& pixel : pixels) {
        if (pixel.x >= width || pixel.y >= static_cast<std::size_t>(image.height))
            throw InputError({file, 0, "--pixel",
                              fmt::format("must be within 0 … {}, 0 … {} (got {},{})", width - 1,
                                          image.height - 1, pixel.x, pixel.y)});
        for (const auto& [kind, channels] : kinds) {
            spectra.push_back(spectrum_of_pixel(image, pixel.y * width + pixel.x, channels, kind));
            spectra.back().name = fmt::format("{} {}", pixel.x, pixel.y);
        }
    }
    if (spectra.empty()) throw InputError({file, 0, "--pixel", "belongs to a spectral image"});
    return spectra;
}

/// Nothing where no channel has the name of a wavelength.
std::vector<NamedSpectrum> of_spectral_channels(const LoadedImage& loaded, const Header& header,
                                                const std::string& file)
{
    const Image& image = loaded.image;
    const auto kinds = spectral_channels(image, file);
    std::vector<NamedSpectrum> spectra;
    if (kinds.empty()) return spectra;
    const std::size_t pixels = image.pixels.size() / image.channel_count();
    const std::size_t count = header.count("count").value_or(pixels);
    if (count * kinds.size() > kMaxSpectra || count > pixels)
        throw InputError({file, 0, "",
                          fmt::format("has {} spectra, one a pixel; all of them can be read where "
                                      "there are at most {}, one by nacre info --spectra OUT "
                                      "--pixel X,Y",
                                      pixels * kinds.size(), kMaxSpectra)});
    const auto names = header.list<std::string>("names", count);
    for (const auto& [kind, channels] : kinds)
        for (std::size_t i = 0; i < count; ++i) {
            spectra.push_back(spectrum_of_pixel(image, i, channels, kind));
            spectra.back().name = names.empty() ? fmt::format("{}", i + 1) : names[i];
        }
    return spectra;
}

std::vector<NamedSpectrum> of_unlabelled(const LoadedImage& loaded, const Header& header,
                                         const std::string& file)
{
    const Image& image = loaded.image;
    auto spectra = of_spectral_channels(loaded, header, file);
    if (!spectra.empty()) return spectra;
    constexpr int kPackedWidth = spectral::kTextureSamples / 4;
    if (image.channel_count() == 4 && image.width % kPackedWidth == 0)
        return of_spectra(loaded, header, "packed");
    throw InputError(
        {file, 0, "",
         fmt::format("is not a texture of spectra: it has no attribute nacre:quantity, no channels "
                     "such as T.550,000000nm, and is not RGBA of a width of n x {} (got {} x {})",
                     kPackedWidth, image.width, image.channel_count())});
}

}  // namespace

std::vector<NamedSpectrum> spectra_of_image(const LoadedImage& loaded, const std::string& file,
                                            const std::vector<Pixel>& pixels)
{
    if (!pixels.empty()) return of_pixels(loaded.image, pixels, file);
    const Header header(loaded, file);
    const std::string quantity = header.text("quantity");
    try {
        if (quantity == "spectra" && header.text("layout") != "image")
            return of_spectra(loaded, header, header.text("layout"));
        if (quantity == "materials") return of_materials(loaded, header);
        if (quantity == "lights") return of_lights(loaded, header);
        if (quantity == "colour_matching_functions") return of_matching_functions(loaded, header);
        return of_unlabelled(loaded, header, file);
    } catch (const InputError& error) {
        std::vector<Diagnostic> problems(error.diagnostics().begin(), error.diagnostics().end());
        for (Diagnostic& problem : problems) problem.file = file;
        throw InputError(std::move(problems));
    }
}

}  // namespace nacre::tool
