// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <functional>
#include <mutex>

#include "films/colour_error.h"
#include "films/column.h"

namespace nacre::lut {

/// Where the error counts: up to 87°. Closer to grazing incidence every surface turns into a mirror
/// within a few columns, and where the film also vanishes the colour has no limit at all: (0, 0)
/// is R = 1 along one axis and R = 0 along the other. On a sphere this is the outer 0.13 % of the
/// radius.
inline constexpr double kLeastCountedCosine = 0.05;

struct TableSize {
    int width, height;
};

/// Reports work done to the caller's function, one thread at a time.
/// A caller who answers false is obeyed by throwing Cancelled out of the next step.
class Progress {
public:
    struct Cancelled {};

    explicit Progress(const std::function<bool(double)>& report) : report_(report) {}

    /// The next `steps` steps take this share of what is left.
    void stage(double share, std::size_t steps);
    void step();

private:
    const std::function<bool(double)>& report_;
    std::mutex mutex_;
    double done_ = 0.0, per_step_ = 0.0;
};

/// Everything a baker needs about a request, prepared once.
struct Baker {
    explicit Baker(const FilmTableRequest& asked)
        : request(asked), spectral(asked), error(asked.weights.to_xyz_d65), progress(asked.progress)
    {}

    /// Of this thread.
    [[nodiscard]] const Column& column(double cos_theta) const
    {
        return columns_.local().turn_to(cos_theta);
    }

    const FilmTableRequest& request;
    SpectralBlocks spectral;
    ColourError error;
    Progress progress;

    [[nodiscard]] double first_value() const
    {
        return request.variation ? request.variation->min : 0.0;
    }
    [[nodiscard]] double last_value() const
    {
        return request.variation ? request.variation->max : 0.0;
    }
    /// The larger of the errors of what is baked.
    [[nodiscard]] double difference(const FilmColour& a, const FilmColour& b) const;

private:
    mutable tbb::enumerable_thread_specific<Column> columns_{[this] { return Column(spectral); }};
};

/// (1 − t) a + t b
[[nodiscard]] FilmColour mix(const FilmColour& a, const FilmColour& b, double t) noexcept;
[[nodiscard]] FilmColour midpoint(const FilmColour& a, const FilmColour& b) noexcept;

/// The error that the largest table has is not allowed.
[[noreturn]] void refuse_tolerance(const FilmTableRequest& request, double error);

/// First guess at a size that meets the tolerance: each axis is refined alone, on a few lines
/// across it, until what linear interpolation loses half-way between texels is below its share.
/// @throws InputError when an axis alone is over the tolerance with as many texels as it may have
[[nodiscard]] TableSize estimate_size(Baker& baker);

/// Next number of texels for an axis whose error is too large; the error of linear interpolation
/// goes with the square of the step. Always grows.
[[nodiscard]] int refined(int texels, double error, double allowed, int limit);

}  // namespace nacre::lut
