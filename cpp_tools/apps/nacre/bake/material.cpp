// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "files/output.h"
#include "files/spectrum_input.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/textures/spectrum_texture.h"
#include "shared/held_ends.h"
#include "shared/session.h"
#include "tables/options.h"
#include "tables/texture.h"

namespace nacre::tool {
namespace {

using spectral::kTextureSamples;
using spectral::LightSpectra;
using spectral::MaterialSpectra;
using spectral::Medium;
using spectral::NamedSpectrum;
using spectral::SpectrumKind;
using spectral::Texture;
using spectral::TextureSamples;
using spectral::Vec3;

struct MaterialOptions {
    std::vector<std::string> inputs, intensities;
    std::string output, depth;
    bool as_they_are = false;
    TableOptions light;
};

constexpr const char* kMaterialHelp = R"(
INPUT is the key of a medium (nacre library list) or its refractiveindex.info YAML. A row each, 516
texels of RGBA:
  0 … 511  at 324 + i nm: intensity, n, k, 1; n and k as (v - min) / (max - min)
  512      colour of the intensity, linear, 1
  513      n min, n max, k min, k max; a .png has them in the attribute nacre:limits
  514, 515 0
A .png has intensity and colour divided by nacre:maximum and nacre:colour_maximum. A .csv has columns
of intensity, n and k for each INPUT.
Intensity is the reflectance in air at normal incidence, or a spectrum given by --intensity. Beyond
their data, which have to cover 400 … 700 nm, n and k are held as they are at the end.

  nacre bake material Au/Johnson Cu/Johnson -o metals.exr
  nacre bake material water/Daimon-20C --intensity colorchecker/blue -o water.ftxt)";

constexpr const char* kLightsHelp = R"(
INPUT is an illuminant, the key of an emission, or a file of spectra. Four lights a row, 516 texels of
RGBA as nacre bake material has them:
  0 … 511    power at 324 + i nm of the lights in R, G, B and A; 0 where there is none
  512 … 515  colour of each of the four, linear, 1: of its power, on the same scale
A .png has power and colour divided by nacre:maximum and nacre:colour_maximum. A .csv has a column for
each light.

  nacre bake lights D65 A F11 lamp/hps -o lights.exr)";

Medium read_medium(const Session& session, const std::string& input)
{
    const std::string extension = std::filesystem::path(input).extension().string();
    if (extension == ".yml" || extension == ".yaml") {
        Medium medium = spectral::parse_refractiveindex_yaml(read_text(input), input);
        for (const std::string& change : medium.changes)
            session.note(fmt::format("{}: changed: {}", input, change));
        return medium;
    }
    return spectral::library_medium(input);
}

NamedSpectrum read_one(const std::string& input)
{
    auto spectra = read_spectra_input(input);
    if (spectra.size() == 1 && !spectra.front().kind)
        apply({.kind = SpectrumKind::reflectance, .scale = {}}, spectra, input);
    if (spectra.size() != 1)
        throw InputError({input, 0, "--intensity",
                          fmt::format("must hold one spectrum (got {})", spectra.size())});
    return std::move(spectra.front());
}

spectral::Sampled on_grid(const TextureSamples& samples)
{
    spectral::Sampled grid;
    std::copy_n(samples.begin() + (spectral::kFirstNm - spectral::kTextureFirstNm),
                spectral::kWavelengths, grid.begin());
    return grid;
}

NamedSpectrum spectrum_of(const std::string& name, const TextureSamples& samples,
                          std::optional<SpectrumKind> kind)
{
    return named_spectrum(name, spectral::kTextureFirstNm, {samples.begin(), samples.end()}, kind);
}

/// Divides by the largest, which bytes then hold as 1. @return it, or 1 where none is > 0
template <class Values>
double fit_into_bytes(Values& values)
{
    const double largest = *std::ranges::max_element(values);
    const double divisor = largest > 0.0 ? largest : 1.0;
    for (double& value : values) value /= divisor;
    return divisor;
}

/// Bytes hold a spectrum and its colour each divided by its largest value, and nothing negative.
class ByteScales {
public:
    void fit(const std::string& label, TextureSamples& samples, Vec3& colour)
    {
        if (std::ranges::min(colour) < 0.0) negative_.push_back(label);
        maximum_.push_back(fit_into_bytes(samples));
        colour_maximum_.push_back(fit_into_bytes(colour));
    }

    void describe(Attributes& attributes) const
    {
        attributes["nacre:maximum"] = nlohmann::json(maximum_).dump();
        attributes["nacre:colour_maximum"] = nlohmann::json(colour_maximum_).dump();
    }

    void warn(const Session& session, const std::string& output) const
    {
        if (negative_.empty()) return;
        session.note(
            fmt::format("{}: bytes have no sign: what is negative in the colour of {} is "
                        "0; nacre:colours has it",
                        output, fmt::join(negative_, ", ")));
    }

private:
    std::vector<double> maximum_, colour_maximum_;
    std::vector<std::string> negative_;
};

