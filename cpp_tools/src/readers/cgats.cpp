// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "nacre/core/limits.h"
#include "nacre/core/text_lines.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"

namespace nacre::spectral {

namespace {

struct Word {
    std::string_view text;
    int line;
    bool first;  ///< of its line
};

/// Words of a CGATS file: between spaces or quotes, comments left out.
class Words {
public:
    explicit Words(std::string_view text) : lines_(text) {}

    std::optional<Word> next()
    {
        bool first = false;
        for (;;) {
            const std::size_t start = rest_.find_first_not_of(" \t\r");
            if (start != std::string_view::npos && rest_[start] != '#') {
                rest_.remove_prefix(start);
                return Word{take(), lines_.number(), first};
            }
            const auto line = lines_.next();
            if (!line) return std::nullopt;
            rest_ = *line;
            first = true;
        }
    }

private:
    std::string_view take()
    {
        const bool quoted = rest_.front() == '"';
        if (quoted) rest_.remove_prefix(1);
        const std::size_t length =
            std::min(rest_.find_first_of(quoted ? "\"" : " \t\r"), rest_.size());
        const std::string_view word = rest_.substr(0, length);
        rest_.remove_prefix(std::min(length + (quoted ? 1 : 0), rest_.size()));
        return word;
    }

    TextLines lines_;
    std::string_view rest_;
};

/// A field that holds the value at a wavelength.
struct SpectralField {
    std::size_t column;
    double nm, scale;
    bool unit_stated;
};

std::optional<SpectralField> spectral_field(std::string_view name, std::size_t column)
{
    struct Prefix {
        std::string_view text;
        double scale;
        bool unit_stated;
    };
    // The longer ones first: SPECTRAL_ is the start of three others.
    constexpr std::array<Prefix, 6> kPrefixes = {{{"SPECTRAL_NM", 1.0, false},
                                                  {"SPECTRAL_PCT", 0.01, true},
                                                  {"SPECTRAL_DEC", 1.0, true},
                                                  {"SPECTRAL_", 1.0, false},
                                                  {"SPEC_", 1.0, false},
                                                  {"NM", 1.0, false}}};
    for (const auto& [prefix, scale, unit_stated] : kPrefixes) {
        if (!same_letters(name.substr(0, prefix.size()), prefix)) continue;
        std::string_view rest = name.substr(prefix.size());
        if (rest.starts_with('_')) rest.remove_prefix(1);
        const auto nm = parse_number(rest);
        if (nm && std::isfinite(*nm) && *nm > 0.0)
            return SpectralField{column, *nm, scale, unit_stated};
    }
    return std::nullopt;
}

class CgatsReader {
public:
    CgatsReader(std::string_view text, const std::string& file) : words_(text), problems_(file) {}

    std::vector<NamedSpectrum> read()
    {
        while (const auto word = words_.next()) {
            if (word->text == "BEGIN_DATA_FORMAT")
                read_fields(word->line);
            else if (word->text == "BEGIN_DATA")
                read_data(word->line);
            else if (word->first)
                read_keyword(word->text);
        }
        if (spectra_.empty() && problems_.empty())
            problems_.add(0, "BEGIN_DATA", "must have sets of data");
        problems_.throw_if_any();
        return std::move(spectra_);
    }

private:
    /// Keywords that say where the data are from; the next word is the value.
    void read_keyword(std::string_view keyword)
    {
        for (const char* known : {"ORIGINATOR", "DESCRIPTOR", "INSTRUMENTATION", "CREATED",
                                  "MEASUREMENT_SOURCE", "SPECTRAL_NORM", "MEAS_TYPE"})
            if (keyword == known)
                if (const auto value = words_.next()) header_.try_emplace(known, value->text);
        // Of the table that follows; a file may have several.
        for (auto& [known, count] : counts_)
            if (keyword == known)
                if (const auto value = words_.next()) count = parse_number(value->text);
    }

    /// Whether a table is as long as a keyword before it says, which a file that broke off is not.
    /// Of a table that could not be read the number says nothing.
    void check_count(const char* keyword, std::size_t got, int line)
    {
        auto& stated = counts_.at(keyword);
        if (problems_.empty() && stated && *stated != static_cast<double>(got))
            problems_.add(line, keyword,
                          fmt::format("must be {}, what there is (got {:g})", got, *stated));
        stated.reset();
    }

    void read_fields(int line)
    {
        columns_ = 0;
        name_column_.reset();
        fields_.clear();
        // Argyll scales its values so that this is 1.
        double norm = parse_number(header("SPECTRAL_NORM")).value_or(1.0);
        if (!(norm > 0.0) || !std::isfinite(norm)) {
            problems_.add(line, "SPECTRAL_NORM", "must be finite and > 0");
            norm = 1.0;
        }
        while (const auto word = words_.next()) {
            if (word->text == "END_DATA_FORMAT") {
                check_count("NUMBER_OF_FIELDS", columns_, line);
                return check_fields(line);
            }
            if (columns_ == kMaxSamples) {
                problems_.add(line, "BEGIN_DATA_FORMAT",
                              fmt::format("must have at most {} fields", kMaxSamples));
                return;
            }
            if (auto field = spectral_field(word->text, columns_)) {
                field->scale /= norm;
                field->unit_stated |= !header("SPECTRAL_NORM").empty();
                fields_.push_back(*field);
            } else if (word->text == "SAMPLE_NAME" ||
                       (word->text == "SAMPLE_ID" && !name_column_)) {
                name_column_ = columns_;
            }
            ++columns_;
        }
        problems_.add(line, "BEGIN_DATA_FORMAT", "must end with END_DATA_FORMAT");
    }

