// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/working_range.h"

#include <string>

#include "base/guard.h"
#include "base/kept_text.h"
#include "nacre/kinds/held_media.h"
#include "nacre/kinds/read_template.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/media/working_range.h"
#include "templates/compile_options.h"

namespace nacre::capi {
namespace {

spectral::RangeRule range_rule(int strict_range) noexcept
{
    return strict_range != 0 ? spectral::RangeRule::strict : spectral::RangeRule::hold_ends;
}

/// @throws InputError that names the medium
spectral::OpticalConstantsPtr covered(const spectral::Medium& medium, int strict_range)
{
    const auto rule = range_rule(strict_range);
    if (auto problem = range_problem(*medium.constants, rule))
        throw InputError({medium.key, 0, "wavelength_nm", std::move(*problem)});
    return spectral::WorkingRange(rule).cover(medium.constants);
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_library_index_on_grid(const char* key, int strict_range, double* n)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(key, "key");
        capi::require(n, "n");
        const auto medium = capi::covered(spectral::library_medium(key), strict_range);
        for (const spectral::Complex& value : medium->on_grid()) {
            *n++ = value.real();
            *n++ = value.imag();
        }
    });
}

nacre_status nacre_library_held_ends(const char* key, const char* illuminant, const char* observer,
                                     int strict_range, double* percent, const char** note)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(key, "key");
        capi::require(illuminant, "illuminant");
        capi::require(observer, "observer");
        capi::require(percent, "percent");
        const spectral::Medium& medium = spectral::library_medium(key);
        (void)capi::covered(medium, strict_range);
        const auto held = held_ends(medium, spectral::named_illuminant(illuminant),
                                    spectral::observer_from_name(observer));
        const char* const words = capi::kept(held ? held->note() : std::string());
        *percent = held ? held->percent : 0.0;
        if (note != nullptr) *note = words;
    });
}

nacre_status nacre_template_held_ends(const char* text, const char* file, const char* illuminant,
                                      const char* observer, int strict_range, const char** notes)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(notes, "notes");
        auto options =
            capi::compile_options(text, file, {illuminant, observer, "lin_rec709_scene"});
        options.range = capi::range_rule(strict_range);
        std::string lines;
        for (const spectral::HeldEnds& held :
             held_media(kinds::parse_template(text, file), options))
            lines += (lines.empty() ? "" : "\n") + held.note();
        *notes = capi::kept(lines);
    });
}
}
