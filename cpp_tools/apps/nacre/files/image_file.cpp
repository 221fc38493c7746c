// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "files/image_file.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "modules/image_codec.h"
#include "modules/module_loader.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/textures/texture.h"

namespace nacre::tool {
namespace {

std::string encode_ftxt(const Image& image, const Attributes& attributes)
{
    spectral::TextTexture content{{.width = image.width,
                                   .height = image.height,
                                   .channels = static_cast<int>(image.channel_count()),
                                   .texels = image.pixels},
                                  {}};
    for (const auto& [name, value] : attributes) {
        const auto* text = std::get_if<std::string>(&value);
        const auto* number = std::get_if<int>(&value);
        content.comments[name] = text     ? *text
                                 : number ? std::to_string(*number)
                                          : nlohmann::json(std::get<2>(value)).dump();
    }
    return spectral::write_ftxt(content);
}

LoadedImage load_ftxt(const std::filesystem::path& file)
{
    spectral::TextTexture content = spectral::read_ftxt(read_text(file), file.string());
    LoadedImage loaded;
    loaded.image = {content.texture.width,
                    content.texture.height,
                    {"R", "G", "B", "A"},
                    std::move(content.texture.texels)};
    loaded.format = "ftxt";
    loaded.depth = "float";
    for (auto& [name, value] : content.comments) loaded.attributes[name] = std::move(value);
    return loaded;
}

}  // namespace

Encoding encoding_for(const std::filesystem::path& file, const std::string& depth)
{
    struct Rule {
        std::string_view extension;
        Container container;
        std::vector<std::string_view> depths;  ///< the first by default
    };
    static const std::vector<Rule> kRules = {{".exr", Container::exr, {"float", "half"}},
                                             {".tx", Container::tx, {"float", "half"}},
                                             {".png", Container::png, {"byte"}},
                                             {".ftxt", Container::ftxt, {"float"}}};
    const std::string extension = file.extension().string();
    const auto rule = std::ranges::find(kRules, extension, &Rule::extension);
    if (rule == kRules.end())
        throw InputError({file.string(), 0, "-o",
                          "must end in .exr, .tx (float, half), .ftxt (float) or .png (byte)"});
    const std::string_view chosen = depth.empty() ? rule->depths.front() : depth;
    if (std::ranges::find(rule->depths, chosen) == rule->depths.end())
        throw InputError({file.string(), 0, "--depth",
                          fmt::format("must be {} for {} (got {})", fmt::join(rule->depths, " or "),
                                      extension, chosen)});
    return {rule->container, chosen == "byte"   ? Depth::byte
                             : chosen == "half" ? Depth::half
                                                : Depth::floating};
}

std::string encode_image(const Image& image, const Attributes& attributes, const Encoding& encoding)
{
    if (encoding.container == Container::ftxt) return encode_ftxt(image, attributes);
    const ImageCodec& codec = loaded_module<ImageCodec>();
    try {
        return codec.encode(image, attributes, encoding);
    } catch (const std::runtime_error& error) {
        throw InputError({"", 0, "", fmt::format("the image cannot be encoded: {}", error.what())});
    }
}

LoadedImage read_image(const std::filesystem::path& file, AlphaMeaning alpha)
{
    // A missing file or a folder gets the message that it gets everywhere.
    if (!std::filesystem::is_regular_file(file)) (void)read_text(file);
    if (file.extension() == ".ftxt") return load_ftxt(file);
    const ImageCodec& codec = loaded_module<ImageCodec>();
    try {
        return codec.decode(file.string(), alpha);
    } catch (const std::runtime_error& error) {
        throw InputError({file.string(), 0, "", error.what()});
    }
}

std::string text_attribute(const LoadedImage& loaded, const char* name)
{
    const auto found = loaded.attributes.find(name);
    const auto* text =
        found == loaded.attributes.end() ? nullptr : std::get_if<std::string>(&found->second);
    return text ? *text : "";
}

void round_to_half(std::vector<float>& values)
{
    loaded_module<ImageCodec>().round_to_half(values);
}

void round_to(Depth depth, std::vector<float>& values)
{
    if (depth == Depth::half) round_to_half(values);
    if (depth == Depth::byte)
        for (float& value : values)
            value = std::round(std::clamp(value, 0.0F, 1.0F) * 255.0F) / 255.0F;
}

}  // namespace nacre::tool
