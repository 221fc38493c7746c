// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <rapidcheck.h>

#include <ostream>

#include "nacre/optics/multilayer.h"

/// @file
/// Random stacks for properties that hold for all of them.

namespace nacre::optics {

/// A stack and the light on it.
struct LitStack {
    FilmStack stack;
    double cos_ambient, wavelength_nm;
};

inline void showValue(const LitStack& lit, std::ostream& out)  // NOLINT: RapidCheck's name
{
    out.precision(17);
    out << "cosine " << lit.cos_ambient << ", " << lit.wavelength_nm
        << " nm: " << lit.stack.ambient;
    for (const Layer& layer : lit.stack.layers)
        out << " | " << layer.n << ' ' << layer.thickness_nm << (layer.coherent ? " nm" : " nm i");
    out << " | " << lit.stack.substrate;
}

namespace test {

/// Evenly spread, whatever RapidCheck's size is; shrinks towards `low`.
inline rc::Gen<double> between(double low, double high)
{
    constexpr int kSteps = 1 << 30;
    return rc::gen::map(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, kSteps + 1)),
                        [=](int step) { return low + (high - low) * step / kSteps; });
}

/// Indices of films: clear ones, weak absorbers and metals.
inline rc::Gen<Complex> index_of_clear()
{
    return rc::gen::map(between(1.2, 2.8), [](double n) { return Complex(n, 0.0); });
}
inline rc::Gen<Complex> index_of_any()
{
    const auto complex = [](double n_low, double n_high, double k_low, double k_high) {
        return rc::gen::apply([](double n, double k) { return Complex(n, k); },
                              between(n_low, n_high), between(k_low, k_high));
    };
    return rc::gen::oneOf(index_of_clear(), complex(1.2, 2.8, 0.0, 0.1),
                          complex(0.05, 4.0, 0.5, 7.0));
}

inline rc::Gen<Layer> layer(const rc::Gen<Complex>& index, double thickest_nm)
{
    return rc::gen::apply(
        [](Complex n, double d_nm) {
            return Layer{n, d_nm, true};
        },
        index, between(0.0, thickest_nm));
}

inline rc::Gen<LitStack> lit_stack(const rc::Gen<Complex>& index, const rc::Gen<Complex>& substrate,
                                   double thickest_nm = 400.0)
{
    return rc::gen::apply(
        [](double ambient, std::vector<Layer> layers, Complex below, double cosine, double nm) {
            if (layers.size() > kMaxLayers) layers.resize(kMaxLayers);
            return LitStack{{ambient, std::move(layers), below}, cosine, nm};
        },
        between(1.0, 1.8), rc::gen::container<std::vector<Layer>>(layer(index, thickest_nm)),
        substrate, between(0.02, 1.0), between(360.0, 830.0));
}
inline rc::Gen<LitStack> clear_stack()
{
    return lit_stack(index_of_clear(), index_of_clear());
}
inline rc::Gen<LitStack> any_stack()
{
    return lit_stack(index_of_any(), index_of_any());
}

}  // namespace test
}  // namespace nacre::optics
