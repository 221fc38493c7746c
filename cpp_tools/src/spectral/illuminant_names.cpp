// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "csv_table.h"
#include "illuminant_table.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/spectral/illuminant.h"
#include "nacre/spectral/spectrum_library.h"
#include "text_lines.h"

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

[[noreturn]] void throw_problem(std::string message)
{
    throw InputError({.file = {}, .field = "illuminant", .message = std::move(message)});
}

/// The whole of `text` as a number.
double number(std::string_view text, std::string_view what)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
        throw_problem(fmt::format("must have a number as {} (got '{}')", what, text));
    return value;
}

SpectralLine parse_line(std::string_view text)
{
    const std::size_t at = text.find('@');
    SpectralLine line{.wavelength_nm = number(text.substr(0, at), "wavelength"), .power = 1.0};
    if (at != std::string_view::npos) line.power = number(text.substr(at + 1), "power");
    return line;
}

std::vector<SpectralLine> parse_lines(std::string_view text)
{
    std::vector<SpectralLine> lines;
    for (;;) {
        const std::size_t comma = text.find(',');
        lines.push_back(parse_line(text.substr(0, comma)));
        if (comma == std::string_view::npos) return lines;
        text.remove_prefix(comma + 1);
    }
}

Spectrum samples_of(const NamedTable& table)
{
    if (table.path == nullptr) return {{kFirstNm, kLastNm}, {1.0, 1.0}};
    CsvTable csv = load_csv(table.path, table.columns);
    return {std::move(csv.columns[0]), std::move(csv.columns[table.column])};
}

constexpr std::string_view kKeyFolder = "cie/";

const NamedTable* table_of_key(std::string_view key)
{
    if (!key.starts_with(kKeyFolder)) return nullptr;
    key.remove_prefix(kKeyFolder.size());
    const auto* const found = std::ranges::find(kTables, key, &NamedTable::name);
    return found == std::end(kTables) ? nullptr : found;
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

/// A light of the library of spectra. Its name always has a slash, which no other name has.
const NamedSpectrum& library_light(std::string_view key)
{
    const NamedSpectrum& found = library_spectrum(key);
    if (found.kind != SpectrumKind::emission)
        throw_problem(fmt::format("must be a light; {} is a reflectance", key));
    return found;
}

/// @throws InputError for what is neither of the illuminants with tables nor of their forms
Spectrum samples_of_name(std::string_view name)
{
    const auto* const found = std::ranges::find(kTables, name, &NamedTable::name);
    if (found != std::end(kTables)) return samples_of(*found);
    const std::size_t colon = name.find(':');
    if (colon != std::string_view::npos) {
        const std::string_view kind = name.substr(0, colon), value = name.substr(colon + 1);
        if (kind == "blackbody") return blackbody_samples(number(value, "temperature in K"));
        if (kind == "daylight") return daylight_samples(number(value, "temperature in K"));
        if (kind == "line") return line_samples(parse_lines(value));
    }
    throw_problem(fmt::format("must be one of {}, {} (got '{}')",
                              fmt::join(illuminant_names(), ", "), kIlluminantForms, name));
}

}  // namespace

NamedSpectrum light_spectrum(std::string_view text)
{
    if (text.find('/') != std::string_view::npos) return library_light(text);
    return {.key = std::string(text),
            .name = std::string(text),
            .references = {},
            .licence = {},
            .comments = {},
            .tags = {},
            .kind = SpectrumKind::emission,
            .samples = samples_of_name(text)};
}

Illuminant named_illuminant(std::string_view text)
{
    return {.name = std::string(text), .power = light_spectrum(text).on_grid()};
}

std::vector<std::string> illuminant_names()
{
    std::vector<std::string> names;
    for (const NamedTable& table : kTables) names.emplace_back(table.name);
    return names;
}

bool is_illuminant_key(std::string_view key)
{
    return table_of_key(key) != nullptr;
}

std::vector<std::string> illuminant_keys()
{
    std::vector<std::string> keys = illuminant_names();
    for (std::string& key : keys) key.insert(0, kKeyFolder);
    return keys;
}

NamedSpectrum illuminant_entry(std::string_view key)
{
    const NamedTable& table = *table_of_key(key);
    const bool drawn = table.path == nullptr;
    return {.key = std::string(key),
            .name = fmt::format("CIE illuminant {}", table.name),
            .references = drawn ? "CIE 015:2018" : comment_of(table, "Source"),
            .licence = drawn ? "1 at every wavelength by definition" : comment_of(table, "Licence"),
            .comments = {},
            .tags = {"illuminant"},
            .kind = SpectrumKind::emission,
            .samples = samples_of(table)};
}

Illuminant line_spectrum(const std::vector<SpectralLine>& lines)
{
    if (lines.empty()) throw_problem("must have at least one line");
    Illuminant illuminant{.name = "lines", .power = {}};
    for (const auto& [nm, power] : lines) {
        if (!(nm >= kFirstNm && nm <= kLastNm))
            throw_problem(fmt::format("must have its lines within {} … {} nm (got {})", kFirstNm,
                                      kLastNm, nm));
        if (!(power > 0.0) || !std::isfinite(power))
            throw_problem(fmt::format("must have lines of a finite power > 0 (got {})", power));
        // Shared by the two neighbours as their distances say: every sum over the grid then equals
        // the value at the line, linear in between.
        const double below = std::floor(nm);
        const auto i = static_cast<std::size_t>(below - kFirstNm);
        illuminant.power[i] += power * (1.0 - (nm - below));
        if (nm > below) illuminant.power[i + 1] += power * (nm - below);
    }
    return illuminant;
}

}  // namespace nacre::spectral
