// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/shader_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <utility>

#include "constants.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"

namespace nacre::oslgen {
namespace {

/// A `surface` is a shader that tells what it is for; displacement and volume shaders are others.
bool begins_shader(std::string_view word)
{
    return word == "shader" || word == "surface";
}

/// One line, with one blank where there were any.
std::string on_one_line(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!blank)
            result += c;
        else if (!result.empty() && result.back() != ' ')
            result += ' ';
    }
    while (result.ends_with(' ')) result.pop_back();
    return result;
}

/// Reads OSL from the left; blanks and comments are passed by.
class Reader {
public:
    Reader(std::string_view text, std::string_view file) : text_(text), file_(file) {}

    [[nodiscard]] int line() const
    {
        return 1 + static_cast<int>(std::ranges::count(text_.substr(0, at_), '\n'));
    }
    [[nodiscard]] std::size_t position() const { return at_; }
    [[nodiscard]] std::string_view between(std::size_t from, std::size_t to) const
    {
        return text_.substr(from, to - from);
    }

    [[noreturn]] void fail(const std::string& message) const
    {
        throw InputError(Diagnostic{std::string(file_), line(), "", message});
    }

    bool accepts(std::string_view token)
    {
        pass_blanks();
        if (!text_.substr(at_).starts_with(token)) return false;
        at_ += token.size();
        return true;
    }
    void expect(std::string_view token)
    {
        if (!accepts(token)) fail(fmt::format("must have {} here", token));
    }

    std::string word()
    {
        pass_blanks();
        const std::size_t start = at_;
        while (at_ < text_.size() && is_word(text_[at_])) ++at_;
        if (at_ == start) fail("must have a name here");
        return std::string(text_.substr(start, at_ - start));
    }

    /// Text of strings that follow one another, as one.
    std::string strings()
    {
        std::string result;
        for (pass_blanks(); at_ < text_.size() && text_[at_] == '"'; pass_blanks()) {
            const std::size_t start = at_;
            pass_string();
            std::string_view inside = text_.substr(start + 1, at_ - start - 2);
            for (std::size_t i = 0; i < inside.size(); ++i) {
                if (inside[i] == '\\' && i + 1 < inside.size()) ++i;
                result += inside[i];
            }
        }
        return result;
    }

    /// The text up to the first of `ends` outside of brackets and strings, which stays.
    std::string expression(std::string_view ends)
    {
        pass_blanks();
        int depth = 0;
        std::string result;
        for (; at_ < text_.size(); ++at_) {
            const std::string_view rest = text_.substr(at_);
            if (rest.starts_with("//") || rest.starts_with("/*")) {
                pass_blanks();
                --at_;
                continue;
            }
            if (depth == 0 && (ends.find(rest.front()) != std::string_view::npos ||
                               rest.starts_with("[[") || rest.starts_with("]]")))
                break;
            if (rest.front() == '"') {
                const std::size_t quote = at_;
                pass_string();
                result += text_.substr(quote, at_ - quote);
                --at_;
                continue;
            }
            result += rest.front();
            if (std::string_view("([{").find(rest.front()) != std::string_view::npos) ++depth;
            if (std::string_view(")]}").find(rest.front()) != std::string_view::npos) --depth;
        }
        if (at_ == text_.size()) fail("ends inside a shader");
        return on_one_line(result);
    }

    /// To behind the word that begins a shader, outside of comments and strings; whether there is
    /// one.
    bool find_shader()
    {
        for (pass_blanks(); at_ < text_.size(); pass_blanks()) {
            if (text_[at_] == '"') {
                pass_string();
            } else if (is_word(text_[at_])) {
                if (begins_shader(word())) return true;
            } else {
                ++at_;
            }
        }
        return false;
    }

private:
    std::string_view text_, file_;
    std::size_t at_ = 0;

    void pass_blanks()
    {
        for (;;) {
            const std::string_view rest = text_.substr(at_);
            if (rest.empty()) return;
            if (std::isspace(static_cast<unsigned char>(rest.front())) != 0)
                ++at_;
            else if (rest.starts_with("//"))
                at_ = std::min(text_.size(), at_ + std::min(rest.find('\n'), rest.size()));
            else if (rest.starts_with("/*"))
                at_ += std::min(rest.size(), rest.find("*/", 2) + 2);
            else
                return;
        }
    }

