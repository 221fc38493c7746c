// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "stacks/coherent_packet.h"

#include <numbers>

namespace nacre::optics::detail {
namespace {

/// (e^z − 1)/z, without loss for small z.
Extended expm1_over(Extended z) noexcept
{
    constexpr Real small = 0.5L;
    if (std::abs(z) > small) return (std::exp(z) - Real{1}) / z;
    Extended sum = 1, term = 1;
    for (int k = 2; k < 24; ++k) {  // 0.5^23 / 24! < 2e-31
        term *= z / static_cast<Real>(k);
        sum += term;
    }
    return sum;
}

}  // namespace

Extended normal_index(const Incidence& incidence, Complex n) noexcept
{
    const Extended n_0 = incidence.ambient, n_j = n;
    const Extended across = n_0 * static_cast<Real>(incidence.cos_ambient);
    if (n == incidence.ambient) return across;
    const Extended q = std::sqrt((n_j - n_0) * (n_j + n_0) + across * across);
    return q.imag() < 0 || (q.imag() == 0 && q.real() < 0) ? -q : q;
}

Extended tilted_admittance(Extended q, Complex n, Polarisation polarisation) noexcept
{
    const Extended index = n;
    return polarisation == Polarisation::s ? q : q / (index * index);
}

namespace {

/// Tangential fields at one depth, up to a common factor: V is E (s) or H (p), U the other one, so
/// that U/V is the admittance seen from there down.
struct Fields {
    Extended U, V;
};

/// Tangential fields at the upper face of a layer, from those at its lower face.
///
/// A layer of phase thickness δ = 2π q d / λ and admittance η maps them by  V cos δ − i (U/η) sin δ
/// and  U cos δ − i V η sin δ  (Macleod, Thin-Film Optical Filters, characteristic matrix; signs
/// for exp(−iωt)). Both grow like exp(Im δ) and overflow for an opaque layer. Multiplied by e^{iδ},
/// with E = e^{2iδ}, |E| ≤ 1,
///
///     V ← V (1 + E)/2 + U (1 − E)/(2η),    U ← U (1 + E)/2 + V η (1 − E)/2,
///
/// they stay bounded whatever the thickness; the factor cancels in r and returns as Π e^{iδ} in t,
/// which for an opaque stack underflows to 0. This is the recursion of amplitudes
/// γ ← (r_j + γE)/(1 + r_j γE) in other variables: these are also defined at q = 0, where r_j = ±1
/// meet as 0/0, and leave fields untouched when a layer has no thickness or no contrast.
///
/// @param passed  multiplied by e^{iδ}
Fields above_layer(const Incidence& incidence, const Layer& layer, Polarisation polarisation,
                   const Fields& below, Extended& passed)
{
    constexpr Extended i{0, 1};
    const Real k0 = 2 * std::numbers::pi_v<Real> / static_cast<Real>(incidence.wavelength_nm);
    const Extended q = normal_index(incidence, layer.n);
    const Real k0_d = k0 * static_cast<Real>(layer.thickness_nm);
    const Extended i_delta = i * k0_d * q;
    const Extended half_sum = (Real{1} + std::exp(Real{2} * i_delta)) / Real{2};
    // (1 − E)/(2q), finite at q = 0; times q/η = 1 (s) or n² (p).
    const Extended difference_over_q = -i * k0_d * expm1_over(Real{2} * i_delta);
    const Extended contrast =
        polarisation == Polarisation::s ? Extended{1} : Extended{layer.n} * Extended{layer.n};
    passed *= std::exp(i_delta);
    return {.U = below.U * half_sum + below.V * difference_over_q * q * q / contrast,
            .V = below.V * half_sum + below.U * difference_over_q * contrast};
}

}  // namespace

PacketResponse respond(const Incidence& incidence, Complex above, std::span<const Layer> layers,
                       Complex below, Polarisation polarisation)
{
    const Extended eta_below =
        tilted_admittance(normal_index(incidence, below), below, polarisation);
    Fields fields{.U = eta_below, .V = 1};
    Extended passed = 1;
    for (std::size_t j = layers.size(); j-- > 0;)
        fields = above_layer(incidence, layers[j], polarisation, fields, passed);

    const Extended eta_above =
        tilted_admittance(normal_index(incidence, above), above, polarisation);
    const Extended incident = eta_above * fields.V + fields.U;
    PacketResponse response{};
    response.r = (eta_above * fields.V - fields.U) / incident;
    response.t = Real{2} * eta_above * passed / incident;
    response.R = std::norm(response.r);
    response.T = eta_below.real() == 0
                     ? Real{0}
                     : eta_below.real() / eta_above.real() * std::norm(response.t);
    return response;
}

std::vector<Real> power_flux(const Incidence& incidence, Complex above,
                             std::span<const Layer> layers, Complex below,
                             Polarisation polarisation)
{
    const Extended eta_below =
        tilted_admittance(normal_index(incidence, below), below, polarisation);
    // Re(U V*) at each face, with the factor that the fields there have gathered.
    std::vector<Real> flux(layers.size() + 1), gathered(layers.size() + 1, 1);
    Fields fields{.U = eta_below, .V = 1};
    flux.back() = eta_below.real();
    for (std::size_t j = layers.size(); j-- > 0;) {
        Extended passed = 1;
        fields = above_layer(incidence, layers[j], polarisation, fields, passed);
        flux[j] = (fields.U * std::conj(fields.V)).real();
        gathered[j] = std::norm(passed);
    }
    const Extended eta_above =
        tilted_admittance(normal_index(incidence, above), above, polarisation);
    const Extended incident = eta_above * fields.V + fields.U;
    // A unit wave from above brings Re η; faces further down still carry the factors above them.
    Real scale = std::norm(Real{2} * eta_above / incident) / eta_above.real();
    for (std::size_t j = 0; j < flux.size(); ++j) {
        flux[j] *= scale;
        scale *= gathered[j];
    }
    return flux;
}

}  // namespace nacre::optics::detail
