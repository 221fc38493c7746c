// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <yaml-cpp/depthguard.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <optional>

#include "markup.h"
#include "nacre/core/diagnostics.h"
#include "tabulated_index.h"
#include "text_lines.h"

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

int line_of(const YAML::Mark& mark)
{
    return mark.is_null() ? 0 : mark.line + 1;
}

/// Reads DATA and collects all that is wrong with it.
class DataReader {
public:
    explicit DataReader(const std::string& name) : name_(name), problems_(name) {}

    MeasuredIndex read(const YAML::Node& root)
    {
        const YAML::Node data = root.IsMap() ? root["DATA"] : YAML::Node();
        if (!data.IsDefined() || !data.IsSequence() || data.size() == 0) {
            add(line_of(data.IsDefined() ? data.Mark() : root.Mark()), "DATA",
                "must be a list of tables and formulas");
        } else {
            for (std::size_t i = 0; i < data.size(); ++i)
                read_entry(data[i], fmt::format("DATA[{}]", i));
            if (problems_.empty() && !n_) add(line_of(data.Mark()), "DATA", "must state n");
        }
        problems_.throw_if_any();
        return {.name = name_, .n = std::move(*n_), .k = std::move(k_)};
    }

private:
    void add(int line, std::string field, std::string message)
    {
        problems_.add(line, std::move(field), std::move(message));
    }

    void read_entry(const YAML::Node& entry, const std::string& field)
    {
        const YAML::Node type = entry.IsMap() ? entry["type"] : YAML::Node();
        if (!type.IsDefined() || !type.IsScalar()) {
            add(line_of(entry.Mark()), field + ".type", "is missing");
            return;
        }
        const std::string& kind = type.Scalar();
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
            add(line_of(type.Mark()), field + ".type",
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

    std::vector<Row> rows_of(const YAML::Node& entry, const std::string& field, const char* key)
    {
        const YAML::Node node = entry[key];
        const std::string path = fmt::format("{}.{}", field, key);
        if (!node.IsDefined() || !node.IsScalar()) {
            add(line_of(entry.Mark()), path, "is missing");
            return {};
        }
        const std::string& text = node.Scalar();
        // The mark of a block (`|`) is that of its indicator; its text starts a line below.
        int line = line_of(node.Mark()) + (text.find('\n') != std::string::npos ? 1 : 0);
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

    void read_table(const YAML::Node& entry, const std::string& field, bool has_n, bool has_k)
    {
        const std::vector<Row> rows = rows_of(entry, field, "data");
        const std::string path = field + ".data";
        if (rows.empty() && problems_.empty()) add(line_of(entry.Mark()), path, "must have rows");
        IndexTable n, k;
        double previous = 0.0;
        for (const auto& [line, numbers] : rows) {
            const std::size_t wanted = has_n && has_k ? 3 : 2;
            if (numbers.size() != wanted) {
                add(line, path,
                    fmt::format("must have {} numbers a row (got {})", wanted, numbers.size()));
                continue;
            }
            const double um = numbers[0];
            if (!(um > previous) || !std::isfinite(um))
                add(line, path,
                    fmt::format("wavelengths must be finite, > 0 and ascending (got {} after {})",
                                um, previous));
            previous = um;
            if (has_n) append(n, um, numbers[1]);
            if (has_k) append(k, um, numbers.back());
            if (has_n && !(numbers[1] > 0.0 && std::isfinite(numbers[1])))
                add(line, path, fmt::format("n must be finite and > 0 (got {})", numbers[1]));
            if (has_k && !(numbers.back() >= 0.0 && std::isfinite(numbers.back())))
                add(line, path, fmt::format("k must be finite and ≥ 0 (got {})", numbers.back()));
        }
        if (has_n) set_n(std::move(n), entry, field);
        if (has_k) set_k(std::move(k), entry, field);
    }

    static void append(IndexTable& table, double um, double value)
    {
        table.wavelengths_um.push_back(um);
        table.values.push_back(value);
    }

    void read_formula(const YAML::Node& entry, const std::string& field, int number)
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

    std::optional<Row> numbers_of(const YAML::Node& entry, const std::string& field,
                                  const char* key)
    {
        std::vector<Row> rows = rows_of(entry, field, key);
        if (rows.empty()) {
            if (problems_.empty())
                add(line_of(entry[key].Mark()), fmt::format("{}.{}", field, key), "is empty");
            return std::nullopt;
        }
        for (std::size_t i = 1; i < rows.size(); ++i)
            rows[0].numbers.insert(rows[0].numbers.end(), rows[i].numbers.begin(),
                                   rows[i].numbers.end());
        return std::move(rows[0]);
    }

    template <typename Source>
    void set_n(Source source, const YAML::Node& entry, const std::string& field)
    {
        if (n_) add(line_of(entry.Mark()), field, "n is stated twice");
        n_ = std::move(source);
    }

    void set_k(IndexTable table, const YAML::Node& entry, const std::string& field)
    {
        if (k_) add(line_of(entry.Mark()), field, "k is stated twice");
        k_ = std::move(table);
    }

    std::string name_;
    FileProblems problems_;
    std::optional<std::variant<IndexTable, RangedFormula>> n_;
    std::optional<IndexTable> k_;
};

std::string text_of(const YAML::Node& root, const char* key)
{
    const YAML::Node node = root[key];
    return node.IsDefined() && node.IsScalar() ? plain_text(node.Scalar()) : std::string();
}

/// The scalars of a list; what is no list of scalars is no business of optics and is passed over.
std::vector<std::string> texts_of(const YAML::Node& root, const char* key)
{
    std::vector<std::string> texts;
    const YAML::Node list = root[key];
    if (!list.IsDefined() || !list.IsSequence()) return texts;
    for (const YAML::Node& item : list)
        if (item.IsScalar()) texts.push_back(plain_text(item.Scalar()));
    return texts;
}

}  // namespace

Medium parse_refractiveindex_yaml(std::string_view text, std::string_view name)
{
    const std::string file(name);
    check_size(text, file);
    try {
        // Aliases are shared nodes in yaml-cpp, never copies, and its parser limits the depth.
        const YAML::Node root = YAML::Load(std::string(text));
        Medium medium{.key = file,
                      .name = file,
                      .references = {},
                      .comments = {},
                      .formula = {},
                      .tags = {},
                      .constants = {}};
        medium.constants = measured_constants(DataReader(file).read(root));
        medium.references = text_of(root, "REFERENCES");
        medium.comments = text_of(root, "COMMENTS");
        medium.formula = text_of(root, "FORMULA");
        medium.tags = texts_of(root, "TAGS");
        if (auto names = texts_of(root, "NAMES"); !names.empty())
            medium.name = std::move(names.front());
        return medium;
    } catch (const YAML::DeepRecursion& error) {
        throw InputError(
            {file, line_of(error.mark), {}, "must not be nested deeper than 499 levels"});
    } catch (const YAML::Exception& error) {
        throw InputError({file, line_of(error.mark), {}, "is not valid YAML: " + error.msg});
    }
}

}  // namespace nacre::spectral
