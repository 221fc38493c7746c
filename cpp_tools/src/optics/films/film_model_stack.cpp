// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/film_model_stack.h"

#include <cassert>
#include <cmath>
#include <utility>
#include <variant>

#include "films/film_forms.h"
#include "films/recursion_lanes.h"

namespace nacre::optics {
namespace {

using detail::LaneRoot, detail::LaneTrip;

/// Of both faces, in one polarisation.
struct Faces {
    Lanes r01;
    ComplexLanes r12;
};

/// Adds half of R of the form, and of T where the form has one of its own.
NACRE_VECTOR_CLONES void add_half(FilmModel model, const Faces& at, const ComplexLanes& phase,
                                  Lanes& R, Lanes& T)
{
    Lanes a, b, bottom;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const double re = at.r12.re[i], im = at.r12.im[i];
        a[i] = re * phase.re[i] - im * phase.im[i];
        b[i] = re * phase.im[i] + im * phase.re[i];
        bottom[i] = re * re + im * im;
    }
    if (model == FilmModel::airy) {
        for (std::size_t i = 0; i < kLanes; ++i) R[i] += 0.5 * forms::airy(at.r01[i], a[i], b[i]);
    } else if (model == FilmModel::series) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            R[i] += 0.5 * forms::cut_series(at.r01[i], a[i], b[i]);
            T[i] += 0.5 * forms::cut_series_passed(at.r01[i], bottom[i], a[i], b[i]);
        }
    } else if (model == FilmModel::opaque_base) {
        for (std::size_t i = 0; i < kLanes; ++i)
            R[i] += 0.5 * forms::opaque_base(at.r01[i], bottom[i], a[i]);
    } else {
        for (std::size_t i = 0; i < kLanes; ++i)
            R[i] += 0.5 * forms::etalon(at.r01[i] * at.r01[i], 1.0 - phase.re[i]);
    }
}

/// Mean of the bands from first / (1 + half_cell) to first / (1 − half_cell) optical paths.
NACRE_VECTOR_CLONES void bands(const Lanes& paths, const Lanes& half_cell, Lanes& R)
{
    for (std::size_t i = 0; i < kLanes; ++i)
        R[i] =
            forms::mean_fraction(paths[i] / (1.0 + half_cell[i]), paths[i] / (1.0 - half_cell[i]));
}

void advance(Lanes& lanes, const Lanes& step)
{
    for (std::size_t i = 0; i < kLanes; ++i) lanes[i] += step[i];
}

Lanes product(const Lanes& a, const Lanes& b)
{
    Lanes result;
    for (std::size_t i = 0; i < kLanes; ++i) result[i] = a[i] * b[i];
    return result;
}

Lanes scaled(const Lanes& lanes, double factor)
{
    Lanes result = lanes;
    for (double& value : result) value *= factor;
    return result;
}

/// One film, listed from the ambient down.
class SingleFilmLanes {
public:
    SingleFilmLanes(const LaneStack& stack, const FilmModelStack::Setup& setup)
        : setup_(setup), stack_(stack)
    {
        if (setup.from_below) std::swap(stack_.above, stack_.below);
        turn_to(stack.cos_0);
    }

    void turn_to(const Lanes& cos_0)
    {
        for (std::size_t i = 0; i < kLanes; ++i) turn_lane(i, cos_0[i]);
    }

    [[nodiscard]] const Lanes& waves() const { return stack_.layers.front().waves; }

    void march(const Lanes& first, const Lanes& step, std::span<Lanes> R, std::span<Lanes> T) const
    {
        if (setup_.model == FilmModel::path_difference)
            march_bands(first, step, R);
        else
            march_phase(first, step, R, T);
        const bool lossless = setup_.model != FilmModel::series;
        for (std::size_t row = 0; row < R.size(); ++row)
            for (std::size_t i = 0; i < kLanes; ++i) {
                R[row][i] = enters_[i] * R[row][i] + (1.0 - enters_[i]);
                T[row][i] = lossless ? 1.0 - R[row][i] : enters_[i] * T[row][i];
            }
    }

private:
    FilmModelStack::Setup setup_;
    LaneStack stack_;
    LaneRoot root_;  ///< n₁ cosθ₁
    Lanes cosine_;   ///< cosθ₁
    Lanes enters_;   ///< 0 where light from below is reflected totally, else 1
    Faces s_, p_;

