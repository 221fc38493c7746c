// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/image_file.h"
#include "files/output.h"
#include "files/spectrum_input.h"
#include "nacre/core/diagnostics.h"
#include "shared/session.h"
#include "tables/texture.h"

namespace nacre::tool {
namespace {

using nlohmann::ordered_json;

constexpr const char* kInfoHelp = R"(
  nacre info soap_film.exr
  nacre info lights.png --spectra lights.csv
  nacre info soap_film.exr --json | python3 -c 'import json, sys; print(json.load(sys.stdin)["stack"])')";

constexpr std::string_view kPrefix = "nacre:";

ordered_json attribute_json(const AttributeValue& value)
{
    if (const auto* number = std::get_if<int>(&value)) return *number;
    if (const auto* list = std::get_if<std::vector<float>>(&value)) return *list;
    // Axes, stack, error and maximum are JSON themselves.
    const auto& text = std::get<std::string>(value);
    const bool structured = text.starts_with('{') || text.starts_with('[');
    ordered_json parsed =
        structured ? ordered_json::parse(text, nullptr, false) : ordered_json(text);
    return parsed.is_discarded() ? ordered_json(text) : parsed;
}

ordered_json describe(const std::string& file, const LoadedImage& loaded)
{
    ordered_json result = {{"file", file},
                           {"format", loaded.format},
                           {"width", loaded.image.width},
                           {"height", loaded.image.height},
                           {"channels", loaded.image.channels},
                           {"depth", loaded.depth}};
    for (const auto& [name, value] : loaded.attributes)
        if (name.starts_with(kPrefix)) result[name.substr(kPrefix.size())] = attribute_json(value);
    for (const char* name : {"colorInteropID", "chromaticities", "wrapmodes"})
        if (const auto found = loaded.attributes.find(name); found != loaded.attributes.end())
            result[name] = attribute_json(found->second);
    return result;
}

std::string readable(const ordered_json& value)
{
    if (value.is_string()) return value.get<std::string>();
    return value.is_number_float() ? fmt::format("{:.6g}", value.get<double>()) : value.dump();
}

/// A member of somebody else's JSON; nothing where it is not there.
std::string member_text(const ordered_json& object, const char* name)
{
    const auto found = object.find(name);
    return found == object.end() ? "?" : readable(*found);
}

std::string axis_text(const ordered_json& axis)
{
    const std::string unit = member_text(axis, "unit");
    return fmt::format("{}, {} … {}{}", member_text(axis, "name"), member_text(axis, "min"),
                       member_text(axis, "max"), unit == "1" ? "" : " " + unit);
}

/// All of them, or where there are many the first, the last and how many.
std::string channels_text(const std::vector<std::string>& channels)
{
    constexpr std::size_t kMost = 8;
    if (channels.size() <= kMost) return fmt::format("channels {}", fmt::join(channels, " "));
    return fmt::format("{} channels {} … {}", channels.size(), channels.front(), channels.back());
}

bool is_numbers(const ordered_json& value)
{
    return value.is_array() && !value.empty() &&
           std::ranges::all_of(value, [](const ordered_json& item) { return item.is_number(); });
}

/// What the colours of a spectral picture are summed from; nothing where it is not as written here.
std::optional<std::string> bands_text(const ordered_json& bands)
{
    if (!bands.is_object() || !bands.contains("wavelength_nm") || !bands.contains("is_line"))
        return std::nullopt;
    const ordered_json &nm = bands["wavelength_nm"], &is_line = bands["is_line"];
    if (!is_numbers(nm) || !is_line.is_array() || is_line.size() != nm.size()) return std::nullopt;
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < nm.size(); ++k)
        if (is_line[k] == true) lines.push_back(fmt::format("{:.4g}", nm[k].get<double>()));
    std::string text = fmt::format("spectral picture: {} bands, {:.4g} … {:.4g} nm, seen by {}",
                                   nm.size(), nm.front().get<double>(), nm.back().get<double>(),
                                   member_text(bands, "observer"));
    if (!lines.empty()) text += fmt::format(", lines at {} nm", fmt::join(lines, ", "));
    return text + "\n";
}

