// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/optics/grating.h"

#include <cmath>
#include <numbers>
#include <string>

#include "math/sinc.h"
#include "math/vector.h"
#include "nacre/core/diagnostics.h"

namespace nacre::optics {
namespace {

using std::numbers::pi;

Direction combine(double a, const Direction& u, double b, const Direction& v) noexcept
{
    return {a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]};
}

double length(const Direction& v) noexcept
{
    return std::hypot(v[0], v[1], v[2]);
}

Direction unit_vector(const Direction& v) noexcept
{
    const double scale = 1.0 / length(v);
    return {v[0] * scale, v[1] * scale, v[2] * scale};
}

bool is_direction(const Direction& v) noexcept
{
    const double norm = length(v);
    return std::isfinite(norm) && norm > 0.0;
}

constexpr double kMaxPhase = 1000.0;            ///< rad
constexpr double kMaxPitchInWavelengths = 1e4;  ///< more than 20 000 orders propagate beyond it
constexpr int kMaxOrder = 100000;

/// J_m(x) as the Fourier coefficient that it is, 1/N Σ cos(mτ − x sinτ): the trapezium rule on a
/// periodic analytic function converges faster than any power of N once N > |m| + |x|.
double bessel(int m, double x) noexcept
{
    const double order = std::abs(m), reach = std::abs(x);
    if (order > 1.5 * reach + 60.0) return 0.0;  // below 1e-40
    const int n = static_cast<int>(order + reach) + 64;
    double sum = 0.0;
    for (int j = 0; j < n; ++j) {
        const double tau = 2.0 * pi * j / n;
        sum += std::cos(m * tau - x * std::sin(tau));
    }
    return sum / n;
}

void check(const Grating& grating, const Direction& k_in, double wavelength_nm, int first_order,
           int last_order)
{
    DiagnosticList problems;
    const auto require = [&](bool ok, const char* field, std::string message) {
        if (!ok) problems.add({{}, 0, field, std::move(message)});
    };
    const GratingProfile& profile = grating.profile;
    const double pitch = grating.pitch_nm;
    require(std::isfinite(wavelength_nm) && wavelength_nm > 0.0, "wavelength_nm",
            "must be finite and > 0");
    require(std::isfinite(pitch) && pitch > 0.0, "pitch_nm", "must be finite and > 0");
    require(!(wavelength_nm > 0.0 && pitch > kMaxPitchInWavelengths * wavelength_nm), "pitch_nm",
            "must be at most 10000 wavelengths");
    require(is_direction(grating.normal), "normal", "must be finite and not zero");
    require(is_direction(grating.grating_vector), "grating_vector", "must be finite and not zero");
    require(is_direction(k_in), "k_in", "must be finite and not zero");
    require(first_order <= last_order && first_order >= -kMaxOrder && last_order <= kMaxOrder,
            "orders", "must ascend and stay within ±100000");
    require(std::abs(profile.phase_rad) <= kMaxPhase, "profile.phase_rad",
            "must be within ±1000 rad");
    require(profile.duty >= 0.0 && profile.duty <= 1.0, "profile.duty", "must be in [0, 1]");
    problems.throw_if_any();

    const Direction normal = unit_vector(grating.normal), g = unit_vector(grating.grating_vector);
    require(dot(k_in, normal) < 0.0, "k_in", "must point towards the surface (k_in · normal < 0)");
    require(length(combine(1.0, g, -dot(g, normal), normal)) > 1e-9, "grating_vector",
            "must not be parallel to the normal");
    problems.throw_if_any();
}

/// Wave vectors in units of 2π/λ, split along and across the surface.
struct Mounting {
    Direction normal, groove;  ///< unit; `groove` is tangential, along the grating vector
    Direction tangential;      ///< of the incident light
    double cos_in, along;      ///< cosine of incidence; tangential · groove
    double step;               ///< λ/d

    /// cos²θ of an order; what is ≤ 0 does not propagate. Written as a change from the incident
    /// cos², so that order 0 is the mirror direction to the last bit.
    [[nodiscard]] double cos_squared(int m) const noexcept
    {
        const double shift = m * step;
        return cos_in * cos_in - shift * (2.0 * along + shift);
    }

    [[nodiscard]] Direction direction(int m) const noexcept
    {
        const Direction flat = combine(1.0, tangential, m * step, groove);
        return combine(1.0, flat, std::sqrt(cos_squared(m)), normal);
    }
};

Mounting mount(const Grating& grating, const Direction& k_in, double wavelength_nm)
{
    Mounting mounting{};
    mounting.normal = unit_vector(grating.normal);
    const Direction& g = grating.grating_vector;
    mounting.groove = unit_vector(combine(1.0, g, -dot(g, mounting.normal), mounting.normal));
    const Direction k = unit_vector(k_in);
    mounting.cos_in = -dot(k, mounting.normal);
    mounting.tangential = combine(1.0, k, mounting.cos_in, mounting.normal);
    mounting.along = dot(mounting.tangential, mounting.groove);
    mounting.step = wavelength_nm / grating.pitch_nm;
    return mounting;
}

/// Scalar efficiencies of the propagating orders, summed; they form one interval around order 0.
double propagating_share(const Mounting& mounting, const GratingProfile& profile)
{
    double share = scalar_efficiency(profile, 0);
    for (int m = 1; mounting.cos_squared(m) > 0.0; ++m) share += scalar_efficiency(profile, m);
    for (int m = -1; mounting.cos_squared(m) > 0.0; --m) share += scalar_efficiency(profile, m);
    return share;
}

}  // namespace

double scalar_efficiency(const GratingProfile& profile, int order) noexcept
{
    const double phase = profile.phase_rad;
    switch (profile.kind) {
        case ProfileKind::sinusoidal: {
            const double amplitude = bessel(order, 0.5 * phase);
            return amplitude * amplitude;
        }
        case ProfileKind::rectangular: {
            const double depth = 1.0 - std::cos(phase), duty = profile.duty;
            if (order == 0) return 1.0 - 2.0 * duty * (1.0 - duty) * depth;
            const double lobe = std::sin(pi * order * duty) / (pi * order);
            return 2.0 * depth * lobe * lobe;
        }
        case ProfileKind::blazed: {
            const double lobe = sinc(0.5 * phase - pi * order);
            return lobe * lobe;
        }
    }
    return 0.0;
}

std::vector<DiffractedOrder> grating_orders(const Grating& grating, const Direction& k_in,
                                            double wavelength_nm, int first_order, int last_order)
{
    check(grating, k_in, wavelength_nm, first_order, last_order);
    const Mounting mounting = mount(grating, k_in, wavelength_nm);
    const double share = propagating_share(mounting, grating.profile);

    std::vector<DiffractedOrder> orders;
    for (int m = first_order; m <= last_order; ++m) {
        DiffractedOrder result{.order = m, .direction = std::nullopt, .efficiency = 0.0};
        if (mounting.cos_squared(m) > 0.0) {
            result.direction = mounting.direction(m);
            // Where every propagating order has efficiency 0, the mirror direction takes it all.
            result.efficiency =
                share > 0.0 ? scalar_efficiency(grating.profile, m) / share : (m == 0 ? 1.0 : 0.0);
        }
        orders.push_back(result);
    }
    return orders;
}

}  // namespace nacre::optics
