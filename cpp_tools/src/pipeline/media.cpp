// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "media.h"

#include <fmt/format.h>

#include <algorithm>
#include <variant>

#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/pipeline/compile.h"

namespace nacre::pipeline {
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

std::optional<double> solid_index(const material::MaterialTemplate& source,
                                  spectral::RangeRule rule)
{
    if (source.interior() != material::Interior::solid) return std::nullopt;
    const auto& stack = std::get<material::StackSpec>(source.kind);
    MediaReader media(source.file, rule);
    const OpticalConstantsPtr substrate = media.constants(stack.substrate),
                              ambient = media.constants(stack.ambient);
    media.throw_if_any();
    return substrate->at(kLineD).real() / ambient->at(kLineD).real();
}

std::vector<spectral::HeldEnds> held_media(const material::MaterialTemplate& source,
                                           const CompileOptions& options)
{
    MediaReader reader(source.file, options.range);
    std::vector<const spectral::Medium*> media;
    for (const material::MediumSpec* spec : source.media()) {
        const auto* named = std::get_if<material::LibraryMedium>(&spec->value);
        if (!named || !reader.constants(*spec)) continue;
        const spectral::Medium* medium = &spectral::library_medium(named->key);
        if (std::ranges::find(media, medium) == media.end()) media.push_back(medium);
    }
    reader.throw_if_any();
    const spectral::Illuminant light = spectral::named_illuminant(options.illuminant);
    std::vector<spectral::HeldEnds> held;
    for (const spectral::Medium* medium : media)
        if (auto ends = held_ends(*medium, light, options.observer))
            held.push_back(std::move(*ends));
    return held;
}

}  // namespace nacre::pipeline
