// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shader_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "nacre/oslgen/literals.h"
#include "nacre/oslgen/lost_light.h"

namespace nacre::oslgen {
namespace {

/// Two question marks may begin a trigraph, which the preprocessor warns of even in strings, and
/// Cycles takes warnings for errors; neighbouring literals are one string.
std::string string_literal(std::string_view text)
{
    std::string result = "\"";
    char before = 0;
    for (const char c : text) {
        if (c == '?' && before == '?') result += "\" \"";
        if (c == '"' || c == '\\') result += '\\';
        result += c;
        before = c;
    }
    return result + '"';
}

/// In a comment nothing joins what was taken apart.
std::string comment_text(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        if (c == '?' && result.ends_with('?')) result += ' ';
        result += c;
    }
    return result;
}

std::string metadata(std::string_view label, std::string_view help, std::string_view more = "")
{
    return fmt::format("\n        [[ string label = {}, string help = {}{} ]]",
                       string_literal(label), string_literal(help), more);
}

std::string parameter(const Socket& socket)
{
    if (socket.type == "normal")
        return "    normal surface_normal = N" + metadata(socket.label, socket.description);
    if (socket.type == "tangent")
        return "    vector tangent = vector(0.0)" + metadata(socket.label, socket.description);
    if (socket.type == "color")
        return fmt::format("    color {} = {}", socket.name, literal(socket.colour)) +
               metadata(socket.label, socket.description);
    if (socket.type == "int")
        return fmt::format("    int {} = {}", socket.name, static_cast<int>(socket.value)) +
               metadata(socket.label, socket.description,
                        fmt::format(", int min = {}, int max = {}", static_cast<int>(socket.min),
                                    static_cast<int>(socket.max)));
    const std::string units =
        socket.unit == "1" ? "" : fmt::format(", string units = {}", string_literal(socket.unit));
    return fmt::format("    float {} = {}", socket.name, literal(socket.value)) +
           metadata(socket.label, socket.description,
                    fmt::format("{}, float min = {}, float max = {}", units, literal(socket.min),
                                literal(socket.max)));
}

constexpr std::string_view kHidden = ", string widget = \"null\"";

/// Whether the powers of the film's reflectance fade to those of the substrate.
bool has_schlick_bare(const Context& context)
{
    return context.schlick && find_table(context, "R_bare");
}

/// Parameters that carry a film's colours: looked up outside, or from a table that is named.
std::string film_parameters(const Context& context)
{
    std::string result;
    for (const std::string& name : looked_up_colours(context)) {
        result += fmt::format(",\n    color {}_in = color(0.0)", name);
        result += metadata(name + " Colour",
                           "Colour looked up outside; used where the table has no name");
    }
    for (const TableInfo& table : context.tables) {
        result += fmt::format(",\n    string table_{} = \"\"", table.name);
        result += metadata(table.name + " Table",
                           "File of " + table.file + "; leave unlinked, renderers need a constant",
                           ", string widget = \"filename\"");
    }
    if (has_schlick_bare(context)) {
        const auto& bare = context.schlick->bare;
        result +=
            fmt::format(",\n    color schlick_bare[{}] = {}", bare.size(), array_literal(bare));
        result +=
            metadata("Bare Coefficients", "Of the powers of the cosine, without the film", kHidden);
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
    if (context.grating) {
        const auto& basis = context.grating->basis;
        result +=
            fmt::format(",\n    color tint_basis[{}] = {}", basis.size(), array_literal(basis));
        result +=
            metadata("Tint Basis", "What the metal leaves of each cell, by its colour", kHidden);
    }
    if (context.glass) {
        result += fmt::format(",\n    float index_knots[{}] = {}", context.glass->knots.size(),
                              array_literal(context.glass->knots));
        result += metadata("Index", "Index over wavelength at equally spaced knots", kHidden);
        result += fmt::format(",\n    color index_mean = {}", literal(context.glass->mean_rgb));
        result +=
            metadata("Mean Index", "Mean of the index with the weight of each channel", kHidden);
    }
    return result;
}

std::string_view row_of(const TableInfo& table)
{
    return table.y.texels == 1 ? "0.0" : "y";
}

/// A table's colour at (x, y), or what was looked up outside under `name`.
std::string look_up(const TableInfo& table, std::string_view name, std::string_view x = "x")
{
    return fmt::format(
        "nacre_film_colour(table_{0}, {1}_in, {2}, {3}, {4}.0, {5}.0, table_origin_top)",
        table.name, name, x, row_of(table), table.x.texels, table.y.texels);
}

/// A rough table's colour over `smooth`, the expression of the colour at roughness 0. Of brushed
/// surfaces further bounces are looked up apart; see nacre_facets.
enum class Facets { seen, further };

std::string rough_colour(const TableInfo& rough, std::string_view smooth, Facets facets)
{
    const bool apart = facets == Facets::further;
    return fmt::format(
        "{0}nacre_rough_table(table_{1}, {2}, nacre_level(facets.{3}), {4},\n"
        "                                facets.seen_cosine, {5}, {6}.0, {7}.0, table_origin_top)",
        apart ? "facets.further_scale * " : "", rough.name, smooth, apart ? "further" : "seen",
        rough.sides, row_of(rough), rough.x.texels / (rough.sides * rough.slices), rough.y.texels);
}

/// `color NAME = …;` of one quantity and substrate, with or without film.
std::string colour_of(const Context& context, const std::string& quantity,
                      const std::string& suffix)
{
    const std::string name = quantity + suffix;
    std::string result =
        fmt::format("    color {} = {};\n", name, look_up(*find_table(context, name), name));
    const TableInfo* rough = find_table(context, quantity + "_rough" + suffix);
    if (!rough) return result;
    result += fmt::format("    if (table_{} != \"\")\n        {} = {};\n", rough->name, name,
                          rough_colour(*rough, name, Facets::seen));
    const TableInfo* further = find_table(context, quantity + "_further" + suffix);
    if (!further || !context.source->surface.anisotropy) return result;
    constexpr std::string_view kBlack = "color(0.0)";
    return result + fmt::format("    if (table_{} != \"\")\n        {} += {} -\n             {};\n",
                                further->name, name,
                                rough_colour(*further, kBlack, Facets::further),
                                rough_colour(*further, kBlack, Facets::seen));
}

/// Statement that fades the colour NAME to NAME_bare by the coverage.
std::string fade(std::string_view name)
{
    return fmt::format("    {0} = mix({0}_bare, {0}, clamp(coverage, 0.0, 1.0));\n", name);
}

/// `color R = …;`, faded to the bare substrate where the material has coverage.
std::string film_colour(const Context& context, const std::string& name)
{
    std::string result = colour_of(context, name, "");
    if (has_bare(context, name)) result += colour_of(context, name, "_bare") + fade(name);
    return result;
}

/// What leaves a rough surface after two and more bounces.
std::string further_colour(const Context& context)
{
    const Facets facets = context.source->surface.anisotropy ? Facets::further : Facets::seen;
    std::string result;
    for (const std::string suffix : {"", "_bare"}) {
        const TableInfo* table = find_table(context, "R_further" + suffix);
        if (!table) continue;
        const std::string name = "R_further" + suffix;
        result += fmt::format("    color {0} = table_{0} == \"\" ? {0}_in :\n        {1};\n", name,
                              rough_colour(*table, "color(0.0)", facets));
    }
    if (find_table(context, "R_further_bare")) result += fade("R_further");
    return result;
}

/// One lobe for each power of the film's reflectance; the first has the further bounces too.
std::string power_lobes(const Context& context)
{
    const TableInfo& table = *find_table(context, "R_schlick");
    const SchlickTerms& terms = context.schlick.value();
    const double last = table.x.texels - 1;
    std::string result;
    for (std::size_t k = 0; k < terms.exponents.size(); ++k) {
        const std::string at = literal(static_cast<double>(k) / last);
        std::string colour = look_up(table, fmt::format("R_schlick_{}", k), at);
        if (has_schlick_bare(context))
            colour = fmt::format("mix(schlick_bare[{}], {}, clamp(coverage, 0.0, 1.0))", k, colour);
        if (k == 0) colour += " + R_further";
        result += fmt::format("    BSDF = nacre_power_lobe(surface_normal, {}, {}, facets){};\n",
                              colour, literal(terms.exponents[k]), k == 0 ? "" : " + BSDF");
    }
    return result;
}

/// The statements four columns further to the right.
std::string indented(std::string_view statements)
{
    std::string result;
    bool starts = true;
    for (const char c : statements) {
        if (starts) result += "    ";
        result += c;
        starts = c == '\n';
    }
    return result;
}

/// The lobe of the film itself.
std::string reflection(const Context& context)
{
    std::string tinted = "    BSDF = nacre_tinted_lobe(surface_normal, R, facets);\n";
    if (!context.schlick) return tinted;
    return "    if (exact_rough && nacre_level(facets.seen) >= 1.0) {\n" +
           indented(further_colour(context) + power_lobes(context)) + "    } else {\n" +
           indented(tinted) + "    }\n";
}

/// What becomes of the light that passes the film.
std::string below_the_film(const Context& context)
{
    switch (context.source->interior()) {
        case material::Interior::opaque:
            return reflection(context);
        case material::Interior::thin_wall:
            return film_colour(context, "T") + reflection(context) +
                   "    BSDF = T * transparent() + BSDF;\n";
        case material::Interior::solid:
            return film_colour(context, "T") + colour_of(context, "lobe_R", "") +
                   colour_of(context, "lobe_T", "") +
                   fmt::format(
                       "    BSDF = nacre_coated_glass(surface_normal, roughness, {}, R, T, "
                       "lobe_R, lobe_T);\n",
                       literal(context.solid_index.value()));
        case material::Interior::diffuse:
            return film_colour(context, "T") + film_colour(context, "R_inner") +
                   film_colour(context, "T_inner") +
                   "    color base = T * nacre_base_colour(base_colour, R_inner, T_inner);\n" +
                   reflection(context) + "    BSDF = base * diffuse(surface_normal) + BSDF;\n";
    }
    return "";
}

std::string brushed_facets()
{
    std::vector<double> lost;
    for (const auto& row : kLostLight) lost.insert(lost.end(), row.begin(), row.end());
    return fmt::format(
        "    float lost[{}] = {};\n"
        "    nacre_facets facets = nacre_brushed_facets(surface_normal, tangent, x, roughness,\n"
        "                                               anisotropy, rotation, lost, {}, {});\n",
        lost.size(), array_literal(lost), literal(kLeastLostAlpha), literal(kLeastLostCosine));
}

std::string film_body(const Context& context)
{
    const TableInfo::Axis& axis = find_table(context, "R")->y;
    std::string body = "    float x = fabs(dot(surface_normal, I));\n";
    std::string column = "x";
    if (context.solid_index) {
        body += fmt::format(
            "    float column = nacre_glass_column(x, {0});\n"
            "    x = nacre_ambient_cosine(x, {0});\n",
            literal(*context.solid_index));
        column = "column";
    }
    if (axis.texels > 1)
        body += fmt::format("    float y = ({} - {}) / {};\n", axis.name, literal(axis.min),
                            literal(axis.max - axis.min));
    body += context.source->surface.anisotropy
                ? brushed_facets()
                : fmt::format("    nacre_facets facets = nacre_isotropic_facets({}, roughness);\n",
                              column);
    return body + film_colour(context, "R") + below_the_film(context);
}

std::string grating_body(const Context& context)
{
    const auto& grating = std::get<material::GratingSpec>(context.source->kind);
    return fmt::format(
        "    nacre_disc_tracks disc = {{ {}, max(pitch_nm, 100.0), {}, {}, {}, {},\n"
        "                               clamp(strength, 0.0, 1.0) }};\n"
        "    BSDF = nacre_disc_lobes(disc, surface_normal, roughness, tint, wavelength_edges,\n"
        "                            wavelength_weight, tint_basis);\n",
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
        "                            mix(color({}), index_mean, dispersion),\n"
        "                            dispersion > 0.0 ? path.weight : color(1.0));\n",
        literal(glass.first_nm), literal(glass.step_nm), literal(glass.n_d), literal(glass.n_d));
}

std::string includes(const Context& context)
{
    if (std::holds_alternative<material::StackSpec>(context.source->kind))
        return fmt::format("#include \"nacre/nacre_rough.h\"\n#include \"nacre/{}\"\n",
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

std::vector<std::string> looked_up_colours(const Context& context)
{
    std::vector<std::string> names;
    for (const TableInfo& table : context.tables) {
        if (table.name == "R_schlick") {
            for (int k = 0; k < table.x.texels; ++k)
                names.push_back(fmt::format("R_schlick_{}", k));
        } else if (table.slices == 1 || table.name.starts_with("R_further")) {
            names.push_back(table.name);
        }
    }
    return names;
}

bool has_bare(const Context& context, std::string_view name)
{
    return context.source->parameter("coverage") != nullptr &&
           find_table(context, std::string(name) + "_bare") != nullptr;
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
        includes(context), comment_text(source.name), context.space, source.id,
        string_literal(source.name), string_literal(source.description), parameters, body(context));
}

}  // namespace nacre::oslgen
