// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "export/gltf_scene.h"
#include "export/materials.h"
#include "files/image_file.h"
#include "files/output.h"
#include "nacre/core/diagnostics.h"
#include "nacre/lut/film_table.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

using kinds::Interior;
using lut::SphereError;
using spectral::Vec3;

struct GltfOptions : ExportOptions {
    bool range = false;
};

constexpr const char* kExportGltfHelp = R"(
One film of KHR_materials_iridescence whose colours on a sphere, at angles up to 85°, come nearest to
the exact ones, by the formulas of the extension. Index, thickness and base colour are those of the
fit: they stand for the whole stack and need not be those of a layer. What it is off by stands in the
material's extras and is printed. With --range the film runs over all thicknesses of the template,
which a texture maps; there is one that runs from pole to pole of the sphere.
Films that light passes get KHR_materials_transmission, glasses also KHR_materials_dispersion.
Colours are linear Rec.709, as glTF has them.

  nacre export gltf --material soap_film --range -o bubble.glb
  nacre export gltf my_film.toml --set thickness_nm=320 -o my_film.gltf
  nacre export gltf --material oil_on_water --material sf11 --json -o both.glb)";

constexpr std::size_t kRangeValues = 9;

std::vector<double> fitted_values(const ExportedMaterial& material, bool range)
{
    if (!range || !material.request.variation) return {material.value};
    const lut::Variation& along = *material.request.variation;
    std::vector<double> values;
    for (std::size_t i = 0; i < kRangeValues; ++i)
        values.push_back(std::lerp(along.min, along.max,
                                   static_cast<double>(i) / static_cast<double>(kRangeValues - 1)));
    return values;
}

double f0_of(double ior)
{
    return std::pow((ior - 1.0) / (ior + 1.0), 2);
}

/// Six digits: what a platform's mathematics library rounds differently must not show.
double cut(double value)
{
    return std::round(value * 1e6) / 1e6;
}

ordered_json cut(const Vec3& colour)
{
    return {cut(colour[0]), cut(colour[1]), cut(colour[2])};
}

/// A surface in the words of glTF, and how far it is from the film.
struct Fitted {
    lut::IridescenceFit film;
    std::vector<double> values;
    SphereError reflectance{};
    Vec3 passed{};  ///< colour of what light gets through the surface
    SphereError transmittance{};
    bool transmits = false;

    [[nodiscard]] Vec3 reflected(double cos_theta, double value) const
    {
        return optics::khr_iridescence(lut::surface_at(film, values, value), cos_theta);
    }
    /// rgb_mix() of the extension: all channels lose what the strongest one reflects.
    [[nodiscard]] double left(double cos_theta, double value) const
    {
        return 1.0 - std::min(1.0, std::ranges::max(reflected(cos_theta, value)));
    }
};

/// Least squares of T = colour · left, over the angles of a sphere.
Vec3 passed_colour(const ExportedMaterial& material, const Fitted& fitted)
{
    Vec3 product{}, square{};
    for (const double value : fitted.values)
        for (int i = 1; i <= 20; ++i) {
            const double cosine = std::sqrt((i - 0.5) / 20.0);  // equal shares of the disc
            const double left = fitted.left(cosine, value);
            const Vec3 exact =
                lut::exact_film_colour(material.request, cosine, value).transmittance;
            for (std::size_t c = 0; c < 3; ++c) {
                product[c] += left * exact[c];
                square[c] += left * left;
            }
        }
    Vec3 colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = square[c] > 0.0 ? std::clamp(product[c] / square[c], 0.0, 1.0) : 0.0;
    return colour;
}

