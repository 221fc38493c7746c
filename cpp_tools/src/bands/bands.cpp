// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/bands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "eye.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"

namespace nacre::bands {

using spectral::SpectralLine, spectral::Vec3;

namespace {

constexpr int kFewestBands = 3;          ///< one pass
constexpr double kBandsOfFringe = 3.75;  ///< that can tell it; fewer are as good with its mean

/// Steps of the fine grid.
struct Span {
    std::size_t first, end;
    std::vector<SpectralLine> lines = {};  ///< it was made for

    [[nodiscard]] std::size_t size() const noexcept { return end - first; }
};

/// Lines nearer to each other than a band of one is wide, together.
std::vector<Span> line_spans(std::span<const Light> lights)
{
    std::vector<SpectralLine> lines;
    for (const Light& light : lights)
        lines.insert(lines.end(), light.lines.begin(), light.lines.end());
    std::ranges::sort(lines, {}, &SpectralLine::wavelength_nm);
    std::vector<Span> spans;
    for (const SpectralLine& line : lines) {
        const double nm = line.wavelength_nm;
        if (spans.empty() || nm > spans.back().lines.back().wavelength_nm + kLineWidthNm) {
            const std::size_t from = spans.empty() ? 0 : spans.back().end;
            spans.push_back({.first = std::max(from, step_of(nm - 0.5 * kLineWidthNm)), .end = 0});
        }
        spans.back().end = step_of(nm + 0.5 * kLineWidthNm);
        spans.back().lines.push_back(line);
    }
    return spans;
}

/// What is left between lines.
std::vector<Span> spans_between(const std::vector<Span>& lines)
{
    std::vector<Span> between;
    std::size_t from = 0;
    for (const Span& line : lines) {
        if (line.first > from) between.push_back({.first = from, .end = line.first});
        from = line.end;
    }
    if (from < kFineWavelengths) between.push_back({.first = from, .end = kFineWavelengths});
    return between;
}

void add_share(Fine& density, const Fine& root, double share)
{
    const double sum = std::accumulate(root.begin(), root.end(), 0.0);
    if (sum <= 0.0) return;
    for (std::size_t i = 0; i < density.size(); ++i) density[i] += share * root[i] / sum;
}

/// Sums of the density up to each step.
std::vector<double> cumulated_density(std::span<const Light> lights, const Eye& seen)
{
    std::vector<const Fine*> powers;
    for (const Light& light : lights)
        if (!light.power.empty()) powers.push_back(&light.power);
    Fine density(kFineWavelengths, 0.0), root(kFineWavelengths);
    std::ranges::transform(seen.sum, root.begin(), [](double value) { return std::sqrt(value); });
    add_share(density, root, powers.empty() ? 1.0 : 0.5);
    for (const Fine* power : powers) {
        for (std::size_t i = 0; i < root.size(); ++i)
            root[i] = std::sqrt(seen.sum[i] * (*power)[i]);
        add_share(density, root, 0.5 / static_cast<double>(powers.size()));
    }
    std::vector<double> cumulated(kFineWavelengths + 1, 0.0);
    std::partial_sum(density.begin(), density.end(), cumulated.begin() + 1);
    return cumulated;
}

/// How many bands each span gets: one, and of the others by the mass that it has more than that,
/// the largest remainders first.
std::vector<std::size_t> shares(const std::vector<Span>& spans,
                                const std::vector<double>& cumulated, std::size_t bands)
{
    std::vector<double> mass;
    mass.reserve(spans.size());
    for (const Span& span : spans) mass.push_back(cumulated[span.end] - cumulated[span.first]);
    std::vector<std::size_t> given(spans.size(), 1);
    for (std::size_t left = bands - spans.size(); left > 0; --left) {
        // The one whose bands hold the most (Adams's divisors).
        std::size_t most = spans.size();
        double held = -1.0;
        for (std::size_t i = 0; i < spans.size(); ++i) {
            const double each = mass[i] / static_cast<double>(given[i]);
            if (given[i] < spans[i].size() && each > held) most = i, held = each;
        }
        if (most == spans.size()) break;  // unreachable: there are more steps than bands
        ++given[most];
    }
    return given;
}

/// Equal masses, each at least a step wide.
void append_equal(std::vector<Span>& result, const Span& span, std::size_t count,
                  const std::vector<double>& cumulated)
{
    const double low = cumulated[span.first], mass = cumulated[span.end] - low;
    std::size_t from = span.first;
    for (std::size_t k = 1; k <= count; ++k) {
        const double target = low + mass * static_cast<double>(k) / static_cast<double>(count);
        const auto above = std::lower_bound(cumulated.begin(), cumulated.end(), target);
        auto end = static_cast<std::size_t>(above - cumulated.begin());
        if (end > 0 && end < cumulated.size() &&
            target - cumulated[end - 1] < cumulated[end] - target)
            --end;
        end = k == count ? span.end : std::clamp(end, from + 1, span.end - (count - k));
        result.push_back({.first = from, .end = end});
        from = end;
    }
}

Band band_of(const Span& span, const Eye& seen)
{
    Band band{.first_nm = spectral::kFirstNm + kStepNm * static_cast<double>(span.first),
              .last_nm = spectral::kFirstNm + kStepNm * static_cast<double>(span.end),
              .wavelength_nm = 0.0,
              .xyz = {},
              .is_line = !span.lines.empty()};
    double weight = 0.0;
    const auto add = [&](double share, double middle_share, const Vec3& xyz, double nm) {
        for (std::size_t c = 0; c < 3; ++c) band.xyz[c] += share * xyz[c];
        band.wavelength_nm += middle_share * nm;
        weight += middle_share;
    };
    double power = 0.0;
    for (const SpectralLine& line : span.lines) power += line.power;
    const double width = band.last_nm - band.first_nm;
    for (const SpectralLine& line : span.lines)  // a power as wide as the band, of their colour
        add(width * line.power / power, line.power, seen.at(line.wavelength_nm),
            line.wavelength_nm);
    if (!band.is_line)
        for (std::size_t i = span.first; i < span.end; ++i)
            add(kStepNm, seen.sum[i], seen.xyz[i], fine_nm(i));
    band.wavelength_nm /= weight;
    return band;
}

/// Weights of the four nanometres around a wavelength, those of the cubic through them.
void add_cubic(spectral::Sampled& weights, double nm)
{
    const double offset = nm - spectral::kFirstNm;
    const double low = std::clamp(std::floor(offset) - 1.0, 0.0, spectral::kWavelengths - 4.0);
    const auto first = static_cast<std::size_t>(low);
    for (std::size_t i = 0; i < 4; ++i) {
        double weight = 1.0;
        for (std::size_t j = 0; j < 4; ++j)
            if (j != i)
                weight *= (offset - low - static_cast<double>(j)) /
                          (static_cast<double>(i) - static_cast<double>(j));
        weights[first + i] += weight;
    }
}

}  // namespace

Light named_light(std::string_view text)
{
    Light light{.name = std::string(text), .power = {}, .lines = spectral::named_lines(text)};
    if (light.lines.empty()) light.power = spectral::light_spectrum(text).values_at(fine_grid());
    return light;
}

Vec3 Bands::xyz(std::span<const double> values) const noexcept
{
    Vec3 sum{};
    for (std::size_t k = 0; k < bands.size(); ++k)
        for (std::size_t c = 0; c < 3; ++c) sum[c] += bands[k].xyz[c] * values[k];
    return sum;
}

spectral::Sampled film_weights(const Bands& bands, std::size_t band, double optical_thickness_nm)
{
    const Band& of = bands.bands[band];
    spectral::Sampled weights{};
    // One way for all bands: what is off in some of them is made up for in others.
    const double fringes =
        2.0 * optical_thickness_nm * (1.0 / spectral::kFirstNm - 1.0 / spectral::kLastNm);
    if (of.is_line || kBandsOfFringe * fringes <= static_cast<double>(bands.size())) {
        add_cubic(weights, of.wavelength_nm);
        return weights;
    }
    const Eye& seen = eye(bands.observer);
    const std::size_t first = step_of(of.first_nm), end = step_of(of.last_nm);
    double sum = 0.0;
    for (std::size_t i = first; i < end; ++i) sum += seen.sum[i];
    for (std::size_t i = first; i < end; ++i) {
        const double offset = fine_nm(i) - spectral::kFirstNm;
        const auto below = static_cast<std::size_t>(offset);
        const double above = offset - static_cast<double>(below);
        weights[below] += (1.0 - above) * seen.sum[i] / sum;
        weights[below + 1] += above * seen.sum[i] / sum;
    }
    return weights;
}

int fewest_bands(std::span<const Light> lights)
{
    const std::vector<Span> lines = line_spans(lights);
    return std::max(kFewestBands, static_cast<int>(lines.size() + spans_between(lines).size()));
}

Bands make_bands(int count, std::span<const Light> lights, spectral::ObserverId observer)
{
    const int fewest = fewest_bands(lights);
    if (count < fewest || count > kMostBands)
        throw InputError(
            {.file = {},
             .field = "bands",
             .message = fmt::format("must be {} … {}{} (got {})", fewest, kMostBands,
                                    fewest > kFewestBands ? ", for all the lines" : "", count)});
    std::vector<Span> spans = line_spans(lights);
    const std::vector<Span> between = spans_between(spans);
    const Eye& seen = eye(observer);
    const std::vector<double> cumulated = cumulated_density(lights, seen);
    const std::vector<std::size_t> given =
        shares(between, cumulated, static_cast<std::size_t>(count) - spans.size());
    for (std::size_t i = 0; i < between.size(); ++i)
        append_equal(spans, between[i], given[i], cumulated);
    std::ranges::sort(spans, {}, &Span::first);
    Bands made{.observer = observer, .bands = {}};
    for (const Span& span : spans) made.bands.push_back(band_of(span, seen));
    return made;
}

}  // namespace nacre::bands
