// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "export/gltf_scene.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "nacre/core/version.h"

namespace nacre::tool {
namespace {

static_assert(std::endian::native == std::endian::little, "glTF buffers are little-endian");

// Enums of the specification.
constexpr int kFloat = 5126, kUnsignedShort = 5123, kArrayBuffer = 34962, kElementBuffer = 34963;
constexpr int kClampToEdge = 33071, kLinear = 9729;

constexpr int kMeridians = 64, kParallels = 32;
constexpr double kSpacing = 2.5;  ///< of the spheres, radius 1

struct Sphere {
    std::vector<float> positions, texture_coordinates;  ///< a normal is its position
    std::vector<std::uint16_t> indices;
};

/// Around y, v = 0 at the top; the seam's vertices are doubled.
Sphere sphere()
{
    Sphere result;
    for (int row = 0; row <= kParallels; ++row)
        for (int column = 0; column <= kMeridians; ++column) {
            const double u = static_cast<double>(column) / kMeridians;
            const double v = static_cast<double>(row) / kParallels;
            const double azimuth = 2.0 * std::numbers::pi * u, polar = std::numbers::pi * v;
            for (const double x : {std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                   std::sin(polar) * std::cos(azimuth)})
                result.positions.push_back(static_cast<float>(x));
            result.texture_coordinates.push_back(static_cast<float>(u));
            result.texture_coordinates.push_back(static_cast<float>(v));
        }
    const auto at = [](int row, int column) {
        return static_cast<std::uint16_t>(row * (kMeridians + 1) + column);
    };
    for (int row = 0; row < kParallels; ++row)
        for (int column = 0; column < kMeridians; ++column) {
            const std::uint16_t a = at(row, column), b = at(row + 1, column);
            const std::uint16_t c = at(row + 1, column + 1), d = at(row, column + 1);
            if (row > 0) result.indices.insert(result.indices.end(), {a, b, d});
            if (row + 1 < kParallels) result.indices.insert(result.indices.end(), {b, c, d});
        }
    return result;
}

/// The one buffer, and the views and accessors into it.
struct Buffer {
    std::string bytes;
    ordered_json views = ordered_json::array(), accessors = ordered_json::array();

    std::size_t add_view(std::string_view data, int target)
    {
        ordered_json view = {
            {"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", data.size()}};
        if (target != 0) view["target"] = target;
        views.push_back(std::move(view));
        bytes += data;
        bytes.resize((bytes.size() + 3) / 4 * 4);
        return views.size() - 1;
    }

    template <class T>
    std::size_t add(const std::vector<T>& values, std::size_t width, const char* type, int target)
    {
        const std::size_t view = add_view(
            {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)}, target);
        accessors.push_back({{"bufferView", view},
                             {"componentType", target == kArrayBuffer ? kFloat : kUnsignedShort},
                             {"count", values.size() / width},
                             {"type", type}});
        return accessors.size() - 1;
    }
};

std::string base64(std::string_view bytes)
{
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t j = 0; j < 3; ++j)
            word = word << 8 | (j < count ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j)
            text += j <= count ? kDigits[word >> (18 - 6 * j) & 63U] : '=';
    }
    return text;
}

void add_texture(ordered_json& document, Buffer& buffer, const std::string& png)
{
    const std::size_t view = buffer.add_view(png, 0);
    document["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}, {"name", "thickness"}}};
    document["samplers"] = {{{"magFilter", kLinear},
                             {"minFilter", kLinear},
                             {"wrapS", kClampToEdge},
                             {"wrapT", kClampToEdge}}};
    document["textures"] = {{{"sampler", 0}, {"source", 0}}};
}

void add_spheres(ordered_json& document, Buffer& buffer, const ordered_json& materials)
{
    const Sphere mesh = sphere();
    const std::size_t position = buffer.add(mesh.positions, 3, "VEC3", kArrayBuffer);
    buffer.accessors.back()["min"] = {-1.0, -1.0, -1.0};
    buffer.accessors.back()["max"] = {1.0, 1.0, 1.0};
    const std::size_t uv = buffer.add(mesh.texture_coordinates, 2, "VEC2", kArrayBuffer);
    const std::size_t indices = buffer.add(mesh.indices, 1, "SCALAR", kElementBuffer);
    ordered_json scene = ordered_json::array();
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const ordered_json attributes = {
            {"POSITION", position}, {"NORMAL", position}, {"TEXCOORD_0", uv}};
        document["meshes"].push_back(
            {{"name", materials[i].at("name")},
             {"primitives",
              {{{"attributes", attributes}, {"indices", indices}, {"material", i}}}}});
        document["nodes"].push_back(
            {{"name", materials[i].at("name")},
             {"mesh", i},
             {"translation", {kSpacing * static_cast<double>(i), 0.0, 0.0}}});
        scene.push_back(i);
    }
    document["scenes"] = {{{"nodes", std::move(scene)}}};
    document["scene"] = 0;
}

std::set<std::string> extensions_of(const ordered_json& materials)
{
    std::set<std::string> names;
    for (const ordered_json& material : materials)
        if (const auto found = material.find("extensions"); found != material.end())
            for (const auto& [name, value] : found->items()) names.insert(name);
    return names;
}

std::string word(std::size_t value)
{
    const auto number = static_cast<std::uint32_t>(value);
    return {reinterpret_cast<const char*>(&number), sizeof number};
}

/// Header, a chunk of JSON padded with spaces, a chunk of bytes: glTF 2.0, section 4.
std::string glb(std::string json, const std::string& bytes)
{
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string chunks =
        word(json.size()) + "JSON" + json + word(bytes.size()) + std::string("BIN\0", 4) + bytes;
    return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

}  // namespace

std::string gltf_document(const ordered_json& materials, const std::string& thickness_png,
                          GltfContainer container)
{
    ordered_json document = {
        {"asset", {{"version", "2.0"}, {"generator", fmt::format("Nacre {}", version())}}}};
    if (const auto names = extensions_of(materials); !names.empty())
        document["extensionsUsed"] = names;
    document["materials"] = materials;
    Buffer buffer;
    add_spheres(document, buffer, materials);
    if (!thickness_png.empty()) add_texture(document, buffer, thickness_png);
    document["accessors"] = std::move(buffer.accessors);
    document["bufferViews"] = std::move(buffer.views);
    ordered_json only = {{"byteLength", buffer.bytes.size()}};
    if (container == GltfContainer::text)
        only["uri"] = "data:application/octet-stream;base64," + base64(buffer.bytes);
    document["buffers"] = ordered_json::array({std::move(only)});
    if (container == GltfContainer::text) return document.dump(2) + "\n";
    return glb(document.dump(), buffer.bytes);
}

}  // namespace nacre::tool
