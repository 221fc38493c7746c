// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "eye.h"

#include <algorithm>
#include <cmath>

namespace nacre::bands {

using spectral::ObserverId, spectral::Vec3;

namespace {

double sampled_at(const spectral::Sampled& values, double nm)
{
    const double offset = nm - spectral::kFirstNm;
    const auto i = std::min(static_cast<std::size_t>(offset), spectral::kWavelengths - 2);
    return values[i] + (offset - static_cast<double>(i)) * (values[i + 1] - values[i]);
}

Eye make_eye(ObserverId observer)
{
    Eye made{.xyz = {}, .sum = {}, .observer = observer, .per_y = 1.0};
    double sum_y = 0.0;
    for (const double nm : fine_grid()) {
        made.xyz.push_back(made.at(nm));
        sum_y += made.xyz.back()[1];
    }
    made.per_y = 1.0 / (sum_y * kStepNm);
    for (Vec3& xyz : made.xyz) {
        made.sum.push_back(xyz[0] + xyz[1] + xyz[2]);
        for (double& value : xyz) value *= made.per_y;
    }
    return made;
}

}  // namespace

Vec3 Eye::at(double nm) const noexcept
{
    const spectral::Observer& tables = spectral::observer(observer);
    return {sampled_at(tables.x, nm) * per_y, sampled_at(tables.y, nm) * per_y,
            sampled_at(tables.z, nm) * per_y};
}

const Eye& eye(ObserverId observer)
{
    static const Eye of_1931 = make_eye(ObserverId::cie1931);
    static const Eye of_1964 = make_eye(ObserverId::cie1964);
    return observer == ObserverId::cie1931 ? of_1931 : of_1964;
}

std::size_t step_of(double nm) noexcept
{
    const double step = std::round((nm - spectral::kFirstNm) / kStepNm);
    return static_cast<std::size_t>(std::clamp(step, 0.0, static_cast<double>(kFineWavelengths)));
}

const std::vector<double>& fine_grid()
{
    static const std::vector<double> grid = [] {
        std::vector<double> nm(kFineWavelengths);
        for (std::size_t i = 0; i < kFineWavelengths; ++i) nm[i] = fine_nm(i);
        return nm;
    }();
    return grid;
}

}  // namespace nacre::bands
