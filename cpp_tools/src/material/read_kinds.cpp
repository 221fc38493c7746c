// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "read_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace nacre::material {
namespace {

constexpr double kMaxThicknessNm = 1e8;  // 10 cm: a larger number of nm is a slip
constexpr int kMaxOrders = 9;
constexpr Bounds kThickness{0.0, kMaxThicknessNm};

void check_range(Section& table, std::optional<double> value, const Quantity& quantity)
{
    if (quantity.min && quantity.max && *quantity.min >= *quantity.max) {
        table.report(
            "min", fmt::format("must be below max (got {} and {})", *quantity.min, *quantity.max));
        return;
    }
    const bool outside = value && ((quantity.min && *value < *quantity.min) ||
                                   (quantity.max && *value > *quantity.max));
    if (outside) table.report("default", fmt::format("must be inside [min, max] (got {})", *value));
}

/// A table { default, min, max, varies }; `slider` means that min and max must be there.
Quantity read_range(Section& table, const Bounds& bounds, bool slider)
{
    Quantity result;
    result.line = table.line();
    table.require("default", "a number");
    const auto value = table.number("default", bounds);
    if (!slider) slider = result.varies = table.boolean("varies").value_or(false);
    if (slider) {
        table.require("min", "a number, since the value is a slider");
        table.require("max", "a number, since the value is a slider");
    }
    result.min = table.number("min", bounds);
    result.max = table.number("max", bounds);
    check_range(table, value, result);
    table.report_unknown_keys();
    result.value = value.value_or(0.0);
    return result;
}

/// A number, or a table { default, min, max, varies }.
Quantity read_quantity(Section& section, std::string_view key, const Bounds& bounds,
                       bool slider = false)
{
    if (section.is_table(key)) {
        Section table = *section.section(key);
        return read_range(table, bounds, slider);
    }
    Quantity result;
    result.line = section.line(key);
    result.value = section.number(key, bounds).value_or(0.0);
    return result;
}

MediumSpec read_medium_at(Section& parent, std::string_view key)
{
    parent.require(key, "a table that names a medium");
    if (auto section = parent.section(key)) {
        MediumSpec result = read_medium(*section);
        section->report_unknown_keys();
        return result;
    }
    return {};
}

SellmeierMedium read_sellmeier(Section& section)
{
    SellmeierMedium result;
    auto table = section.section("sellmeier");
    if (!table) return result;
    table->require("b", "an array of numbers");
    table->require("c", "an array of numbers, µm²");
    result.b = table->numbers("b", 1, 6).value_or(std::vector<double>{});
    result.c = table->numbers("c", 1, 6).value_or(std::vector<double>{});
    if (!result.b.empty() && !result.c.empty() && result.b.size() != result.c.size())
        table->report("c", fmt::format("must have as many numbers as b (got {} and {})",
                                       result.c.size(), result.b.size()));
    table->report_unknown_keys();
    return result;
}

AbbeMedium read_abbe(Section& section)
{
    AbbeMedium result;
    auto table = section.section("abbe");
    if (!table) return result;
    table->require("n_d", "a number > 0");
    table->require("v_d", "a number > 0");
    result.n_d = table->number("n_d", {.min = 0.0, .exclusive_min = true}).value_or(1.5);
    result.v_d = table->number("v_d", {.min = 0.0, .exclusive_min = true}).value_or(60.0);
    table->report_unknown_keys();
    return result;
}

LayerSpec read_layer(Section& section, bool in_group)
{
    LayerSpec result;
    result.medium = read_medium(section);
    section.require("thickness_nm", "a number ≥ 0, or { default, min, max, varies }");
    result.thickness_nm = read_quantity(section, "thickness_nm", kThickness);
    result.coherent = section.boolean("coherent").value_or(true);
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

void read_scale(Section& section, StackSpec& stack)
{
    if (auto scale = section.section("scale"))
        stack.scale = read_range(*scale, {.min = 0.0, .max = 100.0}, true);
    if (stack.scale && stack.varying_layer())
        section.report("scale", "excludes a layer that varies");
    if (section.has("scale") && std::ranges::none_of(stack.layers, &LayerSpec::coherent))
        section.report("scale", "needs a coherent layer to act on");
}

void read_technique(Section& section, StackSpec& stack)
{
    const auto name = section.text("technique");
    stack.technique_line = section.line("technique");
    if (!name) return;
    const auto names = technique_names();
    const auto it = std::ranges::find(names, *name);
    if (it == names.end())
        section.report("technique", fmt::format("must be one of {} (got \"{}\")",
                                                fmt::join(names, ", "), *name));
    else
        stack.technique = static_cast<Technique>(it - names.begin());
}

/// `[stack]`: what is said of all layers.
void read_whole(Section& root, StackSpec& stack)
{
    auto section = root.section("stack");
    if (!section) return;
    if (!section->has("technique")) section->require("scale", "a table { default, min, max }");
    read_scale(*section, stack);
    read_technique(*section, stack);
    section->report_unknown_keys();
}

bool absorbs(const MediumSpec& medium)
{
    if (const auto* constant = std::get_if<ConstantMedium>(&medium.value)) return constant->k > 0.0;
    if (const auto* cauchy = std::get_if<CauchyMedium>(&medium.value)) return cauchy->k > 0.0;
    return false;
}

StackSpec read_stack(Section& root)
{
    StackSpec stack;
    stack.ambient = read_medium_at(root, "ambient");
    stack.layers = read_layers(root);
    stack.substrate = read_medium_at(root, "substrate");
    read_whole(root, stack);
    if (absorbs(stack.ambient)) root.report("ambient", "must not absorb: k must be 0");
    return stack;
}

GratingSpec read_grating(Section& section)
{
    constexpr std::array<std::string_view, 3> kProfiles{"sinusoidal", "rectangular", "blazed"};
    GratingSpec result;
    section.require("pitch_nm", "a number > 0, or { default, min, max }");
    result.pitch_nm = read_quantity(section, "pitch_nm", {100.0, 1e6}, true);
    section.require("depth_nm", "a number ≥ 0");
    result.depth_nm = section.number("depth_nm", {0.0, 1e5}).value_or(0.0);
    section.require("profile", "sinusoidal, rectangular or blazed");
    if (const auto profile = section.text("profile")) {
        const auto it = std::ranges::find(kProfiles, *profile);
        if (it == kProfiles.end())
            section.report("profile", fmt::format("must be {} (got \"{}\")",
                                                  fmt::join(kProfiles, ", "), *profile));
        else
            result.profile = static_cast<GratingProfile>(it - kProfiles.begin());
    }
    if (result.profile == GratingProfile::rectangular)
        result.duty = section.number("duty", {0.0, 1.0}).value_or(0.5);
    result.orders = section.integer("orders", 1, kMaxOrders).value_or(3);
    result.cover = read_medium_at(section, "cover");
    result.substrate = read_medium_at(section, "substrate");
    if (absorbs(result.cover)) section.report("cover", "must not absorb: k must be 0");
    section.report_unknown_keys();
    return result;
}

GlassSpec read_glass(Section& section)
{
    GlassSpec result{read_medium(section)};
    if (absorbs(result.medium)) section.report("k", "must be 0: the glass is clear");
    section.report_unknown_keys();
    return result;
}

}  // namespace

MediumSpec read_medium(Section& section)
{
    constexpr std::array<std::string_view, 5> kForms{"medium", "n", "cauchy", "sellmeier", "abbe"};
    MediumSpec result;
    const auto given = [&](std::string_view key) { return section.has(key); };
    const auto first = std::ranges::find_if(kForms, given);
    const std::string_view form = first == kForms.end() ? "medium" : *first;
    result.line = section.line(form);
    result.field = section.field(form);
    if (std::ranges::count_if(kForms, given) != 1)
        section.report(form,
                       fmt::format("must be given by exactly one of {}", fmt::join(kForms, ", ")));

    constexpr Bounds kIndex{.min = 0.0, .max = 100.0, .exclusive_min = true};
    const auto key = section.text("medium");
    const auto n = section.number("n", kIndex);
    const auto coefficients = section.numbers("cauchy", 1, 3);
    const bool takes_k = form == "n" || form == "cauchy";
    const double k = takes_k ? section.number("k", {0.0, 100.0}).value_or(0.0) : 0.0;
    if (form == "medium")
        result.value = LibraryMedium{key.value_or("")};
    else if (form == "n")
        result.value = ConstantMedium{n.value_or(1.0), k};
    else if (form == "cauchy")
        result.value = CauchyMedium{coefficients.value_or(std::vector<double>{1.0}), k};
    const SellmeierMedium sellmeier = read_sellmeier(section);
    const AbbeMedium abbe = read_abbe(section);
    if (form == "sellmeier")
        result.value = sellmeier;
    else if (form == "abbe")
        result.value = abbe;
    return result;
}

std::variant<StackSpec, GratingSpec, GlassSpec> read_kind(Section& root)
{
    auto grating = root.section("grating");
    auto glass = root.section("glass");
    if (root.has("grating") && root.has("glass"))
        root.report("glass", "excludes [grating]: a material is of one kind");
    if (root.has("grating")) return grating ? read_grating(*grating) : GratingSpec{};
    if (root.has("glass")) return glass ? read_glass(*glass) : GlassSpec{};
    return read_stack(root);
}

}  // namespace nacre::material
