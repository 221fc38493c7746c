// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "tables/stack_table.h"

#include <charconv>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "nacre/core/diagnostics.h"
#include "shared/session.h"
#include "tables/error.h"

namespace nacre::tool {
namespace {

std::optional<std::array<int, 2>> parse_size(const std::string& text, int most)
{
    if (text.empty()) return std::nullopt;
    std::array<int, 2> size{};
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size[0]);
    const bool separated = width.ec == std::errc{} && width.ptr != end && *width.ptr == 'x';
    const auto height = separated ? std::from_chars(width.ptr + 1, end, size[1]) : width;
    if (!separated || height.ec != std::errc{} || height.ptr != end || size[0] < 2 || size[1] < 1 ||
        size[0] > most || size[1] > most)
        throw InputError(
            {"", 0, "--size",
             fmt::format("must be WIDTHxHEIGHT, 2x1 … {0}x{0} (got {1})", most, text)});
    return size;
}

lut::Table take_quantity(lut::FilmTables tables, const std::string& quantity)
{
    return quantity == "transmittance" ? std::move(*tables.transmittance)
                                       : std::move(tables.reflectance);
}

}  // namespace

void add_stack_table_options(CLI::App& command, StackTableOptions& options)
{
    command.add_option("--quantity", options.quantity)
        ->check(CLI::IsMember({"reflectance", "transmittance"}))
        ->capture_default_str();
    command.add_option("--size", options.size, "WIDTHxHEIGHT in texels, instead of --tolerance");
    command.add_option("--depth", options.depth, "default: float")
        ->check(CLI::IsMember({"float", "half"}));
}

Encoding table_encoding(const std::string& output, const std::string& depth)
{
    const Encoding encoding = encoding_for(output, depth);
    if (encoding.container == Container::png)
        throw InputError({output, 0, "-o", "must end in .exr, .tx or .ftxt: a table needs floats"});
    return encoding;
}

lut::Table bake_stack_table(const Session& session, lut::FilmTableRequest request,
                            const StackTableOptions& options, Depth depth,
                            const spectral::ColourSpace& space)
{
    request.size = parse_size(options.size, request.max_texels);
    request.transmittance = options.quantity == "transmittance";
    Progress progress(session);
    request.progress = [&progress](double fraction) {
        progress.show(fraction);
        return true;
    };
    lut::Table table = take_quantity(lut::bake_film_tables(request), options.quantity);
    if (depth == Depth::half) {
        round_to_half(table.texels);
        measure_error(table, request, space);
    }
    return table;
}

}  // namespace nacre::tool
