// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "nacre/kinds/film.h"
#include "nacre/lut/film_table.h"
#include "nacre/lut/iridescence_fit.h"
#include "tables/options.h"

/// @file
/// What the formats of `nacre export` share: which materials, at which values, and files that
/// appear together.

namespace nacre::tool {

using nlohmann::ordered_json;

struct Session;

struct ExportOptions {
    std::vector<std::string> templates;    ///< files
    std::vector<std::string> materials;    ///< ids of the library
    std::vector<std::string> assignments;  ///< NAME=VALUE
    std::string output;
    TableOptions table;
};

/// TEMPLATE…, --material and -o.
void add_export_options(CLI::App& command, ExportOptions& options, const char* output_help);
/// --set
void add_value_options(CLI::App& command, ExportOptions& options);

/// One material at the values that it is exported with.
struct ExportedMaterial {
    kinds::MaterialTemplate source;
    /// That stands for it: `source`, or the bare surface of a body as a film without layers.
    kinds::MaterialTemplate film;
    lut::FilmTableRequest request;  ///< of `film`; what varies keeps its range
    std::vector<spectral::HeldEnds> held;
    double value = 0.0;  ///< of what varies, nm or a factor
    double roughness = 0.0;

    /// `thickness_nm`, `thickness_scale`, or empty where nothing varies.
    [[nodiscard]] std::string varying() const;
    /// Whether light goes through it: then `film` is its bare surface.
    [[nodiscard]] bool is_body() const;
    [[nodiscard]] const kinds::Film& stack() const { return kinds::film_of(film); }
};

/// Reads, looks up media, with a note where they are held, and applies --set.
/// @param format  for the message that refuses what has no film
/// @throws InputError with the problems of every material
[[nodiscard]] std::vector<ExportedMaterial> exported_materials(const Session& session,
                                                               const ExportOptions& options,
                                                               const ResolvedTableOptions& table,
                                                               const char* format);

/// The only one, for formats whose file holds one. @throws InputError where there are more
[[nodiscard]] ExportedMaterial one_material(std::vector<ExportedMaterial> materials);

/// One after the other, with the run's progress.
void for_each_material(const Session& session, const std::vector<ExportedMaterial>& materials,
                       const std::function<void(const ExportedMaterial&)>& act);

/// n + ik of a medium on the 1 nm grid at a wavelength, linear in between.
[[nodiscard]] std::complex<double> index_at(const lut::IndexOnGrid& medium, double wavelength_nm);
inline constexpr double kLineF = 486.1327, kLineD = 587.5618, kLineC = 656.2725;  ///< ISO 7944, nm

/// Of the substrate relative to the ambient, at the d line.
[[nodiscard]] double relative_index(const ExportedMaterial& material);

/// Of the tables of a material.
[[nodiscard]] TableProvenance table_provenance(const ExportedMaterial& material,
                                               TableProvenance provenance);

/// The same film with its colours in linear Rec.709, which renderers without a choice work in.
[[nodiscard]] lut::FilmTableRequest rec709_request(const ExportedMaterial& material,
                                                   const TableProvenance& provenance);

/// Id, source, status, values, light and media with held ends, as every format carries them.
[[nodiscard]] ordered_json provenance_json(const ExportedMaterial& material,
                                           const TableProvenance& provenance);

[[nodiscard]] ordered_json error_json(const lut::SphereError& error);

/// Files that are written aside and then take their names one after the other: on an error none of
/// them appears.
class OutputFiles {
public:
    void add(const std::filesystem::path& path, std::string bytes);
    /// @throws InputError when one of them cannot be written
    void write() const;

private:
    std::vector<std::pair<std::filesystem::path, std::string>> files_;
};

/// The summary of a run: JSON with --json, else one line a material.
void print_summary(const Session& session, const ordered_json& list,
                   const std::vector<std::string>& lines);

}  // namespace nacre::tool
