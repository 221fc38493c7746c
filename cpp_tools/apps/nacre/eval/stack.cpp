// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "eval/questions.h"
#include "eval/records.h"
#include "nacre/optics/multilayer.h"

namespace nacre::tool {
namespace {

using optics::Complex;

constexpr const char* kStackHelp = R"(
record  {"n": [[re, im], …], "d_nm": […], "angle_deg": 30, "wavelength_nm": 550,
         "pol": "s|p|u", "coherence": ["i", "c", …], "spread_nm": […], "bandwidth_nm": 0,
         "layers": false}
  n              indices from the ambient to the substrate, [n, k] or n alone: n > 0, k ≥ 0, and
                 k = 0 in the ambient
  d_nm           thickness of the 0 … 64 layers between, ≥ 0
  angle_deg      angle of incidence in the ambient, in [0, 90) (default 0)
  pol            s, p, or u for the mean of both (default u)
  coherence      optional: "c" or "i" a layer (default c); or, as in the tmm package, a medium,
                 with "i" at both ends
  spread_nm      optional: standard deviation of each thickness within what is looked at
  bandwidth_nm   optional: Gaussian band of the light, full width at half maximum
  layers         optional: true adds what each layer absorbs, without spread and bandwidth only
result  {"R": …, "T": …, "A": …, "r": [re, im], "t": [re, im], "A_layers": […]}; r and t are null
        for u and where a layer is incoherent or averaged over

Bare glass reflects 4 %:
  echo '{"n": [1, 1.5], "d_nm": [], "wavelength_nm": 550}' | nacre eval stack
Silver between two glasses, and how much of the light it keeps:
  echo '{"n": [1, 1.52, [0.05, 3.3], 1.52], "d_nm": [1e6, 20], "coherence": ["i", "c"],
         "angle_deg": 45, "wavelength_nm": 550, "pol": "u", "layers": true}' | nacre eval stack
A file with an array of records, in the same order out:
  nacre eval stack stacks.json -o results.json)";

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

}  // namespace

void add_eval_stack(CLI::App& eval, Session& session)
{
    add_record_command(eval, session, "stack",
                       "R, T, A, r, t of a multilayer at one angle and wavelength", kStackHelp,
                       evaluate_stack);
}

}  // namespace nacre::tool