/// Takes the limits out of the texture. @return n min, n max, k min, k max of each row
std::vector<std::vector<float>> take_limits(Texture& texture)
{
    std::vector<std::vector<float>> limits;
    for (std::size_t row = 0; row < static_cast<std::size_t>(texture.height); ++row) {
        float* texel = texture.at(kTextureSamples + 1, row);
        limits.emplace_back(texel, texel + 4);
        std::fill_n(texel, 4, 0.0F);
    }
    return limits;
}

struct Materials {
    std::vector<MaterialSpectra> rows;
    std::vector<spectral::HeldEnds> held;
    std::vector<NamedSpectrum> spectra;  ///< reflectance, n and k of each
    std::vector<std::string> names, references;
};

/// n, k and reflectance. @throws InputError that names the input
MaterialSpectra row_of(const Medium& medium, const std::string& input,
                       const spectral::ColourWeights& weights, spectral::RangeRule rule)
{
    try {
        return material_spectra(medium, weights, rule);
    } catch (const InputError& error) {
        const Diagnostic& problem = error.diagnostics().front();
        throw InputError({input, 0, problem.field, problem.message});
    }
}

Materials read_materials(const Session& session, const MaterialOptions& options,
                         const ResolvedTableOptions& table)
{
    const auto light = spectral::named_illuminant(table.provenance.illuminant);
    const auto weights = reflectance_weights(light, table.provenance.observer,
                                             table.provenance.space, table.provenance.adaptation);
    Materials all;
    for (std::size_t i = 0; i < options.inputs.size(); ++i) {
        const Medium medium = read_medium(session, options.inputs[i]);
        MaterialSpectra row = row_of(medium, options.inputs[i], weights, table.compile.range);
        if (auto ends = held_ends(medium, light, table.provenance.observer))
            all.held.push_back(std::move(*ends));
        if (!options.intensities.empty()) {
            row.intensity = texture_samples(read_one(options.intensities[i]));
            row.colour = weights.apply(on_grid(row.intensity));
        }
        all.names.push_back(medium.key);
        all.references.push_back(medium.references);
        all.spectra.push_back(
            spectrum_of(medium.key + " reflectance", row.intensity, SpectrumKind::reflectance));
        all.spectra.push_back(spectrum_of(medium.key + " n", row.n, std::nullopt));
        all.spectra.push_back(spectrum_of(medium.key + " k", row.k, std::nullopt));
        all.rows.push_back(row);
    }
    return all;
}

Attributes colour_attributes(Attributes attributes, const TableProvenance& provenance)
{
    attributes["nacre:observer"] = std::string(spectral::observer_name(provenance.observer));
    attributes["nacre:space"] = provenance.space.name;
    return attributes;
}

bool is_csv(const std::string& output)
{
    return std::filesystem::path(output).extension() == ".csv";
}

/// Columns of the spectra as they are; colours and limits belong to images.
int write_csv(const MaterialOptions& options, const std::vector<NamedSpectrum>& spectra,
              const std::vector<spectral::HeldEnds>& held = {})
{
    if (!options.depth.empty())
        throw InputError({options.output, 0, "--depth", "must not be set for a .csv: it is text"});
    std::vector<std::string> notes(held.size());
    std::ranges::transform(held, notes.begin(), &spectral::HeldEnds::note);
    write_text_output(options.output,
                      spectra_csv(spectra, fmt::format("{}", fmt::join(notes, "; "))));
    return kExitOk;
}

/// @throws InputError for options that contradict each other
void check_options(const MaterialOptions& options)
{
    const std::string extension = std::filesystem::path(options.output).extension().string();
    if (extension == ".png" && options.as_they_are)
        throw InputError({options.output, 0, "--as-they-are",
                          "must not be set for a .png: bytes hold nothing above 1"});
    if (!options.intensities.empty() && options.intensities.size() != options.inputs.size())
        throw InputError({{},
                          0,
                          "--intensity",
                          fmt::format("must be given once for each of the {} INPUTs (got {})",
                                      options.inputs.size(), options.intensities.size())});
}

int bake_material(const Session& session, const MaterialOptions& options)
{
    check_options(options);
    const ResolvedTableOptions light = resolve(options.light);
    const TableProvenance& provenance = light.provenance;
    Materials materials = read_materials(session, options, light);
    note_held(session, materials.held);
    if (is_csv(options.output)) return write_csv(options, materials.spectra, materials.held);
    const Encoding encoding = encoding_for(options.output, options.depth);
    const bool bytes = encoding.depth == Depth::byte;
    Attributes attributes = colour_attributes(texture_attributes("materials"), provenance);
    attributes["nacre:illuminant"] = provenance.illuminant;
    attributes["nacre:adaptation"] = spectral::adaptation_name(provenance.adaptation);
    attributes["nacre:names"] = nlohmann::json(materials.names).dump();
    attributes["nacre:references"] = nlohmann::json(materials.references).dump();
    if (!materials.held.empty()) attributes["nacre:held_ends"] = held_json(materials.held).dump();
    ByteScales scales;
    auto colours = nlohmann::json::array();
    for (std::size_t i = 0; i < materials.rows.size(); ++i) {
        MaterialSpectra& row = materials.rows[i];
        colours.push_back(row.colour);
        if (bytes) scales.fit(materials.names[i], row.intensity, row.colour);
    }
    attributes["nacre:colours"] = colours.dump();
    if (bytes) scales.describe(attributes);
    Texture texture = spectral::pack_materials(materials.rows, !options.as_they_are);
    if (bytes) attributes["nacre:limits"] = nlohmann::json(take_limits(texture)).dump();
    write_texture(session, options.output, image_of(std::move(texture)), std::move(attributes),
                  encoding, materials.spectra);
    scales.warn(session, options.output);
    return kExitOk;
}