/// Which light each layer of a spectral picture is of; nothing where it is not as written here.
std::optional<std::string> lights_text(const ordered_json& lights)
{
    if (!lights.is_array()) return std::nullopt;
    std::vector<std::string> parts;
    for (const ordered_json& entry : lights) {
        if (!entry.is_object() || !entry.contains("layer") || !entry.contains("light"))
            return std::nullopt;
        const std::string layer = member_text(entry, "layer"), light = member_text(entry, "light");
        parts.push_back(layer.empty() ? light : fmt::format("{} {}", layer, light));
    }
    return fmt::format("lit by {}\n", fmt::join(parts, ", "));
}

std::string text_of(const ordered_json& description)
{
    std::string text = fmt::format(
        "{}: {} x {} {}, {}, {}\n", readable(description["file"]), description["width"].get<int>(),
        description["height"].get<int>(), readable(description["depth"]),
        channels_text(description["channels"].get<std::vector<std::string>>()),
        readable(description["format"]));
    const auto bands = description.find("bands");
    const auto spectral = bands == description.end() ? std::nullopt : bands_text(*bands);
    if (spectral)
        text += *spectral;
    else if (!description.contains("schema"))
        text += "not a table of nacre: no attribute nacre:schema\n";
    for (const auto& [name, value] : description.items()) {
        if (name == "file" || name == "format" || name == "width" || name == "height" ||
            name == "channels" || name == "depth" || (name == "bands" && spectral))
            continue;
        const auto lights = name == "lights" ? lights_text(value) : std::nullopt;
        if (lights) {
            text += *lights;
        } else if (name == "axes" && value.is_array()) {
            for (const ordered_json& axis : value)
                if (axis.is_object()) text += fmt::format("axis: {}\n", axis_text(axis));
        } else {
            text += fmt::format("{}: {}\n", name, readable(value));
        }
    }
    return text;
}

struct InfoOptions {
    std::vector<std::string> files, pixels;
    std::string spectra;
};

/// `X,Y`
Pixel parse_pixel(const std::string& text)
{
    Pixel pixel{};
    const char* const end = text.data() + text.size();
    const auto x = std::from_chars(text.data(), end, pixel.x);
    if (x.ec == std::errc{} && x.ptr != end && *x.ptr == ',') {
        const auto y = std::from_chars(x.ptr + 1, end, pixel.y);
        if (y.ec == std::errc{} && y.ptr == end) return pixel;
    }
    throw InputError({{},
                      0,
                      "--pixel",
                      fmt::format("must be column and row from 0 at the top left, as in 12,7 (got "
                                  "'{}')",
                                  text)});
}

int write_spectra(const InfoOptions& options)
{
    if (options.files.size() != 1)
        throw InputError(
            {{}, 0, "--spectra", fmt::format("takes one FILE (got {})", options.files.size())});
    std::vector<Pixel> pixels;
    for (const std::string& pixel : options.pixels) pixels.push_back(parse_pixel(pixel));
    write_text_output(options.spectra,
                      spectra_csv(read_spectra_file(options.files.front(), pixels)));
    return kExitOk;
}

int describe_files(const Session& session, const std::vector<std::string>& files)
{
    ordered_json list = ordered_json::array();
    std::string text;
    for (const std::string& file : files) {
        list.push_back(describe(file, read_image(file)));
        text += text_of(list.back());
    }
    const ordered_json& result = list.size() == 1 ? list.front() : list;
    write_text_output("", session.json ? result.dump(2) + "\n" : text);
    return kExitOk;
}

}  // namespace

void add_info(CLI::App& app, Session& session)
{
    const auto options = std::make_shared<InfoOptions>();
    CLI::App* info = app.add_subcommand("info", "what is in a baked file");
    info->fallthrough()->footer(kInfoHelp);
    info->add_option("FILE", options->files,
                     "images; with --json one object, or an array for several")
        ->required();
    CLI::Option* spectra =
        info->add_option("--spectra", options->spectra,
                         "write the spectra of one texture or spectral EXR there as CSV (- is the "
                         "standard output), nothing else");
    info->add_option("--pixel", options->pixels, "X,Y: of a spectral EXR only the spectrum there")
        ->needs(spectra);
    info->callback([&session, options] {
        session.run = [&session, options] {
            return options->spectra.empty() ? describe_files(session, options->files)
                                            : write_spectra(*options);
        };
    });
}

}  // namespace nacre::tool