Fitted fit(const ExportedMaterial& material, bool range)
{
    Fitted result{.film = {}, .values = fitted_values(material, range)};
    const Interior below = material.stack().interior();
    if (material.is_body()) {
        const double f0 = f0_of(relative_index(material));
        result.film = {.film_ior = 1.0,
                       .factor = 0.0,
                       .film_min_nm = 0.0,
                       .film_max_nm = 0.0,
                       .base_f0 = {f0, f0, f0}};
    } else {
        result.film = lut::fit_iridescence(material.request, result.values);
    }
    result.reflectance =
        lut::sphere_error(material.request, result.values,
                          [&](double c, double v) { return result.reflected(c, v); });
    result.transmits = below == Interior::thin_wall || below == Interior::solid;
    if (!result.transmits) return result;
    result.passed = passed_colour(material, result);
    const auto model = [&](double c, double v) {
        const double left = result.left(c, v);
        return Vec3{left * result.passed[0], left * result.passed[1], left * result.passed[2]};
    };
    result.transmittance = lut::sphere_error(material.request, result.values, model, true);
    return result;
}

/// Index of the base. A thin wall refracts nothing: its index only carries the base's F0, up to
/// that of common glass, so that renderers which bend light all the same do so little.
double base_ior(const ExportedMaterial& material, const Fitted& fitted)
{
    if (material.stack().interior() != Interior::thin_wall) return relative_index(material);
    const double root = std::sqrt(std::ranges::max(fitted.film.base_f0));
    constexpr double kGlass = 1.5;
    return root < 0.2 ? (1.0 + root) / (1.0 - root) : kGlass;
}

/// F0 of a dielectric as ior and a colour on it: KHR_materials_specular.
void add_base(ordered_json& extensions, const ExportedMaterial& material, const Fitted& fitted)
{
    const double ior = std::max(1.0, cut(base_ior(material, fitted)));
    extensions["KHR_materials_ior"] = {{"ior", ior}};
    const double f0 = f0_of(ior);
    if (material.is_body() || f0 == 0.0) return;
    Vec3 colour = fitted.film.base_f0;
    for (double& channel : colour) channel /= f0;
    extensions["KHR_materials_specular"] = {{"specularColorFactor", cut(colour)}};
}

void add_iridescence(ordered_json& extensions, const Fitted& fitted)
{
    ordered_json film = {
        {"iridescenceFactor", cut(fitted.film.factor)},
        {"iridescenceIor", cut(fitted.film.film_ior)},
        {"iridescenceThicknessMinimum",
         cut(fitted.values.size() > 1 ? fitted.film.film_min_nm : fitted.film.film_max_nm)},
        {"iridescenceThicknessMaximum", cut(fitted.film.film_max_nm)}};
    if (fitted.values.size() > 1) film["iridescenceThicknessTexture"] = {{"index", 0}};
    extensions["KHR_materials_iridescence"] = std::move(film);
}

/// Refraction needs a volume; 20/V as KHR_materials_dispersion scales it.
void add_interior(ordered_json& extensions, const ExportedMaterial& material)
{
    extensions["KHR_materials_transmission"] = {{"transmissionFactor", 1.0}};
    if (material.stack().interior() != Interior::solid) return;
    extensions["KHR_materials_volume"] = {{"thicknessFactor", 1.0}};
    if (!material.is_body()) return;
    const lut::IndexOnGrid& glass = material.request.stack.substrate;
    const double spread = index_at(glass, kLineF).real() - index_at(glass, kLineC).real();
    const double inverse_abbe = spread / (index_at(glass, kLineD).real() - 1.0);
    extensions["KHR_materials_dispersion"] = {{"dispersion", cut(20.0 * inverse_abbe)}};
}

ordered_json extras_of(const ExportedMaterial& material, const Fitted& fitted,
                       const TableProvenance& provenance)
{
    ordered_json extras = provenance_json(material, provenance);
    if (fitted.values.size() > 1) {
        extras.erase(material.varying());
        extras[material.varying()] = {fitted.values.front(), fitted.values.back()};
    }
    extras["error"] = {{"reflectance", error_json(fitted.reflectance)}};
    if (fitted.transmits) extras["error"]["transmittance"] = error_json(fitted.transmittance);
    extras["error"]["angles_deg"] = {0, 85};
    ordered_json left_out = ordered_json::array();
    if (material.source.parameter("coverage")) left_out.push_back("coverage");
    if (material.stack().anisotropy) left_out.push_back("anisotropy");
    extras["left_out"] = std::move(left_out);
    return extras;
}

