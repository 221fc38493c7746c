// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "colours/stack_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "nacre/core/diagnostics.h"
#include "nacre/optics/multilayer.h"
#include "nacre/optics/stack_batch.h"

namespace nacre::optics::detail {
namespace {

/// What liquids have for k in the visible, and a table's noise; light is not lost on its way to a
/// film by so little.
constexpr double kTraceOfK = 1e-5;
/// Roundings of the vector code that matter less than any colour.
constexpr double kHarmlessDoubt = 1e-8;
constexpr double kOpaque = 40.0;       ///< attenuation of amplitudes by e^−40
constexpr double kMostContrast = 0.9;  ///< |r_j| that counts; of total reflection 1
constexpr double kAttenuated = 300.0;  ///< t far from where it underflows

void set(ComplexLanes& lanes, std::size_t i, Complex value)
{
    lanes.re[i] = value.real();
    lanes.im[i] = value.imag();
}

Complex get(const ComplexLanes& lanes, std::size_t i)
{
    return {lanes.re[i], lanes.im[i]};
}

/// Wave-vector component across the interfaces, on the branch that decays inwards.
Complex normal_index(double n_0, double cos_0, Complex n)
{
    const Complex q = std::sqrt((n - n_0) * (n + n_0) + n_0 * cos_0 * n_0 * cos_0);
    return q.imag() < 0.0 ? -q : q;
}

std::vector<Complex> indices(const spectral::OpticalConstants& medium,
                             const std::vector<double>& wavelengths_nm)
{
    std::vector<Complex> n(wavelengths_nm.size());
    std::ranges::transform(wavelengths_nm, n.begin(), [&](double nm) { return medium.at(nm); });
    return n;
}

[[noreturn]] void refuse(std::size_t medium, std::string message)
{
    throw InputError(
        {.file = {}, .field = fmt::format("n[{}]", medium), .message = std::move(message)});
}

}  // namespace

StackSamples::StackSamples(const DispersiveStack& stack, std::vector<double> wavelengths_nm)
    : wavelengths_nm_(std::move(wavelengths_nm)), coherent_(stack.coherent)
{
    assert(stack.media.size() == stack.coherent.size() + 2);
    n_.reserve(stack.media.size());
    for (std::size_t m = 0; m < stack.media.size(); ++m) {
        const auto known =
            std::find(stack.media.begin(), stack.media.begin() + static_cast<std::ptrdiff_t>(m),
                      stack.media[m]);
        const auto same = static_cast<std::size_t>(known - stack.media.begin());
        try {
            n_.push_back(same < m && same != 0 ? n_[same]
                                               : indices(*stack.media[m], wavelengths_nm_));
        } catch (const InputError& error) {
            refuse(m, error.diagnostics().front().message);
        }
    }
    for (Complex& n : n_.front()) {
        if (n.imag() > kTraceOfK)
            refuse(0, fmt::format("must not absorb in the ambient: k must be ≤ {} (got {:.3g})",
                                  kTraceOfK, n.imag()));
        n = n.real();
    }
    const std::vector<double> none(coherent_.size(), 0.0);
    for (std::size_t i = 0; i < size(); ++i)
        if (const auto problem = validate(at(none, i, none.size())))
            refuse(static_cast<std::size_t>(problem->index),
                   fmt::format("{} at {:g} nm", problem->message, wavelengths_nm_[i]));
}

FilmStack StackSamples::at(std::span<const double> thickness_nm, std::size_t wavelength,
                           std::size_t layers) const
{
    FilmStack stack{
        .ambient = n_.front()[wavelength], .layers = {}, .substrate = n_[layers + 1][wavelength]};
    stack.layers.reserve(layers);
    for (std::size_t j = 0; j < layers; ++j)
        stack.layers.push_back({.n = n_[j + 1][wavelength],
                                .thickness_nm = thickness_nm[j],
                                .coherent = coherent_[j]});
    return stack;
}

LaneStack StackSamples::lanes(std::span<const double> thickness_nm, double cos_ambient,
                              std::size_t first, std::size_t layers) const
{
    LaneStack stack;
    stack.cos_0.fill(cos_ambient);
    stack.layers.resize(layers);
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const std::size_t i = std::min(first + lane, size() - 1);
        stack.n_0[lane] = n_.front()[i].real();
        set(stack.above, lane, n_.front()[i]);
        set(stack.below, lane, n_[layers + 1][i]);
        for (std::size_t j = 0; j < layers; ++j) {
            set(stack.layers[j].n, lane, n_[j + 1][i]);
            stack.layers[j].waves[lane] = thickness_nm[j] / wavelengths_nm_[i];
        }
    }
    return stack;
}

