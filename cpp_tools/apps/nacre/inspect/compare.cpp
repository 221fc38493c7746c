// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "inspect/image_difference.h"
#include "modules/image_codec.h"
#include "modules/module_loader.h"
#include "nacre/core/diagnostics.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;

struct CompareOptions {
    std::string a, b, heatmap, space;
    std::optional<double> max;
};

constexpr const char* kCompareHelp = R"(
Colours are scene-linear in the space that the files name, else in lin_rec709_scene; 8-bit files have
the sRGB curve. A pixel that is not finite in either image is a failure, whatever --max says.
Exit status: 0 alike, 1 wrong usage or input (also images of different size), 2 above --max.

  nacre compare new.exr reference.exr --max 0.5 --heatmap difference.png)";

/// The space that a file names, if it is one of ours.
std::string named_space(const LoadedImage& loaded)
{
    const auto names = spectral::colour_space_names();
    for (const char* attribute : {"nacre:space", "colorInteropID"}) {
        std::string name = text_attribute(loaded, attribute);
        if (std::find(names.begin(), names.end(), name) != names.end()) return name;
    }
    return "";
}

const spectral::ColourSpace& common_space(const CompareOptions& options, const LoadedImage& a,
                                          const LoadedImage& b)
{
    if (!options.space.empty()) return spectral::colour_space(options.space);
    const std::string name_a = named_space(a), name_b = named_space(b);
    if (!name_a.empty() && !name_b.empty() && name_a != name_b)
        throw InputError(
            {options.b, 0, "",
             fmt::format("must be in {} as {} is (got {})", name_a, options.a, name_b)});
    const std::string& name = name_a.empty() ? name_b : name_a;
    return spectral::colour_space(name.empty() ? "lin_rec709_scene" : name);
}

/// One channel of ΔE00 as EXR, or a picture: black 0, yellow the limit or the largest difference.
void write_heatmap(const std::string& file, const ImageDifference& difference, int width,
                   int height, double limit)
{
    const Encoding encoding = encoding_for(file, "");
    Image map{width, height, {"deltaE00"}, difference.delta_e};
    if (encoding.container != Container::png) {
        write_text_output(
            file,
            encode_image(map, {{"nacre:quantity", "dE00"}, {"colorInteropID", "data"}}, encoding));
        return;
    }
    for (float& value : map.pixels)  // not finite: as bad as can be
        value = std::isfinite(value) ? std::min(1.0F, value / static_cast<float>(limit)) : 1.0F;
    const Image picture{
        width, height, {"R", "G", "B"}, loaded_module<ImageCodec>().inferno(std::move(map.pixels))};
    write_text_output(file, encode_image(picture, {}, encoding));
}

void print_difference(const Session& session, const ImageDifference& d,
                      const spectral::ColourSpace& space)
{
    if (session.json) {
        const ordered_json result = {{"dE00", {{"mean", d.mean}, {"max", d.max}}},
                                     {"rmse", d.rmse},
                                     {"worst", {d.worst_x, d.worst_y}},
                                     {"not_finite", d.not_finite},
                                     {"space", space.name}};
        write_text_output("", result.dump() + "\n");
        return;
    }
    write_text_output(
        "", fmt::format("ΔE00 mean {:.6g}, max {:.6g} at pixel ({}, {}); RMSE {:.6g}\n", d.mean,
                        d.max, d.worst_x, d.worst_y, d.rmse));
}

int compare(const Session& session, const CompareOptions& options)
{
    if (options.max && !(*options.max >= 0.0))
        throw InputError({"", 0, "--max", fmt::format("must be ≥ 0 (got {})", *options.max)});
    const LoadedImage a = read_image(options.a), b = read_image(options.b);
    if (a.image.width != b.image.width || a.image.height != b.image.height)
        throw InputError(
            {options.b, 0, "",
             fmt::format("must be {} x {} pixels as {} is (got {} x {})", a.image.width,
                         a.image.height, options.a, b.image.width, b.image.height)});
    const spectral::ColourSpace& space = common_space(options, a, b);
    const ImageDifference difference =
        compare_pixels(linear_pixels(a), linear_pixels(b), a.image.width, space);
    if (!options.heatmap.empty()) {
        const double limit = options.max.value_or(difference.max);
        write_heatmap(options.heatmap, difference, a.image.width, a.image.height,
                      limit > 0.0 ? limit : 1.0);
    }
    print_difference(session, difference, space);
    if (difference.not_finite > 0)
        session.error(fmt::format("{} pixels are not finite", difference.not_finite));
    const bool above = options.max && difference.max > *options.max;
    if (above)
        session.error(fmt::format("ΔE00 {:.6g} is above --max {:g}", difference.max, *options.max));
    return above || difference.not_finite > 0 ? kExitCheckFailed : kExitOk;
}

}  // namespace

void add_compare(CLI::App& app, Session& session)
{
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* command = app.add_subcommand("compare", "colour difference of two images");
    command->fallthrough()->footer(kCompareHelp);
    command->add_option("A", options->a, "image")->required();
    command->add_option("B", options->b, "image of the same size")->required();
    command->add_option("--max", options->max, "largest ΔE00 of a pixel that passes");
    command->add_option("--heatmap", options->heatmap, "ΔE00 of each pixel, .exr or .png")
        ->type_name("FILE");
    command
        ->add_option("--space", options->space,
                     fmt::format("{} (default: as the files say)",
                                 fmt::join(spectral::colour_space_names(), ", ")))
        ->type_name("NAME");
    command->callback([&session, options] {
        session.run = [&session, options] { return compare(session, *options); };
    });
}

}  // namespace nacre::tool
