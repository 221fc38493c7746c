// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>
#include <CLI/CLI.hpp>

#include "colour/target.h"
#include "develop/exchange.h"
#include "develop/regions.h"
#include "develop/spectral_picture.h"
#include "files/output.h"
#include "files/spectrum_input.h"
#include "library/plot.h"
#include "nacre/bands/response.h"
#include "nacre/bands/viewer.h"
#include "nacre/core/diagnostics.h"
#include "plot/colours.h"
#include "shared/session.h"
#include "tables/texture.h"

namespace nacre::tool {
namespace {

using bands::summed;
using spectral::Vec3;

constexpr const char* kDevelopHelp = R"(
From a picture with a channel for each band, as render --spectral writes it, to colours: for other
eyes or a camera, with another white, and under other lamps than it was rendered with.

  nacre develop shop.exr --exposure 1 -o brighter.png
  nacre develop shop.exr --observer cie1964 --space lin_ap1_scene -o shop_acescg.exr
  nacre develop shop.exr --camera nikon-d5100 --white A -o photograph.png
Another lamp, exactly as if it had been there; of a scene with light groups each its own:
  nacre develop shop.exr --light F11 -o under_f11.exr
  nacre develop shop.exr --light Ceiling=lamp/hps --strength Window=0.2 -o evening.exr
Spectra of places, and how far two of them fall apart under other lamps:
  nacre develop shop.exr --region 40,30,8,8 --spectra wall.csv --plot wall.svg
  nacre develop shop.exr --region 40,30,8,8 --region 90,30,8,8 --under A --under F11

LIGHT is a name of `nacre library list --kind illuminants`, a light of the library, blackbody:3200,
daylight:5600 or line:589.3; the new one is as bright as the one before.)";

struct DevelopOptions {
    std::string file, output, observer, camera, white, white_at, adaptation = "bradford", spectra,
                                                                 plot;
    bool raw = false;
    double exposure = 0.0;
    std::vector<std::string> lights, strengths, regions, under;
    ColourTargetOptions colour;
};

spectral::Camera camera_from(const std::string& text)
{
    if (!std::filesystem::exists(text)) return spectral::camera(text);
    spectral::Camera camera{.name = text, .sensitivity = {}};
    for (const spectral::NamedSpectrum& spectrum :
         read_spectra_file(text, {}, {.kind = spectral::SpectrumKind::emission, .scale = {}}))
        camera.sensitivity.push_back(spectrum.samples);
    if (camera.sensitivity.size() != 3)
        throw InputError({text, 0, "",
                          fmt::format("must have three columns, the sensitivities of red, green "
                                      "and blue (got {})",
                                      camera.sensitivity.size())});
    return camera;
}

bands::Viewer viewer_from(const DevelopOptions& options, const SpectralPicture& picture,
                          const Mixture& mixture)
{
    bands::Viewer viewer{.observer = picture.bands.observer,
                         .camera = {},
                         .raw = options.raw,
                         .white = {},
                         .adaptation = spectral::adaptation_from_name(options.adaptation),
                         .exposure = options.exposure};
    if (!options.observer.empty()) viewer.observer = spectral::observer_from_name(options.observer);
    if (!options.camera.empty()) viewer.camera = camera_from(options.camera);
    if (!options.white.empty())
        viewer.white = bands::light_in_bands(picture.bands, bands::named_light(options.white));
    if (!options.white_at.empty()) {
        const Region region = region_from(options.white_at, "--white-at", picture);
        viewer.white = mean_radiance(picture, mixture, region);
    }
    return viewer;
}

std::vector<Vec3> colours_in(const spectral::ColourSpace& space, const bands::Bands& bands,
                             const bands::Viewer& viewer, const DevelopOptions& options)
{
    try {
        std::vector<Vec3> colours = colours_of_bands(bands, viewer, kWithoutCat);
        if (!viewer.raw)
            for (Vec3& colour : colours) colour = multiply(space.from_xyz_d65, colour);
        return colours;
    } catch (const InputError& error) {
        // Of what was asked for, white alone can be wrong.
        throw InputError({{},
                          0,
                          options.white_at.empty() ? "--white" : "--white-at",
                          error.diagnostics().front().message});
    }
}

/// R, G, B, and A where the picture has it.
Image developed(const SpectralPicture& picture, const Mixture& mixture,
                const std::vector<Vec3>& colours)
{
    const auto found = std::ranges::find(picture.image.channels, "A");
    const bool has_alpha = found != picture.image.channels.end();
    const auto alpha = static_cast<std::size_t>(found - picture.image.channels.begin());
    Image result{picture.image.width, picture.image.height, {"R", "G", "B"}, {}};
    if (has_alpha) result.channels.emplace_back("A");
    const std::size_t channels = result.channel_count();
    const auto width = static_cast<std::size_t>(result.width);
    const auto height = static_cast<std::size_t>(result.height);
    result.pixels.resize(width * height * channels);
    tbb::parallel_for(std::size_t{0}, height, [&](std::size_t y) {
        for (std::size_t x = 0; x < width; ++x) {
            const float* from = picture.pixel(x, y);
            float* to = result.pixels.data() + (y * width + x) * channels;
            const Vec3 colour = summed(mixture.radiance(picture, from), colours);
            for (std::size_t c = 0; c < 3; ++c) to[c] = static_cast<float>(colour[c]);
            if (has_alpha) to[3] = from[alpha];
        }
    });
    return result;
}

/// As a screen has it: sRGB, not multiplied by A.
void encode_for_screens(Image& image, const spectral::ColourSpace& space)
{
    const spectral::Mat3 to_screen = spectral::multiply(
        spectral::colour_space("lin_rec709_scene").from_xyz_d65, space.to_xyz_d65);
    const std::size_t channels = image.channel_count();
    for (std::size_t at = 0; at < image.pixels.size(); at += channels) {
        float* pixel = image.pixels.data() + at;
        const double alpha = channels > 3 ? double{pixel[3]} : 1.0;
        Vec3 rgb = multiply(to_screen, Vec3{pixel[0], pixel[1], pixel[2]});
        for (double& value : rgb) value = alpha > 0.0 ? value / alpha : 0.0;
        const Paint paint = screen_paint(rgb);
        pixel[0] = static_cast<float>(paint.red);
        pixel[1] = static_cast<float>(paint.green);
        pixel[2] = static_cast<float>(paint.blue);
    }
}

void write_picture(const DevelopOptions& options, Image image, const spectral::ColourSpace& space)
{
    const Encoding encoding = encoding_for(options.output, "");
    Attributes attributes;
    if (encoding.container == Container::png) {
        encode_for_screens(image, space);
    } else if (!options.raw) {
        attributes["nacre:space"] = space.name;
        if (space.chromaticities)
            attributes["chromaticities"] =
                std::vector<float>(space.chromaticities->begin(), space.chromaticities->end());
    }
    write_text_output(options.output, encode_image(image, attributes, encoding));
}

void check(const DevelopOptions& options)
{
    const auto refuse = [](const char* option, const char* message) {
        throw InputError({{}, 0, option, message});
    };
    if (options.output.empty() && options.regions.empty())
        refuse("-o", "is missing: say where the picture goes, or --region for what is somewhere");
    if (!std::isfinite(options.exposure)) refuse("--exposure", "must be a number of stops");
    if (!options.white.empty() && !options.white_at.empty())
        refuse("--white-at", "and --white are one too many: white is one light");
    if (!options.camera.empty() && !options.observer.empty())
        refuse("--camera", "takes the place of an eye: leave --observer out");
    if (options.raw && options.camera.empty()) refuse("--raw", "is of a --camera");
    if (!options.under.empty() && options.regions.size() != 2)
        refuse("--under", "compares two places: --region twice");
    if (options.regions.empty() && !(options.spectra.empty() && options.plot.empty()))
        refuse("--spectra", "and --plot are of a --region");
    if (options.output == "-") refuse("-o", "must be a file, .exr or .png");
    for (const std::string& file : {options.output, options.spectra, options.plot})
        if (!file.empty()) check_writable(file);
    if (!options.output.empty()) static_cast<void>(encoding_for(options.output, ""));
    if (!options.plot.empty()) check_plot_file(options.plot);
}

int develop(const Session& session, const DevelopOptions& options)
{
    check(options);
    const spectral::ColourSpace space = linear_space(resolve_colour_target(options.colour));
    const SpectralPicture picture = read_spectral_picture(options.file);
    const Mixture mixed = mixture(picture, options.lights, options.strengths);
    const std::vector<Vec3> colours =
        colours_in(space, picture.bands, viewer_from(options, picture, mixed), options);
    std::vector<Place> places;
    std::vector<spectral::NamedSpectrum> spectra;
    for (const std::string& text : options.regions) {
        const Region region = region_from(text, "--region", picture);
        Place place{text, region, mean_radiance(picture, mixed, region), {}};
        place.rgb = summed(place.radiance, colours);
        spectra.push_back(spectrum_of(place, picture));
        places.push_back(std::move(place));
    }
    std::string said;
    if (!places.empty()) said = report(session.json, places, picture, mixed, options.under, space);
    if (!options.output.empty()) write_picture(options, developed(picture, mixed, colours), space);
    if (!options.spectra.empty()) write_text_output(options.spectra, spectra_csv(spectra));
    if (!options.plot.empty()) write_plot(options.plot, plot_of_places(spectra, options.file));
    if (!said.empty()) write_text_output("", said);
    return kExitOk;
}

}  // namespace

