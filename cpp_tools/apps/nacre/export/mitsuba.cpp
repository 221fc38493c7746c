// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <CLI/CLI.hpp>
#include <pugixml.hpp>

#include "export/materials.h"
#include "export/xml_text.h"
#include "files/image_file.h"
#include "files/output.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/core/version.h"
#include "nacre/kinds/film_preview.h"
#include "shared/session.h"

namespace nacre::tool {
namespace {

namespace fs = std::filesystem;
using kinds::Interior;
using lut::SphereError;
using spectral::Vec3;

constexpr const char* kExportMitsubaHelp = R"(
A scene to <include>, with a BSDF of the material's id. Mitsuba 3 has no thin film: a film is the BSDF
nacre_film, a plugin in Python that is written beside the scene, with its reflectance and
transmittance each nanometre over cosθ as <id>_spectrum.exr, for RGB variants also as <id>_R.exr and
<id>_T.exr. A bare metal is a conductor with its n and k as .spd, a glass a dielectric of its n_d.

  nacre export mitsuba --material soap_film --set thickness_nm=300 -o soap_film.xml

  import mitsuba as mi; mi.set_variant("scalar_spectral")
  import nacre_film; nacre_film.register()
  scene = mi.load_file("scene.xml")    # <include filename="soap_film.xml"/> and <ref id="soap_film"/>)";

constexpr const char* kPlugin = "nacre_film.py";

/// The film at equal steps of cosθ from 0 to 1.
struct AngleTable {
    std::vector<kinds::FilmSpectrum> rows;
    SphereError error{};  ///< of colours between the rows
};

double cosine_of(std::size_t row, std::size_t count)
{
    // At grazing incidence itself the film reflects everything; the limit is taken from just
    // before.
    constexpr double kLeast = 1e-6;
    return std::max(kLeast, static_cast<double>(row) / static_cast<double>(count - 1));
}

std::vector<kinds::FilmSpectrum> spectra(const ExportedMaterial& material,
                                         const ResolvedTableOptions& table, std::size_t count)
{
    std::vector<kinds::FilmSpectrum> rows(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        rows[i] =
            kinds::film_spectrum(material.film, table.compile, cosine_of(i, count), material.value);
    });
    return rows;
}

/// Colours between rows are as linear in cosθ as the spectra are.
Vec3 between(const std::vector<kinds::FilmSpectrum>& rows, double cos_theta)
{
    const double place = cos_theta * static_cast<double>(rows.size() - 1);
    const std::size_t below = std::min(static_cast<std::size_t>(place), rows.size() - 2);
    const double fraction = place - static_cast<double>(below);
    Vec3 colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = std::lerp(rows[below].colour.reflectance[c],
                              rows[below + 1].colour.reflectance[c], fraction);
    return colour;
}

/// As many rows as the tolerance asks for, within what is sensible for a table of spectra.
AngleTable angle_table(const ExportedMaterial& material, const ResolvedTableOptions& table)
{
    constexpr std::size_t kFewest = 65, kMost = 2049;
    AngleTable result;
    for (std::size_t count = kFewest;; count = 2 * count - 1) {
        result.rows = spectra(material, table, count);
        result.error =
            lut::sphere_error(material.request, {material.value},
                              [&](double cosine, double) { return between(result.rows, cosine); });
        if (result.error.max <= table.compile.tolerance || count == kMost) return result;
    }
}

Image spectrum_image(const AngleTable& table, bool transmits)
{
    Image image{
        static_cast<int>(spectral::kWavelengths), static_cast<int>(table.rows.size()), {"R"}, {}};
    if (transmits) image.channels.emplace_back("T");
    for (const kinds::FilmSpectrum& row : table.rows)
        for (std::size_t w = 0; w < spectral::kWavelengths; ++w) {
            image.pixels.push_back(static_cast<float>(row.reflectance[w]));
            if (transmits) image.pixels.push_back(static_cast<float>(row.transmittance[w]));
        }
    return image;
}

Image colour_image(const AngleTable& table, Vec3 lut::FilmColour::*quantity)
{
    Image image{static_cast<int>(table.rows.size()), 1, {"R", "G", "B"}, {}};
    for (const kinds::FilmSpectrum& row : table.rows)
        for (const double channel : row.colour.*quantity)
            image.pixels.push_back(static_cast<float>(channel));
    return image;
}

/// One scene in the making.
struct Scene {
    pugi::xml_document xml;
    pugi::xml_node root;
    OutputFiles files;
    fs::path folder;
    bool needs_plugin = false;
    ordered_json summary = ordered_json::array();
    std::vector<std::string> lines;