    void turn_lane(std::size_t i, double cos_0)
    {
        const double n_ambient = stack_.above.re[i], n_film = stack_.layers.front().n.re[i];
        const Complex n_base(stack_.below.re[i], stack_.below.im[i]);
        const double ratio = stack_.n_0[i] / n_ambient;
        const double square = 1.0 - ratio * ratio * (1.0 - cos_0) * (1.0 + cos_0);
        enters_[i] = square > 0.0 ? 1.0 : 0.0;
        const double cos_ambient = !setup_.from_below ? cos_0
                                   : square > 0.0     ? std::sqrt(square)
                                                      : 1.0;
        const Complex cos_film = forward_cosine(n_ambient, n_film, cos_ambient);
        const Complex cos_base = forward_cosine(n_film, n_base, cos_film);
        const auto top = fresnel_amplitudes(n_ambient, n_film, cos_ambient, cos_film);
        const auto bottom = fresnel_amplitudes(n_film, n_base, cos_film, cos_base);
        cosine_[i] = cos_film.real();
        root_.q.re[i] = n_film * cosine_[i];
        root_.q.im[i] = 0.0;
        put(s_, i, top.r_s, bottom.r_s);
        put(p_, i, top.r_p, bottom.r_p);
    }

    static void put(Faces& faces, std::size_t i, Complex r01, Complex r12)
    {
        faces.r01[i] = r01.real();
        faces.r12.re[i] = r12.real();
        faces.r12.im[i] = r12.imag();
    }

    void march_bands(const Lanes& first, const Lanes& step, std::span<Lanes> R) const
    {
        const Lanes path = scaled(product(root_.q.re, cosine_), 2.0);
        Lanes paths = product(path, first);
        const Lanes more = product(path, step);
        for (Lanes& row : R) {
            bands(paths, setup_.half_cell, row);
            advance(paths, more);
        }
    }

    void march_phase(const Lanes& first, const Lanes& step, std::span<Lanes> R,
                     std::span<Lanes> T) const
    {
        LaneTrip trip, more;
        find_trip(trip, root_, first, 1.0);
        find_trip(more, root_, step, 1.0);
        for (std::size_t row = 0; row < R.size(); ++row) {
            R[row].fill(0.0);
            T[row].fill(0.0);
            add_half(setup_.model, s_, trip.E, R[row], T[row]);
            add_half(setup_.model, p_, trip.E, R[row], T[row]);
            add_trip(trip, more);
        }
    }
};

SingleFilm single_film(const FilmStack& stack)
{
    const Layer& film = stack.layers.front();
    return {.n_ambient = stack.ambient.real(),
            .n_film = film.n.real(),
            .n_base = stack.substrate,
            .thickness_nm = film.thickness_nm};
}

void add_recursion_problems(const FilmStack& stack, std::vector<StackProblem>& problems)
{
    for (std::size_t i = 0; i < stack.layers.size(); ++i) {
        const Layer& layer = stack.layers[i];
        const int at = static_cast<int>(i);
        if (!layer.coherent) problems.push_back({"d_nm", at, "must be coherent"});
        if (layer.n.imag() == 0.0 && layer.n.real() <= stack.ambient.real())
            problems.push_back({"n", at + 1, "must be larger than that of the ambient, or absorb"});
    }
}

