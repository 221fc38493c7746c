// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "yaml_tree.h"

#include <fmt/format.h>
#include <yaml.h>

#include <algorithm>
#include <map>

#include "nacre/core/diagnostics.h"
#include "nacre/core/text_lines.h"

namespace nacre::spectral {

namespace {

std::string_view text_of(const yaml_char_t* text)
{
    return text ? std::string_view(reinterpret_cast<const char*>(text)) : std::string_view();
}

class Parser {
public:
    Parser(std::string_view text, const std::string& file) : text_(text), file_(file)
    {
        if (yaml_parser_initialize(&parser_) == 0) throw std::bad_alloc();
        yaml_parser_set_input_string(&parser_, reinterpret_cast<const unsigned char*>(text.data()),
                                     text.size());
        yaml_parser_set_encoding(&parser_, YAML_UTF8_ENCODING);
    }
    Parser(const Parser&) = delete;
    Parser& operator=(const Parser&) = delete;
    ~Parser()
    {
        yaml_event_delete(&event_);
        yaml_parser_delete(&parser_);
    }

    /// Valid until the next call.
    const yaml_event_t& next()
    {
        yaml_event_delete(&event_);
        if (yaml_parser_parse(&parser_, &event_) == 0)
            throw InputError(
                {file_, problem_line(), {}, fmt::format("is not valid YAML: {}", parser_.problem)});
        return event_;
    }

private:
    /// Of characters that YAML does not know only the offset is stated; what ends too early is
    /// stated on a line after the last.
    int problem_line() const
    {
        const auto lines_before = [this](std::size_t offset) {
            return static_cast<std::size_t>(std::ranges::count(text_.substr(0, offset), '\n'));
        };
        const std::size_t line =
            parser_.error == YAML_READER_ERROR
                ? lines_before(parser_.problem_offset)
                : std::min(parser_.problem_mark.line, lines_before(text_.find_last_not_of('\n')));
        return static_cast<int>(line) + 1;
    }

    std::string_view text_;
    const std::string& file_;
    yaml_parser_t parser_{};
    yaml_event_t event_{};
};

class Builder {
public:
    Builder(std::deque<YamlNode>& nodes, const std::string& file) : nodes_(nodes), file_(file) {}

    void read(Parser& parser)
    {
        for (;;) {
            const yaml_event_t& event = parser.next();
            const int line = static_cast<int>(event.start_mark.line) + 1;
            switch (event.type) {
                case YAML_SCALAR_EVENT:
                    add_text(event, line);
                    break;
                case YAML_ALIAS_EVENT:
                    put(known(text_of(event.data.alias.anchor), line));
                    break;
                case YAML_SEQUENCE_START_EVENT:
                    open(YamlNode::Kind::list, event.data.sequence_start.anchor, line);
                    break;
                case YAML_MAPPING_START_EVENT:
                    open(YamlNode::Kind::map, event.data.mapping_start.anchor, line);
                    break;
                case YAML_SEQUENCE_END_EVENT:
                case YAML_MAPPING_END_EVENT:
                    open_.pop_back();
                    break;
                case YAML_DOCUMENT_END_EVENT:
                    return;
                case YAML_STREAM_END_EVENT:
                    nodes_.emplace_back();
                    return;
                default:
                    break;
            }
        }
    }

private:
    struct Open {
        YamlNode* node;
        const YamlNode* key;  ///< of a map, whose value is yet to come
    };

    YamlNode& add(YamlNode::Kind kind, const yaml_char_t* anchor, int line)
    {
        YamlNode& node = nodes_.emplace_back();
        node.kind = kind;
        node.line = line;
        if (anchor) anchors_[std::string(text_of(anchor))] = &node;
        return node;
    }

    void put(const YamlNode& node)
    {
        if (open_.empty()) return;
        auto& [parent, key] = open_.back();
        if (parent->is_list())
            parent->items.push_back(&node);
        else if (key)
            parent->entries.emplace_back(std::exchange(key, nullptr), &node);
        else
            key = &node;
    }

    void open(YamlNode::Kind kind, const yaml_char_t* anchor, int line)
    {
        if (open_.size() == YamlTree::kMostLevels)
            throw InputError(
                {file_,
                 line,
                 {},
                 fmt::format("must not be nested deeper than {} levels", YamlTree::kMostLevels)});
        YamlNode& node = add(kind, anchor, line);
        put(node);
        open_.push_back({&node, nullptr});
    }

    void add_text(const yaml_event_t& event, int line)
    {
        const auto& scalar = event.data.scalar;
        const std::string_view text(reinterpret_cast<const char*>(scalar.value), scalar.length);
        const bool nothing = scalar.plain_implicit != 0 &&
                             scalar.style == YAML_PLAIN_SCALAR_STYLE &&
                             (text.empty() || text == "~" || same_letters(text, "null"));
        YamlNode& node =
            add(nothing ? YamlNode::Kind::null : YamlNode::Kind::text, scalar.anchor, line);
        node.text = text;
        put(node);
    }

    const YamlNode& known(std::string_view anchor, int line) const
    {
        const auto found = anchors_.find(anchor);
        if (found == anchors_.end())
            throw InputError(
                {file_,
                 line,
                 {},
                 fmt::format("is not valid YAML: nothing is called '{}'", excerpt(anchor))});
        return *found->second;
    }

    std::deque<YamlNode>& nodes_;
    const std::string& file_;
    std::vector<Open> open_;
    std::map<std::string, const YamlNode*, std::less<>> anchors_;
};

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const noexcept
{
    const auto found = std::ranges::find_if(entries, [key](const auto& entry) {
        return entry.first->is_text() && entry.first->text == key;
    });
    return found == entries.end() ? nullptr : found->second;
}

YamlTree::YamlTree(std::string_view text, const std::string& file)
{
    std::string input = utf8_of_utf16(text);
    if (input.empty()) input = readable_lines(text);
    std::string_view rest = input;
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (rest.starts_with(kByteOrderMark)) rest.remove_prefix(kByteOrderMark.size());
    Parser parser(rest, file);
    Builder(nodes_, file).read(parser);
}

}  // namespace nacre::spectral
