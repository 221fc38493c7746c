// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/readers/refractiveindex_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <type_traits>

#include "index_rows.h"
#include "markup.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/text_lines.h"
#include "nacre/media/tabulated_index.h"
#include "yaml_tree.h"

namespace nacre::spectral {

namespace {

/// Numbers of one line; nothing where a word is no number.
std::optional<std::vector<double>> parse_numbers(std::string_view text)
{
    std::vector<double> numbers;
    for (const std::string_view word : split_words(text)) {
        const auto number = parse_number(word);
        if (!number) return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

/// Reads DATA and collects all that is wrong with it.
class DataReader {
public:
    explicit DataReader(const std::string& name) : name_(name), problems_(name) {}

    MeasuredIndex read(const YamlNode& root)
    {
        const YamlNode* const data = root.find("DATA");
        if (!data || data->items.empty()) {
            add(data ? data->line : root.line, "DATA", "must be a list of tables and formulas");
        } else {
            for (std::size_t i = 0; i < data->items.size(); ++i)
                read_entry(*data->items[i], fmt::format("DATA[{}]", i));
            if (problems_.empty() && !n_) add(data->line, "DATA", "must state n");
        }
        problems_.throw_if_any();
        extend_clear_ends();
        return {.name = name_, .n = std::move(*n_), .k = std::move(k_)};
    }

    /// What read() had to put right.
    [[nodiscard]] std::vector<std::string> changes() && { return std::move(changes_); }

private:
    void add(int line, std::string field, std::string message)
    {
        problems_.add(line, std::move(field), std::move(message));
    }

    void read_entry(const YamlNode& entry, const std::string& field)
    {
        const YamlNode* const type = entry.find("type");
        if (!type || !type->is_text()) {
            add(entry.line, field + ".type", "is missing");
            return;
        }
        const std::string& kind = type->text;
        if (kind == "tabulated n") {
            read_table(entry, field, true, false);
        } else if (kind == "tabulated k") {
            read_table(entry, field, false, true);
        } else if (kind == "tabulated nk") {
            read_table(entry, field, true, true);
        } else if (kind.size() == 9 && kind.starts_with("formula ") && kind[8] >= '1' &&
                   kind[8] <= '9') {
            read_formula(entry, field, kind[8] - '0');
        } else {
            add(type->line, field + ".type",
                fmt::format("must be 'tabulated n', 'tabulated k', 'tabulated nk' or "
                            "'formula 1' … 'formula 9' (got '{}')",
                            excerpt(kind)));
        }
    }

    /// The numbers of a scalar, each line with its own number in the file.
    struct Row {
        int line;
        std::vector<double> numbers;
    };

    std::vector<Row> rows_of(const YamlNode& entry, const std::string& field, const char* key)
    {
        const YamlNode* const node = entry.find(key);
        const std::string path = fmt::format("{}.{}", field, key);
        if (!node || !node->is_text()) {
            add(entry.line, path, "is missing");
            return {};
        }
        const std::string& text = node->text;
        // The mark of a block (`|`) is that of its indicator; its text starts a line below.
        int line = node->line + (text.find('\n') != std::string::npos ? 1 : 0);
        std::vector<Row> rows;
        for (std::size_t at = 0; at < text.size(); ++line) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            const std::string_view row = std::string_view(text).substr(at, end - at);
            at = end + 1;
            auto numbers = parse_numbers(row);
            if (!numbers) {
                add(line, path, fmt::format("must be numbers (got '{}')", excerpt(row)));
            } else if (!numbers->empty()) {
                rows.push_back({line, std::move(*numbers)});
            }
        }
        return rows;
    }

    void read_table(const YamlNode& entry, const std::string& field, bool has_n, bool has_k)
    {
        const std::string path = field + ".data";
        std::vector<Row> given = rows_of(entry, field, "data");
        if (given.empty() && problems_.empty()) add(entry.line, path, "must have rows");
        std::vector<IndexRow> rows;
        for (const auto& [line, numbers] : given) {
            const std::size_t wanted = has_n && has_k ? 3 : 2;
            if (numbers.size() != wanted) {
                add(line, path,
                    fmt::format("must have {} numbers a row (got {})", wanted, numbers.size()));
                continue;
            }
            rows.push_back(
                {line, numbers[0], has_n ? numbers[1] : 1.0, has_k ? numbers.back() : 0.0});
            check_row(rows.back(), path);
        }
        if (!problems_.empty()) return;
        if (!check_gain(rows, path)) return;
        for (const std::string& change : mend_rows(rows))
            changes_.push_back(fmt::format("{}: {}", path, change));
        IndexTable n, k;
        for (const IndexRow& row : rows) {
            append(n, row.wavelength, row.n);
            append(k, row.wavelength, row.k);
        }
        if (has_n) set_n(std::move(n), entry, field);
        if (has_k) set_k(std::move(k), entry, field);
    }

    /// Rows of k < 0 beyond noise are left out; where they are half of all, the medium has gain.
    bool check_gain(const std::vector<IndexRow>& rows, const std::string& path)
    {
        const auto gains = [](const IndexRow& row) { return row.k < kLeastNoiseOfK; };
        const auto first = std::ranges::find_if(rows, gains);
        const auto count = static_cast<std::size_t>(std::ranges::count_if(rows, gains));
        if (2 * count < rows.size() || count == 0) return true;
        add(first->line, path,
            fmt::format("k must be ≥ 0 (got {} here, and less than {:g} in {} of {} rows)",
                        first->k, kLeastNoiseOfK, count, rows.size()));
        return false;
    }

    void check_row(const IndexRow& row, const std::string& path)
    {
        if (!(row.wavelength > 0.0) || !std::isfinite(row.wavelength))
            add(row.line, path,
                fmt::format("wavelengths must be finite and > 0 (got {})", row.wavelength));
        if (!(row.n > 0.0) || !std::isfinite(row.n))
            add(row.line, path, fmt::format("n must be finite and > 0 (got {})", row.n));
        if (!std::isfinite(row.k))
            add(row.line, path, fmt::format("k must be finite (got {})", row.k));
    }

    static void append(IndexTable& table, double um, double value)
    {
        table.wavelengths_um.push_back(um);
        table.values.push_back(value);
    }

    void read_formula(const YamlNode& entry, const std::string& field, int number)
    {
        const auto range = numbers_of(entry, field, "wavelength_range");
        const auto coefficients = numbers_of(entry, field, "coefficients");
        if (!range || !coefficients) return;

        if (range->numbers.size() != 2 || !(range->numbers[0] > 0.0) ||
            !(range->numbers[1] > range->numbers[0]) || !std::isfinite(range->numbers[1]))
            add(range->line, field + ".wavelength_range",
                "must be two ascending wavelengths in µm, finite and > 0");
        const std::string path = field + ".coefficients";
        const std::string problem = coefficient_count_problem(number, coefficients->numbers.size());
        if (!problem.empty()) add(coefficients->line, path, problem);
        for (const double value : coefficients->numbers)
            if (!std::isfinite(value))
                add(coefficients->line, path, fmt::format("must be finite (got {})", value));
        if (!problems_.empty()) return;
        set_n(
            RangedFormula{{number, coefficients->numbers}, {range->numbers[0], range->numbers[1]}},
            entry, field);
    }

    std::optional<Row> numbers_of(const YamlNode& entry, const std::string& field, const char* key)
    {
        std::vector<Row> rows = rows_of(entry, field, key);
        if (rows.empty()) {
            if (problems_.empty())
                add(entry.find(key)->line, fmt::format("{}.{}", field, key), "is empty");
            return std::nullopt;
        }
        for (std::size_t i = 1; i < rows.size(); ++i)
            rows[0].numbers.insert(rows[0].numbers.end(), rows[i].numbers.begin(),
                                   rows[i].numbers.end());
        return std::move(rows[0]);
    }

    template <typename Source>
    void set_n(Source source, const YamlNode& entry, const std::string& field)
    {
        if (n_)
            compare_n(source, entry, field);
        else
            n_ = std::move(source);
    }

    /// A file may have a formula and the numbers that it gives: the first counts where both agree.
    template <typename Source>
    void compare_n(const Source& second, const YamlNode& entry, const std::string& field)
    {
        constexpr double kAlike = 1e-3;
        if constexpr (std::is_same_v<Source, IndexTable>) {
            for (std::size_t i = 0; i < second.values.size(); ++i) {
                const auto first = first_n_at(second.wavelengths_um[i]);
                if (first && std::abs(*first - second.values[i]) <= kAlike) continue;
                if (first)
                    add(entry.line, field,
                        fmt::format("n is stated twice, and not alike: {:g} and {:g} at {:g} µm",
                                    *first, second.values[i], second.wavelengths_um[i]));
                if (first) return;
            }
            changes_.push_back(field + ": n is stated twice and alike, the first counts");
        } else {
            add(entry.line, field, "n is stated twice");
        }
    }

    /// Nothing outside its range.
    [[nodiscard]] std::optional<double> first_n_at(double um) const
    {
        if (const auto* table = std::get_if<IndexTable>(&*n_)) {
            const auto [low, high] = table->range_um();
            if (um < low || um > high) return std::nullopt;
            return table->at(um);
        }
        const RangedFormula& first = std::get<RangedFormula>(*n_);
        if (um < first.range_um[0] || um > first.range_um[1]) return std::nullopt;
        return first.formula.index_at(um);
    }

    /// A table of k that ends with 0 where the formula of n goes on says that the medium is clear
    /// from there, as one without k is.
    void extend_clear_ends()
    {
        const auto* const formula = std::get_if<RangedFormula>(&*n_);
        if (!formula || !k_) return;
        const auto [low, high] = formula->range_um;
        auto& [um, k] = *k_;
        const auto tell = [this](double end_um, const char* side) {
            changes_.push_back(
                fmt::format("k ends with 0 at {:g} nm and is 0 {} that", end_um * 1000.0, side));
        };
        if (k.front() == 0.0 && low < um.front()) {
            tell(um.front(), "below");
            um.insert(um.begin(), low);
            k.insert(k.begin(), 0.0);
        }
        if (k.back() == 0.0 && high > um.back()) {
            tell(um.back(), "above");
            um.push_back(high);
            k.push_back(0.0);
        }
    }

    void set_k(IndexTable table, const YamlNode& entry, const std::string& field)
    {
        if (k_) add(entry.line, field, "k is stated twice");
        k_ = std::move(table);
    }

    std::string name_;
    FileProblems problems_;
    std::optional<std::variant<IndexTable, RangedFormula>> n_;
    std::optional<IndexTable> k_;
    std::vector<std::string> changes_;
};

std::string text_of(const YamlNode& root, const char* key)
{
    const YamlNode* const node = root.find(key);
    return node && node->is_text() ? plain_text(node->text) : std::string();
}

/// The scalars of a list; what is no list of scalars is no business of optics and is passed over.
std::vector<std::string> texts_of(const YamlNode& root, const char* key)
{
    std::vector<std::string> texts;
    if (const YamlNode* const list = root.find(key))
        for (const YamlNode* item : list->items)
            if (item->is_text()) texts.push_back(plain_text(item->text));
    return texts;
}

}  // namespace

Medium parse_refractiveindex_yaml(std::string_view text, std::string_view name)
{
    const std::string file(name);
    check_size(text, file);
    const YamlTree tree(text, file);
    Medium medium{.key = file,
                  .name = file,
                  .references = {},
                  .comments = {},
                  .formula = {},
                  .tags = {},
                  .changes = {},
                  .constants = {}};
    DataReader reader(file);
    medium.constants = measured_constants(reader.read(tree.root()));
    medium.changes = std::move(reader).changes();
    medium.references = text_of(tree.root(), "REFERENCES");
    medium.comments = text_of(tree.root(), "COMMENTS");
    medium.formula = text_of(tree.root(), "FORMULA");
    medium.tags = texts_of(tree.root(), "TAGS");
    if (auto names = texts_of(tree.root(), "NAMES"); !names.empty())
        medium.name = std::move(names.front());
    return medium;
}

}  // namespace nacre::spectral