    std::string add_file(const std::string& name, std::string bytes)
    {
        files.add(folder / name, std::move(bytes));
        return name;
    }
};

void set(pugi::xml_node bsdf, const char* type, const char* name, const std::string& value)
{
    pugi::xml_node child = bsdf.append_child(type);
    child.append_attribute("name") = name;
    child.append_attribute("value") = value.c_str();
}

void set(pugi::xml_node bsdf, const char* name, double value)
{
    set(bsdf, "float", name, fmt::format("{:.9g}", value));
}

pugi::xml_node add_bsdf(Scene& scene, const ExportedMaterial& material, const char* type)
{
    pugi::xml_node bsdf = scene.root.append_child("bsdf");
    bsdf.append_attribute("type") = type;
    bsdf.append_attribute("id") = material.source.id.c_str();
    return bsdf;
}

/// α = roughness², as Principled has it.
double alpha_of(const ExportedMaterial& material)
{
    return material.roughness * material.roughness;
}

const char* interior_name(Interior interior)
{
    switch (interior) {
        case Interior::opaque:
            return "opaque";
        case Interior::thin_wall:
            return "thin_wall";
        case Interior::solid:
            return "solid";
        case Interior::diffuse:
            break;
    }
    return "diffuse";
}

Attributes image_attributes(const ExportedMaterial& material, const TableProvenance& provenance,
                            const std::string& quantity)
{
    return {{"nacre:version", std::string(version())},
            {"nacre:quantity", quantity},
            {"nacre:material", provenance_json(material, provenance).dump()},
            {"colorInteropID", std::string("data")}};
}

void add_film(Scene& scene, const ExportedMaterial& material, const ResolvedTableOptions& table,
              const AngleTable& film)
{
    const std::string& id = material.source.id;
    const Interior interior = material.stack().interior();
    const bool transmits = interior != Interior::opaque;
    const Encoding encoding{Container::exr, Depth::floating};
    const auto encoded = [&](const Image& image, const char* quantity) {
        return encode_image(image, image_attributes(material, table.provenance, quantity),
                            encoding);
    };
    pugi::xml_node bsdf = add_bsdf(scene, material, "nacre_film");
    set(bsdf, "string", "spectrum",
        scene.add_file(id + "_spectrum.exr",
                       encoded(spectrum_image(film, transmits),
                               "power over wavelength (360 … 830 nm) and cosθ (top row 0)")));
    set(bsdf, "string", "reflectance",
        scene.add_file(id + "_R.exr", encoded(colour_image(film, &lut::FilmColour::reflectance),
                                              "reflectance over cosθ")));
    if (transmits)
        set(bsdf, "string", "transmittance",
            scene.add_file(id + "_T.exr",
                           encoded(colour_image(film, &lut::FilmColour::transmittance),
                                   "transmittance over cosθ")));
    set(bsdf, "string", "interior", interior_name(interior));
    set(bsdf, "alpha", alpha_of(material));
    set(bsdf, "eta", interior == Interior::opaque ? 1.0 : relative_index(material));
    if (interior == Interior::diffuse) {
        const auto& base = *material.stack().diffuse_base;
        set(bsdf, "rgb", "base", fmt::format("{:.9g}, {:.9g}, {:.9g}", base[0], base[1], base[2]));
    }
    scene.needs_plugin = true;
}

/// `.spd` of one part of a metal's index, a line a wavelength.
std::string spd_text(const ExportedMaterial& material, double (*part)(const std::complex<double>&))
{
    std::string text;
    for (const spectral::HeldEnds& ends : material.held) text += fmt::format("# {}\n", ends.note());
    const lut::IndexOnGrid& metal = material.request.stack.substrate;
    for (std::size_t w = 0; w < spectral::kWavelengths; ++w)
        fmt::format_to(std::back_inserter(text), "{:g} {:.9g}\n", spectral::wavelength_nm(w),
                       part(metal[w]));
    return text;
}

void add_metal(Scene& scene, const ExportedMaterial& material)
{
    const bool rough = material.roughness > 0.0;
    pugi::xml_node bsdf = add_bsdf(scene, material, rough ? "roughconductor" : "conductor");
    const auto add = [&](const char* name, const char* suffix,
                         double (*part)(const std::complex<double>&)) {
        pugi::xml_node spectrum = bsdf.append_child("spectrum");
        spectrum.append_attribute("name") = name;
        spectrum.append_attribute("filename") =
            scene.add_file(material.source.id + suffix, spd_text(material, part)).c_str();
    };
    add("eta", "_eta.spd", [](const auto& n) { return n.real(); });
    add("k", "_k.spd", [](const auto& n) { return n.imag(); });
    if (rough) {
        set(bsdf, "string", "distribution", "ggx");
        set(bsdf, "alpha", alpha_of(material));
    }
}

void add_glass(Scene& scene, const ExportedMaterial& material)
{
    const bool rough = material.roughness > 0.0;
    pugi::xml_node bsdf = add_bsdf(scene, material, rough ? "roughdielectric" : "dielectric");
    set(bsdf, "int_ior", relative_index(material));
    set(bsdf, "ext_ior", 1.0);
    if (rough) {
        set(bsdf, "string", "distribution", "ggx");
        set(bsdf, "alpha", alpha_of(material));
    }
}

void add_material(Scene& scene, const ExportedMaterial& material, const ResolvedTableOptions& table)
{
    const std::string& id = material.source.id;
    ordered_json summary = provenance_json(material, table.provenance);
    const lut::SampledStack& stack = material.request.stack;
    if (material.is_body()) {
        add_glass(scene, material);
        summary["left_out"] = {"dispersion"};
        scene.lines.push_back(fmt::format("{}: dielectric of n_d {:.5f}, without its dispersion",
                                          id, relative_index(material)));
    } else if (stack.layers.empty() && material.stack().interior() == Interior::opaque &&
               index_at(stack.ambient, kLineD).real() < 1.001) {
        add_metal(scene, material);
        scene.lines.push_back(id + ": conductor with n and k each nanometre");
    } else {
        const AngleTable film = angle_table(material, table);
        add_film(scene, material, table, film);
        summary["angles"] = film.rows.size();
        summary["error"] = error_json(film.error);
        scene.lines.push_back(fmt::format(
            "{}: {} angles x {} wavelengths, ΔE00 mean {:.2g}, max {:.2g} between angles", id,
            film.rows.size(), spectral::kWavelengths, film.error.mean, film.error.max));
    }
    scene.summary.push_back(std::move(summary));
}

int export_mitsuba(const Session& session, const ExportOptions& options)
{
    const fs::path output = options.output;
    if (output.extension() != ".xml")
        throw InputError({options.output, 0, "-o", "must end in .xml"});
    const ResolvedTableOptions table = resolve(options.table);
    const std::vector<ExportedMaterial> materials =
        exported_materials(session, options, table, "a BSDF of Mitsuba");
    check_writable(options.output);
    Scene scene;
    scene.folder = output.parent_path();
    scene.root = scene.xml.append_child("scene");
    scene.root.append_attribute("version") = "3.0.0";
    for_each_material(session, materials, [&](const ExportedMaterial& material) {
        add_material(scene, material, table);
    });
    if (scene.needs_plugin)
        scene.add_file(kPlugin,
                       std::string(find_resource(std::string("mitsuba/") + kPlugin).value()));
    scene.files.add(output, xml_text(scene.xml));
    scene.files.write();
    print_summary(session, scene.summary, scene.lines);
    return kExitOk;
}

}  // namespace

void add_export_mitsuba(CLI::App& command, Session& session)
{
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* mitsuba = command.add_subcommand("mitsuba", "BSDFs for Mitsuba 3, spectral and RGB");
    mitsuba->footer(kExportMitsubaHelp);
    add_export_options(*mitsuba, *options, ".xml; tables and the plugin go beside it");
    add_value_options(*mitsuba, *options);
    mitsuba
        ->add_option("--tolerance", options->table.tolerance,
                     "largest ΔE00 between angles; decides how many there are")
        ->capture_default_str();
    add_illuminant_options(*mitsuba, options->table);
    mitsuba->callback([&session, options] {
        session.run = [&session, options] { return export_mitsuba(session, *options); };
    });
}

}  // namespace nacre::tool
