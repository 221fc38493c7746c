// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "tables/texture.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "files/spectrum_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/limits.h"
#include "nacre/core/version.h"
#include "nacre/textures/spectrum_texture.h"
#include "shared/session.h"
#include "tables/image.h"

namespace nacre::tool {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;
using spectral::NamedSpectrum;

/// Largest difference from what is meant, and the same over the largest value of the spectrum.
struct ReadError {
    double max = 0.0, relative = 0.0;
};

ReadError read_error(const Image& image, const Attributes& attributes, Depth depth,
                     const std::vector<NamedSpectrum>& exact)
{
    LoadedImage stored{.image = image, .format = {}, .depth = {}, .attributes = attributes};
    round_to(depth, stored.image.pixels);
    const auto spectra = spectra_of_image(stored, "");
    ReadError error;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const auto wanted = exact[i].values_at(spectra[i].samples.wavelengths_nm());
        double off = 0.0, largest = 0.0;
        for (std::size_t j = 0; j < wanted.size(); ++j) {
            off = std::max(off, std::abs(spectra[i].samples.values()[j] - wanted[j]));
            largest = std::max(largest, std::abs(wanted[j]));
        }
        error.max = std::max(error.max, off);
        if (largest > 0.0) error.relative = std::max(error.relative, off / largest);
    }
    return error;
}

/// @throws InputError where the depth ends before the values do
void require_finite(const Image& image, Depth depth, const std::string& output)
{
    std::vector<float> stored = image.pixels;
    round_to(depth, stored);
    for (std::size_t i = 0; i < stored.size(); ++i) {
        if (std::isfinite(stored[i])) continue;
        const bool half = depth == Depth::half && std::isfinite(image.pixels[i]);
        throw InputError(
            {output, 0, "--depth",
             half ? fmt::format("must be float: half ends at 65504 (got {:g})", image.pixels[i])
                  : "holds values of up to 3.4e38; a .csv holds larger ones"});
    }
}

std::string cell_text(std::string text)
{
    std::ranges::replace_if(
        text, [](char c) { return c == ',' || c == ';' || c == '\t' || c == '\n' || c == '"'; },
        ' ');
    return text;
}

}  // namespace

std::string label_of(const NamedSpectrum& spectrum)
{
    return spectrum.key.empty() ? spectrum.name : spectrum.key;
}

Attributes texture_attributes(const std::string& quantity)
{
    const lut::Axis axis{"wavelength", "nm", spectral::kTextureFirstNm,
                         spectral::texture_wavelength_nm(spectral::kTextureSamples - 1),
                         static_cast<int>(spectral::kTextureSamples)};
    return {{"nacre:schema", kTableSchema},    {"nacre:version", std::string(version())},
            {"nacre:axes", axes_json({axis})}, {"nacre:quantity", quantity},
            {"colorInteropID", "data"},        {"wrapmodes", "clamp,clamp"}};
}

void describe_spectra(Attributes& attributes, const std::vector<NamedSpectrum>& spectra)
{
    json names = json::array(), kinds = json::array();
    std::set<std::string> references;
    for (const NamedSpectrum& spectrum : spectra) {
        names.push_back(label_of(spectrum));
        kinds.push_back(spectrum.kind ? spectrum_kind_name(*spectrum.kind) : "");
        if (!spectrum.references.empty()) references.insert(spectrum.references);
    }
    attributes["nacre:names"] = names.dump();
    attributes["nacre:kinds"] = kinds.dump();
    if (!references.empty()) attributes["nacre:references"] = json(references).dump();
}

Image image_of(spectral::Texture texture)
{
    std::vector<std::string> channels = {"R", "G", "B", "A"};
    if (texture.channels == 1) channels = {"Y"};
    return {texture.width, texture.height, std::move(channels), std::move(texture.texels)};
}

void write_texture(const Session& session, const std::string& output, const Image& image,
                   Attributes attributes, const Encoding& encoding,
                   const std::vector<NamedSpectrum>& spectra)
{
    require_finite(image, encoding.depth, output);
    const ReadError error = read_error(image, attributes, encoding.depth, spectra);
    attributes["nacre:error"] =
        ordered_json{{"max", error.max}, {"relative", error.relative}}.dump();
    // A PNG keeps text only.
    if (encoding.depth == Depth::byte)
        for (auto& [name, value] : attributes)
            if (const auto* number = std::get_if<int>(&value)) value = std::to_string(*number);
    write_text_output(output, encode_image(image, attributes, encoding));
    const std::string figure =
        fmt::format("values are off by up to {:.2g}, {:.3g} % of the largest of their spectrum",
                    error.max, 100.0 * error.relative);
    constexpr double kHalfUnit = 0x1p-11;
    if (encoding.depth == Depth::byte)
        session.note(fmt::format("{}: 8 bits a number: {}", output, figure));
    else if (encoding.depth == Depth::half && error.relative > 1.01 * kHalfUnit)
        session.note(fmt::format("{}: half is coarse below 6e-5: {}", output, figure));
    else
        session.detail(fmt::format("{}: {}", output, figure));
}

namespace {

/// Those of all spectra; where they differ every whole nanometre between them as well, so that the
/// interpolation of a reader does not alter what was sampled more coarsely.
std::vector<double> shared_wavelengths(const std::vector<NamedSpectrum>& spectra)
{
    std::set<double> wavelengths;
    bool differ = false;
    for (const NamedSpectrum& spectrum : spectra) {
        const auto& own = spectrum.samples.wavelengths_nm();
        differ = differ || own != spectra.front().samples.wavelengths_nm();
        wavelengths.insert(own.begin(), own.end());
    }
    const double first = differ ? *wavelengths.begin() : 0.0;
    const double last = differ ? *wavelengths.rbegin() : 0.0;
    if (last - first < static_cast<double>(kMaxSamples))
        for (double nm = std::ceil(first); nm < last; nm += 1.0) wavelengths.insert(nm);
    return {wavelengths.begin(), wavelengths.end()};
}

}  // namespace

std::string spectra_csv(const std::vector<NamedSpectrum>& spectra, const std::string& comments)
{
    std::string text = comments.empty() ? std::string() : fmt::format("# COMMENTS: {}\n", comments);
    text += "wavelength_nm";
    for (const NamedSpectrum& spectrum : spectra) text += "," + cell_text(label_of(spectrum));
    text += "\n";
    const std::vector<double> rows = shared_wavelengths(spectra);
    std::vector<std::vector<double>> columns;
    columns.reserve(spectra.size());
    for (const NamedSpectrum& spectrum : spectra) columns.push_back(spectrum.values_at(rows));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        fmt::format_to(std::back_inserter(text), "{}", rows[i]);
        for (const auto& column : columns)
            fmt::format_to(std::back_inserter(text), ",{}", column[i]);
        text += "\n";
    }
    return text;
}

}  // namespace nacre::tool
