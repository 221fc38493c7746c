// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/spectral/observer.h"

#include <fmt/format.h>

#include <numeric>
#include <stdexcept>

#include "csv_table.h"
#include "nacre/core/diagnostics.h"

namespace nacre::spectral {

namespace {

Observer load_observer(std::string_view path)
{
    const CsvTable table = load_csv(path, 4);
    if (table.columns[0].size() != kWavelengths || table.columns[0].front() != kFirstNm)
        throw std::logic_error(fmt::format("resource {} is not on the 1 nm grid", path));
    Observer observer{};
    std::copy(table.columns[1].begin(), table.columns[1].end(), observer.x.begin());
    std::copy(table.columns[2].begin(), table.columns[2].end(), observer.y.begin());
    std::copy(table.columns[3].begin(), table.columns[3].end(), observer.z.begin());
    observer.sum_y = std::accumulate(observer.y.begin(), observer.y.end(), 0.0);
    return observer;
}

}  // namespace

const Observer& observer(ObserverId id)
{
    static const Observer cie1931 = load_observer("cmf/cie_1931_2deg_1nm.csv");
    static const Observer cie1964 = load_observer("cmf/cie_1964_10deg_1nm.csv");
    return id == ObserverId::cie1931 ? cie1931 : cie1964;
}

ObserverId observer_from_name(std::string_view name)
{
    for (const ObserverId id : {ObserverId::cie1931, ObserverId::cie1964})
        if (name == observer_name(id)) return id;
    throw InputError({.file = {},
                      .field = "observer",
                      .message = fmt::format("must be cie1931 or cie1964 (got '{}')", name)});
}

std::string_view observer_name(ObserverId id) noexcept
{
    return id == ObserverId::cie1931 ? "cie1931" : "cie1964";
}

}  // namespace nacre::spectral