std::vector<NamedSpectrum> read_lights(const std::vector<std::string>& inputs)
{
    std::vector<NamedSpectrum> spectra;
    for (const std::string& input : inputs)
        for (NamedSpectrum& spectrum : read_spectra_input(input)) {
            if (spectrum.kind == SpectrumKind::reflectance)
                throw InputError({label_of(spectrum), 0, "kind",
                                  "must be an emission; it is a reflectance, which nacre bake "
                                  "spectra takes"});
            if (auto problem = kind_problem(spectrum.samples, SpectrumKind::emission))
                throw InputError({label_of(spectrum), 0, "values", *problem});
            spectrum.kind = SpectrumKind::emission;
            spectra.push_back(std::move(spectrum));
        }
    return spectra;
}

LightSpectra light_spectra(const NamedSpectrum& spectrum, const TableProvenance& provenance)
{
    LightSpectra light{.power = texture_samples(spectrum), .colour = {}};
    const Vec3 xyz = spectral::emission_to_xyz(on_grid(light.power), provenance.observer);
    light.colour = multiply(provenance.space.from_xyz_d65,
                            multiply(spectral::emission_to_d65(provenance.observer), xyz));
    return light;
}

int bake_lights(const Session& session, const MaterialOptions& options)
{
    const std::vector<NamedSpectrum> spectra = read_lights(options.inputs);
    if (is_csv(options.output)) return write_csv(options, spectra);
    const Encoding encoding = encoding_for(options.output, options.depth);
    const bool bytes = encoding.depth == Depth::byte;
    const TableProvenance provenance = resolve(options.light).provenance;
    std::vector<LightSpectra> lights;
    ByteScales scales;
    auto colours = nlohmann::json::array();
    for (const NamedSpectrum& spectrum : spectra) {
        LightSpectra light = light_spectra(spectrum, provenance);
        colours.push_back(light.colour);
        if (bytes) scales.fit(label_of(spectrum), light.power, light.colour);
        lights.push_back(light);
    }
    Attributes attributes = colour_attributes(texture_attributes("lights"), provenance);
    describe_spectra(attributes, spectra);
    attributes["nacre:count"] = static_cast<int>(lights.size());
    attributes["nacre:colours"] = colours.dump();
    if (bytes) scales.describe(attributes);
    write_texture(session, options.output, image_of(spectral::pack_lights(lights)),
                  std::move(attributes), encoding, spectra);
    scales.warn(session, options.output);
    return kExitOk;
}

CLI::App* add_command(CLI::App& bake, const char* name, const char* description, const char* help,
                      MaterialOptions& options)
{
    CLI::App* command = bake.add_subcommand(name, description);
    command->fallthrough()->footer(help);
    command->add_option("INPUT", options.inputs)->required();
    command
        ->add_option("-o,--output", options.output,
                     ".exr or .tx (float, half), .ftxt, .csv, .png (byte)")
        ->required();
    command->add_option("--depth", options.depth, "default: float, in a PNG byte")
        ->check(CLI::IsMember({"float", "half", "byte"}));
    return command;
}

}  // namespace

void add_bake_material(CLI::App& bake_command, Session& session)
{
    const auto options = std::make_shared<MaterialOptions>();
    CLI::App* material =
        add_command(bake_command, "material", "intensity, n and k of media, and their colours",
                    kMaterialHelp, *options);
    material->add_option("--intensity", options->intensities,
                         "a spectrum for each INPUT in place of its reflectance");
    material->add_flag("--as-they-are", options->as_they_are, "n and k without normalising");
    add_light_options(*material, options->light);
    material->callback([&session, options] {
        session.run = [&session, options] { return bake_material(session, *options); };
    });
}

void add_bake_lights(CLI::App& bake_command, Session& session)
{
    const auto options = std::make_shared<MaterialOptions>();
    CLI::App* lights = add_command(bake_command, "lights", "lights, four a row, and their colours",
                                   kLightsHelp, *options);
    lights->add_option("--observer", options->light.observer, "cie1931, cie1964")
        ->capture_default_str();
    add_colour_target_options(*lights, options->light.colour);
    lights->callback([&session, options] {
        session.run = [&session, options] { return bake_lights(session, *options); };
    });
}

}  // namespace nacre::tool
