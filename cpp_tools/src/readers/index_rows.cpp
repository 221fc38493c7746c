// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "index_rows.h"

#include <fmt/format.h>

#include <algorithm>

namespace nacre::spectral {

namespace {

/// Rows of one kind of fault.
class Faults {
public:
    void add(const IndexRow& row)
    {
        if (count_ == 0 || row.line < first_line_) first_line_ = row.line;
        lowest_k_ = std::min(lowest_k_, row.k);
        ++count_;
    }
    void tell(std::vector<std::string>& changes, std::string_view what, bool with_k) const
    {
        if (count_ == 0) return;
        changes.push_back(fmt::format("{} ({} {}, the first in line {}{})", what, count_,
                                      count_ == 1 ? "row" : "rows", first_line_,
                                      with_k ? fmt::format(", k down to {:g}", lowest_k_) : ""));
    }

private:
    int first_line_ = 0;
    std::size_t count_ = 0;
    double lowest_k_ = 0.0;
};

Faults sort_rows(std::vector<IndexRow>& rows)
{
    Faults out_of_order;
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (rows[i].wavelength < rows[i - 1].wavelength) out_of_order.add(rows[i]);
    std::ranges::stable_sort(rows, {}, &IndexRow::wavelength);
    return out_of_order;
}

Faults drop_repeated(std::vector<IndexRow>& rows)
{
    Faults repeated;
    double previous = 0.0;
    std::erase_if(rows, [&](const IndexRow& row) {
        const bool again = row.wavelength == previous;
        if (again) repeated.add(row);
        previous = row.wavelength;
        return again;
    });
    return repeated;
}

}  // namespace

std::vector<std::string> mend_rows(std::vector<IndexRow>& rows)
{
    std::vector<std::string> changes;
    sort_rows(rows).tell(changes, "sorted by wavelength", false);
    drop_repeated(rows).tell(changes, "second row of a repeated wavelength left out", false);
    Faults noise, gain;
    std::erase_if(rows, [&](IndexRow& row) {
        if (row.k >= 0.0) return false;
        const bool is_noise = row.k >= kLeastNoiseOfK;
        (is_noise ? noise : gain).add(row);
        if (is_noise) row.k = 0.0;
        return !is_noise;
    });
    noise.tell(changes, "k < 0 taken as 0", true);
    gain.tell(changes, "k < 0 left out", true);
    return changes;
}

}  // namespace nacre::spectral
