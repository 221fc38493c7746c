// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "brushed_nodes.h"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <vector>

#include "nacre/oslgen/lost_light.h"

namespace nacre::oslgen {
namespace {

using Json = nlohmann::json;

/// cos² of the view and the tangent along which a brushed surface is drawn out.
std::string add_along_tangent(Graph& graph, Calculation& calculate)
{
    graph.node("turned", "ShaderNodeVectorRotate", {{"rotation_type", "AXIS_ANGLE"}});
    graph.link("input.tangent", "turned.Vector");
    graph.link("input.normal", "turned.Axis");
    graph.link(calculate.number("turn", "MULTIPLY", {"input.rotation", 2.0 * std::numbers::pi}),
               "turned.Angle");
    const std::string across =
        calculate.vector("normal_by_tangent", "CROSS_PRODUCT", {"input.normal", "turned.Vector"});
    const std::string bitangent = calculate.vector("bitangent", "NORMALIZE", {across});
    const std::string x =
        calculate.vector("tangent_x", "CROSS_PRODUCT", {bitangent, "input.normal"});
    calculate.vector("along_tangent", "DOT_PRODUCT", {x, "geometry.Incoming"});
    return calculate.number("along_squared", "MULTIPLY",
                            {"along_tangent.Value", "along_tangent.Value"});
}

/// ln of what white facets lose to others in one bounce, over what they do not.
std::string add_lost_light(Calculation& calculate, const std::string& prefix,
                           const std::string& alpha_squared, const std::string& cosine_squared)
{
    const auto math = [&](const std::string& id, const char* operation,
                          const std::vector<Json>& operands) {
        return calculate.number(prefix + id, operation, operands);
    };
    const auto half_ln = [&](const std::string& id, const std::string& of, double least) {
        const std::string held = math(id + "_held", "MAXIMUM", {of, least * least});
        const std::string ln = math(id + "_ln", "LOGARITHM", {held, std::numbers::e});
        return math(id, "MULTIPLY", {ln, 0.5});
    };
    const std::string u = half_ln("alpha", alpha_squared, kLeastLostAlpha);
    const std::string v = half_ln("cosine", cosine_squared, kLeastLostCosine);
    std::string sum;
    for (std::size_t i = kLostLight.size(); i-- > 0;) {
        const auto& [c0, c1, c2] = kLostLight[i];
        const std::string inner = math(fmt::format("inner_{}", i), "MULTIPLY_ADD", {v, c2, c1});
        const std::string row = math(fmt::format("row_{}", i), "MULTIPLY_ADD", {v, inner, c0});
        sum = sum.empty() ? row : math(fmt::format("sum_{}", i), "MULTIPLY_ADD", {sum, u, row});
    }
    return sum;
}

}  // namespace

void add_brushed_facets(Graph& graph)
{
    Calculation calculate(graph);
    const auto math = [&calculate](const std::string& id, const char* operation,
                                   const std::vector<Json>& operands, bool clamped = false) {
        return calculate.number(id, operation, operands, clamped);
    };
    const std::string rough = math("rough_held", "ADD", {"input.roughness", 0.0}, true);
    const std::string alpha = math("alpha", "MULTIPLY", {rough, rough});
    const std::string above = math("above_0", "MAXIMUM", {"input.anisotropy", 0.0});
    const std::string below = math("below_0", "MINIMUM", {"input.anisotropy", 0.0});
    const std::string along = math("along", "SUBTRACT", {1.0, above});
    const std::string across = math("across", "ADD", {1.0, below});
    const std::string stretch = math("stretch", "DIVIDE", {along, across});
    const std::string x = math("alpha_x", "MULTIPLY", {alpha, stretch}, true);
    const std::string y = math("alpha_y", "DIVIDE", {alpha, stretch}, true);
    const std::string xx = math("alpha_xx", "MULTIPLY", {x, x});
    const std::string yy = math("alpha_yy", "MULTIPLY", {y, y});

    const std::string tt = add_along_tangent(graph, calculate);
    const std::string cc = math("cos_cos", "MULTIPLY", {"cos.Value", "cos.Value"});
    const std::string sum = math("alpha_sum", "ADD", {xx, yy});
    const std::string mean = math("alpha_mean", "MULTIPLY", {sum, 0.5});
    const std::string gap = math("alpha_gap", "SUBTRACT", {xx, yy});
    const std::string sine = math("sin_sin", "SUBTRACT", {1.0, cc});
    const std::string from_side = math("from_side", "MULTIPLY", {yy, sine});
    const std::string in_plane = math("in_plane", "MULTIPLY_ADD", {gap, tt, from_side});
    const std::string weight = math("from_side_weight", "ADD", {1.0, cc});
    const std::string quartic = math("cos_quartic", "MULTIPLY", {cc, cc});
    const std::string from_above = math("from_above", "MULTIPLY", {mean, quartic});
    const std::string squared = math("seen_sum", "MULTIPLY_ADD", {in_plane, weight, from_above});
    const std::string positive = math("seen_squared", "MAXIMUM", {squared, 0.0});
    math("seen", "POWER", {positive, 0.25}, true);
    const std::string slopes = math("seen_slopes", "ADD", {2.0, positive});
    const std::string all_slopes = math("mean_slopes", "ADD", {2.0, mean});
    const std::string tilt = math("tilt", "DIVIDE", {slopes, all_slopes});
    const std::string seen_cosine = math("cos_seen", "MULTIPLY", {"cos.Value", tilt}, true);

    const std::string least = math("least", "MULTIPLY", {mean, 0.04});
    const std::string further = math("further_squared", "MAXIMUM", {positive, least});
    math("further", "POWER", {further, 0.25}, true);
    const std::string half_gap = math("half_gap", "MULTIPLY", {gap, 0.5});
    const std::string gap_share = math("gap_share", "DIVIDE", {half_gap, mean});
    const std::string gap_part = math("gap_part", "MULTIPLY", {half_gap, gap_share});
    const std::string lossy = math("lossy", "MULTIPLY_ADD", {gap_part, -0.12, mean});
    const std::string stretch_part = math("tan_stretched", "MULTIPLY_ADD", {mean, cc, in_plane});
    const std::string above_part = math("mean_cos", "MULTIPLY", {mean, cc});
    const std::string stretched = math("stretched", "DIVIDE", {above_part, stretch_part});
    const std::string seen_cc = math("cos_cos_seen", "MULTIPLY", {seen_cosine, seen_cosine});
    const std::string here = add_lost_light(calculate, "here_", lossy, stretched);
    const std::string there = add_lost_light(calculate, "there_", further, seen_cc);
    math("further_scale", "EXPONENT", {math("goes_on", "SUBTRACT", {here, there})});
}

}  // namespace nacre::oslgen
