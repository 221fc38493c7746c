// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "medium_yaml.h"
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

}  // namespace

std::string refractiveindex_yaml_from_csv(std::string_view text, std::string_view name,
                                          std::string_view references)
{
    const std::string file(name);
    NumberTables read = read_number_tables(text, name);
    const auto [table, n, k] = find_columns(read, file);
    FileProblems problems(file);
    for (std::size_t i = 0; i < n->size(); ++i) {
        if (!((*n)[i] > 0.0))
            problems.add(table->lines[i], "n", fmt::format("must be > 0 (got {:g})", (*n)[i]));
        if (k && !((*k)[i] >= 0.0))
            problems.add(table->lines[i], "k", fmt::format("must be ≥ 0 (got {:g})", (*k)[i]));
    }
    problems.throw_if_any();
    return medium_yaml(
        {.name = read.comments["NAME"],
         .references = references.empty() ? read.comments["REFERENCES"] : std::string(references),
         .wavelengths_nm = table->wavelengths_nm,
         .n = *n,
         .k = k});
}

}  // namespace nacre::spectral
