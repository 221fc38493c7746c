// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "index_rows.h"
#include "medium_yaml.h"
#include "nacre/readers/refractiveindex_yaml.h"
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
            if (same_letters(table.names[i], "n")) columns.n = &table.columns[i];
            if (same_letters(table.names[i], "k")) columns.k = &table.columns[i];
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
                                          std::string_view references,
                                          std::vector<std::string>& changes)
{
    const std::string file(name);
    NumberTables read = read_number_tables(text, name);
    const auto [table, n, k] = find_columns(read, file);
    FileProblems problems(file);
    std::vector<IndexRow> rows;
    for (std::size_t i = 0; i < n->size(); ++i) {
        rows.push_back({table->lines[i], table->wavelengths_nm[i], (*n)[i], k ? (*k)[i] : 0.0});
        if (!(rows[i].n > 0.0))
            problems.add(rows[i].line, "n", fmt::format("must be > 0 (got {:g})", rows[i].n));
        if (!(rows[i].k >= kLeastNoiseOfK))
            problems.add(rows[i].line, "k",
                         fmt::format("must be ≥ 0, or ≥ {:g} for the noise of a measurement (got "
                                     "{:g})",
                                     kLeastNoiseOfK, rows[i].k));
    }
    problems.throw_if_any();
    const auto mended = mend_rows(rows);
    changes.insert(changes.end(), mended.begin(), mended.end());
    MediumTable medium{
        .name = read.comments["NAME"],
        .references = references.empty() ? read.comments["REFERENCES"] : std::string(references),
        .comments = changes_text(mended)};
    for (const IndexRow& row : rows) medium.append(row.wavelength, row.n, row.k);
    medium.has_k = k != nullptr;
    return medium_yaml(medium);
}

}  // namespace nacre::spectral
