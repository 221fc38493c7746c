// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"
#include "number_table.h"

namespace nacre::spectral {

namespace {

std::vector<std::string> split_tags(std::string_view text)
{
    std::vector<std::string> tags;
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        if (const auto tag = trimmed(text.substr(0, comma)); !tag.empty()) tags.emplace_back(tag);
        text.remove_prefix(comma == std::string_view::npos ? text.size() : comma + 1);
    }
    return tags;
}

std::optional<SpectrumKind> kind_of(const std::string& text, const std::string& file)
{
    if (text.empty()) return std::nullopt;
    for (const SpectrumKind kind : {SpectrumKind::emission, SpectrumKind::reflectance})
        if (text == spectrum_kind_name(kind)) return kind;
    throw InputError(
        {.file = file,
         .field = "KIND",
         .message = fmt::format("must be emission or reflectance (got '{}')", excerpt(text))});
}

}  // namespace

std::vector<NamedSpectrum> read_csv_spectra(std::string_view text, std::string_view name)
{
    const std::string file(name);
    NumberTables read = read_number_tables(text, name);
    if (read.tables.size() > 1)
        throw InputError({file, read.tables[1].line, {}, "must have one table of spectra"});
    NumberTable& table = read.tables.front();
    const auto kind = kind_of(read.comments["KIND"], file);
    std::vector<NamedSpectrum> spectra;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        const bool per_cent = table.per_cent[i];
        if (per_cent)
            for (double& value : table.columns[i]) value *= 0.01;
        std::string column = table.names.empty() ? std::string() : table.names[i];
        if (column == "value") column.clear();  // as the files of a library call it, no name
        const bool alone = table.columns.size() == 1;
        spectra.push_back({.key = {},
                           .name = alone && !read.comments["NAME"].empty() ? read.comments["NAME"]
                                                                           : std::move(column),
                           .references = read.comments["REFERENCES"],
                           .licence = read.comments["LICENCE"],
                           .comments = read.comments["COMMENTS"],
                           .tags = split_tags(read.comments["TAGS"]),
                           .kind = kind,
                           .samples = {table.wavelengths_nm, std::move(table.columns[i])},
                           // As the files of a library have it, whose reflectances are ratios.
                           .unit_stated = kind.has_value() || per_cent});
    }
    return spectra;
}

NamedSpectrum read_library_spectrum(std::string_view text, std::string_view name)
{
    const std::string file(name);
    std::vector<NamedSpectrum> spectra = read_csv_spectra(text, name);
    NamedSpectrum& spectrum = spectra.front();
    if (spectra.size() != 1)
        throw InputError(
            {.file = file,
             .field = {},
             .message = fmt::format("must have one column of values (got {})", spectra.size())});
    if (!spectrum.kind)
        throw InputError(
            {file, 0, "KIND", "is missing: '# KIND: emission' or '# KIND: reflectance'"});
    if (auto problem = kind_problem(spectrum.samples, *spectrum.kind))
        throw InputError({file, 0, "value", std::move(*problem)});
    return std::move(spectrum);
}

std::string write_library_spectrum(const NamedSpectrum& spectrum)
{
    std::string text;
    const auto add = [&text](std::string_view key, const std::string& value) {
        if (!value.empty()) text += fmt::format("# {}: {}\n", key, clean_text(value));
    };
    add("NAME", spectrum.name);
    if (spectrum.kind) add("KIND", std::string(spectrum_kind_name(*spectrum.kind)));
    add("REFERENCES", spectrum.references);
    add("LICENCE", spectrum.licence);
    add("COMMENTS", spectrum.comments);
    add("TAGS", fmt::format("{}", fmt::join(spectrum.tags, ", ")));
    text += "wavelength_nm,value\n";
    const auto& nm = spectrum.samples.wavelengths_nm();
    for (std::size_t i = 0; i < nm.size(); ++i)
        text += fmt::format("{},{}\n", nm[i], spectrum.samples.values()[i]);
    return text;
}

}  // namespace nacre::spectral
