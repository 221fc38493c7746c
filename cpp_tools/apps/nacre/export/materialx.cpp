// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <pugixml.hpp>

#include "export/materials.h"
#include "export/materialx_graph.h"
#include "export/xml_text.h"
#include "files/output.h"
#include "files/stack_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/version.h"
#include "nacre/optics/fresnel.h"
#include "nacre/optics/rgb_film.h"
#include "shared/session.h"
#include "tables/image.h"

namespace nacre::tool {
namespace {

namespace fs = std::filesystem;
using kinds::Interior;
using lut::SphereError;
using spectral::Vec3;

constexpr const char* kExportMaterialxHelp = R"(
One document for all materials. A film becomes the material <id>: its table <id>_R.exr (and <id>_T.exr
where light passes) beside the document, read at |N·V| and the input thickness_nm, tints a
generalized_schlick_bsdf. One clear layer also becomes <id>_thin_film: thinfilm_thickness and
thinfilm_ior on conductor_bsdf or dielectric_bsdf, without a table, less exact. A glass becomes an
open_pbr_surface with its Abbe number. What each is off by stands in its doc and is printed.

  nacre export materialx --material tempered_steel -o tempered_steel.mtlx
  nacre export materialx --material soap_film --material sf11 --tolerance 0.3 -o looks.mtlx
  nacre export materialx my_film.toml --set thickness_nm=320 -o my_film.mtlx)";

/// A colour space in the words of MaterialX; `none` is taken as it is.
std::string space_name(const TableProvenance& provenance)
{
    const std::string& name = provenance.space.name;
    if (provenance.built_in_space && name == "lin_rec709_scene") return "lin_rec709";
    if (provenance.built_in_space && name == "lin_ap1_scene") return "acescg";
    return "none";
}

/// One document in the making, the tables beside it, and what is said about each material.
struct Document {
    pugi::xml_document xml;
    pugi::xml_node root;
    OutputFiles files;
    fs::path folder;
    ordered_json summary = ordered_json::array();
    std::vector<std::string> lines;
};

std::string words_of(const ExportedMaterial& material, const std::string& error)
{
    std::string words = fmt::format("{}: {}. {} Source: {} ({}).", material.source.name,
                                    material.source.description, error, material.source.source,
                                    material::status_name(material.source.status));
    for (const spectral::HeldEnds& ends : material.held) words += fmt::format(" {}.", ends.note());
    return words;
}

void add_table(Document& document, const ExportedMaterial& material, const lut::Table& table,
               const TableProvenance& provenance)
{
    document.files.add(document.folder / fmt::format("{}_{}.exr", material.source.id, table.name()),
                       encode_image(table_image(table),
                                    table_attributes(table, table_provenance(material, provenance)),
                                    {Container::exr, Depth::floating}));
}

/// A dielectric below the film takes 1 − F of its own from what it lets pass; here F is in the
/// table already. Past the first column, where both vanish, the quotient stays.
void divide_by_bare(lut::Table& passed, const ExportedMaterial& material)
{
    const double n = relative_index(material);
    const auto width = static_cast<std::size_t>(passed.x.texels);
    for (std::size_t column = width; column-- > 0;) {
        const double cosine = passed.x.at(static_cast<int>(column));
        const auto r =
            optics::fresnel_amplitudes(1.0, n, cosine, optics::forward_cosine(1.0, n, cosine));
        const double through = 1.0 - (std::norm(r.r_s) + std::norm(r.r_p)) / 2.0;
        for (std::size_t row = 0; row < static_cast<std::size_t>(passed.y.texels); ++row)
            for (std::size_t c = 0; c < 3; ++c) {
                float& texel = passed.texels[3 * (row * width + column) + c];
                texel = cosine > 0.0 ? static_cast<float>(texel / through)
                                     : passed.texels[3 * (row * width + column + 1) + c];
            }
    }
    passed.quantity = "transmittance over that of the bare substrate";
}

/// Texel centres hold the ends of the axes: (t (N − 1) + 1/2)/N.
void add_texel_coordinate(MaterialXGraph& graph, const char* fraction, const char* scaled,
                          const char* name, int texels)
{
    graph.arithmetic("multiply", scaled, fraction, (texels - 1.0) / texels);
    graph.arithmetic("add", name, scaled, 0.5 / texels);
}

/// Texture coordinates from |N·V| and what varies. MaterialX counts v from the bottom row, tables
/// count rows from the top.
void add_coordinates(MaterialXGraph& graph, const ExportedMaterial& material,
                     const lut::Table& table)
{
    graph.node("normal", "normal", "vector3").value("space", "string", "world");
    graph.node("viewdirection", "view", "vector3").value("space", "string", "world");
    graph.node("dotproduct", "cosine", "float")
        .node("in1", "vector3", "normal")
        .node("in2", "vector3", "view");
    graph.node("absval", "facing", "float").node("in", "float", "cosine");
    add_texel_coordinate(graph, "facing", "u_scaled", "u", table.x.texels);
    const std::string varying = material.varying();
    if (varying.empty()) {
        graph.node("combine2", "texel", "vector2").node("in1", "float", "u").value("in2", 0.5);
        return;
    }
    const lut::Variation& range = *material.request.variation;
    graph.node("subtract", "above_min", "float")
        .interface("in1", "float", varying.c_str())
        .value("in2", range.min);
    graph.arithmetic("divide", "fraction", "above_min", range.max - range.min);
    graph.node("clamp", "held", "float").node("in", "float", "fraction");
    add_texel_coordinate(graph, "held", "v_scaled", "v_down", table.y.texels);
    graph.node("subtract", "v", "float").value("in1", 1.0).node("in2", "float", "v_down");
    graph.node("combine2", "texel", "vector2").node("in1", "float", "u").node("in2", "float", "v");
}

void add_image(MaterialXGraph& graph, const char* name, const ExportedMaterial& material,
               const std::string& table, const std::string& space)
{
    MaterialXNode image = graph.node("image", name, "color3");
    image.value("file", "filename", fmt::format("{}_{}.exr", material.source.id, table));
    image.element().last_child().append_attribute("colorspace") = space.c_str();
    image.node("texcoord", "vector2", "texel")
        .value("uaddressmode", "string", "clamp")
        .value("vaddressmode", "string", "clamp")
        .value("filtertype", "string", "linear");
}

/// The BSDF of what the table tints, by name of its last node.
const char* add_lobes(MaterialXGraph& graph, const ExportedMaterial& material,
                      const std::string& space)
{
    add_image(graph, "reflectance", material, "R", space);
    graph.node("generalized_schlick_bsdf", "reflection", "BSDF")
        .node("color0", "color3", "reflectance")
        .node("color90", "color3", "reflectance")
        .node("roughness", "vector2", "alpha")
        .value("scatter_mode", "string", "R");
    switch (material.stack().interior()) {
        case Interior::opaque:
            return "reflection";
        case Interior::diffuse:
            graph.node("oren_nayar_diffuse_bsdf", "base", "BSDF")
                .value("color", *material.stack().diffuse_base);
            graph.node("layer", "both", "BSDF")
                .node("top", "BSDF", "reflection")
                .node("base", "BSDF", "base");
            return "both";
        case Interior::thin_wall:
        case Interior::solid:
            break;
    }
    add_image(graph, "transmittance", material, "T", space);
    graph.node("dielectric_bsdf", "transmission", "BSDF")
        .node("tint", "color3", "transmittance")
        .value("ior",
               material.stack().interior() == Interior::solid ? relative_index(material) : 1.0)
        .node("roughness", "vector2", "alpha")
        .value("scatter_mode", "string", "T");
    graph.node("add", "both", "BSDF")
        .node("in1", "BSDF", "reflection")
        .node("in2", "BSDF", "transmission");
    return "both";
}

void add_values(MaterialXGraph& graph, const ExportedMaterial& material)
{
    if (const std::string varying = material.varying(); !varying.empty()) {
        const lut::Variation& range = *material.request.variation;
        graph.input(varying.c_str(), range.layer ? "Film Thickness (nm)" : "Film Thickness (×)",
                    material.value, range.min, range.max);
    }
    graph.input("roughness", "Roughness", material.roughness, 0.0, 1.0);
    graph.roughness();
}

ordered_json add_table_material(Document& document, const ExportedMaterial& material,
                                const TableProvenance& provenance)
{
    const bool passes =
        material.request.transmittance && material.stack().interior() != Interior::diffuse;
    lut::FilmTableRequest request = material.request;
    request.transmittance = passes;
    lut::FilmTables tables = lut::bake_film_tables(request);
    const lut::Table& reflected = tables.reflectance;
    add_table(document, material, reflected, provenance);
    if (passes) {
        if (material.stack().interior() == Interior::solid)
            divide_by_bare(*tables.transmittance, material);
        add_table(document, material, *tables.transmittance, provenance);
    }
    const std::string error = fmt::format(
        "Table of {} x {} texels: ΔE00 mean {:.2g}, max {:.2g} between them.", reflected.x.texels,
        reflected.y.texels, reflected.error_mean, reflected.error_max);
    MaterialXGraph graph(document.root, material.source.id, words_of(material, error));
    add_values(graph, material);
    add_coordinates(graph, material, reflected);
    graph.finish(add_lobes(graph, material, space_name(provenance)),
                 material.stack().interior() == Interior::thin_wall);
    document.lines.push_back(material.source.id + ": " + error);
    return {{"material", material.source.id},
            {"form", "table"},
            {"error",
             {{"mean", reflected.error_mean}, {"max", reflected.error_max}, {"unit", "dE00"}}}};
}

// What counts as clear to a closure that has a real index only.
constexpr double kTraceOfK = 1e-3;

/// The layer of a film that a closure can have.
std::optional<std::size_t> only_layer(const ExportedMaterial& material)
{
    const std::vector<lut::SampledLayer>& layers = material.request.stack.layers;
    if (material.is_body() || layers.size() != 1 || !layers.front().coherent) return std::nullopt;
    const bool clear =
        std::ranges::all_of(layers.front().n, [](const auto& n) { return n.imag() <= kTraceOfK; });
    const bool in_air = index_at(material.request.stack.ambient, kLineD).real() < 1.01;
    return clear && in_air ? std::optional<std::size_t>(0) : std::nullopt;
}

/// Means over each channel's share of the spectrum.
Vec3 channel_means(const lut::FilmTableRequest& request,
                   double (*part)(const std::complex<double>&))
{
    spectral::Sampled samples{};
    std::ranges::transform(request.stack.substrate, samples.begin(), part);
    Vec3 means = request.weights.apply(samples);
    for (double& mean : means) mean = std::max(mean, 0.0);
    return means;
}

optics::MaterialXFilm closure_of(const ExportedMaterial& material,
                                 const lut::FilmTableRequest& request)
{
    const lut::SampledLayer& layer = material.request.stack.layers.front();
    optics::MaterialXFilm film{.film_ior = index_at(layer.n, kLineD).real(),
                               .film_nm = layer.thickness_nm,
                               .base_n = {},
                               .base_k = {}};
    if (material.request.variation)
        film.film_nm = material.request.variation->layer ? material.value
                                                         : material.value * layer.thickness_nm;
    if (material.stack().interior() == Interior::opaque) {
        film.base_n = channel_means(request, [](const auto& n) { return n.real(); });
        film.base_k = channel_means(request, [](const auto& n) { return n.imag(); });
    } else {
        film.base_n.fill(relative_index(material));
    }
    return film;
}

const char* add_closure(MaterialXGraph& graph, const ExportedMaterial& material,
                        const optics::MaterialXFilm& film)
{
    const Interior below = material.stack().interior();
    const bool metal = below == Interior::opaque;
    MaterialXNode lobe = graph.node(metal ? "conductor_bsdf" : "dielectric_bsdf", "film", "BSDF");
    if (metal)
        lobe.value("ior", film.base_n).value("extinction", film.base_k);
    else
        lobe.value("ior", film.base_n[0])
            .value("scatter_mode", "string", below == Interior::diffuse ? "R" : "RT");
    lobe.node("roughness", "vector2", "alpha")
        .interface("thinfilm_thickness", "float", "film_nm")
        .value("thinfilm_ior", film.film_ior);
    if (below != Interior::diffuse) return "film";
    graph.node("oren_nayar_diffuse_bsdf", "base", "BSDF")
        .value("color", *material.stack().diffuse_base);
    graph.node("layer", "both", "BSDF").node("top", "BSDF", "film").node("base", "BSDF", "base");
    return "both";
}

ordered_json add_closure_material(Document& document, const ExportedMaterial& material,
                                  const TableProvenance& provenance)
{
    const lut::FilmTableRequest request = rec709_request(material, provenance);
    const optics::MaterialXFilm film = closure_of(material, request);
    const SphereError error = lut::sphere_error(
        request, {material.value},
        [&film](double cosine, double) { return optics::materialx_film(film, cosine); });
    const std::string words = fmt::format(
        "Thin film of a closure, by the formulas of MaterialX 1.39 at {:.6g} nm: ΔE00 mean {:.2f}, "
        "max {:.2f} on a sphere.",
        film.film_nm, error.mean, error.max);
    const std::string name = material.source.id + "_thin_film";
    MaterialXGraph graph(document.root, name, words_of(material, words));
    graph.input("film_nm", "Film Thickness (nm)", film.film_nm, 0.0, 2000.0);
    graph.input("roughness", "Roughness", material.roughness, 0.0, 1.0);
    graph.roughness();
    graph.finish(add_closure(graph, material, film),
                 material.stack().interior() == Interior::thin_wall);
    document.lines.push_back(name + ": " + words);
    return {{"material", name}, {"form", "closure"}, {"error", error_json(error)}};
}

ordered_json add_glass(Document& document, const ExportedMaterial& material,
                       const TableProvenance& provenance)
{
    const lut::IndexOnGrid& glass = material.request.stack.substrate;
    const double n = relative_index(material);
    const double abbe = (index_at(glass, kLineD).real() - 1.0) /
                        (index_at(glass, kLineF).real() - index_at(glass, kLineC).real());
    const SphereError error =
        lut::sphere_error(rec709_request(material, provenance), {0.0}, [n](double cosine, double) {
            const auto r =
                optics::fresnel_amplitudes(1.0, n, cosine, optics::forward_cosine(1.0, n, cosine));
            const double reflected = (std::norm(r.r_s) + std::norm(r.r_p)) / 2.0;
            return Vec3{reflected, reflected, reflected};
        });
    const std::string words =
        fmt::format("n_d {:.5f}, Abbe number {:.2f}: ΔE00 mean {:.2f}, max {:.2f} in reflection.",
                    n, abbe, error.mean, error.max);
    MaterialXGraph graph(document.root, material.source.id, words_of(material, words));
    graph.input("roughness", "Roughness", material.roughness, 0.0, 1.0);
    graph.node("open_pbr_surface", "shader", "surfaceshader")
        .value("base_weight", 0.0)
        .value("transmission_weight", 1.0)
        .value("specular_ior", n)
        .interface("specular_roughness", "float", "roughness")
        .value("transmission_dispersion_scale", 1.0)
        .value("transmission_dispersion_abbe_number", abbe);
    graph.output("shader");
    document.lines.push_back(material.source.id + ": " + words);
    return {{"material", material.source.id}, {"form", "glass"}, {"error", error_json(error)}};
}

void add_material(Document& document, const ExportedMaterial& material,
                  const TableProvenance& provenance)
{
    ordered_json forms = ordered_json::array();
    if (material.is_body()) {
        forms.push_back(add_glass(document, material, provenance));
    } else {
        forms.push_back(add_table_material(document, material, provenance));
        if (only_layer(material))
            forms.push_back(add_closure_material(document, material, provenance));
    }
    ordered_json summary = provenance_json(material, provenance);
    summary["forms"] = std::move(forms);
    document.summary.push_back(std::move(summary));
}

int export_materialx(const Session& session, const ExportOptions& options)
{
    const fs::path output = options.output;
    if (output.extension() != ".mtlx")
        throw InputError({options.output, 0, "-o", "must end in .mtlx"});
    const ResolvedTableOptions table = resolve(options.table);
    const std::vector<ExportedMaterial> materials =
        exported_materials(session, options, table, "a MaterialX closure");
    check_writable(options.output);
    Document document;
    document.folder = output.parent_path();
    document.root = document.xml.append_child("materialx");
    document.root.append_attribute("version") = "1.39";
    document.root.append_attribute("doc") = fmt::format("Nacre {}", version()).c_str();
    for_each_material(session, materials, [&](const ExportedMaterial& material) {
        add_material(document, material, table.provenance);
    });
    document.files.add(output, xml_text(document.xml));
    document.files.write();
    print_summary(session, document.summary, document.lines);
    return kExitOk;
}

}  // namespace

void add_export_materialx(CLI::App& command, Session& session)
{
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* materialx = command.add_subcommand(
        "materialx", "tables and node graphs, and closures with a thin film");
    materialx->footer(kExportMaterialxHelp);
    add_export_options(*materialx, *options, ".mtlx; tables go beside it");
    add_value_options(*materialx, *options);
    add_table_options(*materialx, options->table);
    materialx->callback([&session, options] {
        session.run = [&session, options] { return export_materialx(session, *options); };
    });
}

}  // namespace nacre::tool
