// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "nacre/core/resources.h"
#include "nacre/core/sha256.h"
#include "nacre/core/text_lines.h"
#include "shader/hand_written.h"
#include "shader/node_form.h"
#include "shader/presets.h"

namespace nacre::kinds {
namespace {

using oslgen::ShaderParameter, oslgen::ShaderSource, oslgen::Socket;

/// Of numbers that state none.
constexpr double kWidest = 1e6;

/// Our shaders' names have it, their materials' ids do not.
constexpr std::string_view kPrefix = "nacre_";

/// Numbers of `color(r, g, b)`, of one for all three, or of one alone.
std::optional<std::array<double, 3>> literal_colour(std::string_view text)
{
    constexpr std::string_view kColour = "color(";
    if (text.starts_with(kColour) && text.ends_with(')')) {
        text.remove_prefix(kColour.size());
        text.remove_suffix(1);
    }
    std::vector<double> values;
    while (values.size() < 3) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const auto value = literal_number(text.substr(0, comma));
        if (!value) return std::nullopt;
        values.push_back(*value);
        if (comma == text.size()) break;
        text.remove_prefix(comma + 1);
    }
    if (values.size() == 1) return std::array{values[0], values[0], values[0]};
    return values.size() == 3 ? std::optional(std::array{values[0], values[1], values[2]})
                              : std::nullopt;
}

/// One shader, with all that is wrong in it.
class ShaderReader {
public:
    explicit ShaderReader(const ShaderSource& shader) : shader_(&shader) {}

    MaterialTemplate material()
    {
        auto kind = std::make_shared<HandWritten>();
        kind->shader = *shader_;
        kind->told = traits();
        for (const ShaderParameter& parameter : shader_->parameters)
            if (auto found = socket(parameter)) kind->sockets.push_back(*std::move(found));
        check_includes();
        for (const auto& [form, graph] :
             {std::pair{NodeForm::nodes, &kind->nodes}, {NodeForm::bands, &kind->bands}})
            *graph = node_form(form, *shader_, kind->sockets, kind->told.closures, problems_);
        kind->presets = read_presets(*shader_, kind->sockets, problems_);
        MaterialTemplate result = head();
        result.kind = std::move(kind);
        problems_.throw_if_any();
        return result;
    }

private:
    const ShaderSource* shader_;
    DiagnosticList problems_;

    void report(int line, std::string_view field, std::string message)
    {
        problems_.add({shader_->file, line, std::string(field), std::move(message)});
    }

    /// Of the shader's metadata.
    std::string text(std::string_view entry, std::string_view what)
    {
        std::string value(shader_->told(entry));
        if (value.empty())
            report(shader_->line, entry,
                   fmt::format("is missing: [[ string {} = \"…\" ]], {}", entry, what));
        return value;
    }

    /// The place of an entry's value among `names`; the first where there is none.
    template <std::size_t N>
    std::size_t choice(std::string_view value, int line, std::string_view entry,
                       const std::array<std::string_view, N>& names)
    {
        const auto it = std::ranges::find(names, value);
        if (it != names.end()) return static_cast<std::size_t>(it - names.begin());
        if (!value.empty())
            report(line, entry,
                   fmt::format("must be one of {} (got \"{}\")", fmt::join(names, ", "), value));
        return 0;
    }

    /// A material is one file, in which headers are put in place: they must be ours.
    void check_includes()
    {
        constexpr std::string_view kInclude = "#include \"";
        TextLines lines(shader_->text);
        while (const auto next = lines.next()) {
            std::string_view line = *next;
            if (!line.starts_with(kInclude)) continue;
            line.remove_prefix(kInclude.size());
            const std::string_view header = line.substr(0, line.find('"'));
            if (!find_resource(fmt::format("osl/{}", header)))
                report(
                    lines.number(), "include",
                    fmt::format("must be a header of Nacre's, nacre/…, as a material is one file; "
                                "put others in place (got \"{}\")",
                                header));
        }
    }

    MaterialTemplate head()
    {
        MaterialTemplate result;
        result.file = shader_->file;
        result.text = shader_->text;
        result.sha256 = sha256_hex(shader_->text);
        result.id = material_id(*shader_);
        if (std::string problem = material::id_problem(result.id); !problem.empty())
            report(shader_->line, "shader", std::move(problem));
        result.name = text("label", "as the artist reads it");
        result.category = text("category", "path in the asset catalogue");
        result.source = text("source", "where formulas and values come from");
        result.description = shader_->told("help");
        result.look.object = shader_->told("look");
        using material::Status;
        constexpr std::array kStatuses{Status::typical, Status::sourced, Status::measured};
        std::array<std::string_view, kStatuses.size()> names;
        std::ranges::transform(kStatuses, names.begin(), material::status_name);
        result.status = kStatuses[choice(shader_->told("status"), shader_->line, "status", names)];
        for (std::string_view rest = shader_->told("tags"); !rest.empty();)
            result.tags.push_back(next_item(rest, ','));
        return result;
    }

