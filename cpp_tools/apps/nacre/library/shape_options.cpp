// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "library/shape_options.h"

#include <charconv>
#include <functional>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "nacre/core/diagnostics.h"
#include "nacre/library/spectrum_library.h"

namespace nacre::tool {
namespace {

using spectral::SpectrumShape;

std::vector<std::string> split(const std::string& text, char separator)
{
    std::vector<std::string> parts(1);
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::optional<double> number(const std::string& text)
{
    double value = 0.0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

/// @throws InputError unless there are between `fewest` and `most` of them
std::vector<double> numbers(const std::string& text, std::size_t fewest, std::size_t most,
                            const char* form)
{
    std::vector<double> values;
    for (const std::string& part : split(text, ':'))
        if (const auto value = number(part)) values.push_back(*value);
    const auto parts = split(text, ':').size();
    if (values.size() != parts || parts < fewest || parts > most)
        throw InputError({{}, 0, {}, fmt::format("must be {}", form)});
    return values;
}

SpectrumShape constant(const std::string& text)
{
    return spectral::ConstantShape{numbers(text, 1, 1, "a number")[0]};
}

SpectrumShape box(const std::string& text)
{
    const auto given =
        numbers(text, 3, 4, "FIRST:LAST:VALUE or FIRST:LAST:VALUE:EDGE, numbers between colons");
    return spectral::BoxShape{given[0], given[1], given[2], given.size() == 4 ? given[3] : 0.0};
}

SpectrumShape gaussian(const std::string& text)
{
    const auto given = numbers(text, 3, 3, "CENTRE:FWHM:PEAK, numbers between colons");
    return spectral::GaussianShape{given[0], given[1], given[2]};
}

spectral::Spectrum control_points(const std::string& text)
{
    std::vector<double> wavelengths_nm, values;
    for (const std::string& point : split(text, ',')) {
        const auto given = numbers(point, 2, 2, "NM:VALUE,NM:VALUE,…, numbers");
        wavelengths_nm.push_back(given[0]);
        values.push_back(given[1]);
    }
    return {std::move(wavelengths_nm), std::move(values)};
}

/// `KEY` or `KEY:FACTOR`; no key has a colon.
SpectrumShape scaled(const std::string& text)
{
    const auto parts = split(text, ':');
    const auto factor = parts.size() == 2 ? number(parts[1]) : std::optional(1.0);
    if (parts.size() > 2 || !factor)
        throw InputError({{}, 0, {}, "must be KEY or KEY:FACTOR, with a number after the colon"});
    return spectral::ScaledShape{spectral::library_spectrum(parts[0]), *factor};
}

using ReadShape = std::function<SpectrumShape(const std::string&)>;

/// Calls `read` for each text; what it throws becomes problems of `option text`.
void read_shapes(const char* option, const std::vector<std::string>& texts, const ReadShape& read,
                 std::vector<SpectrumShape>& shapes, DiagnosticList& problems)
{
    for (const std::string& text : texts) {
        const std::string field = fmt::format("--{} {}", option, text);
        try {
            SpectrumShape shape = read(text);
            if (auto problem = spectral::shape_problem(shape))
                problems.add({{}, 0, field, std::move(*problem)});
            shapes.push_back(std::move(shape));
        } catch (const InputError& error) {
            for (const Diagnostic& diagnostic : error.diagnostics())
                problems.add({{},
                              0,
                              field,
                              diagnostic.field.empty()
                                  ? diagnostic.message
                                  : fmt::format("{} {}", diagnostic.field, diagnostic.message)});
        }
    }
}

std::vector<double> wavelengths(const ShapeOptions& options, DiagnosticList& problems)
{
    try {
        const auto range = numbers(options.range, 2, 2, "FIRST:LAST, two numbers");
        return spectral::even_wavelengths(range[0], range[1], options.step_nm);
    } catch (const InputError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics())
            problems.add({{},
                          0,
                          diagnostic.field == "step" ? "--step" : "--range",
                          diagnostic.field.empty()
                              ? fmt::format("{} (got '{}')", diagnostic.message, options.range)
                              : diagnostic.message});
    }
    return {};
}

}  // namespace

void add_shape_options(CLI::App& command, ShapeOptions& options)
{
    const auto add = [&command](const char* name, std::vector<std::string>& texts, const char* form,
                                const char* help) {
        command.add_option(name, texts, help)
            ->type_name(form)
            ->expected(1)
            ->allow_extra_args(false)
            ->take_all();
    };
    add("--constant", options.constants, "VALUE", "the same everywhere");
    add("--box", options.boxes, "FIRST:LAST:VALUE[:EDGE]",
        "a value between two wavelengths, with edges of so many nm");
    add("--gaussian", options.gaussians, "CENTRE:FWHM:PEAK", "a bell of a width at half its peak");
    add("--points", options.points, "NM:VALUE,NM:VALUE,…", "a curve through control points");
    add("--from", options.spectra, "KEY[:FACTOR]", "a spectrum of the library");
    command
        .add_option("--interpolation", options.interpolation,
                    "between control points; smooth is monotone wherever they are")
        ->check(CLI::IsMember({"linear", "smooth"}))
        ->capture_default_str();
    command.add_option("--range", options.range, "wavelengths in nm")
        ->type_name("FIRST:LAST")
        ->capture_default_str();
    command.add_option("--step", options.step_nm, "nm")->capture_default_str();
}

spectral::Spectrum spectrum_of_shapes(const ShapeOptions& options)
{
    std::vector<SpectrumShape> shapes;
    DiagnosticList problems;
    const auto curve = [&options](const std::string& text) -> SpectrumShape {
        if (options.interpolation == "smooth") return spectral::SmoothShape{control_points(text)};
        return spectral::LinearShape{control_points(text)};
    };
    read_shapes("constant", options.constants, constant, shapes, problems);
    read_shapes("box", options.boxes, box, shapes, problems);
    read_shapes("gaussian", options.gaussians, gaussian, shapes, problems);
    read_shapes("points", options.points, curve, shapes, problems);
    read_shapes("from", options.spectra, scaled, shapes, problems);
    std::vector<double> grid = wavelengths(options, problems);
    problems.throw_if_any();
    if (shapes.empty())
        throw InputError(
            {{}, 0, {}, "must have --constant, --box, --gaussian, --points or --from"});
    if (grid.front() > spectral::kLastNm || grid.back() < spectral::kFirstNm)
        throw InputError({{},
                          0,
                          "--range",
                          fmt::format("must overlap {} … {} nm (got {})", spectral::kFirstNm,
                                      spectral::kLastNm, options.range)});
    return spectral::sum_of_shapes(shapes, std::move(grid));
}

std::string shapes_text(const ShapeOptions& options)
{
    std::string text;
    const auto add = [&text](const char* name, const std::vector<std::string>& parts) {
        for (const std::string& part : parts)
            text += fmt::format("{}{} {}", text.empty() ? "" : " + ", name, part);
    };
    add("constant", options.constants);
    add("box", options.boxes);
    add("gaussian", options.gaussians);
    add(options.interpolation == "smooth" ? "smooth points" : "points", options.points);
    add("from", options.spectra);
    return text;
}

}  // namespace nacre::tool
