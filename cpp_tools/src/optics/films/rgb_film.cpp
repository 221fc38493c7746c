// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/rgb_film.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include "nacre/optics/fresnel.h"

namespace nacre::optics {
namespace {

using spectral::Mat3, spectral::multiply, spectral::Vec3;

constexpr double kPi = std::numbers::pi;
constexpr int kOrders = 2;

// Both take XYZ of equal-energy white: the first to Rec.709, as the extension states it; the second
// to the RGB of CIE 1931, as MaterialX has it.
constexpr Mat3 kToRec709{{{3.2404542, -1.5371385, -0.4985314},
                          {-0.9692660, 1.8760108, 0.0415560},
                          {0.0556434, -0.2040259, 1.0572252}}};
constexpr Mat3 kToCieRgb{{{2.3706743, -0.9000405, -0.4706338},
                          {-0.5138850, 1.4253036, 0.0885814},
                          {0.0052982, -0.0146949, 1.0093968}}};

double square(double x)
{
    return x * x;
}

/// A Gaussian over wavenumber 1/λ, by its scale, centre in 1/m and variance in 1/m².
struct Gaussian {
    double scale, centre, variance;
};

/// Its Fourier transform at an optical path difference in nm, a phase added.
double transform(const Gaussian& g, double path_nm, double shift)
{
    const double phase = 2.0 * kPi * path_nm * 1e-9;
    return g.scale * std::sqrt(2.0 * kPi * g.variance) * std::cos(g.centre * phase + shift) *
           std::exp(-square(phase) * g.variance);
}

/// The observer of Belcour and Barla 2017, eq. 9: XYZ by four Gaussians, relative to their sum.
Vec3 sensitivity(double path_nm, const Vec3& shift)
{
    constexpr Gaussian kX{5.4856e-13, 1.6810e6, 4.3278e9}, kX2{9.7470e-14, 2.2399e6, 4.5282e9};
    constexpr Gaussian kY{4.4201e-13, 1.7953e6, 9.3046e9}, kZ{5.2481e-13, 2.2084e6, 6.6121e9};
    constexpr double kWhite = 1.0685e-7;
    return {(transform(kX, path_nm, shift[0]) + transform(kX2, path_nm, shift[0])) / kWhite,
            transform(kY, path_nm, shift[1]) / kWhite, transform(kZ, path_nm, shift[2]) / kWhite};
}

double schlick(double f0, double cos_theta)
{
    return f0 + (1.0 - f0) * std::pow(1.0 - cos_theta, 5.0);
}

double f0_of_ratio(double n_t, double n_i)
{
    return square((n_t - n_i) / (n_t + n_i));
}

/// Reflection at both faces, summed over every order without interference: Belcour and Barla 2017,
/// eq. 7, and the amplitude that the orders m > 0 start from.
struct Series {
    double mean, first, ratio;
};

Series series(double top, double bottom, double product_of_both)
{
    const double through = 1.0 - top;
    const double returned = square(through) * bottom / (1.0 - product_of_both);
    return {top + returned, returned - through, std::sqrt(product_of_both)};
}

Vec3 iridescent_fresnel(const KhrIridescence& surface, double cos_1)
{
    const double film = surface.film_ior;
    const double cos2_squared = 1.0 - (1.0 - square(cos_1)) / square(film);
    const double cos_2 = std::sqrt(std::max(0.0, cos2_squared));
    const double top = schlick(f0_of_ratio(film, 1.0), cos_1);
    Vec3 phase{}, result{};
    std::array<Series, 3> orders{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double root = std::sqrt(surface.base_f0[c] + 1e-4);
        const double base = (1.0 + root) / (1.0 - root);
        const double bottom = schlick(f0_of_ratio(base, film), cos_2);
        // π for the reflection inside at the top; once more where the base is the thinner medium.
        phase[c] = base < film ? 2.0 * kPi : kPi;
        orders[c] = series(top, bottom, std::clamp(top * bottom, 1e-5, 0.9999));
        result[c] = orders[c].mean;
    }
    const double path_nm = 2.0 * film * surface.film_nm * cos_2;
    for (int m = 1; m <= kOrders; ++m) {
        const Vec3 rgb = multiply(
            kToRec709, sensitivity(m * path_nm, {m * phase[0], m * phase[1], m * phase[2]}));
        for (std::size_t c = 0; c < 3; ++c)
            result[c] += orders[c].first * std::pow(orders[c].ratio, m) * 2.0 * rgb[c];
    }
    for (double& value : result) value = std::max(value, 0.0);
    return result;
}

/// One face for one polarisation: power ratio, and phase in the sign under which both polarisations
/// agree at normal incidence.
struct Face {
    double reflectance, phase;
};

Face face(Complex n_i, Complex n_t, Complex cos_i, bool parallel)
{
    const FresnelAmplitudes r =
        fresnel_amplitudes(n_i, n_t, cos_i, forward_cosine(n_i, n_t, cos_i));
    const Complex amplitude = parallel ? r.r_p : -r.r_s;
    return {std::norm(amplitude), std::arg(amplitude)};
}

Vec3 polarised_film(const MaterialXFilm& film, double cos_1, bool parallel)
{
    const Complex n_film = film.film_ior, cos_2 = forward_cosine(1.0, n_film, cos_1);
    const double top = face(1.0, n_film, cos_1, parallel).reflectance;
    const double phase_inside = face(n_film, 1.0, cos_2, parallel).phase;
    Vec3 phase{}, result{};
    std::array<Series, 3> orders{};
    for (std::size_t c = 0; c < 3; ++c) {
        const Face below = face(n_film, {film.base_n[c], film.base_k[c]}, cos_2, parallel);
        phase[c] = phase_inside + below.phase;
        orders[c] = series(top, below.reflectance, top * below.reflectance);
        result[c] = orders[c].mean;
    }
    const double path_nm = 2.0 * film.film_ior * film.film_nm * cos_2.real();
    for (int m = 1; m <= kOrders; ++m) {
        const Vec3 xyz = sensitivity(m * path_nm, {m * phase[0], m * phase[1], m * phase[2]});
        for (std::size_t c = 0; c < 3; ++c)
            result[c] += orders[c].first * std::pow(orders[c].ratio, m) * 2.0 * xyz[c];
    }
    return result;
}

}  // namespace

Vec3 khr_iridescence(const KhrIridescence& surface, double cos_theta)
{
    Vec3 result = iridescent_fresnel(surface, cos_theta);
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = std::lerp(schlick(surface.base_f0[c], cos_theta), result[c], surface.factor);
    return result;
}

Vec3 materialx_film(const MaterialXFilm& film, double cos_theta)
{
    const Vec3 s = polarised_film(film, cos_theta, false);
    const Vec3 p = polarised_film(film, cos_theta, true);
    Vec3 rgb =
        multiply(kToCieRgb, Vec3{(s[0] + p[0]) / 2.0, (s[1] + p[1]) / 2.0, (s[2] + p[2]) / 2.0});
    for (double& value : rgb) value = std::clamp(value, 0.0, 1.0);
    return rgb;
}

}  // namespace nacre::optics