PowerSamples StackSamples::power(std::span<const double> thickness_nm,
                                 const ObliqueLight& light) const
{
    PowerSamples result{std::vector<double>(size()), std::vector<double>(size())};
    const auto mean = [&light](double s, double p) { return p + light.share_of_s * (s - p); };
    const bool coherent = std::ranges::find(coherent_, false) == coherent_.end();
    BatchPower batch;
    for (std::size_t i = 0; i < size(); ++i) {
        const std::size_t lane = i % kLanes;
        if (coherent && lane == 0)
            stack_batch(lanes(thickness_nm, light.cos_ambient, i, coherent_.size()), batch);
        if (coherent && batch.doubt[lane] < kHarmlessDoubt) {
            result.R[i] = mean(batch.s.R[lane], batch.p.R[lane]);
            result.T[i] = mean(batch.s.T[lane], batch.p.T[lane]);
            continue;
        }
        const FilmStack stack = at(thickness_nm, i, coherent_.size());
        const double nm = wavelengths_nm_[i];
        const PowerRatios s = stack_power(stack, light.cos_ambient, nm, Polarisation::s),
                          p = stack_power(stack, light.cos_ambient, nm, Polarisation::p);
        result.R[i] = mean(s.R, p.R);
        result.T[i] = mean(s.T, p.T);
    }
    return result;
}

StackSamples::Passage StackSamples::passage(std::span<const double> thickness_nm,
                                            double cos_ambient) const
{
    Passage result{
        .layers = coherent_.size(), .phase = std::vector<Complex>(size()), .contrast = 0.0};
    const double n_0 = n_.front().front().real();
    Complex above = n_0 * cos_ambient;
    for (std::size_t j = 0; j <= coherent_.size(); ++j) {
        const Complex q = normal_index(n_0, cos_ambient, n_[j + 1].front());
        result.contrast += std::atanh(std::min(std::abs((above - q) / (above + q)), kMostContrast));
        above = q;
    }
    for (std::size_t j = 0; j < coherent_.size(); ++j) {
        std::vector<Complex> sum = result.phase;
        double least = kOpaque;
        for (std::size_t i = 0; i < size(); ++i) {
            const Complex phase = normal_index(n_.front()[i].real(), cos_ambient, n_[j + 1][i]) *
                                  (2.0 * std::numbers::pi * thickness_nm[j] / wavelengths_nm_[i]);
            least = std::min(least, phase.imag());
            sum[i] += phase;
        }
        if (least >= kOpaque) {
            result.layers = j;
            break;
        }
        result.phase = std::move(sum);
    }
    return result;
}

std::array<AmplitudeSamples, 2> StackSamples::amplitudes(std::span<const double> thickness_nm,
                                                         double cos_ambient) const
{
    const Passage through = passage(thickness_nm, cos_ambient);
    const bool opaque = through.layers < coherent_.size();
    for (const Complex& phase : through.phase)
        if (phase.imag() > kAttenuated) return {};
    AmplitudeSamples s, p;
    BatchPower power;
    BatchAmplitudes batch;
    for (std::size_t i = 0; i < size(); ++i) {
        const std::size_t lane = i % kLanes;
        if (lane == 0)
            stack_batch(lanes(thickness_nm, cos_ambient, i, through.layers), power, batch);
        if (power.doubt[lane] > kHarmlessDoubt) return {};
        // 1/t grows with the attenuation, which r = b/a and T do not need.
        const double kept = std::exp(-through.phase[i].imag());
        const auto add = [&](AmplitudeSamples& to, const LaneAmplitudes& from, double T) {
            const Complex a = kept / get(from.t, lane);
            to.a.push_back(a);
            to.b.push_back(a * get(from.r, lane));
            to.tau.push_back(opaque ? 0.0 : T * std::norm(a));
        };
        add(s, batch.s, power.s.T[lane]);
        add(p, batch.p, power.p.T[lane]);
    }
    return {std::move(s), std::move(p)};
}

}  // namespace nacre::optics::detail
