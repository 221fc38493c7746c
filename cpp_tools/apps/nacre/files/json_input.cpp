// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "files/json_input.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nacre/core/file_io.h"
#include "nacre/core/limits.h"

namespace nacre::tool {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// The words that JSON lacks, as a string that no JSON text of a user's holds by chance.
constexpr std::string_view kNotFinite[][2] = {{"NaN", R"("\u0000NaN")"},
                                              {"-Infinity", R"("\u0000-Infinity")"},
                                              {"Infinity", R"("\u0000Infinity")"}};

/// A member that an object with a key twice gets: the key.
constexpr const char* kTwice = "\x01twice";

/// Walks over the text once, outside strings: rewrites the words above and numbers beyond a double,
/// and notes the lines on which the elements of a top-level array start.
class Scanner {
public:
    Scanner(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    std::string prepared;
    std::vector<int> record_lines;

    void run()
    {
        prepared.reserve(text_.size());
        while (at_ < text_.size()) step();
    }

private:
    void step()
    {
        const char c = text_[at_];
        if (c == '\n') ++line_;
        // The parser would take it for the end and pass over all that follows.
        if (c == '\0') throw InputError({file_, line_, "", "not valid JSON: a null character"});
        if (in_string_) {
            if (c == '\\' && at_ + 1 < text_.size())
                copy();
            else if (c == '"')
                in_string_ = false;
        } else if (!rewrite_word() && !rewrite_huge_number(c)) {
            track(c);
        } else {
            return;
        }
        copy();
    }

    void track(char c)
    {
        const bool space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
        if (depth_ == 1 && in_array_ && expects_element_ && !space && c != ']') {
            record_lines.push_back(line_);
            expects_element_ = false;
        }
        if (c == '"') in_string_ = true;
        if (c == '[' || c == '{') {
            if (depth_++ == 0) in_array_ = expects_element_ = c == '[';
            if (depth_ > kMaxJsonDepth)
                throw InputError(
                    {file_, line_, "", fmt::format("nested deeper than {} levels", kMaxJsonDepth)});
        }
        if (c == ']' || c == '}') --depth_;
        if (c == ',' && depth_ == 1) expects_element_ = true;
    }

    bool rewrite_word()
    {
        for (const auto& [word, replacement] : kNotFinite) {
            if (text_.substr(at_, word.size()) != word) continue;
            if (depth_ == 1 && expects_element_) track('0');
            prepared += replacement;
            at_ += word.size();
            return true;
        }
        return false;
    }

    /// The parser would end the whole batch at 1e999.
    bool rewrite_huge_number(char first)
    {
        if (first != '-' && (first < '0' || first > '9')) return false;
        const std::size_t end =
            std::min(text_.find_first_not_of("0123456789+-.eE", at_), text_.size());
        const std::string token(text_.substr(at_, end - at_));
        if (depth_ == 1 && expects_element_) track('0');
        at_ = end;
        char* read_to = nullptr;
        if (std::isinf(std::strtod(token.c_str(), &read_to)) && *read_to == '\0') {
            constexpr std::size_t kShown = 40;
            prepared += fmt::format(R"("\u0000{}{}")", token.substr(0, kShown),
                                    token.size() > kShown ? "..." : "");
        } else {
            prepared += token;
        }
        return true;
    }

    void copy() { prepared += text_[at_++]; }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 1, depth_ = 0;
    bool in_string_ = false, in_array_ = false, expects_element_ = false;
};

[[noreturn]] void throw_syntax_error(const json::exception& error, std::size_t byte,
                                     std::string_view text, const std::string& file)
{
    const std::string_view before = text.substr(0, std::min(byte, text.size()));
    const int line = 1 + static_cast<int>(std::count(before.begin(), before.end(), '\n'));
    std::string message = error.what();
    // "[json.exception.parse_error.101] parse error at line 1, column 9: syntax error …": the
    // position goes to where the other messages have it.
    if (const auto column = message.find(", column "); column != std::string::npos) {
        message = "column " + message.substr(column + 9);
    } else if (const auto end = message.find("] "); end != std::string::npos) {
        message = message.substr(end + 2);
    }
    throw InputError({file, line, "", "not valid JSON: " + message});
}

/// Marks an object in which a key comes twice: the parser would silently keep the last.
class DoubledKeys {
public:
    bool operator()(json::parse_event_t event, json& parsed)
    {
        if (event == json::parse_event_t::object_start) objects_.emplace_back();
        if (event == json::parse_event_t::key) {
            const auto& key = parsed.get_ref<const std::string&>();
            if (!objects_.back().keys.insert(key).second) objects_.back().twice = key;
        }
        if (event == json::parse_event_t::object_end) {
            if (objects_.back().twice) parsed[kTwice] = *objects_.back().twice;
            objects_.pop_back();
        }
        return true;
    }

private:
    struct Keys {
        std::set<std::string> keys;
        std::optional<std::string> twice;
    };
    std::vector<Keys> objects_;
};

const char* not_finite_word(const json& value)
{
    const auto* text = value.get_ptr<const std::string*>();
    return text && !text->empty() && text->front() == '\0' ? text->c_str() + 1 : nullptr;
}

}  // namespace

const Range kAnyNumber{-kInf, kInf};
const Range kPositive{0.0, kInf, true};
const Range kNotNegative{0.0, kInf};

bool Range::contains(double value) const noexcept
{
    return std::isfinite(value) && (min_open ? value > min : value >= min) &&
           (max_open ? value < max : value <= max);
}

std::string Range::text() const
{
    if (min == -kInf && max == kInf) return "finite";
    if (max == kInf) return fmt::format("{} {}", min_open ? ">" : "≥", min);
    return fmt::format("in {}{}, {}{}", min_open ? '(' : '[', min, max, max_open ? ')' : ']');
}

JsonDocument parse_json(std::string_view text, const std::string& file)
{
    Scanner scanner(text, file);
    scanner.run();
    DoubledKeys doubled;
    try {
        json value =
            json::parse(scanner.prepared, [&doubled](int, json::parse_event_t event, json& parsed) {
                return doubled(event, parsed);
            });
        return {std::move(value), std::move(scanner.record_lines)};
    } catch (const json::parse_error& error) {
        throw_syntax_error(error, error.byte, scanner.prepared, file);
    } catch (const json::out_of_range& error) {
        throw_syntax_error(error, 0, scanner.prepared, file);
    }
}

std::string read_input(const std::string& path)
{
    if (path != "-") return read_text(path, kMaxBatchBytes);
    std::string text;
    char block[1 << 16];
    while (std::cin.read(block, sizeof block), std::cin.gcount() > 0) {
        text.append(block, static_cast<std::size_t>(std::cin.gcount()));
        if (text.size() > kMaxBatchBytes)
            throw InputError({"-", 0, "", fmt::format("must be ≤ {} bytes", kMaxBatchBytes)});
    }
    return text;
}

std::string quoted(const json& value)
{
    if (const char* word = not_finite_word(value)) return word;
    std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
    if (text.size() > 60) text = text.substr(0, 57) + "...";
    return text;
}

std::optional<double> read_number(const json& value, const std::string& field, const Range& range,
                                  DiagnosticList& problems)
{
    const bool readable = value.is_number() || not_finite_word(value);
    if (value.is_number() && range.contains(value.get<double>())) return value.get<double>();
    problems.add({"", 0, field,
                  fmt::format("must be {}{} (got {})", readable ? "" : "a number ", range.text(),
                              quoted(value))});
    return std::nullopt;
}

ObjectReader::ObjectReader(const json& object, std::string path, DiagnosticList& problems)
    : object_(object), path_(std::move(path)), problems_(problems)
{
    if (!object_.is_object())
        problems_.add({"", 0, path_, fmt::format("must be an object (got {})", quoted(object_))});
    else if (const auto twice = object_.find(kTwice); twice != object_.end())
        problem(twice->get_ref<const std::string&>(), "must be there once only");
}

bool ObjectReader::has(const char* key) const
{
    return object_.is_object() && object_.contains(key);
}

const json* ObjectReader::required(const char* key)
{
    const json* member = optional(key);
    if (!member && object_.is_object()) problem(key, "is missing");
    return member;
}

const json* ObjectReader::optional(const char* key)
{
    if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.emplace_back(key);
    return has(key) ? &object_.at(key) : nullptr;
}

std::optional<double> ObjectReader::number(const char* key, const Range& range)
{
    const json* member = required(key);
    return member ? read_number(*member, field(key), range, problems_) : std::nullopt;
}

std::optional<double> ObjectReader::number_or(const char* key, const Range& range, double fallback)
{
    return optional(key) ? number(key, range) : fallback;
}

std::optional<std::vector<double>> ObjectReader::numbers(const char* key, const Range& range)
{
    const json* member = required(key);
    if (!member) return std::nullopt;
    if (!member->is_array()) {
        problem(key, fmt::format("must be a list of numbers (got {})", quoted(*member)));
        return std::nullopt;
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < member->size(); ++i) {
        const auto value =
            read_number((*member)[i], fmt::format("{}[{}]", field(key), i), range, problems_);
        if (value) values.push_back(*value);
    }
    if (values.size() != member->size()) return std::nullopt;
    return values;
}

std::optional<std::string> ObjectReader::text(const char* key)
{
    const json* member = required(key);
    if (!member) return std::nullopt;
    if (member->is_string() && !not_finite_word(*member)) return member->get<std::string>();
    problem(key, fmt::format("must be a text (got {})", quoted(*member)));
    return std::nullopt;
}

std::optional<std::string> ObjectReader::choice(const char* key,
                                                std::vector<std::string_view> allowed)
{
    auto value = text(key);
    if (!value || std::find(allowed.begin(), allowed.end(), *value) != allowed.end()) return value;
    problem(key, fmt::format("must be one of {} (got \"{}\")", fmt::join(allowed, ", "), *value));
    return std::nullopt;
}

std::optional<std::string> ObjectReader::choice_or(const char* key,
                                                   std::vector<std::string_view> allowed,
                                                   const char* fallback)
{
    return optional(key) ? choice(key, std::move(allowed)) : fallback;
}

void ObjectReader::refuse_unknown_keys()
{
    if (!object_.is_object()) return;
    for (const auto& member : object_.items()) {
        if (std::find(known_.begin(), known_.end(), member.key()) != known_.end()) continue;
        if (member.key() == kTwice) continue;
        problem(member.key(),
                fmt::format("is not known here; the keys are {}", fmt::join(known_, ", ")));
    }
}

void ObjectReader::problem(std::string_view key, std::string message)
{
    problems_.add({"", 0, field(key), std::move(message)});
}

std::string ObjectReader::field(std::string_view key) const
{
    return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

}  // namespace nacre::tool
