// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/shapes.h"

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "base/guard.h"
#include "library/spectrum_kind.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/spectral/spectrum_shapes.h"

namespace nacre::capi {
namespace {

using spectral::SpectrumShape;

spectral::Spectrum points_of(const nacre_shape& shape)
{
    require(shape.wavelength_nm, "wavelength_nm");
    require(shape.values, "values");
    return {std::vector(shape.wavelength_nm, shape.wavelength_nm + shape.count),
            std::vector(shape.values, shape.values + shape.count)};
}

SpectrumShape scaled(const nacre_shape& shape)
{
    const double factor = shape.numbers[0];
    if (shape.key != nullptr)
        return spectral::ScaledShape{spectral::library_spectrum(shape.key), factor};
    return spectral::ScaledShape{{.key = {},
                                  .name = {},
                                  .references = {},
                                  .licence = {},
                                  .comments = {},
                                  .tags = {},
                                  .kind = kind_from(shape.of_kind),
                                  .samples = points_of(shape)},
                                 factor};
}

SpectrumShape shape_from(const nacre_shape& shape)
{
    const double* const numbers = shape.numbers;
    switch (shape.kind) {
        case NACRE_CONSTANT:
            return spectral::ConstantShape{numbers[0]};
        case NACRE_BOX:
            return spectral::BoxShape{numbers[0], numbers[1], numbers[2], numbers[3]};
        case NACRE_GAUSSIAN:
            return spectral::GaussianShape{numbers[0], numbers[1], numbers[2]};
        case NACRE_LINEAR:
            return spectral::LinearShape{points_of(shape)};
        case NACRE_SMOOTH:
            return spectral::SmoothShape{points_of(shape)};
        case NACRE_SCALED:
            return scaled(shape);
    }
    fail("kind", "must be a nacre_shape_kind");
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_sum_of_shapes(size_t shapes, const nacre_shape* shape, const char* kind,
                                 size_t count, const double* wavelength_nm, double* values)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(shape, "shape");
        capi::require(wavelength_nm, "wavelength_nm");
        capi::require(values, "values");
        std::vector<spectral::SpectrumShape> all;
        capi::for_each_item(shapes, [&](size_t i) { all.push_back(capi::shape_from(shape[i])); });
        const spectral::Spectrum sum =
            spectral::sum_of_shapes(all, std::vector(wavelength_nm, wavelength_nm + count));
        if (kind != nullptr)
            if (const auto problem = spectral::kind_problem(sum, capi::kind_from(kind)))
                capi::fail("shapes", "the sum does not suit: " + *problem);
        std::ranges::copy(sum.values(), values);
    });
}
}