void add_base_problems(FilmModel model, const FilmStack& stack, std::vector<StackProblem>& problems)
{
    const int base = static_cast<int>(stack.layers.size()) + 1;
    if (model == FilmModel::free_film && stack.substrate != stack.ambient)
        problems.push_back({"n", base, "must equal that of the ambient"});
    if (model != FilmModel::airy && model != FilmModel::series) return;
    if (stack.substrate.imag() > 0.0) problems.push_back({"n", base, "must have k = 0"});
    if (stack.substrate.real() < stack.ambient.real())
        problems.push_back({"n", base, "must not be below that of the ambient"});
}

}  // namespace

std::vector<StackProblem> film_model_problems(FilmModel model, const FilmStack& stack)
{
    std::vector<StackProblem> problems;
    if (model == FilmModel::recursion) {
        add_recursion_problems(stack, problems);
        return problems;
    }
    if (stack.layers.size() != 1) {
        problems.push_back({"d_nm", 0, "must be the only layer: the film is a single one"});
        return problems;
    }
    const Layer& film = stack.layers.front();
    if (!film.coherent) problems.push_back({"d_nm", 0, "must be coherent"});
    if (film.n.imag() > 0.0) problems.push_back({"n", 1, "must have k = 0"});
    if (film.n.real() < stack.ambient.real())
        problems.push_back({"n", 1, "must not be below that of the ambient"});
    add_base_problems(model, stack, problems);
    return problems;
}

PowerRatios film_model_power(FilmModel model, const FilmStack& stack, double cos_ambient,
                             double wavelength_nm, double cell_nm)
{
    assert(film_model_problems(model, stack).empty());
    PowerRatios mean{};
    for (const Polarisation polarisation : {Polarisation::s, Polarisation::p}) {
        const Incidence light{cos_ambient, wavelength_nm, polarisation};
        if (model == FilmModel::recursion) {
            const PowerRatios power = recursion_power(stack, light);
            mean.R += 0.5 * power.R;
            mean.T += 0.5 * power.T;
            continue;
        }
        const SingleFilm film = single_film(stack);
        const double R = model == FilmModel::path_difference
                             ? path_difference_mean(film, light.cos_ambient, wavelength_nm, cell_nm)
                             : film_reflectance(model, film, light);
        mean.R += 0.5 * R;
        mean.T += 0.5 * (model == FilmModel::series ? series_transmittance(film, light) : 1.0 - R);
    }
    mean.A = 1.0 - mean.R - mean.T;
    return mean;
}

struct FilmModelStack::Form {
    std::variant<SingleFilmLanes, detail::RecursionLanes> lanes;
};

FilmModelStack::FilmModelStack(const LaneStack& stack, const Setup& setup)
{
    if (setup.model == FilmModel::recursion)
        form_ = std::make_unique<Form>(Form{detail::RecursionLanes(stack, setup.varying)});
    else
        form_ = std::make_unique<Form>(Form{SingleFilmLanes(stack, setup)});
}
FilmModelStack::FilmModelStack(FilmModelStack&&) noexcept = default;
FilmModelStack& FilmModelStack::operator=(FilmModelStack&&) noexcept = default;
FilmModelStack::~FilmModelStack() = default;

void FilmModelStack::turn_to(const Lanes& cos_0)
{
    std::visit([&](auto& lanes) { lanes.turn_to(cos_0); }, form_->lanes);
}

void FilmModelStack::march(const Lanes& first, const Lanes& step, std::span<Lanes> R,
                           std::span<Lanes> T) const
{
    std::visit([&](const auto& lanes) { lanes.march(first, step, R, T); }, form_->lanes);
}

void FilmModelStack::march(double first, double step, std::span<Lanes> R, std::span<Lanes> T) const
{
    if (const auto* film = std::get_if<SingleFilmLanes>(&form_->lanes))
        film->march(scaled(film->waves(), first), scaled(film->waves(), step), R, T);
    else
        std::get<detail::RecursionLanes>(form_->lanes).march_all(first, step, R, T);
}

}  // namespace nacre::optics
