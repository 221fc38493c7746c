// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/material/medium.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "medium_forms.h"

namespace nacre::material {
namespace {

SellmeierMedium read_sellmeier(Section& section)
{
    SellmeierMedium result;
    auto table = section.section("sellmeier");
    if (!table) return result;
    table->require("b", "an array of numbers");
    table->require("c", "an array of numbers, µm²");
    result.b = table->numbers("b", 1, kMostSellmeierTerms).value_or(std::vector<double>{});
    result.c = table->numbers("c", 1, kMostSellmeierTerms).value_or(std::vector<double>{});
    if (!result.b.empty() && !result.c.empty() && result.b.size() != result.c.size())
        table->report("c", fmt::format("must have as many numbers as b (got {} and {})",
                                       result.c.size(), result.b.size()));
    table->report_unknown_keys();
    return result;
}

AbbeMedium read_abbe(Section& section)
{
    AbbeMedium result;
    auto table = section.section("abbe");
    if (!table) return result;
    table->require("n_d", "a number > 0");
    table->require("v_d", "a number > 0");
    result.n_d = table->number("n_d", kAbbe).value_or(1.5);
    result.v_d = table->number("v_d", kAbbe).value_or(60.0);
    table->report_unknown_keys();
    return result;
}

}  // namespace

bool MediumSpec::absorbs() const
{
    if (const auto* constant = std::get_if<ConstantMedium>(&value)) return constant->k > 0.0;
    if (const auto* cauchy = std::get_if<CauchyMedium>(&value)) return cauchy->k > 0.0;
    return false;
}

MediumSpec read_medium(Section& section)
{
    MediumSpec result;
    const auto given = [&](std::string_view key) { return section.has(key); };
    const auto first = std::ranges::find_if(kMediumForms, given);
    const std::string_view form = first == kMediumForms.end() ? "medium" : *first;
    result.line = section.line(form);
    result.field = section.field(form);
    if (std::ranges::count_if(kMediumForms, given) != 1)
        section.report(
            form, fmt::format("must be given by exactly one of {}", fmt::join(kMediumForms, ", ")));

    const auto key = section.text("medium");
    const auto n = section.number("n", kMediumIndex);
    const auto coefficients = section.numbers("cauchy", 1, kMostCauchyTerms);
    const bool takes_k = form == "n" || form == "cauchy";
    const double k = takes_k ? section.number("k", kMediumAbsorption).value_or(0.0) : 0.0;
    if (form == "medium")
        result.value = LibraryMedium{key.value_or("")};
    else if (form == "n")
        result.value = ConstantMedium{n.value_or(1.0), k};
    else if (form == "cauchy")
        result.value = CauchyMedium{coefficients.value_or(std::vector<double>{1.0}), k};
    const SellmeierMedium sellmeier = read_sellmeier(section);
    const AbbeMedium abbe = read_abbe(section);
    if (form == "sellmeier")
        result.value = sellmeier;
    else if (form == "abbe")
        result.value = abbe;
    return result;
}

MediumSpec read_medium_at(Section& parent, std::string_view key)
{
    parent.require(key, "a table that names a medium");
    if (auto section = parent.section(key)) {
        MediumSpec result = read_medium(*section);
        section->report_unknown_keys();
        return result;
    }
    return {};
}

}  // namespace nacre::material
