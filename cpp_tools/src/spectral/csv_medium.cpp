// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "nacre/spectral/optical_constants.h"
#include "number_table.h"

namespace nacre::spectral {

namespace {

/// Columns of n and k at the same wavelengths, from one table or from one table each.
struct Columns {
    const NumberTable* first = nullptr;
    const std::vector<double>* n = nullptr;
    const std::vector<double>* k = nullptr;
};

Columns find_columns(const NumberTables& read, const std::string& file)
{
    Columns columns;
    for (const NumberTable& table : read.tables) {
        for (std::size_t i = 0; i < table.names.size(); ++i) {
            if (table.names[i] == "n") columns.n = &table.columns[i];
            if (table.names[i] == "k") columns.k = &table.columns[i];
        }
        if (columns.first && table.wavelengths_nm != columns.first->wavelengths_nm)
            throw InputError(
                {file, table.line, {}, "must have the wavelengths of the table before"});
        if (!columns.first) columns.first = &table;
    }
    if (!columns.n)
        throw InputError({file,
                          columns.first->line,
                          {},
                          "must have a row of names with a column n, and k where it absorbs"});
    return columns;
}

/// As YAML has it between double quotes.
std::string quoted_text(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

std::string refractiveindex_yaml_from_csv(std::string_view text, std::string_view name,
                                          std::string_view references)
{
    const std::string file(name);
    NumberTables read = read_number_tables(text, name);
    const auto [table, n, k] = find_columns(read, file);
    FileProblems problems(file);
    std::string rows;
    for (std::size_t i = 0; i < n->size(); ++i) {
        if (!((*n)[i] > 0.0))
            problems.add(table->lines[i], "n", fmt::format("must be > 0 (got {:g})", (*n)[i]));
        if (k && !((*k)[i] >= 0.0))
            problems.add(table->lines[i], "k", fmt::format("must be ≥ 0 (got {:g})", (*k)[i]));
        rows += fmt::format("        {} {}", table->wavelengths_nm[i] / 1000.0, (*n)[i]);
        rows += k ? fmt::format(" {}\n", (*k)[i]) : "\n";
    }
    problems.throw_if_any();
    std::string yaml;
    if (const std::string& given = read.comments["NAME"]; !given.empty())
        yaml += fmt::format("NAMES:\n  - {}\n", quoted_text(given));
    const std::string citation =
        clean_text(references.empty() ? read.comments["REFERENCES"] : std::string(references));
    if (!citation.empty()) yaml += fmt::format("REFERENCES: {}\n", quoted_text(citation));
    return fmt::format("{}DATA:\n  - type: tabulated {}\n    data: |\n{}", yaml, k ? "nk" : "n",
                       rows);
}

}  // namespace nacre::spectral
