// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "eval/questions.h"

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"
#include "nacre/optics/multilayer.h"

namespace nacre::tool {

using optics::Complex;
using spectral::Illuminant;
using spectral::ObserverId;

namespace {

std::optional<Complex> read_index(const json& value, const std::string& field, bool is_ambient,
                                  DiagnosticList& problems)
{
    // A plain number is a clear medium.
    if (value.is_number())
        return read_index(json::array({value, 0.0}), field, is_ambient, problems);
    if (!value.is_array() || value.size() != 2) {
        problems.add({"", 0, field, fmt::format("must be [n, k] (got {})", quoted(value))});
        return std::nullopt;
    }
    const auto n = read_number(value[0], field + "[0]", kPositive, problems);
    const auto k = read_number(value[1], field + "[1]", kNotNegative, problems);
    if (!n || !k) return std::nullopt;
    if (is_ambient && *k > 0.0) {
        problems.add({"", 0, field + "[1]",
                      fmt::format("must be 0 in the ambient: light that is absorbed on its way has "
                                  "no reflectance (got {})",
                                  *k)});
        return std::nullopt;
    }
    return Complex{*n, *k};
}

bool is_word(const json& value, std::string_view word)
{
    const auto* text = value.get_ptr<const std::string*>();
    return text && *text == word;
}

}  // namespace

std::vector<Complex> read_indices(ObjectReader& reader, DiagnosticList& problems)
{
    const json* list = reader.required("n");
    if (!list) return {};
    if (!list->is_array() || list->size() < 2 || list->size() > optics::kMaxLayers + 2) {
        reader.problem(
            "n", fmt::format("must list 2 … {} indices [n, k], ambient and substrate and "
                             "at most {} layers (got {})",
                             optics::kMaxLayers + 2, optics::kMaxLayers,
                             list->is_array() ? fmt::format("{}", list->size()) : quoted(*list)));
        return {};
    }
    std::vector<Complex> indices;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const auto index = read_index((*list)[i], fmt::format("n[{}]", i), i == 0, problems);
        if (index) indices.push_back(*index);
    }
    return indices.size() == list->size() ? indices : std::vector<Complex>{};
}

std::optional<double> read_angle(ObjectReader& reader)
{
    return reader.number_or("angle_deg", {0.0, 90.0, false, true}, 0.0);
}

std::optional<std::string> read_polarisation(ObjectReader& reader)
{
    return reader.choice_or("pol", {"s", "p", "u"}, "u");
}

std::vector<bool> read_coherence(ObjectReader& reader, std::size_t layers)
{
    std::vector<bool> coherent(layers, true);
    const json* list = reader.optional("coherence");
    if (!list) return coherent;
    // The tmm package lists the two outer media too, which are always "i" there.
    const bool with_ends = list->is_array() && list->size() == layers + 2;
    const bool fits = with_ends ? is_word(list->front(), "i") && is_word(list->back(), "i")
                                : list->is_array() && list->size() == layers;
    if (!fits) {
        reader.problem("coherence",
                       fmt::format("must have one of c, i for each of the {} layers, or "
                                   "for each medium with i at both ends (got {})",
                                   layers, quoted(*list)));
        return coherent;
    }
    for (std::size_t i = 0; i < layers; ++i) {
        const std::size_t at = i + (with_ends ? 1 : 0);
        const json& value = (*list)[at];
        coherent[i] = is_word(value, "c");
        if (!coherent[i] && !is_word(value, "i"))
            reader.problem(fmt::format("coherence[{}]", at),
                           fmt::format("must be c or i (got {})", quoted(value)));
    }
    return coherent;
}

ObserverId read_observer(ObjectReader& reader)
{
    if (!reader.optional("observer")) return ObserverId::cie1931;
    const auto name = reader.choice("observer", {"cie1931", "cie1964"});
    return name ? spectral::observer_from_name(*name) : ObserverId::cie1931;
}

std::optional<Illuminant> read_illuminant(ObjectReader& reader)
{
    const auto text = reader.text("illuminant");
    if (!text) return std::nullopt;
    try {
        return spectral::named_illuminant(*text);
    } catch (const InputError& error) {
        for (const Diagnostic& problem : error.diagnostics())
            reader.problem("illuminant", problem.message);
        return std::nullopt;
    }
}

}  // namespace nacre::tool
