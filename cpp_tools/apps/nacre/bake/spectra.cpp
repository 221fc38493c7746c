// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "files/spectrum_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/textures/spectral_channels.h"
#include "nacre/textures/spectrum_texture.h"
#include "shared/session.h"
#include "tables/texture.h"

namespace nacre::tool {
namespace {

using spectral::NamedSpectrum;
using spectral::SpectrumKind;
using spectral::SpectrumLayout;
using spectral::TextureSamples;

struct SpectraOptions {
    std::vector<std::string> inputs;
    std::string output, depth, layout = "packed", maximum = "spectrum", kind;
    std::optional<double> scale;
    int columns = 1;

    [[nodiscard]] std::size_t column_count() const { return static_cast<std::size_t>(columns); }
};

constexpr const char* kBakeSpectraHelp = R"(
INPUT is the key of a spectrum (nacre library list), an illuminant (D65, blackbody:3200), or a file:
.csv, .spd, .spdx, CGATS, a spectral EXR, or a texture made by this command. Samples are 324 … 835 nm
at 1 nm; outside its data a spectrum keeps the value at its end.
  packed  RGBA: texel i of 128 holds 324 + 4 i nm and the three wavelengths after it
  single  one channel: texel i of 512 holds 324 + i nm
  image   spectral EXR (Fichet, Pacanowski, Wilkie 2021): a pixel a spectrum, a channel a wavelength
Spectra stand side by side in --columns, then in rows. In a .png each is divided by its largest value,
which nacre:maximum gives. nacre info FILE --spectra back.csv reads all of them back.

  nacre bake spectra colorchecker/dark-skin colorchecker/light-skin -o skin.exr
  nacre bake spectra D65 A lamp/hps --layout single -o lights.ftxt
  nacre bake spectra my_chart.cgats --columns 6 --layout image --kind reflectance -o chart.exr
  nacre bake spectra skin.exr -o skin.csv)";

std::vector<NamedSpectrum> read_inputs(const Session& session, const SpectraOptions& options)
{
    const spectral::ReadAs said = read_as(options.kind, options.scale);
    std::vector<NamedSpectrum> spectra;
    std::vector<std::string> notes;
    DiagnosticList problems;
    for (const std::string& input : options.inputs) {
        try {
            auto read = read_spectra_input(input, said);
            if (auto note = override_note(input, read)) notes.push_back(std::move(*note));
            std::ranges::move(read, std::back_inserter(spectra));
        } catch (const InputError& error) {
            for (const Diagnostic& problem : error.diagnostics()) problems.add(problem);
        }
    }
    problems.throw_if_any();
    for (const std::string& note : notes) session.note(note);
    return spectra;
}

std::vector<TextureSamples> samples_of(const std::vector<NamedSpectrum>& spectra)
{
    std::vector<TextureSamples> samples;
    samples.reserve(spectra.size());
    for (const NamedSpectrum& spectrum : spectra) {
        try {
            samples.push_back(texture_samples(spectrum));
        } catch (const InputError& error) {
            throw InputError(
                {label_of(spectrum), 0, "wavelength_nm", error.diagnostics().front().message});
        }
    }
    return samples;
}

/// The divisor of each spectrum in bytes. @throws InputError for a value below 0
std::vector<double> maxima(const std::vector<TextureSamples>& samples,
                           const std::vector<NamedSpectrum>& spectra, bool global)
{
    std::vector<double> result;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto [lowest, highest] = std::ranges::minmax(samples[i]);
        if (lowest < 0.0)
            throw InputError({label_of(spectra[i]), 0, "values",
                              fmt::format("must be ≥ 0 for a .png, whose bytes have no sign (got "
                                          "{:g}); .exr, .tx and .ftxt have one",
                                          lowest)});
        result.push_back(highest > 0.0 ? highest : 1.0);
    }
    if (global) result.assign(result.size(), *std::ranges::max_element(result));
    return result;
}

void bake_texture(const Session& session, const SpectraOptions& options,
                  const std::vector<NamedSpectrum>& spectra)
{
    const Encoding encoding = encoding_for(options.output, options.depth);
    std::vector<TextureSamples> samples = samples_of(spectra);
    Attributes attributes = texture_attributes("spectra");
    describe_spectra(attributes, spectra);
    attributes["nacre:layout"] = options.layout;
    attributes["nacre:columns"] = options.columns;
    attributes["nacre:count"] = static_cast<int>(spectra.size());
    if (encoding.depth == Depth::byte) {
        const auto divisors = maxima(samples, spectra, options.maximum == "global");
        for (std::size_t i = 0; i < samples.size(); ++i)
            for (double& value : samples[i]) value /= divisors[i];
        attributes["nacre:maximum"] = nlohmann::json(divisors).dump();
    }
    const auto layout =
        options.layout == "single" ? SpectrumLayout::single : SpectrumLayout::packed;
    write_texture(session, options.output,
                  image_of(spectral::pack_spectra(samples, layout, options.column_count())),
                  std::move(attributes), encoding, spectra);
}

