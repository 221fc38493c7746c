// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "eval.h"
#include "nacre/optics/multilayer.h"

namespace nacre::tool {
namespace {

using optics::Complex;

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

namespace {

bool is_word(const json& value, std::string_view word)
{
    const auto* text = value.get_ptr<const std::string*>();
    return text && *text == word;
}

}  // namespace

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

namespace {

/// One number ≥ 0 a layer.
std::vector<double> read_spread(ObjectReader& reader, const std::vector<bool>& coherent)
{
    std::vector<double> none(coherent.size(), 0.0);
    if (!reader.optional("spread_nm")) return none;
    const auto spread = reader.numbers("spread_nm", kNotNegative);
    if (!spread) return none;
    if (spread->size() != coherent.size()) {
        reader.problem("spread_nm", fmt::format("must have one value for each of the {} layers "
                                                "(got {})",
                                                coherent.size(), spread->size()));
        return none;
    }
    for (std::size_t j = 0; j < coherent.size(); ++j)
        if ((*spread)[j] > 0.0 && !coherent[j])
            reader.problem(
                fmt::format("spread_nm[{}]", j),
                fmt::format("must be 0 in a layer that is incoherent (got {})", (*spread)[j]));
    return *spread;
}

bool read_wants_layers(ObjectReader& reader)
{
    const json* value = reader.optional("layers");
    if (!value) return false;
    if (!value->is_boolean())
        reader.problem("layers", fmt::format("must be true or false (got {})", quoted(*value)));
    return value->is_boolean() && value->get<bool>();
}

struct StackQuestion {
    optics::FilmStack stack;
    double cos_ambient = 1.0, wavelength_nm = 0.0;
    std::string polarisation;
    bool wants_layers = false;
};

StackQuestion read_stack(const json& record)
{
    DiagnosticList problems;
    ObjectReader reader(record, "", problems);
    const auto n = read_indices(reader, problems);
    const auto thickness = reader.numbers("d_nm", kNotNegative);
    const auto angle = read_angle(reader);
    const auto wavelength = reader.number("wavelength_nm", kPositive);
    const auto polarisation = read_polarisation(reader);
    if (!n.empty() && thickness && thickness->size() + 2 != n.size())
        reader.problem("d_nm", fmt::format("must have one thickness for each of the {} layers of n "
                                           "(got {})",
                                           n.size() - 2, thickness->size()));
    const auto coherent = read_coherence(reader, n.empty() ? 0 : n.size() - 2);
    const auto spread = read_spread(reader, coherent);
    const auto bandwidth = reader.number_or("bandwidth_nm", kNotNegative, 0.0);
    const bool wants_layers = read_wants_layers(reader);
    const bool averages =
        bandwidth.value_or(0.0) > 0.0 ||
        std::any_of(spread.begin(), spread.end(), [](double s) { return s > 0.0; });
    if (wants_layers && averages)
        reader.problem("layers",
                       "must be false where layers have a spread or light a bandwidth: "
                       "the absorption by layer is not known there");
    reader.refuse_unknown_keys();
    problems.throw_if_any();

    StackQuestion question{{n.front(), {}, n.back()},
                           std::cos(*angle * std::numbers::pi / 180.0),
                           *wavelength,
                           *polarisation,
                           wants_layers};
    for (std::size_t i = 0; i < thickness->size(); ++i)
        question.stack.layers.push_back({n[i + 1], (*thickness)[i], coherent[i], spread[i]});
    question.stack = seen_in_band(std::move(question.stack), *bandwidth, *wavelength);
    return question;
}

ordered_json pair(const Complex& value)
{
    return {value.real(), value.imag()};
}

std::vector<double> absorption_by_layer(const StackQuestion& question)
{
    const auto of = [&question](optics::Polarisation polarisation) {
        return layer_absorption(question.stack, question.cos_ambient, question.wavelength_nm,
                                polarisation);
    };
    if (question.polarisation == "s") return of(optics::Polarisation::s);
    std::vector<double> result = of(optics::Polarisation::p);
    if (question.polarisation == "u")
        std::ranges::transform(result, of(optics::Polarisation::s), result.begin(),
                               [](double p, double s) { return 0.5 * (p + s); });
    return result;
}

}  // namespace

ordered_json evaluate_stack(const json& record)
{
    const StackQuestion question = read_stack(record);
    const auto& [stack, cos_ambient, wavelength_nm, polarisation, wants_layers] = question;
    const auto which = polarisation == "p" ? optics::Polarisation::p : optics::Polarisation::s;
    const optics::PowerRatios power =
        polarisation == "u" ? optics::stack_power_unpolarised(stack, cos_ambient, wavelength_nm)
                            : optics::stack_power(stack, cos_ambient, wavelength_nm, which);
    ordered_json result = {
        {"R", power.R}, {"T", power.T}, {"A", power.A}, {"r", nullptr}, {"t", nullptr}};
    if (has_amplitudes(stack) && polarisation != "u") {
        const auto [r, t] = optics::stack_amplitudes(stack, cos_ambient, wavelength_nm, which);
        result["r"] = pair(r);
        result["t"] = pair(t);
    }
    if (wants_layers) result["A_layers"] = absorption_by_layer(question);
    return result;
}

}  // namespace nacre::tool
