// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shader/node_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace nacre::kinds {
namespace {

using Json = nlohmann::json;

constexpr std::string_view kEnd = "*/";

std::string_view name_of(NodeForm form)
{
    return form == NodeForm::nodes ? "nodes" : "bands";
}

std::string beginning(NodeForm form)
{
    return fmt::format("/* {}", name_of(form));
}

/// Where the comment starts and how long it is, its line's end included.
struct Place {
    std::size_t at, size;
};

std::optional<Place> find_comment(NodeForm form, std::string_view text)
{
    const std::size_t at = text.find(beginning(form));
    if (at == std::string_view::npos) return std::nullopt;
    std::size_t end = std::min(text.find(kEnd, at), text.size());
    end = std::min(end + kEnd.size(), text.size());
    if (end < text.size() && text[end] == '\n') ++end;
    return Place{at, end - at};
}

int line_of(std::string_view text, std::size_t at)
{
    return 1 + static_cast<int>(std::ranges::count(text.substr(0, at), '\n'));
}

/// `node` of `node.socket`; empty where it is none.
std::string node_of(const std::string& end)
{
    return end.substr(0, end.find('.') == std::string::npos ? 0 : end.find('.'));
}

/// What is wrong with a graph; each problem names nodes and sockets, for JSON's lines are not
/// known.
class Check {
public:
    Check(std::span<const oslgen::Socket> sockets, std::span<const oslgen::Closure> closures)
    {
        for (const oslgen::Socket& socket : sockets) sources_.insert("input." + socket.name);
        for (const oslgen::Closure& closure : closures) open_.insert("output." + closure.output);
    }

    std::vector<std::string> of(const Json& graph)
    {
        if (!graph.is_object() || !graph.contains("nodes") || !graph.contains("links") ||
            !graph["nodes"].is_array() || !graph["links"].is_array())
            return {"must be {\"nodes\": [ … ], \"links\": [ … ]}"};
        for (const Json& node : graph["nodes"]) check_node(node);
        for (const Json& link : graph["links"]) check_link(link);
        for (const std::string& output : open_)
            problems_.push_back(fmt::format("must have a link to {}", output));
        return std::move(problems_);
    }

private:
    std::set<std::string> nodes_, sources_, open_;
    std::vector<std::string> problems_;

    void check_node(const Json& node)
    {
        const bool is_node = node.is_object() && node.contains("id") && node["id"].is_string() &&
                             node.contains("type") && node["type"].is_string();
        if (!is_node)
            problems_.push_back(fmt::format(
                "every node must be an object with an id and a type (got {})", node.dump()));
        else if (!nodes_.insert(node["id"].get<std::string>()).second)
            problems_.push_back(fmt::format("two nodes have the id {}", node["id"].dump()));
    }

    void check_link(const Json& link)
    {
        if (!link.is_array() || link.size() != 2 || !link[0].is_string() || !link[1].is_string()) {
            problems_.push_back(
                fmt::format(R"(every link must be a pair, ["node.socket", "node.socket"] (got {}))",
                            link.dump()));
            return;
        }
        const auto from = link[0].get<std::string>(), to = link[1].get<std::string>();
        if (!nodes_.contains(node_of(from)) && !sources_.contains(from))
            problems_.push_back(
                fmt::format("a link must come from a node or from an input: {} (got \"{}\")",
                            fmt::join(sources_, ", "), from));
        if (!nodes_.contains(node_of(to)) && open_.erase(to) == 0)
            problems_.push_back(
                fmt::format("a link must lead to a node, or once to an output (got \"{}\")", to));
    }
};

}  // namespace

std::optional<nlohmann::json> node_form(NodeForm form, const oslgen::ShaderSource& shader,
                                        std::span<const oslgen::Socket> sockets,
                                        std::span<const oslgen::Closure> closures,
                                        DiagnosticList& problems)
{
    const std::string_view text = shader.text;
    const auto comment = find_comment(form, text);
    if (!comment) return std::nullopt;
    const std::size_t start = comment->at + beginning(form).size();
    const std::string_view inside = text.substr(start, text.find(kEnd, start) - start);
    const auto report = [&](int line, std::string message) {
        problems.add({shader.file, line, std::string(name_of(form)), std::move(message)});
    };
    try {
        Json graph = Json::parse(inside);
        for (std::string& problem : Check(sockets, closures).of(graph))
            report(line_of(text, comment->at), std::move(problem));
        return graph;
    } catch (const Json::parse_error& error) {
        const std::size_t before = error.byte == 0 ? 0 : error.byte - 1;
        report(line_of(text, start + before), "must be the graph of a node group, as JSON");
        return std::nullopt;
    }
}

std::string without_node_forms(std::string_view text)
{
    std::string result(text);
    for (const NodeForm form : {NodeForm::nodes, NodeForm::bands})
        if (const auto comment = find_comment(form, result))
            result.erase(comment->at, comment->size);
    return result;
}

}  // namespace nacre::kinds
