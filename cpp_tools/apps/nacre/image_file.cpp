// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "image_file.h"

#include <algorithm>
#include <cmath>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/spectral/texture.h"

namespace nacre::tool {
namespace {

using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

constexpr int kTile = 64;

/// Neither writing nor reading multiplies or divides by A.
constexpr const char* kUnassociated = "oiio:UnassociatedAlpha";

/// Keeps a malicious header from asking for more memory than any picture needs.
constexpr std::int64_t kMaxValues = std::int64_t{1} << 31;

TypeDesc type_of(Depth depth)
{
    if (depth == Depth::half) return TypeDesc::HALF;
    return depth == Depth::byte ? TypeDesc::UINT8 : TypeDesc::FLOAT;
}

void set_attribute(ImageSpec& spec, const std::string& name, const AttributeValue& value)
{
    if (const auto* number = std::get_if<int>(&value)) {
        spec.attribute(name, *number);
    } else if (const auto* text = std::get_if<std::string>(&value)) {
        spec.attribute(name, *text);
    } else {
        const auto& list = std::get<std::vector<float>>(value);
        spec.attribute(name, TypeDesc(TypeDesc::FLOAT, static_cast<int>(list.size())), list.data());
    }
}

ImageSpec make_spec(const Image& image, const Attributes& attributes, const Encoding& encoding)
{
    ImageSpec spec(image.width, image.height, static_cast<int>(image.channel_count()),
                   type_of(encoding.depth));
    spec.channelnames = image.channels;
    spec.attribute("DateTime", "");  // left out, OpenImageIO writes the time of day
    if (encoding.container == Container::png) {
        spec.attribute("oiio:ColorSpace", "raw");
        spec.attribute(kUnassociated, 1);
    } else {
        spec.attribute("compression",
                       encoding.compression == Compression::pxr24 ? "pxr24" : "zip");
    }
    if (encoding.container == Container::tx) {
        spec.tile_width = spec.tile_height = kTile;
        spec.attribute("textureformat", "Plain Texture");
        spec.attribute("openexr:levelmode", 0);  // one level: no mip maps
    }
    for (const auto& [name, value] : attributes) set_attribute(spec, name, value);
    return spec;
}

[[noreturn]] void throw_encoding_error(const std::string& reason)
{
    throw InputError({"", 0, "", "the image cannot be encoded: " + reason});
}

LoadedImage describe(const ImageInput& input)
{
    const ImageSpec& spec = input.spec();
    LoadedImage loaded;
    loaded.image.width = spec.width;
    loaded.image.height = spec.height;
    loaded.image.channels = spec.channelnames;
    loaded.format = input.format_name();
    loaded.depth = spec.format.c_str();
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    loaded.display_encoded = spec.format == TypeDesc::UINT8 && space != "raw" && space != "Linear";
    for (const auto& attribute : spec.extra_attribs) {
        const std::string name = attribute.name().string();
        const TypeDesc type = attribute.type();
        if (type == TypeDesc::STRING) {
            loaded.attributes[name] = attribute.get_string();
        } else if (type == TypeDesc::INT) {
            loaded.attributes[name] = attribute.get_int();
        } else if (type.basetype == TypeDesc::FLOAT) {
            const auto* first = static_cast<const float*>(attribute.data());
            loaded.attributes[name] = std::vector<float>(
                first, first + type.numelements() * static_cast<std::size_t>(type.aggregate));
        }
    }
    return loaded;
}

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
    // Into memory first, so that a full disc is met by the one place that writes files.
    const char* name = encoding.container == Container::png ? "memory.png" : "memory.exr";
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = ImageOutput::create(name);
    if (!output) throw_encoding_error(OIIO::geterror());
    output->set_ioproxy(&memory);
    if (!output->open(name, make_spec(image, attributes, encoding)) ||
        !output->write_image(TypeDesc::FLOAT, image.pixels.data()) || !output->close())
        throw_encoding_error(output->geterror());
    return {bytes.begin(), bytes.end()};
}

LoadedImage read_image(const std::filesystem::path& file, AlphaMeaning alpha)
{
    // A missing file or a folder gets the message that it gets everywhere.
    if (!std::filesystem::is_regular_file(file)) (void)read_text(file);
    if (file.extension() == ".ftxt") return load_ftxt(file);
    ImageSpec hints;
    if (alpha == AlphaMeaning::number) hints.attribute(kUnassociated, 1);
    const auto input = ImageInput::open(file.string(), &hints);
    if (!input)
        throw InputError(
            {file.string(), 0, "", "is not an image that can be read: " + OIIO::geterror()});
    LoadedImage loaded = describe(*input);
    const std::int64_t values = std::int64_t{loaded.image.width} * loaded.image.height *
                                static_cast<std::int64_t>(loaded.image.channel_count());
    if (values <= 0 || values > kMaxValues)
        throw InputError({file.string(), 0, "",
                          fmt::format("has {} values; must be in [1, {}]", values, kMaxValues)});
    loaded.image.pixels.resize(static_cast<std::size_t>(values));
    if (!input->read_image(0, 0, 0, -1, TypeDesc::FLOAT, loaded.image.pixels.data()))
        throw InputError({file.string(), 0, "", "cannot be read to its end: " + input->geterror()});
    return loaded;
}

void round_to_half(std::vector<float>& values)
{
    std::vector<std::uint16_t> halves(values.size());
    OIIO::convert_types(TypeDesc::FLOAT, values.data(), TypeDesc::HALF, halves.data(),
                        static_cast<int>(values.size()));
    OIIO::convert_types(TypeDesc::HALF, halves.data(), TypeDesc::FLOAT, values.data(),
                        static_cast<int>(values.size()));
}

void round_to(Depth depth, std::vector<float>& values)
{
    if (depth == Depth::half) round_to_half(values);
    if (depth == Depth::byte)
        for (float& value : values)
            value = std::round(std::clamp(value, 0.0F, 1.0F) * 255.0F) / 255.0F;
}

}  // namespace nacre::tool
