// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/film_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "films/film_forms.h"
#include "math/sinc.h"
#include "nacre/core/diagnostics.h"
#include "nacre/optics/multilayer.h"

namespace nacre::optics {
namespace {

using std::numbers::pi;

/// In the order of FilmModel.
constexpr std::array<std::string_view, 7> kModelNames{
    "path_difference", "airy", "series", "opaque_base", "free_film", "etalon", "recursion"};

class Domain {
public:
    void require(bool ok, const char* field, std::string message)
    {
        if (!ok) problems_.add({{}, 0, field, std::move(message)});
    }

    void light(double cos_ambient, double wavelength_nm)
    {
        require(cos_ambient > 0.0 && cos_ambient <= 1.0, "angle_deg", "must be in [0, 90)");
        require(std::isfinite(wavelength_nm) && wavelength_nm > 0.0, "wavelength_nm",
                "must be finite and > 0");
    }

    void base(Complex n, const char* field)
    {
        require(std::isfinite(n.real()) && n.real() > 0.0, field, "must have n > 0");
        require(std::isfinite(n.imag()) && n.imag() >= 0.0, field, "must have k ≥ 0");
    }

    /// Light reaches the film and passes it as a wave, not as an evanescent field.
    void film(const SingleFilm& film, double cos_ambient)
    {
        require(std::isfinite(film.n_ambient) && film.n_ambient > 0.0, "n[0]", "must be > 0");
        require(std::isfinite(film.n_film) && film.n_film > 0.0, "n[1]", "must be > 0");
        base(film.n_base, "n[2]");
        require(std::isfinite(film.thickness_nm) && film.thickness_nm >= 0.0, "d_nm[0]",
                "must be finite and ≥ 0");
        throw_if_any();
        require(across(film, cos_ambient) < film.n_film, "angle_deg",
                "must be below the critical angle of the film: this form has no total reflection");
    }

    void clear_base(const SingleFilm& film, double cos_ambient)
    {
        require(film.n_base.imag() == 0.0, "n[2]",
                "must have k = 0: this form is one of clear media");
        require(across(film, cos_ambient) < film.n_base.real(), "angle_deg",
                "must be below the critical angle of the base: this form has no total reflection");
    }

    void throw_if_any() { problems_.throw_if_any(); }

