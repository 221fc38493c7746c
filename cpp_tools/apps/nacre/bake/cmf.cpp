// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "files/spectrum_input.h"
#include "nacre/core/version.h"
#include "nacre/spectral/observer.h"
#include "shared/session.h"
#include "tables/image.h"
#include "tables/texture.h"

namespace nacre::tool {
namespace {

struct CmfOptions {
    std::string output, depth, observer = "cie1931", maximum = "global";
};

constexpr const char* kBakeCmfHelp = R"(
One row of 471 texels, 360 … 830 nm at 1 nm: R = x̄, G = ȳ, B = z̄. Bytes hold the values divided by
the maximum, which the attribute nacre:maximum gives for R, G and B.

  nacre bake cmf -o cmf.exr
  nacre bake cmf --observer cie1964 --maximum channel -o cmf_bytes.png
  nacre bake cmf -o cmf.ftxt)";

/// Largest value of each channel, or of all of them three times.
std::vector<float> maxima(const spectral::Observer& observer, bool global)
{
    std::vector<float> result;
    for (const auto* curve : {&observer.x, &observer.y, &observer.z})
        result.push_back(static_cast<float>(*std::max_element(curve->begin(), curve->end())));
    if (global) result.assign(3, *std::max_element(result.begin(), result.end()));
    return result;
}

Image cmf_image(const spectral::Observer& observer, const std::vector<float>& divisors)
{
    Image image{static_cast<int>(spectral::kWavelengths), 1, {"R", "G", "B"}, {}};
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i) {
        image.pixels.push_back(static_cast<float>(observer.x[i]) / divisors[0]);
        image.pixels.push_back(static_cast<float>(observer.y[i]) / divisors[1]);
        image.pixels.push_back(static_cast<float>(observer.z[i]) / divisors[2]);
    }
    return image;
}

/// As they are, for comparing with what a file holds of them.
std::vector<spectral::NamedSpectrum> exact_spectra(const spectral::Observer& observer)
{
    std::vector<spectral::NamedSpectrum> spectra;
    for (const auto& [name, curve] :
         {std::pair{"x", &observer.x}, {"y", &observer.y}, {"z", &observer.z}})
        spectra.push_back(
            named_spectrum(name, spectral::kFirstNm, {curve->begin(), curve->end()}, std::nullopt));
    return spectra;
}

int bake(const Session& session, const CmfOptions& options)
{
    const auto exact =
        exact_spectra(spectral::observer(spectral::observer_from_name(options.observer)));
    if (std::filesystem::path(options.output).extension() == ".csv") {
        write_text_output(options.output, spectra_csv(exact));
        return kExitOk;
    }
    const Encoding encoding = encoding_for(options.output, options.depth);
    const auto id = spectral::observer_from_name(options.observer);
    const spectral::Observer& observer = spectral::observer(id);
    const lut::Axis axis{"wavelength", "nm", spectral::kFirstNm, spectral::kLastNm,
                         static_cast<int>(spectral::kWavelengths)};
    // Text, because it is all that a PNG keeps.
    Attributes attributes{
        {"nacre:schema", kTableSchema},       {"nacre:version", std::string(version())},
        {"nacre:axes", axes_json({axis})},    {"nacre:quantity", "colour_matching_functions"},
        {"nacre:observer", options.observer}, {"colorInteropID", "data"},
        {"wrapmodes", "clamp,clamp"}};
    std::vector<float> divisors(3, 1.0F);
    if (encoding.depth == Depth::byte) {
        divisors = maxima(observer, options.maximum == "global");
        attributes["nacre:maximum"] = nlohmann::json(divisors).dump();
    }
    write_texture(session, options.output, cmf_image(observer, divisors), std::move(attributes),
                  encoding, exact);
    return kExitOk;
}

}  // namespace

void add_bake_cmf(CLI::App& bake_command, Session& session)
{
    const auto options = std::make_shared<CmfOptions>();
    CLI::App* cmf = bake_command.add_subcommand("cmf", "colour-matching functions as a texture");
    cmf->fallthrough()->footer(kBakeCmfHelp);
    cmf->add_option("-o,--output", options->output,
                    ".exr or .tx (float, half), .ftxt, .csv, .png (byte)")
        ->required();
    cmf->add_option("--observer", options->observer)
        ->check(CLI::IsMember({"cie1931", "cie1964"}))
        ->capture_default_str();
    cmf->add_option("--depth", options->depth, "default: float, in a PNG byte")
        ->check(CLI::IsMember({"float", "half", "byte"}));
    cmf->add_option("--maximum", options->maximum, "what bytes are divided by")
        ->check(CLI::IsMember({"global", "channel"}))
        ->capture_default_str();
    cmf->callback([&session, options] {
        session.run = [&session, options] { return bake(session, *options); };
    });
}

}  // namespace nacre::tool