ordered_json gltf_material(const ExportedMaterial& material, const Fitted& fitted,
                           const TableProvenance& provenance)
{
    const Interior below = material.stack().interior();
    Vec3 base = fitted.film.base_f0;
    if (fitted.transmits) base = fitted.passed;
    if (below == Interior::diffuse) base = *material.stack().diffuse_base;
    ordered_json colour = cut(base);
    colour.push_back(1.0);
    ordered_json extensions = ordered_json::object();
    if (below != Interior::opaque) add_base(extensions, material, fitted);
    if (!material.is_body()) add_iridescence(extensions, fitted);
    if (fitted.transmits) add_interior(extensions, material);
    return {{"name", material.source.id},
            {"pbrMetallicRoughness",
             {{"baseColorFactor", std::move(colour)},
              {"metallicFactor", below == Interior::opaque ? 1.0 : 0.0},
              {"roughnessFactor", material.roughness}}},
            {"extensions", std::move(extensions)},
            {"extras", {{"nacre", extras_of(material, fitted, provenance)}}}};
}

/// G runs from 0 in the top row to 1: thickness is data, and no colour.
std::string thickness_ramp()
{
    constexpr int kWidth = 4, kHeight = 256;
    Image ramp{kWidth, kHeight, {"R", "G", "B"}, {}};
    for (int row = 0; row < kHeight; ++row)
        ramp.pixels.insert(ramp.pixels.end(), std::size_t{3} * kWidth,
                           static_cast<float>(row) / (kHeight - 1));
    return encode_image(ramp, {}, {Container::png, Depth::byte});
}

GltfContainer container_of(const std::string& output)
{
    const std::string extension = std::filesystem::path(output).extension().string();
    if (extension == ".gltf") return GltfContainer::text;
    if (extension == ".glb") return GltfContainer::binary;
    throw InputError({output, 0, "-o", "must end in .gltf or .glb"});
}

int export_gltf(const Session& session, const GltfOptions& options)
{
    const GltfContainer container = container_of(options.output);
    const ResolvedTableOptions table = resolve(options.table);
    const std::vector<ExportedMaterial> materials =
        exported_materials(session, options, table, "glTF");
    check_writable(options.output);
    ordered_json list = ordered_json::array(), summary = ordered_json::array();
    std::vector<std::string> lines;
    bool textured = false;
    for_each_material(session, materials, [&](const ExportedMaterial& material) {
        const Fitted fitted = fit(material, options.range);
        textured = textured || fitted.values.size() > 1;
        list.push_back(gltf_material(material, fitted, table.provenance));
        summary.push_back(list.back()["extras"]["nacre"]);
        std::string line =
            fmt::format("{}: ΔE00 mean {:.2f}, max {:.2f} in reflection", material.source.id,
                        fitted.reflectance.mean, fitted.reflectance.max);
        if (fitted.transmits)
            line += fmt::format("; mean {:.2f}, max {:.2f} in transmission",
                                fitted.transmittance.mean, fitted.transmittance.max);
        lines.push_back(std::move(line));
    });
    OutputFiles files;
    files.add(options.output,
              gltf_document(list, textured ? thickness_ramp() : std::string(), container));
    files.write();
    print_summary(session, summary, lines);
    return kExitOk;
}

}  // namespace

void add_export_gltf(CLI::App& command, Session& session)
{
    const auto options = std::make_shared<GltfOptions>();
    CLI::App* gltf =
        command.add_subcommand("gltf", "the nearest film of KHR_materials_iridescence");
    gltf->footer(kExportGltfHelp);
    add_export_options(*gltf, *options, ".gltf or .glb");
    add_value_options(*gltf, *options);
    gltf->add_flag("--range", options->range, "fit all thicknesses of the template, not only one");
    add_illuminant_options(*gltf, options->table);
    gltf->callback([&session, options] {
        session.run = [&session, options] { return export_gltf(session, *options); };
    });
}

}  // namespace nacre::tool
