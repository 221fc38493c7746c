// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <set>
#include <sstream>
#include <string_view>

#include "constants.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "nacre/oslgen/write.h"

namespace nacre::oslgen {
namespace {

constexpr std::string_view kInclude = "#include \"nacre/";
constexpr std::string_view kCopyright = "// SPDX-FileCopyrightText: Nacre contributors";
constexpr std::string_view kLicence = "// SPDX-License-Identifier: BSD-3-Clause";

/// The header's path below `osl/`, or nothing where the line includes none of ours.
std::string included_header(std::string_view line)
{
    if (!line.starts_with(kInclude) || !line.ends_with('"')) return {};
    line.remove_prefix(std::string_view("#include \"").size());
    line.remove_suffix(1);
    return std::string(line);
}

/// The two lines of our licence stand once, at the top of the result.
bool is_repeated(std::string_view line)
{
    return line == "#pragma once" || line == kCopyright || line == kLicence;
}

void append(std::string_view text, const std::string& name, std::set<std::string>& seen,
            std::string& result)
{
    std::istringstream lines{std::string(text)};
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        const std::string header = included_header(line);
        if (header.empty()) {
            if (!is_repeated(line)) result += resolved(line) + '\n';
            continue;
        }
        if (is_resolved(header) || !seen.insert(header).second) continue;
        const auto content = find_resource("osl/" + header);
        if (!content)
            throw InputError(
                Diagnostic{name, number, "", fmt::format("no such header: {}", header)});
        append(*content, header, seen, result);
    }
}

}  // namespace

std::string inline_includes(const std::string& osl, const std::string& name)
{
    std::string result = fmt::format("{}\n{}\n", kCopyright, kLicence);
    std::set<std::string> seen;
    append(osl, name, seen, result);
    return result;
}

}  // namespace nacre::oslgen
