// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "medium_yaml.h"

#include <fmt/format.h>

#include "nacre/core/diagnostics.h"
#include "nacre/core/text_lines.h"
#include "nacre/media/optical_constants.h"
#include "nacre/readers/refractiveindex_yaml.h"

namespace nacre::spectral {

namespace {

/// As YAML has it between double quotes.
std::string quoted_text(const std::string& text)
{
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

std::string medium_yaml(const MediumTable& table)
{
    std::string yaml;
    if (!table.name.empty()) yaml += fmt::format("NAMES:\n  - {}\n", quoted_text(table.name));
    if (const std::string citation = clean_text(table.references); !citation.empty())
        yaml += fmt::format("REFERENCES: {}\n", quoted_text(citation));
    if (!table.comments.empty())
        yaml += fmt::format("COMMENTS: {}\n", quoted_text(clean_text(table.comments)));
    yaml += fmt::format("DATA:\n  - type: tabulated {}\n    data: |\n", table.has_k ? "nk" : "n");
    for (std::size_t i = 0; i < table.n.size(); ++i) {
        yaml += fmt::format("        {} {}", table.wavelengths_nm[i] / 1000.0, table.n[i]);
        yaml += table.has_k ? fmt::format(" {}\n", table.k[i]) : "\n";
    }
    return yaml;
}

std::string changes_text(std::span<const std::string> changes)
{
    std::string text;
    for (const std::string& change : changes)
        text += fmt::format("{}{}", text.empty() ? "Changed when it was imported: " : "; ", change);
    return text;
}

std::string refractiveindex_yaml_of_file(std::string_view text, std::string_view file,
                                         std::string_view references,
                                         std::vector<std::string>& changes)
{
    if (!file.ends_with(".yml") && !file.ends_with(".yaml")) {
        std::string yaml = refractiveindex_yaml_from_csv(text, file, references, changes);
        (void)parse_refractiveindex_yaml(yaml, file);
        return yaml;
    }
    const Medium medium = parse_refractiveindex_yaml(text, file);
    changes.insert(changes.end(), medium.changes.begin(), medium.changes.end());
    std::string yaml(text);
    const std::string citation = clean_text(std::string(references));
    if (citation.empty()) return yaml;
    if (!medium.references.empty())
        throw InputError(
            {std::string(file), 0, "REFERENCES", "is stated already: leave the citation out"});
    return yaml + fmt::format("\nREFERENCES: {}\n", quoted_text(citation));
}

}  // namespace nacre::spectral