    void check_fields(int line)
    {
        std::ranges::sort(fields_, {}, &SpectralField::nm);
        const auto same = std::ranges::adjacent_find(fields_, {}, &SpectralField::nm);
        if (fields_.size() < 2)
            problems_.add(line, "BEGIN_DATA_FORMAT",
                          "must have two or more fields such as SPECTRAL_NM380");
        else if (same != fields_.end())
            problems_.add(line, "BEGIN_DATA_FORMAT",
                          fmt::format("must have {:g} nm once only", same->nm));
    }

    void read_data(int line)
    {
        if (columns_ == 0) problems_.add(line, "BEGIN_DATA", "must come after BEGIN_DATA_FORMAT");
        // What came before is wrong already: only the end is of interest.
        const bool readable = columns_ > 0 && fields_.size() >= 2;
        sets_ = 0;
        row_.clear();
        by_lines_ = readable && has_wrong_line();
        while (const auto word = words_.next()) {
            const bool end = word->text == "END_DATA";
            if (by_lines_ && !row_.empty() && (end || word->first)) end_line();
            if (end) {
                if (!row_.empty()) add_wrong_row();
                if (readable) check_count("NUMBER_OF_SETS", sets_, line);
                return;
            }
            if (readable) add_word(*word);
        }
        problems_.add(line, "BEGIN_DATA", "must end with END_DATA");
    }

    /// Whether a word is missing or one too many, so that sets have to be told apart by their
    /// lines: what is wrong with one is not carried into the next then.
    [[nodiscard]] bool has_wrong_line() const
    {
        Words ahead = words_;
        std::size_t words = 0, in_line = 0, lines = 0, whole = 0;
        const auto end_of_line = [&] {
            if (in_line == 0) return;
            ++lines;
            if (in_line == columns_) ++whole;
            in_line = 0;
        };
        while (const auto word = ahead.next()) {
            if (word->first) end_of_line();
            if (word->text == "END_DATA") break;
            ++in_line;
            ++words;
        }
        end_of_line();
        return words % columns_ != 0 && 2 * whole >= lines;
    }

    void add_word(const Word& word)
    {
        if (by_lines_ && row_.size() > columns_) {
            ++surplus_;
            return;
        }
        row_.push_back(word);
        if (!by_lines_) take_set();
    }

    void end_line()
    {
        if (row_.size() == columns_)
            take_set();
        else
            add_wrong_row();
    }

    /// The first set of the row where it is whole.
    void take_set()
    {
        if (row_.size() < columns_) return;
        ++sets_;
        add_spectrum(std::span(row_).first(columns_));
        row_.erase(row_.begin(), row_.begin() + static_cast<std::ptrdiff_t>(columns_));
    }

    void add_wrong_row()
    {
        problems_.add(row_.front().line, {},
                      fmt::format("must have {} words as there are fields (got {})", columns_,
                                  row_.size() + surplus_));
        row_.clear();
        surplus_ = 0;
    }

    void add_spectrum(std::span<const Word> row)
    {
        std::vector<double> nm, values;
        for (const SpectralField& field : fields_) {
            const Word& word = row[field.column];
            const auto value = parse_number(word.text);
            if (!value || !std::isfinite(*value))
                problems_.add(
                    word.line, fmt::format("{:g} nm", field.nm),
                    fmt::format("must be a finite number (got '{}')", excerpt(word.text)));
            nm.push_back(field.nm);
            values.push_back(value.value_or(0.0) * field.scale);
        }
        if (sets_ == kMaxSpectra + 1)
            problems_.add(row.front().line, {},
                          fmt::format("must have at most {} sets of data", kMaxSpectra));
        if (!problems_.empty()) return;
        const bool emission = header("MEAS_TYPE") == "EMISSION" || header("MEAS_TYPE") == "AMBIENT";
        spectra_.push_back(
            {.key = {},
             .name = clean_text(name_column_ ? row[*name_column_].text : header("DESCRIPTOR")),
             .references = references(),
             .licence = {},
             .comments = clean_text(header("DESCRIPTOR")),
             .tags = {},
             .kind = emission ? SpectrumKind::emission : SpectrumKind::reflectance,
             .samples = {std::move(nm), std::move(values)},
             .unit_stated = std::ranges::all_of(fields_, &SpectralField::unit_stated)});
    }

    [[nodiscard]] std::string_view header(std::string_view keyword) const
    {
        const auto found = header_.find(keyword);
        return found == header_.end() ? std::string_view() : found->second;
    }

    [[nodiscard]] std::string references() const
    {
        std::string text;
        for (const char* part : {"ORIGINATOR", "INSTRUMENTATION", "MEASUREMENT_SOURCE", "CREATED"})
            if (const auto value = header(part); !value.empty())
                text += fmt::format("{}{}", text.empty() ? "" : ", ", value);
        return clean_text(text);
    }

    Words words_;
    FileProblems problems_;
    std::map<std::string_view, std::string_view, std::less<>> header_;
    std::map<std::string_view, std::optional<double>, std::less<>> counts_ = {
        {"NUMBER_OF_FIELDS", {}}, {"NUMBER_OF_SETS", {}}};
    std::size_t columns_ = 0;
    std::optional<std::size_t> name_column_;
    std::vector<Word> row_;    ///< since the last set
    std::size_t surplus_ = 0;  ///< words of its line beyond one more than there are columns
    std::size_t sets_ = 0;     ///< of the table that is read
    bool by_lines_ = false;    ///< a line of that table is a set
    std::vector<SpectralField> fields_;
    std::vector<NamedSpectrum> spectra_;
};

}  // namespace

std::vector<NamedSpectrum> read_cgats(std::string_view text, std::string_view name)
{
    const std::string file(name);
    check_size(text, file);
    return CgatsReader(text, file).read();
}

}  // namespace nacre::spectral
