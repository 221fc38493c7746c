// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/oslgen/socket.h"

#include <fmt/format.h>

#include <utility>

namespace nacre::oslgen {

std::string parameter_name(const Socket& socket)
{
    return socket.type == "normal" ? "surface_normal" : socket.name;
}

Socket slider_socket(const material::FieldInfo& info, const material::Quantity& quantity)
{
    return {.name = std::string(info.key),
            .label = info.unit == "1" ? std::string(info.label)
                                      : fmt::format("{} ({})", info.label, info.unit),
            .type = "float",
            .unit = std::string(info.unit),
            .description = std::string(info.help),
            .value = quantity.value,
            .min = quantity.min.value_or(0.5 * quantity.value),
            .max = quantity.max.value_or(2.0 * quantity.value)};
}

Socket slider_socket(const material::SliderInfo& info)
{
    return {.name = std::string(info.name),
            .label = std::string(info.label),
            .type = "float",
            .unit = "1",
            .description = std::string(info.help),
            .value = info.value,
            .min = 0.0,
            .max = info.max};
}

Socket colour_socket(std::string name, std::string label, std::string description,
                     const std::array<double, 3>& colour)
{
    return {.name = std::move(name),
            .label = std::move(label),
            .type = "color",
            .unit = "1",
            .description = std::move(description),
            .colour = colour};
}

Socket normal_socket()
{
    return {.name = "normal",
            .label = "Normal",
            .type = "normal",
            .unit = "1",
            .description = "For bump and normal maps"};
}

Socket roughness_socket(const material::TemplateHead& head)
{
    Socket socket = slider_socket(material::kRoughness);
    socket.value = head.roughness;
    return socket;
}

void apply_parameters(const material::TemplateHead& head, std::span<Socket> sockets)
{
    for (Socket& socket : sockets) {
        const material::ParameterSpec* parameter = head.parameter(socket.name);
        if (!parameter) continue;
        socket.label = parameter->label;
        if (!parameter->description.empty()) socket.description = parameter->description;
        socket.value = parameter->value;
        socket.min = parameter->min;
        socket.max = parameter->max;
    }
}

}  // namespace nacre::oslgen
