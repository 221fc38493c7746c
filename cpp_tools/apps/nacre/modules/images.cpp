// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <stdexcept>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "modules/image_codec.h"
#include "modules/module_entry.h"

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
        spec.attribute("compression", encoding.compression == Compression::pxr24 ? "pxr24" : "zip");
    }
    if (encoding.container == Container::tx) {
        spec.tile_width = spec.tile_height = kTile;
        spec.attribute("textureformat", "Plain Texture");
        spec.attribute("openexr:levelmode", 0);  // one level: no mip maps
    }
    for (const auto& [name, value] : attributes) set_attribute(spec, name, value);
    return spec;
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

std::string encode(const Image& image, const Attributes& attributes, const Encoding& encoding)
{
    // Into memory first, so that a full disc is met by the one place that writes files.
    const char* name = encoding.container == Container::png ? "memory.png" : "memory.exr";
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = ImageOutput::create(name);
    if (!output) throw std::runtime_error(OIIO::geterror());
    output->set_ioproxy(&memory);
    if (!output->open(name, make_spec(image, attributes, encoding)) ||
        !output->write_image(TypeDesc::FLOAT, image.pixels.data()) || !output->close())
        throw std::runtime_error(output->geterror());
    return {bytes.begin(), bytes.end()};
}

LoadedImage decode(const std::string& file, AlphaMeaning alpha)
{
    ImageSpec hints;
    if (alpha == AlphaMeaning::number) hints.attribute(kUnassociated, 1);
    const auto input = ImageInput::open(file, &hints);
    if (!input) throw std::runtime_error("is not an image that can be read: " + OIIO::geterror());
    LoadedImage loaded = describe(*input);
    const std::int64_t values = std::int64_t{loaded.image.width} * loaded.image.height *
                                static_cast<std::int64_t>(loaded.image.channel_count());
    if (values <= 0 || values > kMaxValues)
        throw std::runtime_error(
            fmt::format("has {} values; must be in [1, {}]", values, kMaxValues));
    loaded.image.pixels.resize(static_cast<std::size_t>(values));
    if (!input->read_image(0, 0, 0, -1, TypeDesc::FLOAT, loaded.image.pixels.data()))
        throw std::runtime_error("cannot be read to its end: " + input->geterror());
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

std::vector<float> inferno(std::vector<float> values)
{
    const ImageSpec row(static_cast<int>(values.size()), 1, 1, TypeDesc::FLOAT);
    const OIIO::ImageBuf colours =
        OIIO::ImageBufAlgo::color_map(OIIO::ImageBuf(row, values.data()), 0, "inferno");
    std::vector<float> rgb(values.size() * 3);
    colours.get_pixels(colours.roi(), TypeDesc::FLOAT, rgb.data());
    return rgb;
}

constexpr ImageCodec kCodec = {encode, decode, round_to_half, inferno};

}  // namespace
}  // namespace nacre::tool

NACRE_MODULE_ENTRY(nacre::tool::kCodec)
