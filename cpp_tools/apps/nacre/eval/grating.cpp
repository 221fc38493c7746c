// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "eval/records.h"
#include "nacre/optics/grating.h"

namespace nacre::tool {
namespace {

using optics::Direction;

constexpr const char* kGratingHelp = R"(
record  {"pitch_nm": 1600, "grating_vector": [x, y, z], "normal": [x, y, z], "k_in": [x, y, z],
         "wavelength_nm": 550, "orders": [-3, 3],
         "profile": {"kind": "sinusoidal|rectangular|blazed", "phase_rad": 1.5, "duty": 0.5}}
  grating_vector across the grooves; only its part in the surface counts
  k_in           direction of the light, towards the surface; its length does not matter
  profile        what shares the light among the orders: without it the answer is directions alone
  phase_rad      from peak to valley, of the reflected light
  duty           in (0, 1), of a rectangular profile (default 0.5)
result  {"orders": [{"order": m, "direction": [x, y, z], "efficiency": …}, …]}; the direction of an
        evanescent order is null; efficiency, with a profile only, is a share of the reflected light

A CD under a light from above:
  echo '{"pitch_nm": 1600, "grating_vector": [1,0,0], "normal": [0,0,1], "k_in": [0,0,-1],
         "wavelength_nm": 550, "orders": [-3, 3],
         "profile": {"kind": "rectangular", "phase_rad": 1.5}}' | nacre eval grating)";

constexpr int kMaxOrder = 1000;

double dot(const Direction& a, const Direction& b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Three finite numbers that are not all zero.
std::optional<Direction> read_direction(ObjectReader& reader, const char* key)
{
    const auto values = reader.numbers(key, kAnyNumber);
    if (!values) return std::nullopt;
    if (values->size() != 3) {
        reader.problem(key, fmt::format("must be [x, y, z] (got {} numbers)", values->size()));
        return std::nullopt;
    }
    const Direction direction{(*values)[0], (*values)[1], (*values)[2]};
    const double length = std::hypot(direction[0], direction[1], direction[2]);
    if (!(length > 0.0) || !std::isfinite(length)) {
        reader.problem(key, "must have a length > 0");
        return std::nullopt;
    }
    return Direction{direction[0] / length, direction[1] / length, direction[2] / length};
}

std::optional<std::array<int, 2>> read_orders(ObjectReader& reader)
{
    const json* list = reader.required("orders");
    if (!list) return std::nullopt;
    const auto is_order = [](const json& value) {
        return value.is_number_integer() && value >= -kMaxOrder && value <= kMaxOrder;
    };
    if (list->is_array() && list->size() == 2 && is_order((*list)[0]) && is_order((*list)[1]) &&
        (*list)[0] <= (*list)[1])
        return std::array{(*list)[0].get<int>(), (*list)[1].get<int>()};
    reader.problem("orders", fmt::format("must be [first, last], whole numbers in [-{0}, {0}], "
                                         "first ≤ last (got {1})",
                                         kMaxOrder, quoted(*list)));
    return std::nullopt;
}

optics::GratingProfile read_profile(const json& member, DiagnosticList& problems)
{
    optics::GratingProfile profile;
    ObjectReader inner(member, "profile", problems);
    if (!member.is_object()) return profile;
    constexpr auto& kNames = optics::kProfileNames;
    const auto kind = inner.choice("kind", {kNames.begin(), kNames.end()});
    const auto phase = inner.number("phase_rad", kAnyNumber);
    const auto duty = inner.number_or("duty", {0.0, 1.0, true, true}, profile.duty);
    inner.refuse_unknown_keys();
    if (kind)
        profile.kind =
            static_cast<optics::ProfileKind>(std::ranges::find(kNames, *kind) - kNames.begin());
    profile.phase_rad = phase.value_or(0.0);
    profile.duty = duty.value_or(profile.duty);
    return profile;
}

/// The geometry that has no answer: grooves that do not cut the surface, light from below.
void check_geometry(ObjectReader& reader, const Direction& vector, const Direction& normal,
                    const Direction& k_in)
{
    if (!(1.0 - std::abs(dot(vector, normal)) > 1e-12))
        reader.problem("grating_vector", "must not be parallel to the normal");
    if (!(dot(k_in, normal) < 0.0))
        reader.problem("k_in",
                       fmt::format("must point towards the surface, k_in · normal < 0 (got {})",
                                   dot(k_in, normal)));
}

ordered_json evaluate_grating(const json& record)
{
    DiagnosticList problems;
    ObjectReader reader(record, "", problems);
    const auto pitch = reader.number("pitch_nm", kPositive);
    const auto vector = read_direction(reader, "grating_vector");
    const auto normal = read_direction(reader, "normal");
    const auto k_in = read_direction(reader, "k_in");
    const auto wavelength = reader.number("wavelength_nm", kPositive);
    const auto orders = read_orders(reader);
    // How the light is shared follows from the profile, where it goes does not.
    const json* const member = reader.optional("profile");
    const auto profile = member ? read_profile(*member, problems) : optics::GratingProfile{};
    if (vector && normal && k_in) check_geometry(reader, *vector, *normal, *k_in);
    reader.refuse_unknown_keys();
    problems.throw_if_any();

    ordered_json list = ordered_json::array();
    for (const auto& order : optics::grating_orders({*pitch, *vector, *normal, profile}, *k_in,
                                                    *wavelength, (*orders)[0], (*orders)[1])) {
        ordered_json answer = {{"order", order.order}, {"direction", nullptr}};
        if (order.direction) answer["direction"] = *order.direction;
        if (member) answer["efficiency"] = order.efficiency;
        list.push_back(std::move(answer));
    }
    return {{"orders", std::move(list)}};
}

}  // namespace

void add_eval_grating(CLI::App& eval, Session& session)
{
    add_record_command(eval, session, "grating",
                       "directions and efficiencies of diffraction orders", kGratingHelp,
                       evaluate_grating);
}

}  // namespace nacre::tool
