// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "files/stack_input.h"

#include <filesystem>

#include <fmt/format.h>

#include "files/json_input.h"
#include "nacre/core/file_io.h"
#include "nacre/kinds/read_template.h"

namespace nacre::tool {
namespace {

using kinds::MaterialTemplate;

constexpr const char* kAnonymous =
    R"({ id = "stack", name = "Stack", category = "Stacks", source = "given as JSON" })";

std::string toml_value(const json& value);

std::string toml_table(const json& object)
{
    std::string text;
    for (const auto& [key, value] : object.items())
        text +=
            fmt::format("{}{} = {}", text.empty() ? "" : ", ", json(key).dump(), toml_value(value));
    return "{ " + text + " }";
}

/// JSON and TOML share their strings, numbers and booleans; the words that JSON lacks arrive as
/// marked strings, see parse_json().
std::string toml_value(const json& value)
{
    if (value.is_object()) return toml_table(value);
    if (value.is_null()) throw InputError({"", 0, "", "null has no meaning here"});
    if (!value.is_array()) {
        const std::string word = quoted(value);
        if (word == "NaN") return "nan";
        if (word == "Infinity") return "inf";
        return word == "-Infinity" ? "-inf" : value.dump();
    }
    std::string text;
    for (const json& element : value) text += (text.empty() ? "" : ", ") + toml_value(element);
    return "[" + text + "]";
}

/// So that both forms go through one reader, with the same checks and messages.
std::string toml_from_json(const json& root, const std::string& file)
{
    if (!root.is_object())
        throw InputError({file, 0, "", fmt::format("must be an object (got {})", quoted(root))});
    std::string text;
    if (!root.contains("schema")) text += "schema = 1\n";
    if (!root.contains("material")) text += fmt::format("material = {}\n", kAnonymous);
    for (const auto& [key, value] : root.items())
        text += fmt::format("{} = {}\n", json(key).dump(), toml_value(value));
    return text;
}

MaterialTemplate parse_json_template(const std::string& file)
{
    const json root = parse_json(read_input(file), file).value;
    try {
        return kinds::parse_template(toml_from_json(root, file), file);
    } catch (const InputError& error) {
        // Lines of the intermediate text mean nothing to the user.
        std::vector<Diagnostic> diagnostics(error.diagnostics().begin(), error.diagnostics().end());
        for (Diagnostic& diagnostic : diagnostics) {
            diagnostic.file = file;
            diagnostic.line = 0;
        }
        throw InputError(std::move(diagnostics));
    }
}

struct MediumJson {
    ordered_json operator()(const material::LibraryMedium& medium) const
    {
        return {{"medium", medium.key}};
    }
    ordered_json operator()(const material::ConstantMedium& medium) const
    {
        return {{"n", medium.n}, {"k", medium.k}};
    }
    ordered_json operator()(const material::CauchyMedium& medium) const
    {
        return {{"cauchy", medium.coefficients}, {"k", medium.k}};
    }
    ordered_json operator()(const material::SellmeierMedium& medium) const
    {
        return {{"sellmeier", {{"b", medium.b}, {"c", medium.c}}}};
    }
    ordered_json operator()(const material::AbbeMedium& medium) const
    {
        return {{"abbe", {{"n_d", medium.n_d}, {"v_d", medium.v_d}}}};
    }
};

ordered_json medium_json(const material::MediumSpec& medium)
{
    return std::visit(MediumJson{}, medium.value);
}

ordered_json range_json(const material::Quantity& quantity)
{
    ordered_json result = {{"default", quantity.value}};
    if (quantity.min) result["min"] = *quantity.min;
    if (quantity.max) result["max"] = *quantity.max;
    return result;
}

ordered_json thickness_json(const material::Quantity& thickness)
{
    if (!thickness.varies) return thickness.value;
    ordered_json result = range_json(thickness);
    result["varies"] = true;
    return result;
}

}  // namespace

MaterialTemplate read_template_input(const std::string& file)
{
    const std::string extension = std::filesystem::path(file).extension().string();
    if (file == "-" || extension == ".json") return parse_json_template(file);
    if (extension != ".toml" && extension != ".osl")
        throw InputError(
            {file, 0, "",
             "must be a template (.toml), the JSON of one (.json) or a shader (.osl)"});
    return kinds::parse_template(read_text(file), file);
}

std::string stack_json(const MaterialTemplate& source)
{
    const kinds::Film& stack = kinds::film_of(source);
    ordered_json layers = ordered_json::array();
    for (const kinds::LayerSpec& layer : stack.layers) {
        ordered_json entry = medium_json(layer.medium);
        entry["thickness_nm"] = thickness_json(layer.thickness_nm);
        if (!layer.coherent) entry["coherent"] = false;
        layers.push_back(std::move(entry));
    }
    ordered_json result = {{"ambient", medium_json(stack.ambient)},
                           {"layer", std::move(layers)},
                           {"substrate", medium_json(stack.substrate)}};
    if (stack.scale) result["stack"] = {{"scale", range_json(*stack.scale)}};
    if (stack.transmission) result["surface"] = {{"transmission", true}};
    return result.dump();
}

}  // namespace nacre::tool
