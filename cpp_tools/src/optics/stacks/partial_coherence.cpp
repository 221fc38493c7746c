// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "stacks/partial_coherence.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace nacre::optics::detail {
namespace {

/// Coherent layers above one with a spread: r' = r_f + t_f t_b z / (1 − r_b z), where z is the wave
/// that comes back through that layer, at the lower face of the packet.
struct TwoWay {
    Extended r_front, r_back, t_front, t_both;
};

/// One passage through a layer with a spread and back.
struct SpreadTrip {
    Extended E;      ///< e^{2iδ} at the mean thickness
    Real deviation;  ///< standard deviation of the phase of E
};

/// From the ambient down: packets[0], trips[0], packets[1], …, packets.back() on the substrate.
struct Chain {
    std::vector<TwoWay> packets;
    std::vector<SpreadTrip> trips;
    Real to_power;  ///< from |t|² to T
};

TwoWay two_way(const Incidence& incidence, Complex above, std::span<const Layer> layers,
               Complex below, Polarisation polarisation)
{
    const std::vector<Layer> reversed(layers.rbegin(), layers.rend());
    const PacketResponse down = respond(incidence, above, layers, below, polarisation);
    const PacketResponse up = respond(incidence, below, reversed, above, polarisation);
    return {.r_front = down.r, .r_back = up.r, .t_front = down.t, .t_both = down.t * up.t};
}

SpreadTrip spread_trip(const Incidence& incidence, const Layer& layer)
{
    const Real turn = 4 * std::numbers::pi_v<Real> / static_cast<Real>(incidence.wavelength_nm);
    const Extended q = normal_index(incidence, layer.n);
    const Extended i_q{-q.imag(), q.real()};
    return {.E = std::exp(turn * static_cast<Real>(layer.thickness_nm) * i_q),
            .deviation = turn * q.real() * static_cast<Real>(layer.spread_nm)};
}

Chain split(const Incidence& incidence, Complex above, std::span<const Layer> layers, Complex below,
            Polarisation polarisation)
{
    const auto admittance = [&](Complex n) {
        return tilted_admittance(normal_index(incidence, n), n, polarisation).real();
    };
    Chain chain{.packets = {}, .trips = {}, .to_power = admittance(below) / admittance(above)};
    const auto spread = [](const Layer& layer) { return layer.spread_nm > 0.0; };
    for (auto begin = layers.begin();;) {
        const auto end = std::find_if(begin, layers.end(), spread);
        const Complex under = end == layers.end() ? below : end->n;
        chain.packets.push_back(two_way(incidence, above, {begin, end}, under, polarisation));
        if (end == layers.end()) return chain;
        chain.trips.push_back(spread_trip(incidence, *end));
        above = end->n;
        begin = end + 1;
    }
}

/// ⟨e^{imφ}⟩ over a normal distribution of mean 0.
Real damping(Real deviation, std::size_t m)
{
    const Real turned = deviation * static_cast<Real>(m);
    return std::exp(-turned * turned / 2);
}

/// Σ_{m ≥ 1} ρ^{m−1} damping(m).
Extended damped_series(Extended rho, Real deviation)
{
    constexpr Real kNegligible = 1e-20L;
    Extended sum = 0, power = 1;
    Real size = 1;
    const Real ratio = std::abs(rho);
    for (std::size_t m = 1;; ++m) {
        const Real damped = damping(deviation, m);
        sum += damped * power;
        // The rest of the series is smaller than its geometric bound.
        if (size * damped <= kNegligible * std::max(Real{1} - ratio, kNegligible)) return sum;
        power *= rho;
        size *= ratio;
    }
}

/// One layer with a spread. With ρ = r_b z the means are those of a geometric series,
///     ⟨ρ^k ρ*^l⟩ = ρ^k ρ*^l damping(|k − l|),
/// whose double sum is (1 + 2 Re Σ_{m ≥ 1} ρ^m damping(m)) / (1 − |ρ|²).
MeanPower one_spread_layer(const Chain& chain)
{
    const TwoWay &upper = chain.packets.front(), &lower = chain.packets.back();
    const auto& [E, deviation] = chain.trips.front();
    const Extended z = lower.r_front * E, rho = upper.r_back * z;
    const Real room = 1 - std::norm(rho);
    if (!(room > 0)) return {.R = std::norm(upper.r_front), .T = 0};  // nothing leaks in
    const Extended series = damped_series(rho, deviation);
    const Real inside = (1 + 2 * (rho * series).real()) / room;
    const Extended back = upper.t_both * z;
    const Real crossed = 2 * (std::conj(upper.r_front) * back * series).real();
    return {.R = std::norm(upper.r_front) + crossed + std::norm(back) * inside,
            .T = chain.to_power * std::norm(upper.t_front * lower.t_front) * std::abs(E) * inside};
}

// ---- Several layers ----------------------------------------------------------------------------

using Coefficient = std::complex<double>;

/// Square matrix by rows; plain products, without the care for infinities of std::complex.
class Matrix {
public:
    explicit Matrix(std::size_t order) : order_(order), values_(order * order) {}
    [[nodiscard]] std::size_t order() const { return order_; }
    Coefficient& at(std::size_t row, std::size_t column) { return values_[row * order_ + column]; }
    [[nodiscard]] Coefficient at(std::size_t row, std::size_t column) const
    {
        return values_[row * order_ + column];
    }

private:
    std::size_t order_;
    std::vector<Coefficient> values_;
};

void add_product(Coefficient& sum, Coefficient a, Coefficient b)
{
    sum += Coefficient(a.real() * b.real() - a.imag() * b.imag(),
                       a.real() * b.imag() + a.imag() * b.real());
}

/// first · second†
Matrix times_adjoint(const Matrix& first, const Matrix& second)
{
    const std::size_t order = first.order();
    Matrix result(order);
    for (std::size_t k = 0; k < order; ++k)
        for (std::size_t l = 0; l < order; ++l)
            for (std::size_t m = 0; m < order; ++m)
                add_product(result.at(k, l), first.at(k, m), std::conj(second.at(l, m)));
    return result;
}

/// Row k: coefficients in z of r'^k, where r' = (α + βz)/(1 − r_b z). They stay below 1 for a
/// passive packet, which maps the disc |z| ≤ 1 into itself (Cauchy).
Matrix powers_of_response(const TwoWay& packet, std::size_t order)
{
    const Coefficient alpha{packet.r_front};
    const Coefficient beta{packet.t_both - packet.r_front * packet.r_back};
    const Coefficient r_back{packet.r_back};
    Matrix rows(order);
    rows.at(0, 0) = 1.0;
    for (std::size_t k = 1; k < order; ++k)
        for (std::size_t n = 0; n < order; ++n) {
            Coefficient& value = rows.at(k, n);
            add_product(value, alpha, rows.at(k - 1, n));
            if (n == 0) continue;
            add_product(value, beta, rows.at(k - 1, n - 1));
            add_product(value, r_back, rows.at(k, n - 1));
        }
    return rows;
}

/// The same rows times t_f / (1 − r_b z), what a transmitted wave gains in addition.
Matrix transmitted_powers(const TwoWay& packet, Matrix rows)
{
    const Coefficient t_front{packet.t_front}, r_back{packet.r_back};
    for (std::size_t k = 0; k < rows.order(); ++k)
        for (std::size_t n = 0; n < rows.order(); ++n) {
            Coefficient value{};
            add_product(value, t_front, rows.at(k, n));
            if (n > 0) add_product(value, r_back, rows.at(k, n - 1));
            rows.at(k, n) = value;
        }
    return rows;
}

/// ⟨r^k r*^l⟩, and ⟨|t|² r^k r*^l⟩ of the stack below some depth.
struct Moments {
    Matrix reflected, transmitted;
};

Moments moments_of(const TwoWay& bottom, std::size_t order)
{
    Moments moments{Matrix(order), Matrix(order)};
    std::vector<Coefficient> powers(order, 1.0);
    for (std::size_t k = 1; k < order; ++k) powers[k] = powers[k - 1] * Coefficient(bottom.r_front);
    const auto strength = static_cast<double>(std::norm(bottom.t_front));
    for (std::size_t k = 0; k < order; ++k)
        for (std::size_t l = 0; l < order; ++l) {
            moments.reflected.at(k, l) = powers[k] * std::conj(powers[l]);
            moments.transmitted.at(k, l) = strength * moments.reflected.at(k, l);
        }
    return moments;
}

/// Through a layer and back: r^k r*^l gains ⟨E^k E*^l⟩; what is transmitted passes once.
void pass(Moments& moments, const SpreadTrip& trip)
{
    const std::size_t order = moments.reflected.order();
    const auto once = static_cast<double>(std::abs(trip.E));
    std::vector<Coefficient> powers(order, 1.0);
    for (std::size_t k = 1; k < order; ++k) powers[k] = powers[k - 1] * Coefficient(trip.E);
    for (std::size_t k = 0; k < order; ++k)
        for (std::size_t l = 0; l < order; ++l) {
            const auto damped = static_cast<double>(damping(trip.deviation, k > l ? k - l : l - k));
            const Coefficient factor = damped * powers[k] * std::conj(powers[l]);
            moments.reflected.at(k, l) *= factor;
            moments.transmitted.at(k, l) *= once * factor;
        }
}

/// ⟨|Σ row_k r^k|²⟩
double mean_square(const Matrix& rows, std::size_t row, const Matrix& moments)
{
    Coefficient sum{};
    for (std::size_t k = 0; k < rows.order(); ++k) {
        Coefficient inner{};
        for (std::size_t l = 0; l < rows.order(); ++l)
            add_product(inner, moments.at(k, l), std::conj(rows.at(row, l)));
        add_product(sum, rows.at(row, k), inner);
    }
    return sum.real();
}

/// Above a packet: linear in the moments, since r'^k is a power series in r.
void rise(Moments& moments, const TwoWay& packet)
{
    const Matrix reflected = powers_of_response(packet, moments.reflected.order());
    const Matrix transmitted = transmitted_powers(packet, reflected);
    // U M U†; M is its own adjoint.
    const auto transformed = [](const Matrix& rows, const Matrix& values) {
        return times_adjoint(times_adjoint(rows, values), rows);
    };
    moments.reflected = transformed(reflected, moments.reflected);
    moments.transmitted = transformed(transmitted, moments.transmitted);
}

/// Order at which the series of multiple reflections has died away.
std::size_t order_needed(const Chain& chain)
{
    constexpr double kNegligible = 1e-14;
    constexpr std::size_t kLeast = 8, kMost = 512;
    double ratio = 0.0;
    for (std::size_t j = 0; j < chain.trips.size(); ++j)
        ratio = std::max(ratio, static_cast<double>(std::abs(chain.packets[j].r_back) *
                                                    std::abs(chain.trips[j].E)));
    if (ratio >= 1.0) return kMost;
    const double terms = std::log(kNegligible) / std::log(std::max(ratio, kNegligible));
    return std::clamp(static_cast<std::size_t>(terms) + 2, kLeast, kMost);
}

MeanPower several_spread_layers(const Chain& chain)
{
    Moments moments = moments_of(chain.packets.back(), order_needed(chain));
    for (std::size_t j = chain.trips.size() - 1; j > 0; --j) {
        pass(moments, chain.trips[j]);
        rise(moments, chain.packets[j]);
    }
    // At the surface two of the moments are wanted.
    pass(moments, chain.trips.front());
    const Matrix reflected = powers_of_response(chain.packets.front(), moments.reflected.order());
    const Matrix transmitted = transmitted_powers(chain.packets.front(), reflected);
    return {.R = mean_square(reflected, 1, moments.reflected),
            .T = chain.to_power * mean_square(transmitted, 0, moments.transmitted)};
}

}  // namespace

bool has_spread(std::span<const Layer> layers) noexcept
{
    return std::any_of(layers.begin(), layers.end(),
                       [](const Layer& layer) { return layer.spread_nm > 0.0; });
}

MeanPower mean_response(const Incidence& incidence, Complex above, std::span<const Layer> layers,
                        Complex below, Polarisation polarisation)
{
    const Chain chain = split(incidence, above, layers, below, polarisation);
    if (chain.trips.empty()) {
        const PacketResponse plain = respond(incidence, above, layers, below, polarisation);
        return {.R = plain.R, .T = plain.T};
    }
    return chain.trips.size() == 1 ? one_spread_layer(chain) : several_spread_layers(chain);
}

}  // namespace nacre::optics::detail
