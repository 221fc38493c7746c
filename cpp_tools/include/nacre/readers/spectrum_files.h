// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/spectral/named_spectrum.h"

/// @file
/// Spectra from the text of files. Limits: nacre/core/limits.h.
///
/// Every reader throws an InputError with all that is wrong, each with its line, and reads nothing
/// but what it is given; `file` is what messages call it.

namespace nacre::spectral {

/// What a user says of a file that does not tell.
struct ReadAs {
    std::optional<SpectrumKind> kind;  ///< of all; also in place of what the file says
    std::optional<double> scale;       ///< multiplies all values: 1 for ratios, 0.01 for per cent
};

/// Kind and scale as the user says.
/// @throws InputError for a reflectance above 1 somewhere of which neither the file nor the user
///         says whether it is a ratio, which a fluorescent colour may have, or per cent, as the
///         black patch of a chart has it; and for values that cannot be of the user's kind where
///         the file says another, by kind_problem().
void apply(const ReadAs& said, std::vector<NamedSpectrum>& spectra, const std::string& file);

/// Rows of a wavelength and values, as spreadsheets and instruments write them; in UTF-8, or UTF-16
/// with or without a byte order mark.
///
///   between cells  tabs, `;`, `,` or spaces; those at the end of a row count for nothing
///   numbers        with points, or commas where no comma is between cells or they stand in quotes;
///                  one of them throughout a file
///   wavelengths    ascending or descending
///   first row      names, or nothing: then nanometres. That of the wavelengths is any of
///                  `wavelength`, `wave length`, `lambda`, `λ`, `WL`, `Wellenlänge` and a unit, or
///                  one of both, whatever the case, with `in`, `_`, `/`, `(…)` or `[…]` around it:
///                  `wavelength_nm`, `Wavelength(nm)`, `λ (nm)`, `λ / µm`, `lambda_nm`, `nm`
///   units          nm (also where none is named), µm (`um`, `micron`, `micrometer`), Å; `wl` alone
///                  is µm below 100, as refractiveindex.info exports it, and else nm
///   per cent       columns called `R (%)`, `R [%]`, `%T`, `R percent` or `r_pct`: ratios once read
///   comments       lines of `#`; at the top `# KEY: value` with NAME, KIND, REFERENCES, LICENCE,
///                  COMMENTS, TAGS
[[nodiscard]] std::vector<NamedSpectrum> read_csv_spectra(std::string_view text,
                                                          std::string_view file);

/// `.spd` of Mitsuba and pbrt: a wavelength in nm and a value a line, `#` before comments.
[[nodiscard]] std::vector<NamedSpectrum> read_spd(std::string_view text, std::string_view file);

/// `.spdx`, IES TM-27-14: XML with one SpectralDistribution. Document types, and with them entities
/// of a file's own, are refused.
[[nodiscard]] std::vector<NamedSpectrum> read_spdx(std::string_view text, std::string_view file);

/// CGATS text (ANSI CGATS.17, ISO 28178) and the `.sp` and `.ti3` of Argyll: a spectrum for each
/// set of data that has fields such as SPECTRAL_NM380, SPECTRAL_PCT380, SPEC_380 or nm380.
[[nodiscard]] std::vector<NamedSpectrum> read_cgats(std::string_view text, std::string_view file);

enum class SpectrumFormat { csv, spd, spdx, cgats };

/// By the extension of `file` (.csv, .spd, .spdx, .cgats, .ti3, .sp), else by how the text starts.
[[nodiscard]] SpectrumFormat spectrum_format(std::string_view text, std::string_view file);
[[nodiscard]] std::vector<NamedSpectrum> read_spectra(std::string_view text, std::string_view file,
                                                      const ReadAs& said = {});

/// The same for one spectrum whose KIND is stated: the form of the files of a library.
[[nodiscard]] NamedSpectrum read_library_spectrum(std::string_view text, std::string_view file);
[[nodiscard]] std::string write_library_spectrum(const NamedSpectrum& spectrum);

}  // namespace nacre::spectral