    void pass_string()
    {
        const std::size_t start = at_++;
        while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
        if (at_ >= text_.size()) {
            at_ = start;
            fail("has a string without an end");
        }
        ++at_;
    }
};

Metadata read_metadata(Reader& reader)
{
    Metadata result;
    if (!reader.accepts("[[")) return result;
    do {
        const std::string type = reader.word();
        std::string name = reader.word();
        reader.expect("=");
        result[std::move(name)] = type == "string" ? reader.strings() : reader.expression(",");
    } while (reader.accepts(","));
    reader.expect("]]");
    return result;
}

ShaderParameter read_parameter(Reader& reader)
{
    ShaderParameter result;
    result.type = reader.word();
    result.line = reader.line();
    if (result.type == "output") {
        result.is_output = true;
        result.type = reader.word();
    }
    if (result.type == "closure") result.type += ' ' + reader.word();
    result.name = reader.word();
    if (reader.accepts("[")) {
        result.size = reader.expression("]");
        reader.expect("]");
    }
    reader.expect("=");
    result.value = reader.expression(",)");
    result.metadata = read_metadata(reader);
    return result;
}

std::string_view found(const Metadata& metadata, std::string_view name, std::string_view otherwise)
{
    const auto it = metadata.find(name);
    return it == metadata.end() ? otherwise : std::string_view(it->second);
}

/// Statements at the outermost level, each with its `;` or braces.
std::vector<std::string> statements(std::string_view body)
{
    std::vector<std::string> result;
    std::size_t start = 0;
    int depth = 0;
    for (std::size_t i = 0; i < body.size(); ++i) {
        const char c = body[i];
        if (c == '(' || c == '{') ++depth;
        if (c == ')' || c == '}') --depth;
        const bool ends = depth == 0 && c == ';';
        if (!ends) continue;
        result.push_back(on_one_line(body.substr(start, i + 1 - start)));
        start = i + 1;
    }
    return result;
}

/// `NAME` of `TYPE NAME = …;`, or nothing.
std::string declared(std::string_view statement)
{
    const std::size_t equals = statement.find(" = ");
    const std::size_t blank = statement.find(' ');
    if (equals == std::string_view::npos || blank >= equals) return "";
    const std::string_view name = statement.substr(blank + 1, equals - blank - 1);
    return std::ranges::all_of(name, is_word) ? std::string(name) : "";
}

std::string with_constants(std::string_view statement, const Given& given)
{
    std::string result;
    for (std::size_t i = 0; i < statement.size();) {
        if (!is_word(statement[i])) {
            result += statement[i++];
            continue;
        }
        std::size_t end = i;
        while (end < statement.size() && is_word(statement[end])) ++end;
        const std::string_view word = statement.substr(i, end - i);
        const bool is_member = i > 0 && statement[i - 1] == '.';
        const auto constant = given.constants.find(word);
        result += !is_member && constant != given.constants.end()
                      ? std::string_view(constant->second)
                      : word;
        i = end;
    }
    return result;
}