void add_develop(CLI::App& app, Session& session)
{
    const auto options = std::make_shared<DevelopOptions>();
    CLI::App* command = app.add_subcommand("develop", "colours of a spectral picture");
    command->fallthrough()->footer(kDevelopHelp);
    command->add_option("FILE", options->file, "a spectral .exr")->required();
    command->add_option("-o,--output", options->output, "the picture, .exr or .png (sRGB)")
        ->type_name("FILE");
    command->add_option("--observer", options->observer,
                        "cie1931 or cie1964 (default: that of the file)");
    command->add_option("--camera", options->camera,
                        fmt::format("{}, or a CSV of wavelengths and three sensitivities",
                                    fmt::join(spectral::camera_keys(), ", ")));
    command->add_flag("--raw", options->raw,
                      "the camera's own channels, white balanced, in no space");
    command
        ->add_option("--white", options->white,
                     "what is white: a light (default: nothing is adapted to)")
        ->type_name("LIGHT");
    command->add_option("--white-at", options->white_at, "a place of the picture that is white")
        ->type_name("X,Y[,W,H]");
    add_adaptation_option(*command, options->adaptation);
    command->add_option("--exposure", options->exposure, "in stops")->capture_default_str();
    command->add_option("--light", options->lights, "what the lamps are, or those of a light group")
        ->type_name("[GROUP=]LIGHT");
    command->add_option("--strength", options->strengths, "how much of a light group there is")
        ->type_name("GROUP=FACTOR");
    command
        ->add_option("--region", options->regions,
                     "print colour and spectrum of a pixel, or the mean of a rectangle")
        ->type_name("X,Y[,W,H]");
    command->add_option("--spectra", options->spectra, "spectra of regions as CSV")
        ->type_name("FILE");
    command->add_option("--plot", options->plot, "spectra of regions, .svg or .png")
        ->type_name("FILE");
    command
        ->add_option("--under", options->under,
                     "how far apart two regions are under a light, and whether they would be if "
                     "they were alike before")
        ->type_name("LIGHT");
    add_colour_target_options(*command, options->colour);
    command->callback([&session, options] {
        session.run = [&session, options] { return develop(session, *options); };
    });
}

}  // namespace nacre::tool
