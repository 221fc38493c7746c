// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "nacre/material/template.h"

namespace nacre::material {
namespace {

using Json = nlohmann::ordered_json;

Json number(const Json& bounds, const char* description)
{
    Json result{{"type", "number"}, {"description", description}};
    result.update(bounds);
    return result;
}

Json text(const char* description)
{
    return {{"type", "string"}, {"minLength", 1}, {"description", description}};
}

Json object(Json properties, Json required)
{
    return {{"type", "object"},
            {"additionalProperties", false},
            {"required", std::move(required)},
            {"properties", std::move(properties)}};
}

Json reference(const char* name)
{
    return {{"$ref", std::string("#/$defs/") + name}};
}

/// The keys of a medium; `exactly_one` says which of them decides.
Json medium_properties()
{
    const Json terms{{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 1}};
    Json cauchy = terms;
    cauchy["maxItems"] = 3;
    cauchy["description"] = "n = a + b/λ² + c/λ⁴, λ in µm";
    Json sellmeier_terms = terms;
    sellmeier_terms["maxItems"] = 6;
    Json sellmeier = object({{"b", sellmeier_terms}, {"c", sellmeier_terms}}, {"b", "c"});
    sellmeier["description"] = "n² − 1 = Σ b λ²/(λ² − c), λ in µm, c in µm²";
    const Json positive{{"exclusiveMinimum", 0}};
    Json abbe = object(
        {{"n_d", number(positive, "index at 587.56 nm")}, {"v_d", number(positive, "Abbe number")}},
        {"n_d", "v_d"});
    return {{"medium", text("key of the library, as `nacre library list` shows it")},
            {"n", number({{"exclusiveMinimum", 0}, {"maximum", 100}}, "constant index")},
            {"k", number({{"minimum", 0}, {"maximum", 100}}, "absorption, with n or cauchy")},
            {"cauchy", cauchy},
            {"sellmeier", sellmeier},
            {"abbe", abbe}};
}

Json exactly_one_medium()
{
    Json forms = Json::array();
    for (const char* form : {"medium", "n", "cauchy", "sellmeier", "abbe"})
        forms.push_back({{"required", {form}}});
    return forms;
}

/// A table that holds a medium, with more keys beside it.
Json medium_object(const Json& more, Json required)
{
    Json properties = medium_properties();
    properties.update(more);
    Json result = object(properties, std::move(required));
    result["oneOf"] = exactly_one_medium();
    return result;
}

Json range(const Json& bounds, bool may_vary, Json required)
{
    Json properties{{"default", number(bounds, "value of a fresh material")},
                    {"min", number(bounds, "lowest value of the slider")},
                    {"max", number(bounds, "highest value of the slider")}};
    if (may_vary)
        properties["varies"] = {{"type", "boolean"},
                                {"description", "becomes a slider and an axis of the table"}};
    return object(properties, std::move(required));
}

Json layer_schema()
{
    const Json bounds{{"minimum", 0}, {"maximum", 1e8}};
    Json thickness{
        {"oneOf", Json::array({number(bounds, "nm"), range(bounds, true, {"default"})})}};
    Json coherent{{"type", "boolean"}, {"description", "false: fringes average out"}};
    return medium_object({{"thickness_nm", thickness}, {"coherent", coherent}}, {"thickness_nm"});
}

Json group_schema()
{
    return object({{"repeat", {{"type", "integer"}, {"minimum", 1}, {"maximum", kMaxLayers}}},
                   {"group", {{"type", "array"}, {"minItems", 1}, {"items", reference("layer")}}}},
                  {"group"});
}

Json grating_schema()
{
    const Json pitch{{"minimum", 100}, {"maximum", 1e6}};
    return object({{"pitch_nm",
                    {{"oneOf", Json::array({number(pitch, "period, nm"),
                                            range(pitch, false, {"default", "min", "max"})})}}},
                   {"depth_nm", number({{"minimum", 0}, {"maximum", 1e5}}, "groove depth, nm")},
                   {"profile", {{"enum", {"sinusoidal", "rectangular", "blazed"}}}},
                   {"duty", number({{"minimum", 0}, {"maximum", 1}}, "raised share of the period")},
                   {"orders", {{"type", "integer"}, {"minimum", 1}, {"maximum", 9}}},
                   {"cover", reference("medium")},
                   {"substrate", reference("medium")}},
                  {"pitch_nm", "depth_nm", "profile", "cover", "substrate"});
}

Json material_schema()
{
    return object({{"id", {{"type", "string"}, {"pattern", "^[a-z][a-z0-9_]{0,62}$"}}},
                   {"name", text("as the artist reads it")},
                   {"category", text("path in the asset catalogue")},
                   {"description", text("one sentence")},
                   {"source", text("where the values come from, and which are only typical")},
                   {"status",
                    {{"enum", {"measured", "sourced", "typical"}},
                     {"description", "how far the values can be trusted; else typical"}}},
                   {"tags",
                    {{"type", "array"},
                     {"items", text("a word that a search may use")},
                     {"description", "for searches"}}}},
                  {"id", "name", "category", "source"});
}

Json technique_schema()
{
    return {{"enum", technique_names()},
            {"description", "what the reflectance is computed by; else multilayer"}};
}

Json whole_schema()
{
    const Json scale = range({{"minimum", 0}, {"maximum", 100}}, false, {"default", "min", "max"});
    Json result = object({{"scale", scale}, {"technique", technique_schema()}}, Json::array());
    result["minProperties"] = 1;
    return result;
}

Json base_schema()
{
    return {{"type", "array"},
            {"minItems", 3},
            {"maxItems", 3},
            {"items", number({{"minimum", 0}, {"maximum", 1}}, "reflectance of a channel")},
            {"description", "matt base under a clear substrate"}};
}

Json look_schema()
{
    const Json source{
        {"type", "string"},
        {"pattern", "^[a-z][a-z0-9_]*(:[a-z][a-z0-9_]*=[^,]+(,[a-z][a-z0-9_]*=[^,]+)*)?$"}};
    return object({{"object",
                    {{"type", "string"},
                     {"pattern", "^[a-z][a-z0-9_]*$"},
                     {"description", "what the material is pictured on, such as blade"}}},
                   {"thickness",
                    {{"type", "array"},
                     {"items", source},
                     {"description", "what the thickness follows, the lowest source first"}}}},
                  Json::array());
}

Json parameter_schema()
{
    const Json bounds{{"minimum", 0}, {"maximum", 10}};
    return object({{"name", {{"enum", {"coverage", "dispersion", "roughness", "strength"}}}},
                   {"label", text("as the artist reads it")},
                   {"description", text("tooltip")},
                   {"default", number(bounds, "value of a fresh material")},
                   {"min", number(bounds, "lowest value of the slider, 0")},
                   {"max", number(bounds, "highest value of the slider, 1")}},
                  {"name", "label", "default"});
}

}  // namespace

std::string template_json_schema()
{
    const Json layers{
        {"type", "array"},
        {"items", {{"oneOf", Json::array({reference("layer"), reference("group")})}}}};
    Json root = object(
        {{"schema", {{"const", 1}}},
         {"material", material_schema()},
         {"ambient", reference("medium")},
         {"layer", layers},
         {"substrate", reference("medium")},
         {"stack", whole_schema()},
         {"grating", grating_schema()},
         {"glass", reference("medium")},
         {"surface", object({{"roughness", number({{"minimum", 0}, {"maximum", 1}}, "Blender's")},
                             {"anisotropy", number({{"minimum", -0.9}, {"maximum", 0.9}},
                                                   "of brushed surfaces, Blender's")},
                             {"transmission", {{"type", "boolean"}}},
                             {"diffuse_base", base_schema()}},
                            Json::array())},
         {"parameter", {{"type", "array"}, {"items", parameter_schema()}}},
         {"look", look_schema()}},
        {"schema", "material"});
    root["oneOf"] = Json::array({{{"required", {"ambient", "substrate"}}},
                                 {{"required", {"grating"}}},
                                 {{"required", {"glass"}}}});
    root["$defs"] = {{"medium", medium_object(Json::object(), Json::array())},
                     {"layer", layer_schema()},
                     {"group", group_schema()}};
    Json head{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
              {"title", "Nacre material template"}};
    head.update(root);
    return head.dump(2) + "\n";
}

}  // namespace nacre::material
