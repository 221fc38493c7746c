// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "csv_table.h"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

#include "nacre/core/resources.h"

namespace nacre::spectral {

namespace {

std::string_view take_line(std::string_view& text)
{
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return line;
}

bool parse_row(std::string_view line, CsvTable& table)
{
    const char* at = line.data();
    const char* const end = at + line.size();
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        if (i > 0 && (at == end || *at++ != ',')) return false;
        double value = 0.0;
        const auto [next, error] = std::from_chars(at, end, value);
        if (error != std::errc{}) return false;
        table.columns[i].push_back(value);
        at = next;
    }
    return at == end;
}

}  // namespace

CsvTable load_csv(std::string_view path, std::size_t columns)
{
    const auto resource = find_resource(path);
    if (!resource) throw std::logic_error(fmt::format("resource {} is missing", path));

    CsvTable table{.columns = std::vector<std::vector<double>>(columns)};
    std::string_view text = *resource;
    bool names_seen = false;
    while (!text.empty()) {
        const std::string_view line = take_line(text);
        if (line.empty() || line.starts_with('#')) continue;
        if (!names_seen) {
            names_seen = true;
        } else if (!parse_row(line, table)) {
            throw std::logic_error(fmt::format("resource {}: malformed row '{}'", path, line));
        }
    }
    return table;
}

}  // namespace nacre::spectral
