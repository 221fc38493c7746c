// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "number_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "nacre/core/limits.h"
#include "table_headings.h"

namespace nacre::spectral {

namespace {

/// A cell and whether it stood between quotes, where a separator is none.
struct Cell {
    std::string_view text;
    bool quoted = false;
};

bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/// Every comma stands between digits, as a decimal comma does.
bool has_decimal_commas(std::string_view word)
{
    for (std::size_t i = 0; i < word.size(); ++i)
        if (word[i] == ',' &&
            (i == 0 || i + 1 == word.size() || !is_digit(word[i - 1]) || !is_digit(word[i + 1])))
            return false;
    return true;
}

std::vector<std::string_view> split_at_spaces(std::string_view line)
{
    std::vector<std::string_view> words;
    for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
        const std::size_t end = std::min(line.find(' '), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
    return words;
}

/// Tabs and semicolons win over commas, which may stand inside names and numbers, and those over
/// spaces, which may follow any of them.
char separator_of(std::string_view line)
{
    for (const char separator : {'\t', ';'})
        if (line.find(separator) != std::string_view::npos) return separator;
    const auto words = split_at_spaces(line);
    const bool commas = line.find(',') != std::string_view::npos;
    return words.size() > 1 && (!commas || std::ranges::all_of(words, has_decimal_commas)) ? ' '
                                                                                           : ',';
}

/// The cell at the start of `line`, which is left with what follows the separator.
Cell take_cell(std::string_view& line, char separator, bool& last)
{
    line = trimmed(line);
    Cell cell;
    if (const std::size_t quote =
            line.starts_with('"') ? line.find('"', 1) : std::string_view::npos;
        quote != std::string_view::npos) {
        cell = {trimmed(line.substr(1, quote - 1)), true};
        const std::string_view rest = trimmed(line.substr(quote + 1));
        if (rest.empty() || rest.front() == separator || separator == ' ') {
            last = rest.empty();
            line = rest;
            if (!last && separator != ' ') line.remove_prefix(1);
            return cell;
        }
    }
    const std::size_t end = line.find(separator);
    cell = {trimmed(line.substr(0, end)), false};
    last = end == std::string_view::npos;
    line.remove_prefix(last ? line.size() : end + 1);
    return cell;
}

/// No more than one cell too many: a file of another kind may hold millions in a line. Empty ones
/// at the end, as spreadsheets leave them, are none.
std::vector<Cell> split_cells(std::string_view line, char separator)
{
    constexpr std::size_t kMost = kMaxSpectra + 2;
    std::vector<Cell> cells;
    for (bool last = false; !last && cells.size() < kMost;)
        cells.push_back(take_cell(line, separator, last));
    while (!cells.empty() && cells.back().text.empty()) cells.pop_back();
    return cells;
}

/// In names between spaces a unit belongs to the word before: `Wavelength (nm) R (%)`.
std::vector<Cell> with_units_joined(const std::vector<Cell>& cells)
{
    std::vector<Cell> joined;
    for (const Cell& cell : cells) {
        const bool unit = !cell.text.empty() && std::string_view("([/%").find(cell.text.front()) !=
                                                    std::string_view::npos;
        if (unit && !joined.empty() && !joined.back().text.empty()) {
            const char* const start = joined.back().text.data();
            joined.back().text = {
                start, static_cast<std::size_t>(cell.text.data() + cell.text.size() - start)};
        } else {
            joined.push_back(cell);
        }
    }
    return joined;
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
        auto cells = split_cells(line, separator_);
        if (cells.empty()) return;
        if (separator_ == ' ') {
            auto joined = with_units_joined(cells);
            if (wavelength_heading(joined.front().text)) cells = std::move(joined);
        }
        const auto heading = wavelength_heading(cells.front().text);
        if (first && !heading && !looks_like_number(cells.front().text)) return refuse_start(cells);
        if (heading || first) start_table(cells, heading);
        if (!heading) read_row(cells);
    }

    static bool looks_like_number(std::string_view text)
    {
        return !text.empty() &&
               (is_digit(text.front()) ||
                (text.size() > 1 &&
                 std::string_view("+-.").find(text.front()) != std::string_view::npos &&
                 is_digit(text[1])));
    }

    void refuse_start(const std::vector<Cell>& cells)
    {
        problems_.add(lines_.number(), "wavelength",
                      fmt::format("the first column must be numbers, or be called wavelength_nm, "
                                  "wavelength_um, Wavelength (nm), λ (µm), WL … (got '{}')",
                                  excerpt(cells.front().text)));
        full_ = true;
    }

    void read_comment(std::string_view comment)
    {
        const std::size_t colon = comment.find(':');
        if (!result_.tables.empty() || colon == std::string_view::npos) return;
        std::string& value = result_.comments[std::string(trimmed(comment.substr(0, colon)))];
        if (value.empty()) value = clean_text(comment.substr(colon + 1));
    }

    void start_table(const std::vector<Cell>& cells,
                     const std::optional<WavelengthHeading>& heading)
    {
        finish_table();
        NumberTable& table = result_.tables.emplace_back();
        table.line = lines_.number();
        heading_ = heading.value_or(WavelengthHeading());
        descending_.reset();
        column_count_ = cells.size() - 1;
        if (column_count_ == 0 || column_count_ > kMaxSpectra)
            problems_.add(table.line, {},
                          fmt::format("must have 1 … {} columns after the wavelength (got {})",
                                      kMaxSpectra, column_count_));
        column_count_ = std::min(column_count_, kMaxSpectra);
        table.columns.resize(column_count_);
        table.per_cent.resize(column_count_);
        for (std::size_t i = 0; heading && i < column_count_; ++i) {
            auto [name, per_cent] = value_heading(cells[i + 1].text);
            table.names.push_back(std::move(name));
            table.per_cent[i] = per_cent;
        }
    }

    void read_row(const std::vector<Cell>& cells)
    {
        NumberTable& table = result_.tables.back();
        const int line = lines_.number();
        if (cells.size() != column_count_ + 1) {
            problems_.add(line, {},
                          fmt::format("must have {} numbers as the rows before (got {}){}",
                                      column_count_ + 1, cells.size(),
                                      separator_ == ',' && cells.size() == 2 * (column_count_ + 1)
                                          ? "; where numbers have decimal commas, there must be ; "
                                            "or tabs between them"
                                          : ""));
            return;
        }
        if (table.wavelengths_nm.size() == kMaxSamples) {
            problems_.add(line, {}, fmt::format("must have at most {} rows", kMaxSamples));
            full_ = true;
            return;
        }
        if (const auto wavelength = number(cells[0], line, "wavelength"))
            add_wavelength(table, *wavelength, line);
        for (std::size_t i = 1; i < cells.size(); ++i)
            table.columns[i - 1].push_back(number(cells[i], line, name_of(table, i)).value_or(0.0));
    }

    static std::string name_of(const NumberTable& table, std::size_t column)
    {
        return table.names.empty() ? fmt::format("column {}", column + 1)
                                   : excerpt(table.names[column - 1]);
    }

    std::optional<double> number(const Cell& cell, int line, const std::string& field)
    {
        const auto value = parse_number(with_point(cell));
        if (value && std::isfinite(*value)) {
            check_marks(cell, line, field);
            return value;
        }
        problems_.add(line, field,
                      fmt::format("must be a finite number (got '{}')", excerpt(cell.text)));
        return std::nullopt;
    }

    /// A decimal comma becomes a point where it cannot separate cells.
    [[nodiscard]] std::string with_point(const Cell& cell) const
    {
        std::string text(cell.text);
        const std::size_t comma = text.find(',');
        if (comma != std::string::npos && (separator_ != ',' || cell.quoted) &&
            has_decimal_commas(text) && text.find('.') == std::string::npos)
            text[comma] = '.';
        return text;
    }

    /// A comma among points may group thousands.
    void check_marks(const Cell& cell, int line, const std::string& field)
    {
        const bool comma = cell.text.find(',') != std::string_view::npos;
        if (!comma && cell.text.find('.') == std::string_view::npos) return;
        if (!decimal_comma_) decimal_comma_ = comma;
        if (*decimal_comma_ == comma || mixed_marks_) return;
        mixed_marks_ = true;
        problems_.add(line, field,
                      fmt::format("must have a decimal {} as the numbers before (got '{}')",
                                  *decimal_comma_ ? "comma" : "point", excerpt(cell.text)));
    }

    void add_wavelength(NumberTable& table, double given, int line)
    {
        table.lines.push_back(line);
        const bool first = table.wavelengths_nm.empty();
        const double before = first ? 0.0 : table.wavelengths_nm.back();
        if (!first && !descending_) descending_ = given < before;
        const bool down = descending_.value_or(false);
        if (!(given > 0.0) || !(down ? given < before : given > before)) {
            const double unit = heading_.nm_per_unit;
            problems_.add(line, "wavelength",
                          fmt::format("must be > 0 and {} (got {:g} nm after {:g} nm)",
                                      down ? "descending as before" : "ascending", given * unit,
                                      before * unit));
        }
        table.wavelengths_nm.push_back(given);
    }

    void finish_table()
    {
        if (result_.tables.empty() || !problems_.empty()) return;
        NumberTable& table = result_.tables.back();
        if (table.wavelengths_nm.size() < 2) {
            problems_.add(table.line, {},
                          fmt::format("must have at least two rows of numbers (got {})",
                                      table.wavelengths_nm.size()));
            return;
        }
        if (descending_.value_or(false)) {
            std::ranges::reverse(table.lines);
            std::ranges::reverse(table.wavelengths_nm);
            for (auto& column : table.columns) std::ranges::reverse(column);
        }
        const double unit = nm_per_unit(table);
        for (double& nm : table.wavelengths_nm) nm *= unit;
        // No instrument measures from 0 to 30 nm; what says so means µm.
        constexpr double kLeastLastNm = 30.0;
        if (table.wavelengths_nm.back() < kLeastLastNm)
            problems_.add(table.line, "wavelength",
                          fmt::format("must reach {:g} nm; for µm the column must be called "
                                      "wavelength_um (got {:g} … {:g})",
                                      kLeastLastNm, table.wavelengths_nm.front(),
                                      table.wavelengths_nm.back()));
    }

    /// refractiveindex.info exports µm as `wl`, and instruments nm as `WL`: which it is follows
    /// from the numbers, as 100 µm and more is no light that anybody films.
    [[nodiscard]] double nm_per_unit(const NumberTable& table) const
    {
        constexpr double kFirstOfNm = 100.0;
        if (!heading_.is_wl) return heading_.nm_per_unit;
        return table.wavelengths_nm.front() < kFirstOfNm ? 1000.0 : 1.0;
    }

    TextLines lines_;
    FileProblems problems_;
    NumberTables result_;
    char separator_ = ',';
    WavelengthHeading heading_;
    std::optional<bool> descending_;     ///< of the table that is read, from its second row on
    std::optional<bool> decimal_comma_;  ///< of the file, from its first fraction on
    bool mixed_marks_ = false;
    std::size_t column_count_ = 0;
    bool full_ = false;
};

}  // namespace

NumberTables read_number_tables(std::string_view text, std::string_view file)
{
    check_size(text, std::string(file));
    const std::string decoded = utf8_of_utf16(text);
    return TableReader(decoded.empty() ? text : decoded, file).read();
}

}  // namespace nacre::spectral
