// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nacre/oslgen/literals.h"
#include "nacre/oslgen/lost_light.h"
#include "writers.h"

namespace nacre::oslgen {
namespace {

std::string_view row_of(const TableInfo& table)
{
    return table.y.texels == 1 ? "0.0" : "y";
}

/// A table's colour at (x, y), or what was looked up outside under `name`.
std::string look_up(const TableInfo& table, std::string_view name, std::string_view x = "x")
{
    return fmt::format(
        "nacre_film_colour(table_{0}, {1}_in, {2}, {3}, {4}.0, {5}.0, table_origin_top)",
        table.name(), name, x, row_of(table), table.x.texels, table.y.texels);
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
        apart ? "facets.further_scale * " : "", rough.name(), smooth, apart ? "further" : "seen",
        rough.sides, row_of(rough), rough.x.texels / (rough.sides * rough.slices), rough.y.texels);
}

/// `color NAME = …;`
std::string read(const TableColour& colour)
{
    const std::string name = colour.smooth.name();
    std::string result = fmt::format("    color {} = {};\n", name, look_up(colour.smooth, name));
    if (colour.rough)
        result += fmt::format("    if (table_{} != \"\")\n        {} = {};\n", colour.rough->name(),
                              name, rough_colour(*colour.rough, name, Facets::seen));
    if (!colour.further) return result;
    constexpr std::string_view kBlack = "color(0.0)";
    return result + fmt::format("    if (table_{} != \"\")\n        {} += {} -\n             {};\n",
                                colour.further->name(), name,
                                rough_colour(*colour.further, kBlack, Facets::further),
                                rough_colour(*colour.further, kBlack, Facets::seen));
}

/// Statement that fades the colour NAME to NAME_bare by the coverage.
std::string fade(std::string_view name)
{
    return fmt::format("    {0} = mix({0}_bare, {0}, clamp(coverage, 0.0, 1.0));\n", name);
}

std::string read(const FadedColour& colour)
{
    if (!colour.bare) return read(colour.film);
    return read(colour.film) + read(*colour.bare) + fade(colour.film.smooth.name());
}

/// What leaves a rough surface after two and more bounces.
std::string further_colour(const TableSurface& surface)
{
    const Facets facets = surface.is_brushed ? Facets::further : Facets::seen;
    const std::vector<TableInfo> tables = surface.further_bounces();
    std::string result;
    for (const TableInfo& table : tables)
        result += fmt::format("    color {0} = table_{0} == \"\" ? {0}_in :\n        {1};\n",
                              table.name(), rough_colour(table, "color(0.0)", facets));
    return tables.size() > 1 ? result + fade(tables.front().name()) : result;
}

/// One lobe for each power of the reflectance; the first has the further bounces too.
std::string power_lobes(const TableSurface& surface)
{
    const TableInfo& table = *surface.find({TableOf::R, TableContent::powers});
    const std::vector<double>& exponents = surface.powers->exponents;
    const bool fades = !surface.bare_powers().empty();
    const double last = table.x.texels - 1;
    std::string result;
    for (std::size_t k = 0; k < exponents.size(); ++k) {
        const std::string at = literal(static_cast<double>(k) / last);
        std::string colour = look_up(table, fmt::format("{}_{}", table.name(), k), at);
        if (fades)
            colour = fmt::format("mix(schlick_bare[{}], {}, clamp(coverage, 0.0, 1.0))", k, colour);
        if (k == 0) colour += " + R_further";
        result += fmt::format("    BSDF = nacre_power_lobe(surface_normal, {}, {}, facets){};\n",
                              colour, literal(exponents[k]), k == 0 ? "" : " + BSDF");
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

/// The lobe of the surface itself.
std::string reflection(const TableSurface& surface)
{
    std::string tinted = "    BSDF = nacre_tinted_lobe(surface_normal, R, facets);\n";
    if (!surface.powers) return tinted;
    return "    if (exact_rough && nacre_level(facets.seen) >= 1.0) {\n" +
           indented(further_colour(surface) + power_lobes(surface)) + "    } else {\n" +
           indented(tinted) + "    }\n";
}

/// The lobes, and what becomes of the light that passes the surface.
struct Lobes {
    const TableSurface& surface;

    std::string operator()(const OpaqueBase&) const { return reflection(surface); }
    std::string operator()(const ThinWall&) const
    {
        return read(surface.faded(TableOf::T)) + reflection(surface) +
               "    BSDF = T * transparent() + BSDF;\n";
    }
    std::string operator()(const SolidGlass& glass) const
    {
        return read(surface.faded(TableOf::T)) + read(surface.colour(TableOf::lobe_R)) +
               read(surface.colour(TableOf::lobe_T)) +
               fmt::format(
                   "    BSDF = nacre_coated_glass(surface_normal, roughness, {}, R, T, "
                   "lobe_R, lobe_T);\n",
                   literal(glass.index));
    }
    std::string operator()(const MattBase&) const
    {
        return read(surface.faded(TableOf::T)) + read(surface.faded(TableOf::R_inner)) +
               read(surface.faded(TableOf::T_inner)) +
               "    color base = T * nacre_base_colour(base_colour, R_inner, T_inner);\n" +
               reflection(surface) + "    BSDF = base * diffuse(surface_normal) + BSDF;\n";
    }
};

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

/// Colours that are looked up outside, from row 0 of a table: one, or one for each coefficient.
std::vector<std::string> looked_up(const TableInfo& table)
{
    if (table.role.content != TableContent::powers) return {table.name()};
    std::vector<std::string> names;
    names.reserve(static_cast<std::size_t>(table.x.texels));
    for (int k = 0; k < table.x.texels; ++k) names.push_back(fmt::format("{}_{}", table.name(), k));
    return names;
}

}  // namespace

std::string surface_includes(const TableSurface& surface)
{
    return fmt::format("#include \"nacre/nacre_rough.h\"\n#include \"nacre/{}\"\n",
                       surface.solid_index() ? "nacre_coated_glass.h" : "nacre_surface.h");
}

std::string surface_parameters(const TableSurface& surface)
{
    std::string result;
    for (const TableInfo& table : surface.tables)
        if (is_looked_up(table))
            for (const std::string& name : looked_up(table)) {
                result += fmt::format(",\n    color {}_in = color(0.0)", name);
                result += metadata(name + " Colour",
                                   "Colour looked up outside; used where the table has no name");
            }
    for (const TableInfo& table : surface.tables) {
        result += fmt::format(",\n    string table_{} = \"\"", table.name());
        result += metadata(table.name() + " Table",
                           "File of " + table.file + "; leave unlinked, renderers need a constant",
                           ", string widget = \"filename\"");
    }
    if (const auto bare = surface.bare_powers(); !bare.empty()) {
        result +=
            fmt::format(",\n    color schlick_bare[{}] = {}", bare.size(), array_literal(bare));
        result +=
            metadata("Bare Coefficients", "Of the powers of the cosine, without the film", kHidden);
    }
    result += ",\n    int table_origin_top = 1";
    return result + metadata("Table Origin Top", "0 where t = 0 names the bottom row of a texture",
                             ", string widget = \"checkBox\"");
}

std::string surface_statements(const TableSurface& surface)
{
    std::string result = "    float x = fabs(dot(surface_normal, I));\n";
    std::string column = "x";
    if (const auto index = surface.solid_index()) {
        result += fmt::format(
            "    float column = nacre_glass_column(x, {0});\n"
            "    x = nacre_ambient_cosine(x, {0});\n",
            literal(*index));
        column = "column";
    }
    if (const auto axis = surface.row())
        result += fmt::format("    float y = ({} - {}) / {};\n", axis->name, literal(axis->min),
                              literal(axis->max - axis->min));
    result +=
        surface.is_brushed
            ? brushed_facets()
            : fmt::format("    nacre_facets facets = nacre_isotropic_facets({}, roughness);\n",
                          column);
    return result + read(surface.faded(TableOf::R)) + std::visit(Lobes{surface}, surface.below);
}

}  // namespace nacre::oslgen
