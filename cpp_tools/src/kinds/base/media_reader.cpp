// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/media_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "nacre/library/media_library.h"

namespace nacre::kinds {
namespace {

using spectral::OpticalConstantsPtr;

struct Build {
    OpticalConstantsPtr operator()(const material::LibraryMedium& medium) const
    {
        return spectral::library_medium(medium.key).constants;
    }
    OpticalConstantsPtr operator()(const material::ConstantMedium& medium) const
    {
        return spectral::constant_index({medium.n, medium.k});
    }
    OpticalConstantsPtr operator()(const material::CauchyMedium& medium) const
    {
        std::vector<double> c = medium.coefficients;
        c.resize(3, 0.0);
        return spectral::cauchy(c[0], c[1], c[2], medium.k);
    }
    OpticalConstantsPtr operator()(const material::SellmeierMedium& medium) const
    {
        return spectral::sellmeier(medium.b, medium.c);
    }
    OpticalConstantsPtr operator()(const material::AbbeMedium& medium) const
    {
        return spectral::abbe(medium.n_d, medium.v_d);
    }
};

lut::IndexOnGrid unit_index()
{
    lut::IndexOnGrid result;
    result.fill(1.0);
    return result;
}

}  // namespace

void MediaReader::report(const material::MediumSpec& spec, const InputError& error)
{
    for (const Diagnostic& problem : error.diagnostics())
        problems_.add({file_, spec.line, spec.field, problem.message});
}

OpticalConstantsPtr MediaReader::constants(const material::MediumSpec& spec)
{
    try {
        return range_.cover(std::visit(Build{}, spec.value));
    } catch (const InputError& error) {
        report(spec, error);
        return nullptr;
    }
}

lut::IndexOnGrid MediaReader::on_grid(const material::MediumSpec& spec)
{
    const OpticalConstantsPtr medium = constants(spec);
    if (!medium) return unit_index();
    try {
        return medium->on_grid();
    } catch (const InputError& error) {
        report(spec, error);
        return unit_index();
    }
}

lut::IndexOnGrid MediaReader::clear_on_grid(const material::MediumSpec& spec, double max_k)
{
    lut::IndexOnGrid index = on_grid(spec);
    double largest = 0.0;
    for (const auto& n : index) largest = std::max(largest, n.imag());
    if (largest > max_k)
        problems_.add(
            {file_, spec.line, spec.field,
             fmt::format("must not absorb: k must be ≤ {} (got up to {:.3g})", max_k, largest)});
    for (auto& n : index) n = n.real();
    return index;
}

}  // namespace nacre::kinds
