// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "nacre/oslgen/literals.h"

namespace nacre::oslgen {
namespace {

std::string quoted(std::string_view text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::string metadata(std::string_view label, std::string_view help, std::string_view more = "")
{
    return fmt::format("\n        [[ string label = {}, string help = {}{} ]]", quoted(label),
                       quoted(help), more);
}

std::string parameter(const Socket& socket)
{
    if (socket.type == "normal")
        return "    normal surface_normal = N" + metadata(socket.label, socket.description);
    if (socket.type == "color")
        return fmt::format("    color {} = {}", socket.name, literal(socket.colour)) +
               metadata(socket.label, socket.description);
    const std::string units =
        socket.unit == "1" ? "" : fmt::format(", string units = {}", quoted(socket.unit));
    return fmt::format("    float {} = {}", socket.name, literal(socket.value)) +
           metadata(socket.label, socket.description,
                    fmt::format("{}, float min = {}, float max = {}", units, literal(socket.min),
                                literal(socket.max)));
}

constexpr std::string_view kHidden = ", string widget = \"null\"";

/// Parameters that carry a film's colours: looked up outside, or from a table that is named.
std::string film_parameters(const Context& context)
{
    std::string result;
    for (const TableInfo& table : context.tables) {
        result += fmt::format(",\n    color {}_in = color(0.0)", table.name);
        result += metadata(table.name + " Colour",
                           "Colour looked up outside; used where the table has no name");
    }
    for (const TableInfo& table : context.tables) {
        result += fmt::format(",\n    string table_{} = \"\"", table.name);
        result += metadata(table.name + " Table",
                           "File of " + table.file + "; leave unlinked, renderers need a constant",
                           ", string widget = \"filename\"");
    }
    result += ",\n    int table_origin_top = 1";
    result += metadata("Table Origin Top", "0 where t = 0 names the bottom row of a texture",
                       ", string widget = \"checkBox\"");
    return result;
}

std::string wavelength_parameters(const Context& context)
{
    const WavelengthTable& table = context.wavelengths.value();
    std::string result = fmt::format(",\n    float wavelength_edges[{}] = {}",
                                     table.edges_nm.size(), array_literal(table.edges_nm));
    result += metadata("Wavelength Edges", "Inverse CDF of the path's wavelength, nm", kHidden);
    result += fmt::format(",\n    color wavelength_weight[{}] = {}", table.weight.size(),
                          array_literal(table.weight));
    result += metadata("Wavelength Weight", "Colour that a path of each cell carries", kHidden);
    if (context.glass) {
        result += fmt::format(",\n    float index_knots[{}] = {}", context.glass->knots.size(),
                              array_literal(context.glass->knots));
        result += metadata("Index", "Index over wavelength at equally spaced knots", kHidden);
    }
    return result;
}

std::string look_up(const TableInfo& table)
{
    const std::string y = table.y.texels == 1 ? "0.0" : "y";
    return fmt::format(
        "nacre_film_colour(table_{0}, {0}_in, x, {1}, {2}.0, {3}.0, "
        "table_origin_top)",
        table.name, y, table.x.texels, table.y.texels);
}

/// `color R = …;`, faded to the bare substrate where the material has coverage.
std::string film_colour(const Context& context, const std::string& name)
{
    const TableInfo* table = find_table(context, name);
    const TableInfo* bare = find_table(context, name + "_bare");
    std::string result = fmt::format("    color {} = {};\n", name, look_up(*table));
    if (bare)
        result += fmt::format("    {0} = mix({1}, {0}, clamp(coverage, 0.0, 1.0));\n", name,
                              look_up(*bare));
    return result;
}

/// What becomes of the light that passes the film.
std::string below_the_film(const Context& context)
{
    switch (context.source->interior()) {
        case material::Interior::opaque:
            return "    BSDF = nacre_reflection(surface_normal, R, roughness);\n";
        case material::Interior::thin_wall:
            return film_colour(context, "T") +
                   "    BSDF = nacre_reflection(surface_normal, R, roughness);\n"
                   "    BSDF = T * transparent() + BSDF;\n";
        case material::Interior::solid:
            return film_colour(context, "T") +
                   fmt::format(
                       "    BSDF = nacre_coated_glass(surface_normal, roughness, {}, R, T);\n",
                       literal(context.solid_index.value()));
        case material::Interior::diffuse:
            return film_colour(context, "T") + film_colour(context, "R_inner") +
                   film_colour(context, "T_inner") +
                   "    color base = T * nacre_base_colour(base_colour, R_inner, T_inner);\n"
                   "    BSDF = nacre_reflection(surface_normal, R, roughness);\n"
                   "    BSDF = base * diffuse(surface_normal) + BSDF;\n";
    }
    return "";
}

std::string film_body(const Context& context)
{
    const TableInfo::Axis& axis = find_table(context, "R")->y;
    std::string body = "    float x = fabs(dot(surface_normal, I));\n";
    if (context.solid_index)
        body +=
            fmt::format("    x = nacre_ambient_cosine(x, {});\n", literal(*context.solid_index));
    if (axis.texels > 1)
        body += fmt::format("    float y = ({} - {}) / {};\n", axis.name, literal(axis.min),
                            literal(axis.max - axis.min));
    return body + film_colour(context, "R") + below_the_film(context);
}

std::string grating_body(const Context& context)
{
    const auto& grating = std::get<material::GratingSpec>(context.source->kind);
    return fmt::format(
        "    nacre_disc_tracks disc = {{ {}, max(pitch_nm, 100.0), {}, {}, {}, {},\n"
        "                               clamp(strength, 0.0, 1.0) }};\n"
        "    BSDF = nacre_disc_lobes(disc, surface_normal, roughness, tint, wavelength_edges,\n"
        "                            wavelength_weight);\n",
        static_cast<int>(grating.profile), literal(grating.depth_nm), literal(grating.duty),
        literal(context.grating->cover_index), grating.orders);
}

std::string glass_body(const Context& context)
{
    const GlassIndex& glass = context.glass.value();
    return fmt::format(
        "    nacre_wavelength path = nacre_draw_wavelength(wavelength_edges, wavelength_weight,\n"
        "                                                  nacre_path_random());\n"
        "    float index = nacre_index(index_knots, {}, {}, path.nm);\n"
        "    BSDF = nacre_glass_lobe(surface_normal, roughness, mix({}, index, dispersion),\n"
        "                            mix(color({}), {}, dispersion),\n"
        "                            dispersion > 0.0 ? path.weight : color(1.0));\n",
        literal(glass.first_nm), literal(glass.step_nm), literal(glass.n_d), literal(glass.n_d),
        literal(glass.mean_rgb));
}

std::string includes(const Context& context)
{
    if (std::holds_alternative<material::StackSpec>(context.source->kind))
        return fmt::format("#include \"nacre/{}\"\n#include \"nacre/nacre_table.h\"\n",
                           context.solid_index ? "nacre_coated_glass.h" : "nacre_surface.h");
    if (std::holds_alternative<material::GratingSpec>(context.source->kind))
        return "#include \"nacre/nacre_disc.h\"\n";
    return "#include \"nacre/nacre_dispersion.h\"\n#include \"nacre/nacre_glass.h\"\n";
}

std::string body(const Context& context)
{
    if (std::holds_alternative<material::StackSpec>(context.source->kind))
        return film_body(context);
    if (std::holds_alternative<material::GratingSpec>(context.source->kind))
        return grating_body(context);
    return glass_body(context);
}

}  // namespace

std::string_view parameter_name(const Socket& socket)
{
    return socket.type == "normal" ? "surface_normal" : std::string_view(socket.name);
}

const TableInfo* find_table(const Context& context, std::string_view name)
{
    const auto it = std::ranges::find(context.tables, name, &TableInfo::name);
    return it == context.tables.end() ? nullptr : &*it;
}

std::string shader_text(const Context& context)
{
    const material::MaterialTemplate& source = *context.source;
    std::string parameters;
    for (const Socket& socket : sockets(context))
        parameters += (parameters.empty() ? "" : ",\n") + parameter(socket);
    parameters += context.wavelengths ? wavelength_parameters(context) : film_parameters(context);
    return fmt::format(
        "{}\n"
        "// {}. Made by `nacre compile`; colours are in {}.\n"
        "shader nacre_{}"
        "\n[[ string label = {}, string help = {} ]]\n"
        "(\n{},\n    output closure color BSDF = 0\n)\n{{\n{}}}\n",
        includes(context), source.name, context.space, source.id, quoted(source.name),
        quoted(source.description), parameters, body(context));
}

}  // namespace nacre::oslgen
