// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "film/technique.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "nacre/core/diagnostics.h"
#include "nacre/kinds/media_reader.h"
#include "nacre/optics/film_model_stack.h"

namespace nacre::kinds::film {
namespace {

using optics::FilmModel, optics::StackProblem;

/// Those of the forms that take a base which absorbs.
constexpr std::array kAnyBase{FilmModel::path_difference, FilmModel::opaque_base,
                              FilmModel::etalon};

void drop_traces(lut::IndexOnGrid& index)
{
    if (std::ranges::all_of(index, [](const auto& n) { return n.imag() <= kTraceOfK; }))
        for (auto& n : index) n = n.real();
}

void make_clear(FilmModel model, lut::SampledStack& stack)
{
    if (model == FilmModel::recursion) return;
    for (lut::SampledLayer& layer : stack.layers) drop_traces(layer.n);
    if (std::ranges::find(kAnyBase, model) == kAnyBase.end()) drop_traces(stack.substrate);
}

optics::FilmStack at_wavelength(const lut::SampledStack& stack, std::size_t i)
{
    optics::FilmStack result{stack.ambient[i], {}, stack.substrate[i]};
    for (const lut::SampledLayer& layer : stack.layers)
        result.layers.push_back(
            {.n = layer.n[i], .thickness_nm = layer.thickness_nm, .coherent = layer.coherent});
    return result;
}

/// Where the template says what is wrong.
Diagnostic located(const StackProblem& problem, const Film& film, const std::string& file)
{
    const auto at = static_cast<std::size_t>(problem.index);
    if (std::string_view(problem.field) != "n") {
        const bool there = at < film.layers.size();
        return {file, there ? film.layers[at].medium.line : film.technique_line, "layer", {}};
    }
    const material::MediumSpec& medium = at == 0                    ? film.ambient
                                         : at <= film.layers.size() ? film.layers[at - 1].medium
                                                                    : film.substrate;
    return {file, medium.line, medium.field, {}};
}

/// Each problem at the first wavelength that has it.
void report(FilmModel model, const Film& film, const lut::SampledStack& stack,
            const std::string& file)
{
    DiagnosticList problems;
    std::set<std::pair<std::string_view, int>> known;
    for (std::size_t i = 0; i < spectral::kWavelengths; ++i)
        for (const StackProblem& problem :
             optics::film_model_problems(model, at_wavelength(stack, i))) {
            if (!known.emplace(problem.message, problem.index).second) continue;
            Diagnostic diagnostic = located(problem, film, file);
            diagnostic.message = fmt::format(
                "{} with technique \"{}\" (at {} nm); choose \"{}\", which takes any stack",
                problem.message, optics::film_model_name(model), spectral::wavelength_nm(i),
                technique_name(Technique::multilayer));
            problems.add(std::move(diagnostic));
        }
    problems.throw_if_any();
}

}  // namespace

std::optional<lut::Technique> technique(const Film& film, lut::SampledStack& stack,
                                        const std::string& file)
{
    if (film.technique == Technique::multilayer) return std::nullopt;
    const FilmModel model = optics::film_model_from_name(technique_name(film.technique));
    make_clear(model, stack);
    report(model, film, stack, file);
    return lut::Technique{.model = model};
}

}  // namespace nacre::kinds::film
