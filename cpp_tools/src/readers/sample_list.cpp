// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "sample_list.h"

#include <fmt/format.h>

#include <cmath>

#include "nacre/core/limits.h"

namespace nacre::spectral {

bool SampleList::add(int line, std::string_view wavelength_nm, std::string_view value)
{
    if (values_.size() == kMaxSamples) {
        problems_.add(line, {}, fmt::format("must have at most {} samples", kMaxSamples));
        return false;
    }
    const auto nm = number(line, "wavelength", wavelength_nm);
    const auto sample = number(line, "value", value);
    const double before = wavelengths_nm_.empty() ? 0.0 : wavelengths_nm_.back();
    if (nm && !(*nm > before))
        problems_.add(
            line, "wavelength",
            fmt::format("must be > 0 and ascending (got {:g} nm after {:g} nm)", *nm, before));
    wavelengths_nm_.push_back(nm.value_or(before));
    values_.push_back(sample.value_or(0.0));
    return true;
}

std::optional<Spectrum> SampleList::finish()
{
    if (values_.size() < 2 && problems_.empty())
        problems_.add(0, {},
                      fmt::format("must have at least two samples, a wavelength and a value each "
                                  "(got {})",
                                  values_.size()));
    if (!problems_.empty()) return std::nullopt;
    return Spectrum(std::move(wavelengths_nm_), std::move(values_));
}

std::optional<double> SampleList::number(int line, const char* field, std::string_view word)
{
    const auto value = parse_number(word);
    if (value && std::isfinite(*value)) return value;
    problems_.add(line, field, fmt::format("must be a finite number (got '{}')", excerpt(word)));
    return std::nullopt;
}

}  // namespace nacre::spectral
