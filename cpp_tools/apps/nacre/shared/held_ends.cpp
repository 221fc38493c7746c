// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "shared/held_ends.h"

#include <CLI/CLI.hpp>

#include "shared/session.h"

namespace nacre::tool {

void add_strict_range(CLI::App& command, bool& strict)
{
    command.add_flag("--strict-range", strict,
                     "refuse media whose data do not cover 360 ... 830 nm; else n and k are held "
                     "at the ends of data that cover 400 ... 700 nm, with a note");
}

spectral::RangeRule range_rule(bool strict) noexcept
{
    return strict ? spectral::RangeRule::strict : spectral::RangeRule::hold_ends;
}

void note_held(const Session& session, const std::vector<spectral::HeldEnds>& held)
{
    for (const spectral::HeldEnds& ends : held) session.note(ends.note());
}

nlohmann::ordered_json held_json(const std::vector<spectral::HeldEnds>& held)
{
    auto list = nlohmann::ordered_json::array();
    for (const spectral::HeldEnds& ends : held)
        list.push_back({{"medium", ends.medium},
                        {"range_nm", ends.range_nm},
                        {"percent", ends.percent},
                        {"note", ends.note()}});
    return list;
}

}  // namespace nacre::tool
