// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "fuzz_target.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"

using namespace nacre;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    (void)fuzz::run(data, size, [](std::string_view text) {
        std::vector<std::string> changes;
        (void)spectral::refractiveindex_yaml_from_csv(text, "input.csv", "", changes);
    });
    return fuzz::run(data, size, [](std::string_view text) {
        auto spectra = spectral::read_csv_spectra(text, "input.csv");
        spectral::NamedSpectrum& spectrum = spectra.front();
        spectrum.kind = spectral::SpectrumKind::emission;
        if (spectral::kind_problem(spectrum.samples, *spectrum.kind)) return;
        // What is written is read as it was.
        const auto again = spectral::read_library_spectrum(
            spectral::write_library_spectrum(spectrum), "again.csv");
        fuzz::require(again.samples.values() == spectrum.samples.values(), "other values");
        fuzz::require(again.name == spectrum.name, "another name");
    });
}
