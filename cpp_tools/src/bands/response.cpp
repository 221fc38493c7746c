// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/bands/response.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "eye.h"
#include "nacre/core/diagnostics.h"

namespace nacre::bands {

using spectral::Vec3;

namespace {

/// Of the brightest band, below which a light is none.
constexpr double kDark = 1e-6;

[[noreturn]] void refuse(std::string field, std::string message)
{
    throw InputError({.file = {}, .field = std::move(field), .message = std::move(message)});
}

}  // namespace

std::vector<Vec3> responses(const Bands& bands, const Sensor& sensor)
{
    std::vector<Vec3> result;
    for (const Band& band : bands.bands) {
        Vec3 sum{};
        const auto add = [&sum](double share, const Vec3& sensed) {
            for (std::size_t c = 0; c < 3; ++c) sum[c] += share * sensed[c];
        };
        if (band.is_line)
            add(band.last_nm - band.first_nm, sensor(band.wavelength_nm));
        else
            for (std::size_t i = step_of(band.first_nm); i < step_of(band.last_nm); ++i)
                add(kStepNm, sensor(fine_nm(i)));
        result.push_back(sum);
    }
    return result;
}

Bands seen_by(const Bands& bands, spectral::ObserverId observer)
{
    const Eye& seen = eye(observer);
    const std::vector<Vec3> xyz = responses(bands, [&seen](double nm) { return seen.at(nm); });
    Bands result = bands;
    result.observer = observer;
    for (std::size_t k = 0; k < result.size(); ++k) result.bands[k].xyz = xyz[k];
    return result;
}

Bands bands_of(std::span<const double> edges_nm, std::span<const double> wavelength_nm,
               const std::vector<bool>& is_line, spectral::ObserverId observer)
{
    const std::size_t count = wavelength_nm.size();
    if (count == 0 || count > kMostBands || edges_nm.size() != count + 1 || is_line.size() != count)
        refuse("bands", fmt::format("must be 1 … {} with one edge more (got {} and {} edges)",
                                    kMostBands, count, edges_nm.size()));
    Bands made{.observer = observer, .bands = {}};
    for (std::size_t k = 0; k < count; ++k) {
        const Band band{.first_nm = edges_nm[k],
                        .last_nm = edges_nm[k + 1],
                        .wavelength_nm = wavelength_nm[k],
                        .xyz = {},
                        .is_line = is_line[k]};
        if (!(step_of(band.first_nm) < step_of(band.last_nm)))
            refuse("edges_nm", fmt::format("must ascend by 0.1 nm or more (got {} and {})",
                                           band.first_nm, band.last_nm));
        if (!(band.wavelength_nm >= band.first_nm && band.wavelength_nm <= band.last_nm))
            refuse("wavelength_nm", fmt::format("must be within its band, {} … {} (got {})",
                                                band.first_nm, band.last_nm, band.wavelength_nm));
        made.bands.push_back(band);
    }
    if (step_of(edges_nm.front()) != 0 || step_of(edges_nm.back()) != kFineWavelengths)
        refuse("edges_nm", fmt::format("must be from {} to {} (got {} … {})", spectral::kFirstNm,
                                       spectral::kLastNm, edges_nm.front(), edges_nm.back()));
    return seen_by(made, observer);
}

Bands bands_around(std::span<const double> wavelength_nm, spectral::ObserverId observer)
{
    std::vector<double> edges{double{spectral::kFirstNm}};
    for (std::size_t k = 1; k < wavelength_nm.size(); ++k)
        edges.push_back(0.5 * (wavelength_nm[k - 1] + wavelength_nm[k]));
    edges.push_back(double{spectral::kLastNm});
    return bands_of(edges, wavelength_nm, std::vector<bool>(wavelength_nm.size()), observer);
}

std::vector<double> exchange(const Bands& bands, std::span<const double> power,
                             std::string_view name, const Light& light)
{
    const auto brightness = [&bands](std::span<const double> values) {
        return bands.xyz(values)[1];
    };
    const std::vector<double> wanted = light_in_bands(bands, light);
    const double before = brightness(power), after = brightness(wanted);
    const double dark = kDark * *std::ranges::max_element(power);
    const double little = kDark * *std::ranges::max_element(wanted);
    std::vector<double> factors(bands.size());
    for (std::size_t k = 0; k < bands.size(); ++k) {
        if (power[k] > dark)
            factors[k] = wanted[k] / after / (power[k] / before);
        else if (wanted[k] > little)
            refuse(light.name,
                   fmt::format("shines at {:.4g} nm, where {} has no light that could be turned "
                               "into it: render under a light that has all wavelengths, such as E",
                               bands.bands[k].wavelength_nm, name));
    }
    return factors;
}

}  // namespace nacre::bands
