// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "library/plot.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "colour/target.h"
#include "nacre/library/lights.h"
#include "nacre/media/working_range.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/gamut.h"
#include "plot/colours.h"

namespace nacre::tool {
namespace {

using spectral::Complex;
using spectral::Medium;
using spectral::NamedSpectrum;
using spectral::OpticalConstantsPtr;
using spectral::RangeRule;
using spectral::Sampled;
using spectral::Vec3;
using spectral::WorkingRange;

constexpr Paint kBlue = {0.08, 0.33, 0.62};
constexpr Paint kRed = {0.75, 0.22, 0.13};
constexpr auto kEye = spectral::ObserverId::cie1931;

/// What of a range is shown: 300 … 1000 nm, or all where it has nothing of that.
std::array<double, 2> shown(double first, double last)
{
    const double low = std::max(first, 300.0), high = std::min(last, 1000.0);
    if (low < high) return {low, high};
    return {first, last};
}

/// Each nanometre and both ends; a wide range in as many steps.
std::vector<double> wavelengths(double first, double last)
{
    constexpr double kMost = 1000.0;
    std::vector<double> result = {first};
    const double step = std::max(1.0, (last - first) / kMost);
    for (int i = 1; i <= static_cast<int>(kMost); ++i) {
        const double nm = std::floor(first) + i * step;
        if (nm > result.back() && nm < last) result.push_back(nm);
    }
    result.push_back(last);
    return result;
}

std::string joined(std::initializer_list<std::string> parts)
{
    std::string text;
    for (const std::string& part : parts)
        if (!part.empty()) text += (text.empty() ? "" : "  ·  ") + part;
    return text;
}

std::string three(const Vec3& numbers)
{
    return fmt::format("{:.3f} {:.3f} {:.3f}", numbers[0], numbers[1], numbers[2]);
}

/// Swatch and numbers of a colour.
void add_colour(Plot& plot, const Vec3& xyz, const Vec3& rgb, const Vec3& screen)
{
    plot.swatch = screen_paint(screen);
    const auto xy = spectral::xyz_to_xy(xyz);
    plot.facts.insert(plot.facts.end(), {{"sRGB", hexadecimal(*plot.swatch)},
                                         {"rgb", three(rgb)},
                                         {"XYZ", three(xyz)},
                                         {"xy", fmt::format("{:.4f} {:.4f}", xy[0], xy[1])}});
}

void add_reflectance(Plot& plot, const Sampled& reflectance)
{
    const auto light = spectral::named_illuminant("D65");
    const auto weights =
        spectral::reflectance_weights(light, kEye, spectral::colour_space("lin_rec709_scene"));
    const Vec3 rgb = weights.apply(reflectance);
    add_colour(plot, spectral::reflectance_to_xyz(reflectance, light, kEye), rgb, rgb);
}

void add_emission(Plot& plot, const Sampled& power)
{
    Vec3 xyz = spectral::emission_to_xyz(power, kEye);
    const double luminance = xyz[1];
    if (!(luminance > 0.0)) return;
    for (double& value : xyz) value /= luminance;
    const auto& space = spectral::colour_space("lin_rec709_scene");
    const Vec3 rgb = multiply(space.from_xyz_d65, xyz);
    add_colour(plot, xyz, rgb,
               map_to_gamut(rgb, spectral::GamutMapping::scale, space.to_xyz_d65[1],
                            spectral::ColourOf::light));
    if (const auto white = spectral::colour_temperature(xyz)) {
        plot.facts.push_back({"CCT", fmt::format("{:.0f} K", white->cct_kelvin)});
        plot.facts.push_back({"Duv", fmt::format("{:+.4f}", white->duv)});
    }
}

/// From a round number to another around all values; of one value some room around it.
Axis axis_around(const std::vector<double>& values, double low, double from, double to)
{
    const auto [least, most] = std::ranges::minmax(values);
    low = std::min(low, least);
    constexpr double kFlat = 1e-9;  // less is no more than rounding
    const double size = std::max(std::abs(low), std::abs(most));
    const double room = most - low > kFlat * size ? 0.0 : 0.1 * std::max(1.0, size);
    return Axis::rounded(low - room, most + room, from, to);
}

Axis vertical_axis(const std::vector<double>& values, double low)
{
    return axis_around(values, low, kPlotArea.bottom, kPlotArea.top);
}

/// Logarithmic where k spans more than two decades.
Axis absorption_axis(const std::vector<double>& k)
{
    double least = std::ranges::max(k);
    const double most = least;
    for (const double value : k)
        if (value > 0.0) least = std::min(least, value);
    if (most <= 100.0 * least) return vertical_axis(k, 0.0);
    constexpr double kDeepest = 1e-10;  // of the highest
    return Axis::decades(std::max(least, most * kDeepest), most, kPlotArea.bottom, kPlotArea.top);
}

/// At normal incidence from air; with held ends.
Sampled surface_reflectance(const OpticalConstantsPtr& medium)
{
    const auto index = WorkingRange(RangeRule::hold_ends).cover(medium)->on_grid();
    Sampled reflectance;
    std::ranges::transform(index, reflectance.begin(),
                           [](Complex n) { return std::norm((n - 1.0) / (n + 1.0)); });
    return reflectance;
}

/// What a surface reflects, where the data are enough for a colour.
void add_surface(Plot& plot, const Medium& medium)
{
    if (range_problem(*medium.constants, RangeRule::hold_ends)) return;
    plot.caption = "reflects at normal incidence, under D65";
    add_reflectance(plot, surface_reflectance(medium.constants));
    if (const auto held = held_ends(medium, spectral::named_illuminant("D65"), kEye))
        plot.facts.push_back({"held", held->share() + " of Y"});
}

/// Of glass: n at the lines d, F and C, and the Abbe number.
void add_dispersion(Plot& plot, const Medium& medium)
{
    const auto n = [&medium](double nm) { return medium.constants->at(nm).real(); };
    const double blue = n(486.1327), yellow = n(587.5618), red = n(656.2725);
    plot.facts.push_back({"n_d", fmt::format("{:.5f}", yellow)});
    plot.facts.push_back({"n_F", fmt::format("{:.5f}", blue)});
    plot.facts.push_back({"n_C", fmt::format("{:.5f}", red)});
    if (blue != red)
        plot.facts.push_back({"V_d", fmt::format("{:.2f}", (yellow - 1.0) / (blue - red))});
}

std::string title_of(const std::string& name, const std::string& key)
{
    return name.empty() ? key : name;
}

}  // namespace

Plot plot_of(const NamedSpectrum& spectrum)
{
    const bool emission = spectrum.kind == spectral::SpectrumKind::emission;
    Plot plot;
    plot.title = title_of(spectrum.name, spectrum.key);
    plot.subtitle =
        joined({spectrum.key, emission ? "emission" : "reflectance", spectrum.comments});
    plot.citation = joined({spectrum.references, spectrum.licence});
    const auto [first, last] = shown(spectrum.samples.first_nm(), spectrum.samples.last_nm());
    plot.wavelengths_nm = wavelengths(first, last);
    std::vector<double> values = spectrum.values_at(plot.wavelengths_nm);
    Axis axis = vertical_axis(values, 0.0);
    plot.curves.push_back(
        {emission ? "relative power" : "reflectance", std::move(values), std::move(axis), kInk});
    plot.filled = true;
    if (last < spectral::kFirstNm || first > spectral::kLastNm) return plot;
    plot.caption = emission ? "chromaticity, Y = 1" : "under D65";
    if (emission)
        add_emission(plot, spectrum.on_grid());
    else
        add_reflectance(plot, spectrum.on_grid());
    return plot;
}

Plot plot_of(const Medium& medium)
{
    Plot plot;
    plot.title = title_of(medium.name, medium.key);
    plot.subtitle =
        joined({medium.key, medium.formula, fmt::format("{}", fmt::join(medium.tags, ", "))});
    plot.citation = medium.references;
    const auto [first, last] = medium.constants->range_nm();
    const auto range = shown(first, last);
    plot.wavelengths_nm = wavelengths(range[0], range[1]);
    std::vector<double> n, k;
    for (const double nm : plot.wavelengths_nm) {
        const Complex index = medium.constants->at(nm);
        n.push_back(index.real());
        k.push_back(index.imag());
    }
    constexpr double kClear = 1e-3;
    const double absorption = std::ranges::max(k);
    Axis n_axis = vertical_axis(n, std::ranges::min(n));
    plot.curves.push_back({"n", std::move(n), std::move(n_axis), kBlue});
    if (absorption > 0.0) {
        Axis axis = absorption_axis(k);
        plot.curves.push_back({"k", std::move(k), std::move(axis), kRed});
    }
    if (absorption > kClear)
        add_surface(plot, medium);
    else if (range[0] <= 486.0 && range[1] >= 657.0)
        add_dispersion(plot, medium);
    return plot;
}

}  // namespace nacre::tool
