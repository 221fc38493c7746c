// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/film_preview.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "film/solid_index.h"
#include "nacre/core/diagnostics.h"
#include "nacre/optics/film_model_stack.h"
#include "nacre/optics/multilayer.h"
#include "nacre/spectral/wavelengths.h"

namespace nacre::kinds {
namespace film {
namespace {

/// Fits, further bounces and the lobes of the substrate wait for compile().
bool is_left_out(const TableRole& role)
{
    return role.content == TableContent::further || role.content == TableContent::powers ||
           role.of == TableOf::lobe_R || role.of == TableOf::lobe_T;
}

/// Means over the hemisphere below: one column.
bool is_inner(const TableRole& role)
{
    return role.of == TableOf::R_inner || role.of == TableOf::T_inner;
}

/// The tables of one stack that are asked for.
class Preview {
public:
    Preview(lut::FilmTableRequest request, const MaterialTemplate& source,
            spectral::RangeRule range)
        : request_(std::move(request)),
          below_(film_of(source).interior()),
          solid_index_(solid_index(source, range)),
          file_(source.file)
    {}

    lut::Table make(const TableRole& role, lut::TexelSize size)
    {
        const bool passes = role.of == TableOf::T || role.of == TableOf::T_inner;
        if (is_inner(role)) {
            if (below_ != Interior::diffuse || role.content != TableContent::smooth) refuse(role);
            return passes ? inner(size).transmittance : inner(size).reflectance;
        }
        if (passes && !request_.transmittance) refuse(role);
        if (role.content == TableContent::rough)
            return passes ? *rough(size).transmittance : rough(size).reflectance;
        return passes ? *smooth(size).transmittance : smooth(size).reflectance;
    }

private:
    lut::FilmTableRequest request_;
    Interior below_;
    std::optional<double> solid_index_;
    std::string file_;
    std::optional<lut::FilmTables> smooth_;
    std::optional<lut::RoughTables> rough_;
    std::optional<lut::InnerTables> inner_;

    [[noreturn]] void refuse(const TableRole& role) const
    {
        throw InputError(Diagnostic{
            file_,
            0,
            {},
            fmt::format("such a film has no table {}; compile it anew", table_name(role))});
    }

    // Both quantities of a kind have one size.
    const lut::FilmTables& smooth(lut::TexelSize size)
    {
        if (!smooth_) smooth_ = lut::preview_film_tables(request_, size);
        return *smooth_;
    }
    const lut::RoughTables& rough(lut::TexelSize size)
    {
        constexpr lut::TexelSize kWhereThereIsNone{33, 33};
        const int rows = request_.variation ? kWhereThereIsNone.height : 1;
        if (rough_) return *rough_;
        const lut::FilmTables& means = smooth({kWhereThereIsNone.width, rows});
        rough_ = solid_index_ ? lut::preview_rough_glass_tables(means, *solid_index_, size)
                              : lut::preview_rough_tables(means, size);
        return *rough_;
    }
    const lut::InnerTables& inner(lut::TexelSize size)
    {
        if (!inner_) inner_ = lut::preview_inner_tables(request_, size.height);
        return *inner_;
    }
};

[[noreturn]] void refuse_size(const TableLayout& table, const std::string& file)
{
    throw InputError(
        Diagnostic{file,
                   0,
                   {},
                   fmt::format("table {} cannot be {} x {}; compile it anew",
                               table_name(table.role), table.size.width, table.size.height)});
}

void check(const TableLayout& table, bool varies, const MaterialTemplate& source)
{
    const bool rough = table.role.content == TableContent::rough;
    const bool is_solid = film_of(source).interior() == Interior::solid;
    const int strips = lut::kRoughSlices * (is_solid ? lut::kGlassSides : 1);
    const int least = is_inner(table.role) ? 1 : rough ? 2 * strips : 2;
    const bool one_row = !varies || table.role.is_bare;
    constexpr int kMost = 65536;
    if (table.size.width >= least && table.size.width <= kMost && table.size.height <= kMost &&
        (!rough || table.size.width % strips == 0) &&
        (one_row ? table.size.height == 1 : table.size.height >= 2))
        return;
    refuse_size(table, source.file);
}

optics::PowerRatios power_at(const lut::FilmTableRequest& request, const optics::FilmStack& stack,
                             double cos_theta, double wavelength_nm)
{
    constexpr double kCellNm = 1.0;  // of the grid
    if (request.technique && !stack.layers.empty())
        return optics::film_model_power(request.technique->model, stack, cos_theta, wavelength_nm,
                                        kCellNm);
    return optics::stack_power_unpolarised(stack, cos_theta, wavelength_nm);
}

/// The stack at thicknesses of its own; indices are filled in for each wavelength.
optics::FilmStack stack_at(const lut::FilmTableRequest& request, double value)
{
    optics::FilmStack stack;
    for (const lut::SampledLayer& layer : request.stack.layers)
        stack.layers.push_back(
            {.n = {}, .thickness_nm = layer.thickness_nm, .coherent = layer.coherent});
    if (!request.variation) return stack;
    if (request.variation->layer) {
        stack.layers[*request.variation->layer].thickness_nm = value;
        return stack;
    }
    for (optics::Layer& layer : stack.layers)
        if (layer.coherent) layer.thickness_nm *= value;
    return stack;
}

}  // namespace
}  // namespace film

std::vector<lut::Table> preview_tables(const MaterialTemplate& source,
                                       const CompileOptions& options,
                                       std::span<const TableLayout> layout)
{
    const lut::FilmTableRequest request = film_request(source, options);
    lut::FilmTableRequest bare_request = request;
    bare_request.stack.layers.clear();
    bare_request.variation.reset();
    film::Preview whole(request, source, options.range),
        bare(std::move(bare_request), source, options.range);

    // First what the others are made from, in whatever order they are asked for.
    for (const TableLayout& wanted : layout)
        if (wanted.role.of == TableOf::R && wanted.role.content == TableContent::smooth) {
            film::check(wanted, request.variation.has_value(), source);
            static_cast<void>((wanted.role.is_bare ? bare : whole).make(wanted.role, wanted.size));
        }
    std::vector<lut::Table> tables;
    for (const TableLayout& wanted : layout) {
        if (film::is_left_out(wanted.role)) continue;
        film::check(wanted, request.variation.has_value(), source);
        lut::Table table = (wanted.role.is_bare ? bare : whole).make(wanted.role, wanted.size);
        if (table.x.texels != wanted.size.width || table.y.texels != wanted.size.height)
            film::refuse_size(wanted, source.file);
        table.role = wanted.role;
        tables.push_back(std::move(table));
    }
    return tables;
}

FilmSpectrum film_spectrum(const MaterialTemplate& source, const CompileOptions& options,
                           double cos_theta, double value)
{
    const lut::FilmTableRequest request = film_request(source, options);
    FilmSpectrum result{};
    optics::FilmStack stack = film::stack_at(request, value);
    for (std::size_t w = 0; w < spectral::kWavelengths; ++w) {
        stack.ambient = request.stack.ambient[w];
        stack.substrate = request.stack.substrate[w];
        for (std::size_t i = 0; i < stack.layers.size(); ++i)
            stack.layers[i].n = request.stack.layers[i].n[w];
        const optics::PowerRatios power =
            film::power_at(request, stack, cos_theta, spectral::wavelength_nm(w));
        result.reflectance[w] = power.R;
        result.transmittance[w] = power.T;
    }
    result.colour = {request.weights.apply(result.reflectance),
                     request.weights.apply(result.transmittance)};
    return result;
}

}  // namespace nacre::kinds
