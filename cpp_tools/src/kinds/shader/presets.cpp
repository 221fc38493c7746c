// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shader/presets.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

#include "nacre/core/text_lines.h"

namespace nacre::kinds {
namespace {

using Json = nlohmann::json;
using oslgen::Socket;

/// Null where the text is no value of the socket.
Json value_of(const Socket& socket, std::string_view text)
{
    const auto value = literal_number(text);
    if (!value || *value < socket.min || *value > socket.max) return nullptr;
    if (socket.type == "float") return *value;
    return *value == std::floor(*value) ? Json(static_cast<int>(*value)) : Json(nullptr);
}

bool is_number(const Socket& socket)
{
    return socket.type == "float" || socket.type == "int";
}

std::string allowed(const Socket& socket)
{
    return fmt::format("{} in [{}, {}]", socket.type == "int" ? "a whole number" : "a number",
                       socket.min, socket.max);
}

}  // namespace

std::optional<double> literal_number(std::string_view text)
{
    text = trimmed(text);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string next_item(std::string_view& rest, char separator)
{
    const std::size_t end = std::min(rest.find(separator), rest.size());
    std::string result(trimmed(rest.substr(0, end)));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    return result;
}

nlohmann::json read_presets(const oslgen::ShaderSource& shader, std::span<const Socket> sockets,
                            DiagnosticList& problems)
{
    Json result = Json::array();
    for (std::string_view rest = trimmed(shader.told("presets")); !rest.empty();) {
        const std::string preset = next_item(rest, ';');
        std::string_view values = preset;
        const std::string name = next_item(values, ':');
        const auto report = [&](const std::string& message) {
            problems.add(
                {shader.file, shader.line, "presets", fmt::format("\"{}\": {}", name, message)});
        };
        if (name.empty() || trimmed(values).empty()) report("must be NAME: SOCKET = VALUE, …; …");
        Json chosen = Json::object();
        while (!trimmed(values).empty()) {
            const std::string assignment = next_item(values, ',');
            std::string_view value = assignment;
            const std::string key = next_item(value, '=');
            const auto socket = std::ranges::find(sockets, key, &Socket::name);
            if (socket == sockets.end() || !is_number(*socket)) {
                report(fmt::format("must be of inputs that are numbers (got {})", key));
                continue;
            }
            Json read = value_of(*socket, trimmed(value));
            if (read.is_null())
                report(
                    fmt::format("{} must be {} (got {})", key, allowed(*socket), trimmed(value)));
            chosen[key] = std::move(read);
        }
        result.push_back({{"name", name}, {"values", std::move(chosen)}});
    }
    return result;
}

}  // namespace nacre::kinds
