// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "film/fields.h"
#include "film/film_kind.h"
#include "nacre/material/schema.h"

namespace nacre::kinds {
namespace film {
namespace {

using material::infos, material::reference_schema, material::SchemaJson, material::Section;

constexpr std::array<std::string_view, 8> kTechniques{"multilayer", "path_difference", "airy",
                                                      "series",     "opaque_base",     "free_film",
                                                      "etalon",     "recursion"};

constexpr auto kAmbient = field<&Film::ambient>({.key = "ambient", .is_clear = true});
constexpr auto kSubstrate = field<&Film::substrate>({.key = "substrate"});
constexpr auto kTechnique =
    field<&Film::technique>({.key = "technique",
                             .help = "what the reflectance is computed by; else multilayer",
                             .choices = kTechniques});

LayerSpec read_layer(Section& section, bool in_group)
{
    LayerSpec result;
    result.medium = read_medium(section);
    read_fields(section, kLayerFields, result);
    if (result.thickness_nm.varies && in_group)
        section.report("thickness_nm", "a layer of a group cannot vary; use [stack] scale");
    if (result.thickness_nm.varies && !result.coherent)
        section.report("coherent", "a layer that varies must be coherent (got false)");
    section.report_unknown_keys();
    return result;
}

void read_group(Section& section, std::vector<LayerSpec>& layers)
{
    const int repeat = section.integer("repeat", 1, kMaxLayers).value_or(1);
    std::vector<LayerSpec> group;
    for (Section& layer : section.sections("group")) group.push_back(read_layer(layer, true));
    if (group.empty()) section.report("group", "must hold at least one layer");
    // One more than allowed is enough to report too many.
    for (int i = 0; i < repeat && layers.size() <= kMaxLayers; ++i)
        layers.insert(layers.end(), group.begin(), group.end());
    section.report_unknown_keys();
}

std::vector<LayerSpec> read_layers(Section& root)
{
    std::vector<LayerSpec> layers;
    bool varying = false;
    for (Section& section : root.sections("layer")) {
        if (section.has("group") || section.has("repeat")) {
            read_group(section, layers);
            continue;
        }
        layers.push_back(read_layer(section, false));
        if (layers.back().thickness_nm.varies && std::exchange(varying, true))
            section.report("thickness_nm", "only one layer can vary, and an earlier one does");
    }
    if (layers.size() > kMaxLayers)
        root.report("layer", fmt::format("must be at most {} layers, groups repeated (got more)",
                                         kMaxLayers));
    return layers;
}

/// `[stack]`: what is said of all layers.
void read_whole(Section& root, Film& film)
{
    auto section = root.section("stack");
    if (!section) return;
    if (!section->has("technique")) section->require("scale", wanted(kScale.info));
    kScale.read(*section, kScale.info, film);
    if (film.scale && film.varying_layer())
        section->report("scale", "excludes a layer that varies");
    if (section->has("scale") && std::ranges::none_of(film.layers, &LayerSpec::coherent))
        section->report("scale", "needs a coherent layer to act on");
    kTechnique.read(*section, kTechnique.info, film);
    film.technique_line = section->line("technique");
    section->report_unknown_keys();
}

void read_more_surface(Section& section, Film& film)
{
    read_fields(section, kSurfaceFields, film);
    if (film.transmission && film.anisotropy)
        section.report("anisotropy", "excludes transmission: glass has no brushed form");
    if (film.transmission && film.diffuse_base)
        section.report("diffuse_base", "excludes transmission: nothing passes a matt base");
}

std::shared_ptr<const Kind> read(Section& root, material::TemplateHead& head)
{
    auto film = std::make_shared<Film>();
    kAmbient.read(root, kAmbient.info, *film);
    film->layers = read_layers(root);
    kSubstrate.read(root, kSubstrate.info, *film);
    read_whole(root, *film);
    read_surface(root, head, [&](Section& section) { read_more_surface(section, *film); });
    return film;
}

KindSchema schema()
{
    const SchemaJson one_or_group{
        {"oneOf", SchemaJson::array({reference_schema("layer"), reference_schema("group")})}};
    SchemaJson whole = material::fields_schema(std::array{kScale.info, kTechnique.info});
    whole["minProperties"] = 1;
    SchemaJson group = material::object_schema(
        {{"repeat", {{"type", "integer"}, {"minimum", 1}, {"maximum", kMaxLayers}}},
         {"group", {{"type", "array"}, {"minItems", 1}, {"items", reference_schema("layer")}}}},
        {"group"});
    return {.properties = {{"ambient", material::field_schema(kAmbient.info)},
                           {"layer", {{"type", "array"}, {"items", one_or_group}}},
                           {"substrate", material::field_schema(kSubstrate.info)},
                           {"stack", std::move(whole)}},
            .required = {"ambient", "substrate"},
            .definitions = {{"layer", material::medium_schema(infos(kLayerFields))},
                            {"group", std::move(group)}}};
}

}  // namespace
}  // namespace film

template <>
KindInfo kind_info<Film>()
{
    return {.name = Film::kName,
            .section = "",
            .sliders = {film::kCoverage, material::kRoughness},
            .surface = infos(film::kSurfaceFields),
            .schema = film::schema,
            .read = film::read};
}

std::span<const std::string_view> technique_names()
{
    return film::kTechniques;
}

std::string_view technique_name(Technique technique)
{
    return film::kTechniques.at(static_cast<std::size_t>(technique));
}

}  // namespace nacre::kinds