    /// n sinθ, the same in every medium.
    static double across(const SingleFilm& film, double cos_ambient) noexcept
    {
        return film.n_ambient * std::sqrt((1.0 - cos_ambient) * (1.0 + cos_ambient));
    }

private:
    DiagnosticList problems_;
};

struct Surfaces {
    double r01, t01, t10;
    Complex r12;
    double phase;
};

double phase_of(const SingleFilm& film, double cos_film, double wavelength_nm) noexcept
{
    return 4.0 * pi * film.n_film * film.thickness_nm * cos_film / wavelength_nm;
}

double cosine_in_film(const SingleFilm& film, double cos_ambient) noexcept
{
    return forward_cosine(film.n_ambient, film.n_film, cos_ambient).real();
}

Surfaces surfaces(const SingleFilm& film, const Incidence& light) noexcept
{
    const double cos_film = cosine_in_film(film, light.cos_ambient);
    const Complex cos_base = forward_cosine(film.n_film, film.n_base, cos_film);
    const auto top = fresnel_amplitudes(film.n_ambient, film.n_film, light.cos_ambient, cos_film);
    const auto back = fresnel_amplitudes(film.n_film, film.n_ambient, cos_film, light.cos_ambient);
    const auto bottom = fresnel_amplitudes(film.n_film, film.n_base, cos_film, cos_base);
    const double phase = phase_of(film, cos_film, light.wavelength_nm);
    if (light.polarisation == Polarisation::s)
        return {top.r_s.real(), top.t_s.real(), back.t_s.real(), bottom.r_s, phase};
    return {top.r_p.real(), top.t_p.real(), back.t_p.real(), bottom.r_p, phase};
}

/// Checks a film of clear media and gives its coefficients.
Surfaces clear_surfaces(const SingleFilm& film, const Incidence& light)
{
    Domain domain;
    domain.light(light.cos_ambient, light.wavelength_nm);
    domain.film(film, light.cos_ambient);
    domain.clear_base(film, light.cos_ambient);
    domain.throw_if_any();
    return surfaces(film, light);
}

void check_recursion(const FilmStack& stack, const Incidence& light)
{
    Domain domain;
    domain.light(light.cos_ambient, light.wavelength_nm);
    if (const auto problem = validate(stack))
        throw InputError({.file = {},
                          .field = fmt::format("{}[{}]", problem->field, problem->index),
                          .message = problem->message});
    for (std::size_t i = 0; i < stack.layers.size(); ++i) {
        const std::string field = fmt::format("n[{}]", i + 1);
        const Layer& layer = stack.layers[i];
        domain.require(layer.coherent && layer.spread_nm == 0.0, field.c_str(),
                       "must be coherent and without a spread: this form is one of amplitudes");
        // Nearer to it the error would exceed 1e-12.
        constexpr double kNearest = 1e-4;
        const Complex cosine = forward_cosine(stack.ambient, layer.n, light.cos_ambient);
        domain.require(std::abs(cosine) >= kNearest, field.c_str(),
                       "must not be at its critical angle, where this form is 0/0; nacre eval "
                       "stack has a value there");
    }
    domain.throw_if_any();
}

/// 1 − cosδ, with its digits in a film that is all but gone.
double versine(double phase) noexcept
{
    const double half = std::sin(0.5 * phase);
    return 2.0 * half * half;
}

/// 2 n d cosθ_light cosθ_view, in nm.
double bands_path(const SingleFilm& film, double cos_light, double cos_view, double wavelength_nm)
{
    Domain domain;
    domain.light(std::min(cos_light, cos_view), wavelength_nm);
    domain.light(std::max(cos_light, cos_view), wavelength_nm);
    domain.film(film, std::min(cos_light, cos_view));
    domain.throw_if_any();
    return 2.0 * film.n_film * film.thickness_nm * cosine_in_film(film, cos_light) *
           cosine_in_film(film, cos_view);
}

}  // namespace

double round_trip_phase(const SingleFilm& film, double cos_ambient, double wavelength_nm)
{
    Domain domain;
    domain.light(cos_ambient, wavelength_nm);
    domain.film(film, cos_ambient);
    domain.throw_if_any();
    return phase_of(film, cosine_in_film(film, cos_ambient), wavelength_nm);
}

double path_difference_bands(const SingleFilm& film, double cos_light, double cos_view,
                             double wavelength_nm)
{
    const double waves = bands_path(film, cos_light, cos_view, wavelength_nm) / wavelength_nm;
    return waves - std::floor(waves);
}

double path_difference_mean(const SingleFilm& film, double cos_ambient, double wavelength_nm,
                            double cell_nm)
{
    Domain domain;
    domain.require(cell_nm >= 0.0 && cell_nm < wavelength_nm, "cell_nm",
                   "must be in [0, wavelength_nm)");
    domain.throw_if_any();
    const double path = bands_path(film, cos_ambient, cos_ambient, wavelength_nm);
    const double half = 0.5 * cell_nm;
    return forms::mean_fraction(path / (wavelength_nm + half), path / (wavelength_nm - half));
}

double airy_reflectance(const SingleFilm& film, const Incidence& light)
{
    const Surfaces at = clear_surfaces(film, light);
    const Complex once = at.r12 * std::polar(1.0, at.phase);
    return forms::airy(at.r01, once.real(), once.imag());
}

double series_reflectance(const SingleFilm& film, const Incidence& light)
{
    const Surfaces at = clear_surfaces(film, light);
    const Complex once = at.r12 * std::polar(1.0, at.phase);
    return forms::cut_series(at.r01, once.real(), once.imag());
}

double series_transmittance(const SingleFilm& film, const Incidence& light)
{
    const Surfaces at = clear_surfaces(film, light);
    const Complex once = at.r12 * std::polar(1.0, at.phase);
    return forms::cut_series_passed(at.r01, std::norm(at.r12), once.real(), once.imag());
}

double series_error_bound(const SingleFilm& film, const Incidence& light)
{
    const Surfaces at = clear_surfaces(film, light);
    const double ratio = std::abs(at.r01 * at.r12);
    const double remainder = at.t01 * at.t10 * std::abs(at.r12) * ratio * ratio / (1.0 - ratio);
    return remainder * (2.0 * std::sqrt(airy_reflectance(film, light)) + remainder);
}

double opaque_base_reflectance(const SingleFilm& film, const Incidence& light)
{
    Domain domain;
    domain.light(light.cos_ambient, light.wavelength_nm);
    domain.film(film, light.cos_ambient);
    domain.throw_if_any();
    const Surfaces at = surfaces(film, light);
    const double once = at.r12.real() * std::cos(at.phase) - at.r12.imag() * std::sin(at.phase);
    return forms::opaque_base(at.r01, std::norm(at.r12), once);
}

double free_film_reflectance(const SingleFilm& film, const Incidence& light)
{
    Domain same;
    same.require(film.n_base == Complex(film.n_ambient), "n[2]",
                 "must equal n[0]: a free film has the same medium on both sides");
    same.throw_if_any();
    const Surfaces at = clear_surfaces(film, light);
    return forms::etalon(at.r01 * at.r01, versine(at.phase));
}

double etalon_transmittance(double mirror_reflectance, double phase_rad)
{
    Domain domain;
    domain.require(mirror_reflectance >= 0.0 && mirror_reflectance < 1.0, "mirror_reflectance",
                   "must be in [0, 1)");
    domain.require(std::isfinite(phase_rad), "phase_rad", "must be finite");
    domain.throw_if_any();
    return forms::etalon_passed(mirror_reflectance, versine(phase_rad));
}

double etalon_reflectance(const SingleFilm& film, const Incidence& light,
                          std::optional<double> mirror_reflectance)
{
    const double phase = round_trip_phase(film, light.cos_ambient, light.wavelength_nm);
    if (mirror_reflectance) return 1.0 - etalon_transmittance(*mirror_reflectance, phase);
    const auto face =
        fresnel_amplitudes(film.n_ambient, film.n_film, light.cos_ambient,
                           forward_cosine(film.n_ambient, film.n_film, light.cos_ambient));
    const Complex r = light.polarisation == Polarisation::s ? face.r_s : face.r_p;
    return 1.0 - etalon_transmittance(std::norm(r), phase);
}

Amplitudes recursion_amplitudes(const FilmStack& stack, const Incidence& light)
{
    check_recursion(stack, light);
    const auto cosine_in = [&](Complex n) {
        return forward_cosine(stack.ambient, n, light.cos_ambient);
    };
    Complex below = stack.substrate, reflected{}, passed{1.0};
    for (std::size_t j = stack.layers.size() + 1; j-- > 0;) {
        const Complex above = j == 0 ? stack.ambient : stack.layers[j - 1].n;
        const auto at = fresnel_amplitudes(above, below, cosine_in(above), cosine_in(below));
        const bool s = light.polarisation == Polarisation::s;
        const Complex r = s ? at.r_s : at.r_p, t = s ? at.t_s : at.t_p;
        Complex once{1.0};
        if (j < stack.layers.size())
            once = std::exp(
                Complex(0.0, 2.0 * pi * stack.layers[j].thickness_nm / light.wavelength_nm) *
                below * cosine_in(below));
        const Complex again = reflected * once * once, both = 1.0 + r * again;
        reflected = (r + again) / both;
        passed *= t * once / both;
        below = above;
    }
    return {.r = reflected, .t = passed};
}

PowerRatios recursion_power(const FilmStack& stack, const Incidence& light)
{
    const auto [r, t] = recursion_amplitudes(stack, light);
    const Complex cosine = forward_cosine(stack.ambient, stack.substrate, light.cos_ambient);
    // The flux of s goes with N cosθ, that of p, by the conjugate of one of them, with N* cosθ.
    const Complex n =
        light.polarisation == Polarisation::s ? stack.substrate : std::conj(stack.substrate);
    const double R = std::norm(r);
    const double T =
        std::norm(t) * (n * cosine).real() / (stack.ambient.real() * light.cos_ambient);
    return {.R = R, .T = T, .A = 1.0 - R - T};
}

std::span<const std::string_view> film_model_names()
{
    return kModelNames;
}

std::string_view film_model_name(FilmModel model)
{
    return kModelNames[static_cast<std::size_t>(model)];
}

FilmModel film_model_from_name(std::string_view name)
{
    const auto it = std::ranges::find(kModelNames, name);
    if (it == kModelNames.end())
        throw InputError({.file = {},
                          .field = "model",
                          .message = fmt::format("must be one of {} (got '{}')",
                                                 fmt::join(kModelNames, ", "), name)});
    return static_cast<FilmModel>(it - kModelNames.begin());
}

double film_reflectance(FilmModel model, const SingleFilm& film, const Incidence& light)
{
    switch (model) {
        case FilmModel::path_difference:
            return path_difference_bands(film, light.cos_ambient, light.cos_ambient,
                                         light.wavelength_nm);
        case FilmModel::airy:
            return airy_reflectance(film, light);
        case FilmModel::series:
            return series_reflectance(film, light);
        case FilmModel::opaque_base:
            return opaque_base_reflectance(film, light);
        case FilmModel::free_film:
            return free_film_reflectance(film, light);
        case FilmModel::etalon:
            return etalon_reflectance(film, light, std::nullopt);
        case FilmModel::recursion:
            break;
    }
    const FilmStack stack{film.n_ambient, {{film.n_film, film.thickness_nm}}, film.n_base};
    return recursion_power(stack, light).R;
}

UvForm uv_interface(double n_ambient, Complex n_base, double cos_ambient)
{
    Domain domain;
    domain.light(cos_ambient, 1.0);
    domain.require(std::isfinite(n_ambient) && n_ambient > 0.0, "n[0]", "must be > 0");
    domain.base(n_base, "n[1]");
    domain.throw_if_any();

    const double n = n_base.real(), k = n_base.imag(), m = std::norm(n_base);
    const double s2 = n_ambient * n_ambient * (1.0 - cos_ambient) * (1.0 + cos_ambient);
    // (u + iv)² = cos²θ₂ = 1 − s²/(n + ik)²
    const double re = 1.0 - (n - k) * (n + k) * s2 / (m * m);
    const double im = 2.0 * n * k * s2 / (m * m);
    const double modulus = std::hypot(re, im);
    // The larger of both roots by the sum, the other from 2uv = im: no cancellation.
    const double large = std::sqrt(0.5 * (modulus + std::abs(re)));
    const double small = large > 0.0 ? 0.5 * im / large : 0.0;
    const double u = re >= 0.0 ? large : small, v = re >= 0.0 ? small : large;

    const double a = n * u - k * v, b = n * v + k * u;  // (n + ik)(u + iv)
    const double c = n_ambient * cos_ambient;
    const double s_scale = 1.0 / ((c + a) * (c + a) + b * b);
    const double f = n_ambient * u, g = n_ambient * v, h = n * cos_ambient, l = k * cos_ambient;
    const double p_scale = 1.0 / ((h + f) * (h + f) + (l + g) * (l + g));
    return {.u = u,
            .v = v,
            .r_s = {(c * c - a * a - b * b) * s_scale, -2.0 * c * b * s_scale},
            .r_p = {(h * h + l * l - f * f - g * g) * p_scale, 2.0 * (l * f - h * g) * p_scale}};
}

double slit_intensity(double width_nm, double spacing_nm, double sin_angle, double wavelength_nm)
{
    Domain domain;
    domain.light(1.0, wavelength_nm);
    domain.require(std::isfinite(width_nm) && width_nm > 0.0, "width_nm", "must be > 0");
    domain.require(spacing_nm == 0.0 || (std::isfinite(spacing_nm) && spacing_nm >= width_nm),
                   "spacing_nm", "must be 0 for one slit, or at least the width");
    domain.require(std::abs(sin_angle) <= 1.0, "angle_deg", "must be in [-90, 90]");
    domain.throw_if_any();
    const double turns = pi * sin_angle / wavelength_nm;
    const double one = sinc(width_nm * turns), two = std::cos(spacing_nm * turns);
    return one * one * two * two;
}

}  // namespace nacre::optics
