// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <variant>

#include "nacre/oslgen/material_program.h"

namespace nacre::oslgen {
namespace {

using material::GlassSpec;
using material::GratingSpec;
using material::MaterialTemplate;
using material::Quantity;
using material::StackSpec;

Socket slider(std::string name, std::string label, std::string unit, std::string description,
              const Quantity& quantity)
{
    return {.name = std::move(name),
            .label = std::move(label),
            .type = "float",
            .unit = std::move(unit),
            .description = std::move(description),
            .value = quantity.value,
            .min = quantity.min.value_or(0.5 * quantity.value),
            .max = quantity.max.value_or(2.0 * quantity.value)};
}

Socket share(std::string name, std::string label, std::string description, double value)
{
    return {.name = std::move(name),
            .label = std::move(label),
            .type = "float",
            .unit = "1",
            .description = std::move(description),
            .value = value};
}

void add_film(const StackSpec& stack, const MaterialTemplate& source, std::vector<Socket>& result)
{
    if (const auto layer = stack.varying_layer())
        result.push_back(slider("thickness_nm", "Film Thickness (nm)", "nm",
                                "Thickness of the film, held to the range of the table",
                                stack.layers[*layer].thickness_nm));
    if (stack.scale)
        result.push_back(slider("thickness_scale", "Film Thickness (×)", "1",
                                "Factor on the thickness of every layer, held to the range of the "
                                "table; moves all colours",
                                *stack.scale));
    if (source.parameter("coverage"))
        result.push_back(share("coverage", "Coverage", "0: bare substrate, 1: film", 1.0));
    if (source.surface.diffuse_base)
        result.push_back({.name = "base_colour",
                          .label = "Base Colour",
                          .type = "color",
                          .unit = "1",
                          .description = "Colour of the matt base under the film and its substrate",
                          .colour = *source.surface.diffuse_base});
}

void add_brush(double anisotropy, std::vector<Socket>& result)
{
    Socket socket =
        share("anisotropy", "Anisotropy",
              "0: no direction; above 0 highlights are drawn out across the tangent", anisotropy);
    socket.min = -0.9;
    socket.max = 0.9;
    result.push_back(std::move(socket));
    result.push_back(share("rotation", "Rotation", "Turns the tangent; 1: once around", 0.0));
}

void add_grating(const GratingSpec& grating, const GratingColours& colours,
                 std::vector<Socket>& result)
{
    result.push_back(slider("pitch_nm", "Pitch (nm)", "nm", "Distance of neighbouring tracks",
                            grating.pitch_nm));
    result.push_back({.name = "tint",
                      .label = "Tint",
                      .type = "color",
                      .unit = "1",
                      .description = "Colour of the reflecting metal",
                      .colour = colours.tint});
    result.push_back(share("strength", "Strength",
                           "Share of the diffracted light; the rest stays in the mirror image",
                           1.0));
}

void add_glass(std::vector<Socket>& result)
{
    Socket dispersion =
        share("dispersion", "Dispersion",
              "0: the index of the d line for every wavelength, 1: as measured", 1.0);
    dispersion.max = 5.0;
    result.push_back(dispersion);
}

/// What the template says about a slider wins.
void apply_parameters(const MaterialTemplate& source, std::vector<Socket>& result)
{
    for (Socket& socket : result) {
        const material::ParameterSpec* parameter = source.parameter(socket.name);
        if (!parameter) continue;
        socket.label = parameter->label;
        if (!parameter->description.empty()) socket.description = parameter->description;
        socket.value = parameter->value;
        socket.min = parameter->min;
        socket.max = parameter->max;
    }
}

}  // namespace

std::vector<Socket> sockets(const Context& context)
{
    const MaterialTemplate& source = *context.source;
    std::vector<Socket> result;
    if (const auto* stack = std::get_if<StackSpec>(&source.kind))
        add_film(*stack, source, result);
    else if (const auto* grating = std::get_if<GratingSpec>(&source.kind))
        add_grating(*grating, context.grating.value(), result);
    else
        add_glass(result);
    result.push_back(share("roughness", "Roughness", "0: mirror; GGX alpha is the square",
                           source.surface.roughness));
    if (source.surface.anisotropy) add_brush(*source.surface.anisotropy, result);
    if (context.schlick)
        result.push_back({.name = "exact_rough",
                          .label = "Exact Rough (OSL)",
                          .type = "int",
                          .unit = "1",
                          .description = "1: the film's colour at each microfacet, in twice the "
                                         "time; 0: their mean. OSL only, from roughness 0.1 on"});
    apply_parameters(source, result);
    result.push_back({.name = "normal",
                      .label = "Normal",
                      .type = "normal",
                      .unit = "1",
                      .description = "For bump and normal maps"});
    if (source.surface.anisotropy)
        result.push_back(
            {.name = "tangent",
             .label = "Tangent",
             .type = "tangent",
             .unit = "1",
             .description = "Direction of the brush; unlinked: around the object's Z"});
    return result;
}

}  // namespace nacre::oslgen
