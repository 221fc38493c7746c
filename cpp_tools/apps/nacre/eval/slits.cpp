// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "eval/records.h"
#include "nacre/optics/film_models.h"

namespace nacre::tool {
namespace {

constexpr const char* kSlitsHelp = R"(
record  {"width_nm": 2000, "spacing_nm": 6000, "angle_deg": 5, "wavelength_nm": 550}
  spacing_nm     between the centres of two slits, at least their width; without it one slit
  angle_deg      away from straight ahead, in [-90, 90] (default 0)
result  {"intensity": …}, far behind the slits, 1 straight ahead

The first dark fringe of two slits:
  echo '{"width_nm": 1000, "spacing_nm": 4000, "angle_deg": 3.94, "wavelength_nm": 550}' |
    nacre eval slits)";

ordered_json evaluate_slits(const json& record)
{
    DiagnosticList problems;
    ObjectReader reader(record, "", problems);
    const auto width = reader.number("width_nm", kPositive);
    const auto angle = reader.number_or("angle_deg", {-90.0, 90.0}, 0.0);
    const auto wavelength = reader.number("wavelength_nm", kPositive);
    const auto spacing = reader.number_or("spacing_nm", kPositive, 0.0);
    reader.refuse_unknown_keys();
    problems.throw_if_any();
    const double sine = std::sin(*angle * std::numbers::pi / 180.0);
    return {{"intensity", optics::slit_intensity(*width, *spacing, sine, *wavelength)}};
}

}  // namespace

void add_eval_slits(CLI::App& eval, Session& session)
{
    add_record_command(eval, session, "slits", "intensity behind one slit or two", kSlitsHelp,
                       evaluate_slits);
}

}  // namespace nacre::tool
