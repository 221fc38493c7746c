// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"
#include "sample_list.h"

namespace nacre::spectral {

std::vector<NamedSpectrum> read_spd(std::string_view text, std::string_view name)
{
    const std::string file(name);
    check_size(text, file);
    FileProblems problems(file);
    SampleList samples(problems);
    const std::string decoded = utf8_of_utf16(text);
    TextLines lines(decoded.empty() ? text : decoded);
    while (const auto line = lines.next()) {
        const auto words = split_words(line->substr(0, line->find('#')));
        if (words.empty()) continue;
        if (words.size() != 2) {
            problems.add(
                lines.number(), {},
                fmt::format("must be a wavelength and a value (got {} words)", words.size()));
            continue;
        }
        if (!samples.add(lines.number(), words[0], words[1])) break;
    }
    auto spectrum = samples.finish();
    problems.throw_if_any();
    std::vector<NamedSpectrum> spectra;
    spectra.push_back({.key = {},
                       .name = {},
                       .references = {},
                       .licence = {},
                       .comments = {},
                       .tags = {},
                       .kind = std::nullopt,
                       .samples = std::move(*spectrum)});
    return spectra;
}

}  // namespace nacre::spectral