std::optional<double> number(std::string_view text)
{
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The operands of a call that begins at `open`, where none of them has brackets; else nothing.
std::vector<std::string_view> plain_operands(std::string_view text, std::size_t open)
{
    const std::size_t close = text.find_first_of("()", open + 1);
    if (close == std::string_view::npos || text[close] == '(') return {};
    std::vector<std::string_view> result;
    for (std::size_t from = open + 1; from <= close;) {
        std::size_t to = std::min(text.find(',', from), close);
        std::string_view operand = text.substr(from, to - from);
        while (operand.starts_with(' ')) operand.remove_prefix(1);
        result.push_back(operand);
        from = to + 1;
    }
    return result;
}

/// The operand that a call of numbers comes to; nothing where one is no number.
std::optional<std::string_view> chosen(std::string_view function,
                                       const std::vector<std::string_view>& operands)
{
    std::vector<double> values;
    for (const std::string_view operand : operands) {
        const auto value = number(operand);
        if (!value) return std::nullopt;
        values.push_back(*value);
    }
    if (function == "max" && values.size() == 2) return operands[values[0] >= values[1] ? 0 : 1];
    if (function == "clamp" && values.size() == 3)
        return operands[values[0] < values[1] ? 1 : values[0] > values[2] ? 2 : 0];
    return std::nullopt;
}

/// What `clamp` and `max` of numbers come to.
std::string folded(std::string text)
{
    for (const std::string_view function : {"clamp", "max"}) {
        for (std::size_t at = text.find(function); at != std::string::npos;
             at = text.find(function, at + 1)) {
            const std::size_t open = at + function.size();
            if (open >= text.size() || text[open] != '(' || (at > 0 && is_word(text[at - 1])))
                continue;
            const auto operands = plain_operands(text, open);
            if (const auto value = chosen(function, operands)) {
                const std::string result(*value);
                text.replace(at, text.find(')', open) + 1 - at, result);
            }
        }
    }
    return text;
}

constexpr std::size_t kColumns = 100;

/// What the commas outside of inner brackets part; each with its comma, the last with the rest.
std::vector<std::string> items(std::string_view text)
{
    std::vector<std::string> result(1);
    int depth = 0;
    for (const char c : text) {
        if (c == ' ' && result.back().empty()) continue;
        result.back() += c;
        if (c == '(' || c == '{') ++depth;
        if (c == ')' || c == '}') --depth;
        if (depth == 0 && c == ',') result.emplace_back();
    }
    return result;
}

/// The statement on lines that are not too long, broken at the operands of its first bracket.
std::string laid_out(const std::string& statement)
{
    const std::string whole = "    " + statement;
    const std::size_t open = whole.find_first_of("({");
    if (whole.size() <= kColumns || open == std::string::npos) return whole + '\n';
    const std::size_t column = whole.find_first_not_of(' ', open + 1);
    std::string result, line = whole.substr(0, column);
    for (const std::string& item : items(std::string_view(whole).substr(column))) {
        const bool fits = line.size() + 1 + item.size() <= kColumns;
        if (line.size() > column && !fits) {
            result += line + '\n';
            line = std::string(column, ' ');
        }
        line += (line.size() > column ? " " : "") + item;
    }
    return result + line + '\n';
}

}  // namespace

std::string_view ShaderParameter::told(std::string_view entry, std::string_view otherwise) const
{
    return found(metadata, entry, otherwise);
}

std::string_view ShaderSource::told(std::string_view entry, std::string_view otherwise) const
{
    return found(metadata, entry, otherwise);
}

bool is_shader_text(std::string_view text)
{
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        const std::size_t blank = line.find(' ');
        const bool begins = blank != std::string_view::npos && begins_shader(line.substr(0, blank));
        if (begins && blank + 1 < line.size() && is_word(line[blank + 1])) return true;
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
    return false;
}

ShaderSource parse_shader(std::string_view text, std::string_view file)
{
    const std::string osl = resolved(text);
    Reader reader(osl, file);
    if (!reader.find_shader()) reader.fail("must be a shader: shader NAME ( … ) { … }");
    ShaderSource result;
    result.file = file;
    result.text = text;
    result.line = reader.line();
    result.name = reader.word();
    result.metadata = read_metadata(reader);
    reader.expect("(");
    while (!reader.accepts(")")) {
        result.parameters.push_back(read_parameter(reader));
        if (!reader.accepts(",")) {
            reader.expect(")");
            break;
        }
    }
    reader.expect("{");
    const std::size_t start = reader.position();
    static_cast<void>(reader.expression("}"));
    result.body = reader.between(start, reader.position());
    return result;
}

ShaderSource shipped_shader(std::string_view name)
{
    const std::string file = fmt::format("/{}.osl", name);
    for (const std::string_view path : list_resources("shaders/"))
        if (path.ends_with(file)) return parse_shader(find_resource(path).value(), path);
    throw InputError(Diagnostic{"shaders" + file, 0, "", "there is no such shader"});
}

std::string specialised(const ShaderSource& shader, const Given& given)
{
    std::string result;
    for (const std::string& statement : statements(shader.body)) {
        const std::string name = declared(statement);
        if (given.constants.contains(name)) continue;
        std::string text = statement;
        if (const auto computed = given.variables.find(name); computed != given.variables.end())
            text = statement.substr(0, statement.find(" = ") + 3) + computed->second + ';';
        result += laid_out(folded(with_constants(text, given)));
    }
    return result;
}

}  // namespace nacre::oslgen
