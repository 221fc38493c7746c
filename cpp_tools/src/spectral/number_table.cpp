// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "number_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "nacre/core/limits.h"

namespace nacre::spectral {

namespace {

constexpr double kNmPerUm = 1000.0;

/// Tabs and semicolons win over commas, which may stand inside names.
char separator_of(std::string_view line)
{
    for (const char separator : {'\t', ';'})
        if (line.find(separator) != std::string_view::npos) return separator;
    return ',';
}

/// No more than one cell too many: a file of another kind may hold millions in a line.
std::vector<std::string_view> split_cells(std::string_view line, char separator)
{
    constexpr std::size_t kMost = kMaxSpectra + 2;
    std::vector<std::string_view> cells;
    for (;;) {
        const std::size_t end = line.find(separator);
        std::string_view cell = trimmed(line.substr(0, end));
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
            cell = trimmed(cell.substr(1, cell.size() - 2));
        cells.push_back(cell);
        if (end == std::string_view::npos || cells.size() == kMost) return cells;
        line.remove_prefix(end + 1);
    }
}

std::string lower(std::string_view text)
{
    std::string result(text);
    std::ranges::transform(result, result.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
    });
    return result;
}

/// nm for one unit of a wavelength column by its name; nothing for a name that is not one.
std::optional<double> unit_of(std::string_view name)
{
    constexpr std::array<std::string_view, 6> kNm = {
        "wavelength_nm", "wavelength [nm]", "wavelength (nm)", "wavelength", "lambda", "nm"};
    // refractiveindex.info exports µm as `wl`.
    constexpr std::array<std::string_view, 6> kUm = {
        "wavelength_um", "wavelength [um]", "wavelength (um)", "wavelength, µm", "um", "wl"};
    const std::string plain = lower(name);
    if (std::ranges::find(kNm, plain) != kNm.end()) return 1.0;
    if (std::ranges::find(kUm, plain) != kUm.end()) return kNmPerUm;
    return std::nullopt;
}

class TableReader {
public:
    TableReader(std::string_view text, std::string_view file)
        : lines_(text), problems_(std::string(file))
    {}

    NumberTables read()
    {
        while (const auto line = lines_.next()) {
            if (full_) break;
            read_line(trimmed(*line));
        }
        if (result_.tables.empty() && problems_.empty())
            problems_.add(0, {}, "must have rows of a wavelength and values");
        finish_table();
        problems_.throw_if_any();
        return std::move(result_);
    }

private:
    void read_line(std::string_view line)
    {
        if (line.empty()) return;
        if (line.front() == '#') {
            read_comment(trimmed(line.substr(1)));
            return;
        }
        const bool first = result_.tables.empty();
        if (first) separator_ = separator_of(line);
        const auto cells = split_cells(line, separator_);
        const bool names = unit_of(cells.front()).has_value();
        if (names || first) start_table(cells, names);
        if (!names) read_row(cells);
    }

    void read_comment(std::string_view comment)
    {
        const std::size_t colon = comment.find(':');
        if (!result_.tables.empty() || colon == std::string_view::npos) return;
        std::string& value = result_.comments[std::string(trimmed(comment.substr(0, colon)))];
        if (value.empty()) value = clean_text(comment.substr(colon + 1));
    }

    void start_table(const std::vector<std::string_view>& cells, bool names)
    {
        finish_table();
        NumberTable& table = result_.tables.emplace_back();
        table.line = lines_.number();
        // A row of neither names nor numbers says what is amiss when it is read as numbers.
        unit_ = names ? unit_of(cells.front()).value_or(1.0) : 1.0;
        column_count_ = cells.size() - 1;
        if (column_count_ == 0 || column_count_ > kMaxSpectra)
            problems_.add(table.line, {},
                          fmt::format("must have 1 … {} columns after the wavelength (got {})",
                                      kMaxSpectra, column_count_));
        column_count_ = std::min(column_count_, kMaxSpectra);
        table.columns.resize(column_count_);
        if (names)
            for (std::size_t i = 1; i <= column_count_; ++i)
                table.names.push_back(clean_text(cells[i]));
    }

    void read_row(const std::vector<std::string_view>& cells)
    {
        NumberTable& table = result_.tables.back();
        const int line = lines_.number();
        if (cells.size() != column_count_ + 1) {
            problems_.add(line, {},
                          fmt::format("must have {} numbers as the rows before (got {})",
                                      column_count_ + 1, cells.size()));
            return;
        }
        if (table.wavelengths_nm.size() == kMaxSamples) {
            problems_.add(line, {}, fmt::format("must have at most {} rows", kMaxSamples));
            full_ = true;
            return;
        }
        if (const auto wavelength = number(cells[0], line, "wavelength"))
            add_wavelength(table, *wavelength * unit_, line);
        for (std::size_t i = 1; i < cells.size(); ++i)
            table.columns[i - 1].push_back(number(cells[i], line, name_of(table, i)).value_or(0.0));
    }

    static std::string name_of(const NumberTable& table, std::size_t column)
    {
        return table.names.empty() ? fmt::format("column {}", column + 1)
                                   : excerpt(table.names[column - 1]);
    }

    std::optional<double> number(std::string_view cell, int line, const std::string& field)
    {
        const auto value = parse_number(cell);
        if (value && std::isfinite(*value)) return value;
        problems_.add(line, field,
                      fmt::format("must be a finite number (got '{}')", excerpt(cell)));
        return std::nullopt;
    }

    void add_wavelength(NumberTable& table, double nm, int line)
    {
        table.lines.push_back(line);
        const double before = table.wavelengths_nm.empty() ? 0.0 : table.wavelengths_nm.back();
        if (!(nm > before) || !std::isfinite(nm))
            problems_.add(
                line, "wavelength",
                fmt::format("must be > 0 and ascending (got {:g} nm after {:g} nm)", nm, before));
        table.wavelengths_nm.push_back(nm);
    }

    void finish_table()
    {
        if (result_.tables.empty() || !problems_.empty()) return;
        const NumberTable& table = result_.tables.back();
        if (table.wavelengths_nm.size() < 2) {
            problems_.add(table.line, {},
                          fmt::format("must have at least two rows of numbers (got {})",
                                      table.wavelengths_nm.size()));
            return;
        }
        // No instrument measures from 0 to 30 nm; what says so means µm.
        constexpr double kLeastLastNm = 30.0;
        if (table.wavelengths_nm.back() < kLeastLastNm)
            problems_.add(table.line, "wavelength",
                          fmt::format("must reach {:g} nm; for µm the column must be called "
                                      "wavelength_um (got {:g} … {:g})",
                                      kLeastLastNm, table.wavelengths_nm.front(),
                                      table.wavelengths_nm.back()));
    }

    TextLines lines_;
    FileProblems problems_;
    NumberTables result_;
    char separator_ = ',';
    double unit_ = 1.0;
    std::size_t column_count_ = 0;
    bool full_ = false;
};

}  // namespace

NumberTables read_number_tables(std::string_view text, std::string_view file)
{
    check_size(text, std::string(file));
    return TableReader(text, file).read();
}

}  // namespace nacre::spectral
