// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "eval/questions.h"
#include "eval/records.h"
#include "nacre/optics/film_models.h"
#include "nacre/optics/multilayer.h"

namespace nacre::tool {
namespace {

using optics::Complex;
using optics::Incidence;
using optics::Polarisation;
using optics::SingleFilm;

constexpr const char* kFilmHelp = R"(
record  {"model": "airy", "n": [1, 1.33, 1], "d_nm": [400], "angle_deg": 30,
         "wavelength_nm": 550, "pol": "s|p|u"}
  model          airy             clear film on a clear base (Durikovic and Kimura); exact
                 series           reflection at the top and two round trips, cut there
                 opaque_base      clear film on a base that may absorb (Sun and Wang); exact
                 free_film        the same medium on both sides, such as a soap bubble; exact
                 etalon           Airy's function; "mirror_reflectance": R instead of Fresnel's
                 recursion        any absorbing layers, from the base up (Hirayama); exact
                 path_difference  bands without physics; "view_angle_deg" instead of "pol"
                 uv               interface alone by u + iv = cosθ₂; "n" of two media, "d_nm": []
  the rest       as for `nacre eval stack`; film and ambient are clear, and no form but recursion
                 and uv has total reflection
result  {"R": …, "exact": …, "error": …}: the form, the multilayer, and their difference; null where
        the mirrors are given. path_difference: {"bands": …} in [0, 1). uv: {"R": …,
        "r_s": [re, im], "r_p": [re, im], "cos": [u, v]}

How far the cut series is off on a high index:
  echo '{"model": "series", "n": [1, 2.4, 3.5], "d_nm": [115], "angle_deg": 0,
         "wavelength_nm": 550, "pol": "u"}' | nacre eval film)";

struct FilmQuestion {
    std::string model, polarisation;
    std::vector<Complex> n;
    SingleFilm film;          ///< where the model has a film
    optics::FilmStack stack;  ///< of all media
    double cos_ambient, cos_view, wavelength_nm;
    std::optional<double> mirror_reflectance;
};

double cosine(double angle_deg)
{
    return std::cos(angle_deg * std::numbers::pi / 180.0);
}

/// The model with any number of layers.
void check_stack(ObjectReader& reader, const std::vector<Complex>& n,
                 const std::vector<double>& d_nm)
{
    if (n.size() < 2)
        reader.problem(
            "n", fmt::format("must list ambient and base at least (got {} values)", n.size()));
    else if (d_nm.size() + 2 != n.size())
        reader.problem("d_nm", fmt::format("must have {} values, one for each layer of n (got {})",
                                           n.size() - 2, d_nm.size()));
}

/// The layers of the model: none for an interface, else one.
void check_layers(ObjectReader& reader, const std::vector<Complex>& n,
                  const std::vector<double>& d_nm, bool is_interface)
{
    const std::size_t media = is_interface ? 2 : 3;
    if (n.size() != media)
        reader.problem(
            "n",
            fmt::format("must list {} for this model (got {} values)",
                        is_interface ? "ambient and base" : "ambient, film and base", n.size()));
    else if (!is_interface && n[1].imag() > 0.0)
        reader.problem("n[1]", fmt::format("must have k = 0: only `nacre eval stack` has absorbing "
                                           "films (got {})",
                                           n[1].imag()));
    if (d_nm.size() + 2 != media)
        reader.problem("d_nm",
                       fmt::format("must have {} for this model (got {} values)",
                                   is_interface ? "no thickness" : "one thickness", d_nm.size()));
}

FilmQuestion read_film(const json& record)
{
    DiagnosticList problems;
    ObjectReader reader(record, "", problems);
    const auto model = reader.choice("model", {"path_difference", "airy", "series", "opaque_base",
                                               "free_film", "etalon", "recursion", "uv"});
    const auto n = read_indices(reader, problems);
    const auto d_nm = reader.numbers("d_nm", kNotNegative);
    const auto angle = read_angle(reader);
    const auto wavelength = reader.number("wavelength_nm", kPositive);
    if (model == "recursion" && !n.empty() && d_nm)
        check_stack(reader, n, *d_nm);
    else if (model && !n.empty() && d_nm)
        check_layers(reader, n, *d_nm, model == "uv");
    std::optional<double> view, mirror;
    std::optional<std::string> polarisation = "u";
    if (model == "path_difference")
        view = reader.number("view_angle_deg", {0.0, 90.0, false, true});
    else if (model)
        polarisation = read_polarisation(reader);
    if (model == "etalon" && reader.optional("mirror_reflectance"))
        mirror = reader.number("mirror_reflectance", {0.0, 1.0, false, true});
    if (model) reader.refuse_unknown_keys();
    problems.throw_if_any();

    FilmQuestion question{
        *model,         *polarisation, n,           {},    {n.front(), {}, n.back()},
        cosine(*angle), 1.0,           *wavelength, mirror};
    for (std::size_t i = 0; i < d_nm->size(); ++i)
        question.stack.layers.push_back({n[i + 1], (*d_nm)[i]});
    if (view) question.cos_view = cosine(*view);
    if (n.size() == 3) question.film = {n[0].real(), n[1].real(), n[2], d_nm->front()};
    return question;
}

std::vector<Polarisation> polarisations(const std::string& word)
{
    if (word == "u") return {Polarisation::s, Polarisation::p};
    return {word == "s" ? Polarisation::s : Polarisation::p};
}

double reflectance(const FilmQuestion& question, Polarisation which)
{
    const Incidence light{question.cos_ambient, question.wavelength_nm, which};
    if (question.model == "recursion") return optics::recursion_power(question.stack, light).R;
    if (question.mirror_reflectance)
        return optics::etalon_reflectance(question.film, light, question.mirror_reflectance);
    return optics::film_reflectance(optics::film_model_from_name(question.model), question.film,
                                    light);
}

ordered_json evaluate_interface(const FilmQuestion& question)
{
    const auto form =
        optics::uv_interface(question.n[0].real(), question.n[1], question.cos_ambient);
    const auto pair = [](Complex value) { return ordered_json{value.real(), value.imag()}; };
    double sum = 0.0;
    const auto both = polarisations(question.polarisation);
    for (const Polarisation which : both)
        sum += std::norm(which == Polarisation::s ? form.r_s : form.r_p);
    return {{"R", sum / static_cast<double>(both.size())},
            {"r_s", pair(form.r_s)},
            {"r_p", pair(form.r_p)},
            {"cos", {form.u, form.v}}};
}

ordered_json evaluate_film(const json& record)
{
    const FilmQuestion question = read_film(record);
    if (question.model == "uv") return evaluate_interface(question);
    if (question.model == "path_difference")
        return {
            {"bands", optics::path_difference_bands(question.film, question.cos_ambient,
                                                    question.cos_view, question.wavelength_nm)}};
    double R = 0.0, exact = 0.0;
    const auto both = polarisations(question.polarisation);
    for (const Polarisation which : both) {
        R += reflectance(question, which) / static_cast<double>(both.size());
        exact +=
            optics::stack_power(question.stack, question.cos_ambient, question.wavelength_nm, which)
                .R /
            static_cast<double>(both.size());
    }
    ordered_json result = {{"R", R}, {"exact", nullptr}, {"error", nullptr}};
    if (!question.mirror_reflectance) {
        result["exact"] = exact;
        result["error"] = R - exact;
    }
    return result;
}

}  // namespace

void add_eval_film(CLI::App& eval, Session& session)
{
    add_record_command(eval, session, "film", "closed forms of one film beside the exact value",
                       kFilmHelp, evaluate_film);
}

}  // namespace nacre::tool