/// All of one kind. @throws InputError
SpectrumKind common_kind(const std::vector<NamedSpectrum>& spectra)
{
    for (const NamedSpectrum& spectrum : spectra) {
        if (!spectrum.kind)
            throw InputError({label_of(spectrum), 0, "--kind",
                              "must be emission or reflectance: the file does not tell"});
        if (spectrum.kind != spectra.front().kind)
            throw InputError(
                {label_of(spectrum), 0, "",
                 fmt::format("is of the kind {}, {} is not: a spectral image holds "
                             "one kind",
                             spectrum_kind_name(*spectrum.kind), label_of(spectra.front()))});
    }
    return *spectra.front().kind;
}

Image spectral_image(const std::vector<TextureSamples>& samples, SpectrumKind kind,
                     std::size_t columns)
{
    columns = std::min(columns, samples.size());
    Image image{static_cast<int>(columns),
                static_cast<int>((samples.size() + columns - 1) / columns),
                {},
                {}};
    for (std::size_t i = 0; i < spectral::kTextureSamples; ++i)
        image.channels.push_back(
            spectral::spectral_channel_name({kind, spectral::texture_wavelength_nm(i)}));
    image.pixels.resize(columns * static_cast<std::size_t>(image.height) *
                        spectral::kTextureSamples);
    auto to = image.pixels.begin();
    for (const TextureSamples& spectrum : samples)
        to = std::ranges::transform(spectrum, to, [](double v) {
                 return static_cast<float>(v);
             }).out;
    return image;
}

void bake_image(const Session& session, const SpectraOptions& options,
                const std::vector<NamedSpectrum>& spectra)
{
    const Encoding encoding = encoding_for(options.output, options.depth);
    if (encoding.container != Container::exr)
        throw InputError({options.output, 0, "-o", "must end in .exr for --layout image"});
    const SpectrumKind kind = common_kind(spectra);
    const std::vector<TextureSamples> samples = samples_of(spectra);
    Attributes attributes = texture_attributes("spectra");
    describe_spectra(attributes, spectra);
    attributes["nacre:layout"] = "image";
    attributes["nacre:count"] = static_cast<int>(spectra.size());
    attributes["spectralLayoutVersion"] = std::string(spectral::kSpectralLayoutVersion);
    if (kind == SpectrumKind::emission)
        attributes["emissiveUnits"] = std::string(spectral::kSpectralEmissiveUnits);
    write_texture(session, options.output, spectral_image(samples, kind, options.column_count()),
                  std::move(attributes), encoding, spectra);
}

int bake(const Session& session, const SpectraOptions& options)
{
    if (options.columns < 1)
        throw InputError({{},
                          0,
                          "--columns",
                          fmt::format("must be a whole number ≥ 1 (got {})", options.columns)});
    const std::vector<NamedSpectrum> spectra = read_inputs(session, options);
    if (std::filesystem::path(options.output).extension() == ".csv")
        write_text_output(options.output, spectra_csv(spectra));
    else if (options.layout == "image")
        bake_image(session, options, spectra);
    else
        bake_texture(session, options, spectra);
    return kExitOk;
}

}  // namespace

void add_bake_spectra(CLI::App& bake_command, Session& session)
{
    const auto options = std::make_shared<SpectraOptions>();
    CLI::App* spectra = bake_command.add_subcommand("spectra", "spectra as a texture");
    spectra->fallthrough()->footer(kBakeSpectraHelp);
    spectra->add_option("INPUT", options->inputs, "keys, illuminants, files")->required();
    spectra
        ->add_option("-o,--output", options->output,
                     ".exr or .tx (float, half), .ftxt, .csv, .png (byte)")
        ->required();
    spectra->add_option("--layout", options->layout)
        ->check(CLI::IsMember({"packed", "single", "image"}))
        ->capture_default_str();
    spectra->add_option("--columns", options->columns, "spectra side by side")
        ->capture_default_str();
    spectra->add_option("--depth", options->depth, "default: float, in a PNG byte")
        ->check(CLI::IsMember({"float", "half", "byte"}));
    spectra->add_option("--maximum", options->maximum, "what bytes are divided by")
        ->check(CLI::IsMember({"spectrum", "global"}))
        ->capture_default_str();
    spectra
        ->add_option(
            "--kind", options->kind,
            "of all; where one is stated to be of the other kind, a note says so, and values that "
            "cannot be of this one are refused")
        ->check(CLI::IsMember({"emission", "reflectance"}));
    spectra->add_option("--scale", options->scale, kScaleHelp);
    spectra->callback([&session, options] {
        session.run = [&session, options] { return bake(session, *options); };
    });
}

}  // namespace nacre::tool
