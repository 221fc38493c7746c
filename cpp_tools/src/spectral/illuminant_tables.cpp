// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "csv_table.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/core/text_lines.h"
#include "nacre/spectral/illuminant.h"

namespace nacre::spectral {

namespace {

struct NamedTable {
    const char* name;
    const char* path;  ///< null: 1 at every wavelength
    std::size_t column = 1, columns = 2;
};

constexpr const char* kFluorescent = "spd/cie_fluorescent.csv";
constexpr const char* kLed = "spd/cie_led.csv";

constexpr NamedTable kTables[] = {
    {"E", nullptr},
    {"A", "spd/cie_a.csv"},
    {"D65", "spd/cie_d65.csv"},
    {"D50", "spd/cie_d50.csv"},
    {"D55", "spd/cie_d55.csv"},
    {"D75", "spd/cie_d75.csv"},
    {"B", "spd/cie_b.csv"},
    {"C", "spd/cie_c.csv"},
    {"F1", kFluorescent, 1, 13},
    {"F2", kFluorescent, 2, 13},
    {"F3", kFluorescent, 3, 13},
    {"F4", kFluorescent, 4, 13},
    {"F5", kFluorescent, 5, 13},
    {"F6", kFluorescent, 6, 13},
    {"F7", kFluorescent, 7, 13},
    {"F8", kFluorescent, 8, 13},
    {"F9", kFluorescent, 9, 13},
    {"F10", kFluorescent, 10, 13},
    {"F11", kFluorescent, 11, 13},
    {"F12", kFluorescent, 12, 13},
    {"LED-B1", kLed, 1, 10},
    {"LED-B2", kLed, 2, 10},
    {"LED-B3", kLed, 3, 10},
    {"LED-B4", kLed, 4, 10},
    {"LED-B5", kLed, 5, 10},
    {"LED-BH1", kLed, 6, 10},
    {"LED-RGB1", kLed, 7, 10},
    {"LED-V1", kLed, 8, 10},
    {"LED-V2", kLed, 9, 10},
};

/// Null for what is no name of a table.
const NamedTable* table_of(std::string_view name)
{
    const auto* const found = std::ranges::find(kTables, name, &NamedTable::name);
    return found == std::end(kTables) ? nullptr : found;
}

Spectrum samples_of(const NamedTable& table)
{
    if (table.path == nullptr) return {{kFirstNm, kLastNm}, {1.0, 1.0}};
    CsvTable csv = load_csv(table.path, table.columns);
    return {std::move(csv.columns[0]), std::move(csv.columns[table.column])};
}

/// What follows `# Source: ` or another word in the comments of an embedded table.
std::string comment_of(const NamedTable& table, std::string_view word)
{
    if (table.path == nullptr) return {};
    TextLines lines(find_resource(table.path).value_or(std::string_view()));
    while (auto line = lines.next())
        if (const std::string head = fmt::format("# {}: ", word); line->starts_with(head))
            return std::string(line->substr(head.size()));
    return {};
}

}  // namespace

std::vector<std::string> illuminant_names()
{
    std::vector<std::string> names;
    for (const NamedTable& table : kTables) names.emplace_back(table.name);
    return names;
}

std::optional<Spectrum> illuminant_samples(std::string_view name)
{
    const NamedTable* const table = table_of(name);
    if (table == nullptr) return std::nullopt;
    return samples_of(*table);
}

IlluminantCitation illuminant_citation(std::string_view name)
{
    const NamedTable& table = *table_of(name);
    if (table.path == nullptr) return {"CIE 015:2018", "1 at every wavelength by definition"};
    return {comment_of(table, "Source"), comment_of(table, "Licence")};
}

Illuminant cie_illuminant(std::string_view name)
{
    const auto samples = illuminant_samples(name);
    if (!samples)
        throw InputError({.file = {},
                          .field = "illuminant",
                          .message = fmt::format("must be one of {} (got '{}')",
                                                 fmt::join(illuminant_names(), ", "), name)});
    return {.name = std::string(name), .power = samples->on_grid(Interpolation::linear)};
}

}  // namespace nacre::spectral
