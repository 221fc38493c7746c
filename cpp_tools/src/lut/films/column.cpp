// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "films/column.h"

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "nacre/core/vector_clones.h"

namespace nacre::lut {
namespace {

using optics::kLanes;
using optics::Lanes;
using optics::LanesOf;
using optics::SingleLanes;

/// Rows that are computed together: their lanes stay in the first-level cache.
template <class Real>
constexpr std::size_t kRows = 128 / sizeof(Real);
/// Bytes of a vector of sums.
constexpr std::size_t kVectorBytes = 32;
template <class Real>
constexpr std::size_t kAccumulators = kVectorBytes / sizeof(Real);

/// At grazing incidence cosθ = 0 the coefficients of T are 0/0; this close to it R and T equal
/// their limits (1 and 0, or 0 and 1 for matched indices) to single precision.
constexpr double kLeastCosine = 1e-10;
/// Below it a film in resonance has a denominator that single precision takes for 0.
constexpr double kLeastSingleCosine = 1.0 / 32.0;

/// Weighted sums of one row, spread over independent accumulators in a fixed order: the result
/// depends neither on the instruction set nor on the number of threads.
template <class Real>
struct RowSums {
    std::array<std::array<Real, kAccumulators<Real>>, 6> part{};
};

template <class Real>
NACRE_INLINE void add_row(RowSums<Real>& sums, const LanesOf<Real>& R, const LanesOf<Real>& T,
                          const std::array<LanesOf<Real>, 3>& weight)
{
    using V [[gnu::vector_size(kVectorBytes)]] = Real;
    const auto load = [](V& value, const Real* from) { std::memcpy(&value, from, sizeof value); };
    V sum[6];
    std::memcpy(&sum, &sums.part, sizeof sum);
    for (std::size_t i = 0; i < kLanes; i += kAccumulators<Real>) {
        V R_i, T_i;
        load(R_i, &R[i]);
        load(T_i, &T[i]);
        for (std::size_t c = 0; c < 3; ++c) {
            V w;
            load(w, &weight[c][i]);
            sum[c] += w * R_i;
            sum[3 + c] += w * T_i;
        }
    }
    static_assert(sizeof sum == sizeof sums.part);
    std::memcpy(&sums.part, &sum, sizeof sum);
}
NACRE_VECTOR_CLONES void add_weighted(RowSums<double>& sums, const Lanes& R, const Lanes& T,
                                      const std::array<Lanes, 3>& weight)
{
    add_row(sums, R, T, weight);
}
NACRE_VECTOR_CLONES void add_weighted(RowSums<float>& sums, const SingleLanes& R,
                                      const SingleLanes& T,
                                      const std::array<SingleLanes, 3>& weight)
{
    add_row(sums, R, T, weight);
}

template <class Real>
FilmColour total(const RowSums<Real>& sums)
{
    FilmColour colour{};
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t j = 0; j < kAccumulators<Real>; ++j) {
            colour.reflectance[c] += static_cast<double>(sums.part[c][j]);
            colour.transmittance[c] += static_cast<double>(sums.part[3 + c][j]);
        }
    }
    return colour;
}

void set(optics::ComplexLanes& lanes, std::size_t i, std::complex<double> value)
{
    lanes.re[i] = value.real();
    lanes.im[i] = value.imag();
}

SpectralBlocks::Block make_block(const FilmTableRequest& request, std::size_t first)
{
    const SampledStack& stack = request.stack;
    SpectralBlocks::Block block;
    block.first = first;
    block.stack.layers.resize(stack.layers.size());
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::size_t k = std::min(first + i, spectral::kWavelengths - 1);
        const bool padding = first + i >= spectral::kWavelengths;
        const double inverse = 1.0 / spectral::wavelength_nm(k);
        block.inverse_wavelength[i] = inverse;
        for (std::size_t c = 0; c < 3; ++c) {
            block.weight[c][i] = padding ? 0.0 : request.weights.weight[c][k];
            block.single_weight[c][i] = static_cast<float>(block.weight[c][i]);
        }
        block.stack.n_0[i] = stack.ambient[k].real();
        set(block.stack.above, i, stack.ambient[k]);
        set(block.stack.below, i, stack.substrate[k]);
        for (std::size_t j = 0; j < stack.layers.size(); ++j) {
            set(block.stack.layers[j].n, i, stack.layers[j].n[k]);
            block.stack.layers[j].waves[i] = stack.layers[j].thickness_nm * inverse;
        }
    }
    return block;
}

bool has_weight(const spectral::ColourWeights& weights, std::size_t first)
{
    const std::size_t end = std::min(first + kLanes, spectral::kWavelengths);
    for (std::size_t i = first; i < end; ++i)
        for (const spectral::Sampled& channel : weights.weight)
            if (channel[i] != 0.0) return true;
    return false;
}

bool all_coherent(const SpectralBlocks& spectral)
{
    return std::find(spectral.coherent.begin(), spectral.coherent.end(), false) ==
           spectral.coherent.end();
}

/// Cells of 1 nm.
optics::FilmModelStack::Setup setup(const SpectralBlocks& spectral,
                                    const SpectralBlocks::Block& block)
{
    optics::FilmModelStack::Setup result{
        .model = spectral.technique->model,
        .varying = spectral.variation ? spectral.variation->layer : std::nullopt,
        .from_below = spectral.technique->from_below,
        .half_cell = {}};
    for (std::size_t i = 0; i < kLanes; ++i)
        result.half_cell[i] = 0.5 * block.inverse_wavelength[i];
    return result;
}