    oslgen::Traits traits()
    {
        oslgen::Traits result;
        result.stage = shader_->told("stage", result.stage);
        result.is_body = shader_->told("is_body") == "1";
        constexpr std::array<std::string_view, 2> kTruths{"", "white"};
        if (choice(shader_->told("truth"), shader_->line, "truth", kTruths) == 1)
            result.truth = oslgen::Truth::white;
        // Who draws a random number for the path splits white light.
        result.wavelength_per_path = shader_->text.find("nacre_path_random") != std::string::npos;
        result.closures.clear();
        for (const ShaderParameter& output : shader_->parameters) {
            if (!output.is_output || output.type != "closure color") continue;
            using oslgen::ClosureRole;
            constexpr std::array kRoles{ClosureRole::surface, ClosureRole::emission,
                                        ClosureRole::volume};
            std::array<std::string_view, kRoles.size()> names;
            std::ranges::transform(kRoles, names.begin(), oslgen::closure_role_name);
            result.closures.push_back(
                {output.name,
                 kRoles[choice(output.told("role"), output.line, output.name + ".role", names)]});
        }
        if (result.closures.empty())
            report(shader_->line, shader_->name, "must have an output closure color");
        return result;
    }

    /// What a node group can have as an input: numbers, colours, and directions that the geometry
    /// gives where nothing is plugged in. All else keeps the shader's default.
    std::optional<Socket> socket(const ShaderParameter& parameter)
    {
        if (parameter.is_output || parameter.is_hidden() || !parameter.size.empty())
            return std::nullopt;
        Socket result{.name = parameter.name,
                      .label = std::string(parameter.told("label", parameter.name)),
                      .type = parameter.type,
                      .unit = std::string(parameter.told("units", "1")),
                      .description = std::string(parameter.told("help"))};
        if (parameter.type == "float" || parameter.type == "int") {
            read_number(parameter, result);
        } else if (parameter.type == "color") {
            if (const auto colour = literal_colour(parameter.value))
                result.colour = *colour;
            else
                report_default(parameter, "a colour of numbers");
        } else if (parameter.type == "normal" && parameter.value == "N") {
            result.name = "normal";
            if (parameter.name != oslgen::parameter_name(result))
                report(parameter.line, parameter.name,
                       fmt::format("must be called {}: bump and normal maps go there",
                                   oslgen::parameter_name(result)));
        } else if (parameter.type == "vector" && parameter.name == "tangent") {
            result.type = "tangent";
        } else {
            return std::nullopt;
        }
        return result;
    }

    void read_number(const ShaderParameter& parameter, Socket& socket)
    {
        const auto number = [&](std::string_view entry, double otherwise) {
            const std::string_view said = parameter.told(entry);
            if (said.empty()) return otherwise;
            const auto value = literal_number(said);
            if (!value)
                report(parameter.line, fmt::format("{}.{}", parameter.name, entry),
                       fmt::format("must be a number (got {})", said));
            return value.value_or(otherwise);
        };
        socket.min = number("min", -kWidest);
        socket.max = number("max", kWidest);
        const auto value = literal_number(parameter.value);
        if (!value || (parameter.type == "int" && *value != std::floor(*value)))
            report_default(parameter, parameter.type == "int" ? "a whole number" : "a number");
        else if (*value < socket.min || *value > socket.max)
            report(parameter.line, parameter.name,
                   fmt::format("default must be in [{}, {}] (got {})", socket.min, socket.max,
                               parameter.value));
        socket.value = value.value_or(0.0);
    }

    void report_default(const ShaderParameter& parameter, std::string_view what)
    {
        report(parameter.line, parameter.name,
               fmt::format("default must be {}, or the parameter hidden: [[ string widget = "
                           "\"null\" ]] (got {})",
                           what, parameter.value));
    }
};

}  // namespace

std::string material_id(const oslgen::ShaderSource& shader)
{
    const bool is_ours = shader.name.starts_with(kPrefix);
    return is_ours ? shader.name.substr(kPrefix.size()) : shader.name;
}

MaterialTemplate read_shader(std::string_view osl, std::string_view file)
{
    const ShaderSource shader = oslgen::parse_shader(osl, file);
    return ShaderReader(shader).material();
}

}  // namespace nacre::kinds
