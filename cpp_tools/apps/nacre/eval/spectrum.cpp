// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "eval/colours.h"
#include "eval/questions.h"
#include "nacre/core/diagnostics.h"
#include "nacre/library/lights.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/spectral/colour.h"
#include "nacre/spectral/colour_quadrature.h"
#include "nacre/spectral/rgb_spectrum.h"

namespace nacre::tool {

using spectral::Illuminant;
using spectral::ObserverId;
using spectral::Vec3;

namespace {

constexpr const char* kSpectrumHelp = R"(
record  {"wavelength_nm": […], "values": […], "kind": "emission|reflectance",
         "illuminant": "D65", "observer": "cie1931|cie1964"}
        {"spectrum": "study/box", "kind": "reflectance", "scale": 1, "illuminant": "lamp/hps"}
        {"illuminant": "D50"}, {"blackbody_K": 2856} or {"daylight_K": 6504}, with "observer" or not
        {"rgb": [r, g, b], "method": "jakob-hanika|smits", "kind": "reflectance|emission",
         "wavelength_nm": […], "illuminant": "D65", "observer": "cie1931|cie1964"}
  wavelength_nm  ascending. To 1 nm: by Sprague where six or more stand in equal steps (CIE 167),
                 else linearly; outside of them the nearest value counts (CIE 015:2018, 7.2.3)
  spectrum       key of nacre library list --kind spectra; kind takes it for another than it was
                 measured as, such as the shape of a light for that of a paint; scale multiplies it
  illuminant     of a reflectance (default D65): a name of `nacre library list --kind illuminants`,
                 blackbody:3200, daylight:5600, line:589.3 or line:435.8@1,546.1@0.8 (power after @)
  observer       default cie1931
  rgb            linear, of the space of the answer: a spectrum that has this colour under D65 and
                 cie1931, a light with kind emission; then also "wavelength_nm", "values",
                 "error_dE00" of the round trip and, by jakob-hanika, "coefficients" by nm: the
                 values are 1/2 + x/(2√(1 + x²)), x their polynomial, for a light times 2 max(rgb)
                 times D65 of Y = 1
  method         jakob-hanika (default) meets every colour of Rec.709 with values in [0, 1];
                 smits is off by some hundredths
  wavelength_nm  with rgb: where values are wanted, default 380, 390 … 780
result  {"XYZ": […], "xy": […], "Lab": […], "rgb": […], "space": "…", "cct_K": …, "duv": …}
        emission is normalised with k = 1/∫ȳ dλ, reflectance with k = 1/∫Sȳ dλ; illuminants, whose
        tables are relative, to Y = 1. Lab and rgb of a reflectance are those of a perfect white
        adapted to (100, 0, 0) and (1, 1, 1); Lab of an emission is relative to D65 with Y = 1.
        cct_K and duv are null where a colour has no correlated colour temperature.

The white point of D50:
  echo '{"illuminant": "D50"}' | nacre eval spectrum
Two lines of mercury:
  echo '{"illuminant": "line:435.8@1,546.1@0.8"}' | nacre eval spectrum
A smooth reflectance for an orange:
  echo '{"rgb": [0.8, 0.3, 0.02]}' | nacre eval spectrum
In a space of an OpenColorIO config:
  nacre eval spectrum chips.json --config config.ocio --space ACEScg)";

/// What all kinds of records come down to: XYZ, the same relative to D65 for rgb, and to the 2
/// degree observer, whose locus of Planck the colour temperature belongs to.
struct Colour {
    Vec3 xyz, xyz_d65, lab_white, xyz_1931;
    spectral::ColourOf what = spectral::ColourOf::surface;
    ordered_json spectrum = ordered_json::object();  ///< members that only some records answer with
};

/// @param xyz_of  the XYZ to an observer
template <class XyzOf>
Colour emission_colour(ObserverId observer, const XyzOf& xyz_of)
{
    const Vec3 xyz = xyz_of(observer);
    return {.xyz = xyz,
            .xyz_d65 = multiply(spectral::emission_to_d65(observer), xyz),
            .lab_white = spectral::emission_white(observer),
            .xyz_1931 = observer == ObserverId::cie1931 ? xyz : xyz_of(ObserverId::cie1931),
            .what = spectral::ColourOf::light};
}

Colour source_colour(const Illuminant& source, ObserverId observer)
{
    return emission_colour(observer, [&](ObserverId who) {
        Vec3 xyz = spectral::emission_to_xyz(source.power, who);
        const double y = xyz[1];
        for (double& value : xyz) value /= y;
        return xyz;
    });
}

double read_linearly(const spectral::Sampled& values, double wavelength_nm)
{
    const double at = wavelength_nm - spectral::kFirstNm;
    const auto i = std::min(static_cast<std::size_t>(at), values.size() - 2);
    const double part = at - static_cast<double>(i);
    return values[i] + part * (values[i + 1] - values[i]);
}

/// The first wavelength that is not dark; the last one where all are.
int lower_bound_nm(const spectral::Sampled& values)
{
    std::size_t i = 0;
    while (i + 1 < values.size() && values[i] == 0.0) ++i;
    return spectral::kFirstNm + static_cast<int>(i);
}

/// The sum of `values` with weights of which an illuminant of E makes those of an emission.
Vec3 sampled_xyz(const spectral::Sampled& values, const Illuminant& illuminant, ObserverId observer,
                 const std::string& sampling)
{
    const auto weights = reflectance_weights(
        illuminant, observer, spectral::colour_space("xyz_d65"), spectral::Adaptation::none);
    const auto quadrature = named_quadrature(sampling, weights, lower_bound_nm(values));
    if (!quadrature) return weights.apply(values);
    std::vector<double> samples;
    samples.reserve(quadrature->wavelength_nm.size());
    for (const double nm : quadrature->wavelength_nm) samples.push_back(read_linearly(values, nm));
    return quadrature_sum(*quadrature, samples);
}

Colour reflectance_colour(const spectral::Sampled& reflectance, const Illuminant& illuminant,
                          ObserverId observer, const ColourChoices& choices)
{
    const Vec3 white = spectral::white_under(illuminant, observer);
    const Vec3 xyz = sampled_xyz(reflectance, illuminant, observer, choices.sampling);
    return {.xyz = xyz,
            .xyz_d65 = multiply(
                spectral::adaptation(choices.adaptation, white, spectral::d65_white(), kWithoutCat),
                xyz),
            .lab_white = white,
            .xyz_1931 =
                observer == ObserverId::cie1931
                    ? xyz
                    : sampled_xyz(reflectance, illuminant, ObserverId::cie1931, choices.sampling)};
}

/// Records that name a light: `illuminant`, `blackbody_K` or `daylight_K` alone.
Colour read_source(ObjectReader& reader, const char* key, DiagnosticList& problems)
{
    const ObserverId observer = read_observer(reader);
    std::optional<Illuminant> source;
    if (const std::string_view kind = key; kind == "illuminant") {
        source = read_illuminant(reader);
    } else if (kind == "blackbody_K") {
        if (const auto kelvin = reader.number(key, {100.0, 1e6}))
            source = spectral::blackbody(*kelvin);
    } else if (const auto kelvin = reader.number(key, {4000.0, 25000.0})) {
        source = spectral::daylight(*kelvin);
    }
    reader.refuse_unknown_keys();
    problems.throw_if_any();
    return source_colour(*source, observer);
}

std::optional<spectral::Spectrum> read_samples(ObjectReader& reader)
{
    const auto wavelengths = reader.numbers("wavelength_nm", kPositive);
    const auto values = reader.numbers("values", kAnyNumber);
    if (!wavelengths || !values) return std::nullopt;
    if (values->size() != wavelengths->size()) {
        reader.problem("values", fmt::format("must have one value for each of the {} wavelengths "
                                             "(got {})",
                                             wavelengths->size(), values->size()));
        return std::nullopt;
    }
    if (wavelengths->size() < 2) {
        reader.problem("wavelength_nm",
                       fmt::format("must have ≥ 2 wavelengths (got {})", wavelengths->size()));
        return std::nullopt;
    }
    for (std::size_t i = 1; i < wavelengths->size(); ++i) {
        if ((*wavelengths)[i] > (*wavelengths)[i - 1]) continue;
        reader.problem(fmt::format("wavelength_nm[{}]", i),
                       fmt::format("must be > {} nm, the one before (got {})",
                                   (*wavelengths)[i - 1], (*wavelengths)[i]));
        return std::nullopt;
    }
    if (wavelengths->back() < spectral::kFirstNm || wavelengths->front() > spectral::kLastNm) {
        reader.problem(
            "wavelength_nm",
            fmt::format("must reach into the visible {} … {} nm (got {} … {})", spectral::kFirstNm,
                        spectral::kLastNm, wavelengths->front(), wavelengths->back()));
        return std::nullopt;
    }
    return spectral::Spectrum(*wavelengths, *values);
}

/// Values on the grid, and what they are.
struct GivenSpectrum {
    spectral::Sampled values;
    bool is_emission;
};

/// `kind`: what a spectrum stands for in this record, whatever it was measured as; `scale`
/// multiplies its values. Nothing where they do not do for that.
std::optional<GivenSpectrum> read_as_kind(ObjectReader& reader,
                                          const spectral::NamedSpectrum& found)
{
    const auto kind = reader.optional("kind") ? reader.choice("kind", {"emission", "reflectance"})
                                              : std::string(spectrum_kind_name(*found.kind));
    const auto scale = reader.optional("scale") ? reader.number("scale", kPositive) : 1.0;
    if (!kind || !scale) return std::nullopt;
    const bool emission = *kind == "emission";
    std::vector<double> values = found.samples.values();
    for (double& value : values) value *= *scale;
    const auto problem = kind_problem(
        {found.samples.wavelengths_nm(), std::move(values)},
        emission ? spectral::SpectrumKind::emission : spectral::SpectrumKind::reflectance);
    if (problem) {
        reader.problem("spectrum", fmt::format("{}: {}; scale multiplies it", found.key, *problem));
        return std::nullopt;
    }
    spectral::Sampled grid = found.on_grid();
    for (double& value : grid) value *= *scale;
    return GivenSpectrum{grid, emission};
}

/// `spectrum`: the key of one in the library, with `kind` and `scale` or not.
std::optional<GivenSpectrum> read_named(ObjectReader& reader)
{
    const auto key = reader.text("spectrum");
    if (!key) return std::nullopt;
    try {
        return read_as_kind(reader, spectral::library_spectrum(*key));
    } catch (const InputError& error) {
        for (const Diagnostic& problem : error.diagnostics())
            reader.problem("spectrum", problem.message);
        return std::nullopt;
    }
}

/// `wavelength_nm`, `values` and `kind`.
std::optional<GivenSpectrum> read_given(ObjectReader& reader)
{
    const auto samples = read_samples(reader);
    const auto kind = reader.choice("kind", {"emission", "reflectance"});
    if (!samples || !kind) return std::nullopt;
    return GivenSpectrum{samples->on_grid(), *kind == "emission"};
}

Colour read_sampled(ObjectReader& reader, DiagnosticList& problems, const ColourChoices& choices)
{
    const auto given = reader.has("spectrum") ? read_named(reader) : read_given(reader);
    const ObserverId observer = read_observer(reader);
    const bool named = reader.has("illuminant");
    if (named && given && given->is_emission)
        reader.problem("illuminant", "belongs to kind reflectance; an emission is its own light");
    auto illuminant =
        named ? read_illuminant(reader)
              : (void(reader.optional("illuminant")), spectral::named_illuminant("D65"));
    reader.refuse_unknown_keys();
    problems.throw_if_any();
    if (given->is_emission)
        return emission_colour(observer, [&](ObserverId who) {
            return sampled_xyz(given->values, spectral::named_illuminant("E"), who,
                               choices.sampling);
        });
    return reflectance_colour(given->values, *illuminant, observer, choices);
}

/// `wavelength_nm` where the values are wanted.
std::vector<double> read_wanted(ObjectReader& reader)
{
    if (reader.has("wavelength_nm"))
        return reader.numbers("wavelength_nm", {spectral::kFirstNm, spectral::kLastNm})
            .value_or(std::vector<double>{});
    void(reader.optional("wavelength_nm"));
    std::vector<double> wanted;
    for (int nm = 380; nm <= 780; nm += 10) wanted.push_back(nm);
    return wanted;
}

std::optional<Vec3> read_rgb(ObjectReader& reader)
{
    const auto numbers = reader.numbers("rgb", kAnyNumber);
    if (!numbers) return std::nullopt;
    if (numbers->size() != 3) {
        reader.problem("rgb", fmt::format("must be 3 numbers (got {})", numbers->size()));
        return std::nullopt;
    }
    return Vec3{(*numbers)[0], (*numbers)[1], (*numbers)[2]};
}

ordered_json spectrum_json(const spectral::RisenSpectrum& risen, const std::vector<double>& wanted)
{
    ordered_json values = ordered_json::array();
    for (const double nm : wanted) values.push_back(read_linearly(risen.values, nm));
    ordered_json result = {{"wavelength_nm", wanted}, {"values", std::move(values)}};
    if (risen.coefficients) result["coefficients"] = *risen.coefficients;
    result["error_dE00"] = risen.error;
    return result;
}

/// `rgb`, of the space that answers are in, and how a spectrum is found for it.
Colour read_upsampled(ObjectReader& reader, DiagnosticList& problems, const ColourTarget& target,
                      const ColourChoices& choices)
{
    const std::optional<Vec3> rgb = read_rgb(reader);
    const std::vector<double> wanted = read_wanted(reader);
    const auto method = reader.optional("method")
                            ? reader.choice("method", {"jakob-hanika", "smits"})
                            : "jakob-hanika";
    const auto kind = reader.optional("kind") ? reader.choice("kind", {"emission", "reflectance"})
                                              : "reflectance";
    const bool emission = kind == "emission";
    const ObserverId observer = read_observer(reader);
    const bool named = reader.optional("illuminant") != nullptr;
    if (named && emission)
        reader.problem("illuminant", "belongs to kind reflectance; an emission is its own light");
    const auto illuminant = named ? read_illuminant(reader) : spectral::named_illuminant("D65");
    reader.refuse_unknown_keys();
    problems.throw_if_any();
    const spectral::RisenSpectrum risen = spectral::rgb_to_spectrum(
        *rgb, linear_space(target), spectral::upsampling_from_name(*method),
        emission ? spectral::SpectrumKind::emission : spectral::SpectrumKind::reflectance);
    Colour colour =
        emission ? emission_colour(
                       observer, [&](ObserverId who) { return emission_to_xyz(risen.values, who); })
                 : reflectance_colour(risen.values, *illuminant, observer, choices);
    colour.spectrum = spectrum_json(risen, wanted);
    return colour;
}

Colour read_colour(const json& record, const ColourTarget& target, const ColourChoices& choices)
{
    DiagnosticList problems;
    ObjectReader reader(record, "", problems);
    problems.throw_if_any();
    if (reader.has("rgb")) return read_upsampled(reader, problems, target, choices);
    const bool sampled = reader.has("spectrum") || reader.has("values") ||
                         reader.has("wavelength_nm") || reader.has("kind");
    if (!sampled)
        for (const char* key : {"blackbody_K", "daylight_K", "illuminant"})
            if (reader.has(key)) return read_source(reader, key, problems);
    return read_sampled(reader, problems, choices);
}

ordered_json evaluate_spectrum(const json& record, const ColourTarget& target,
                               const ColourChoices& choices)
{
    const Colour colour = read_colour(record, target, choices);
    const auto& xyz = colour.xyz;
    ordered_json xy = nullptr, cct = nullptr, duv = nullptr;
    if (xyz[0] + xyz[1] + xyz[2] > 0.0) xy = spectral::xyz_to_xy(xyz);
    if (!xy.is_null()) {
        if (const auto temperature = spectral::colour_temperature(colour.xyz_1931)) {
            cct = temperature->cct_kelvin;
            duv = temperature->duv;
        }
    }
    ordered_json result = {{"XYZ", xyz},
                           {"xy", xy},
                           {"Lab", spectral::xyz_to_lab(xyz, colour.lab_white)},
                           {"rgb", rgb_of(colour.xyz_d65, target, choices, colour.what)},
                           {"space", target.name},
                           {"cct_K", cct},
                           {"duv", duv}};
    result.update(colour.spectrum);
    return result;
}

}  // namespace

void add_eval_spectrum(CLI::App& eval, Session& session)
{
    add_colour_command(eval, session, "spectrum", "colour and colour temperature of a spectrum",
                       kSpectrumHelp, std::make_shared<ColourOptions>(), evaluate_spectrum);
}

}  // namespace nacre::tool