void scale(Lanes& lanes, double factor)
{
    for (double& value : lanes) value *= factor;
}

}  // namespace

SpectralBlocks::SpectralBlocks(const FilmTableRequest& request) : variation(request.variation)
{
    for (const SampledLayer& layer : request.stack.layers) coherent.push_back(layer.coherent);
    if (!request.stack.layers.empty()) technique = request.technique;
    for (std::size_t first = 0; first < spectral::kWavelengths; first += optics::kLanes)
        if (has_weight(request.weights, first)) blocks.push_back(make_block(request, first));
}

Column::Column(const SpectralBlocks& spectral) : spectral_(&spectral)
{
    const auto varying = spectral.variation ? spectral.variation->layer : std::nullopt;
    for (const SpectralBlocks::Block& block : spectral.blocks) {
        optics::LaneStack stack = block.stack;
        stack.cos_0.fill(1.0);
        if (spectral.technique)
            blocks_.emplace_back(std::in_place_type<optics::FilmModelStack>, stack,
                                 setup(spectral, block));
        else if (!all_coherent(spectral))
            blocks_.emplace_back(std::in_place_type<optics::MixedStack>, stack, spectral.coherent,
                                 varying);
        else if (varying)
            blocks_.emplace_back(std::in_place_type<optics::PhaseMap>, stack, *varying);
        else
            blocks_.emplace_back(std::in_place_type<optics::ScaledStack>, stack);
    }
}

Column& Column::turn_to(double cos_theta)
{
    grazing_ = cos_theta < kLeastSingleCosine;
    Lanes cos_0;
    cos_0.fill(std::max(cos_theta, kLeastCosine));
    for (auto& block : blocks_) std::visit([&](auto& stack) { stack.turn_to(cos_0); }, block);
    return *this;
}

template <class Real>
void Column::rows(std::size_t b, double first, double step, std::span<LanesOf<Real>> R,
                  std::span<LanesOf<Real>> T) const
{
    const auto& block = blocks_[b];
    if (spectral_->variation && spectral_->variation->layer) {
        Lanes start = spectral_->blocks[b].inverse_wavelength, stride = start;
        scale(start, first);
        scale(stride, step);
        if (const auto* map = std::get_if<optics::PhaseMap>(&block))
            map->march(start, stride, R, T);
        if constexpr (std::is_same_v<Real, double>) {
            if (const auto* mixed = std::get_if<optics::MixedStack>(&block))
                mixed->march(start, stride, R, T);
            if (const auto* form = std::get_if<optics::FilmModelStack>(&block))
                form->march(start, stride, R, T);
        }
        return;
    }
    if (!spectral_->variation) {
        first = 1.0;
        step = 0.0;
    }
    if (const auto* scaled = std::get_if<optics::ScaledStack>(&block))
        scaled->march(first, step, R, T);
    if constexpr (std::is_same_v<Real, double>) {
        if (const auto* mixed = std::get_if<optics::MixedStack>(&block))
            mixed->march(first, step, R, T);
        if (const auto* form = std::get_if<optics::FilmModelStack>(&block))
            form->march(first, step, R, T);
    }
}

template <class Real>
void Column::evaluate_in(double first, double step, std::span<FilmColour> out) const
{
    const auto weights = [this](std::size_t b) -> const std::array<LanesOf<Real>, 3>& {
        if constexpr (std::is_same_v<Real, double>)
            return spectral_->blocks[b].weight;
        else
            return spectral_->blocks[b].single_weight;
    };
    std::array<LanesOf<Real>, kRows<Real>> R, T;
    for (std::size_t start = 0; start < out.size(); start += kRows<Real>) {
        const std::size_t count = std::min(kRows<Real>, out.size() - start);
        std::array<RowSums<Real>, kRows<Real>> sums{};
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            rows<Real>(b, first + static_cast<double>(start) * step, step,
                       std::span(R).first(count), std::span(T).first(count));
            for (std::size_t row = 0; row < count; ++row)
                add_weighted(sums[row], R[row], T[row], weights(b));
        }
        for (std::size_t row = 0; row < count; ++row) out[start + row] = total(sums[row]);
    }
}

void Column::visit_reflectance(
    double first, double step, std::size_t count,
    const std::function<void(std::size_t, std::size_t, const Lanes&)>& visit) const
{
    std::array<Lanes, kRows<double>> R, T;
    for (std::size_t start = 0; start < count; start += kRows<double>) {
        const std::size_t here = std::min(kRows<double>, count - start);
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            rows<double>(b, first + static_cast<double>(start) * step, step,
                         std::span(R).first(here), std::span(T).first(here));
            for (std::size_t row = 0; row < here; ++row) visit(start + row, b, R[row]);
        }
    }
}

void Column::evaluate(double first, double step, std::span<FilmColour> out,
                      Precision precision) const
{
    const bool has_single = all_coherent(*spectral_) && !spectral_->technique;
    if (precision == Precision::single_precision && !grazing_ && has_single)
        evaluate_in<float>(first, step, out);
    else
        evaluate_in<double>(first, step, out);
}

}  // namespace nacre::lut
