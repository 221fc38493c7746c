// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <string>

#include "nacre/core/limits.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"
#include "sample_list.h"

namespace nacre::spectral {

namespace {

/// Lines of a text by position; positions must not descend.
class LineCounter {
public:
    explicit LineCounter(std::string_view text) : text_(text) {}

    int at(std::ptrdiff_t offset)
    {
        const auto end =
            std::min(static_cast<std::size_t>(std::max<std::ptrdiff_t>(offset, 0)), text_.size());
        for (; at_ < end; ++at_)
            if (text_[at_] == '\n') ++line_;
        return line_;
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

/// Depth of the deepest element, counted up to one above the limit.
int depth_of(const pugi::xml_node& root)
{
    int deepest = 0, depth = 0;
    pugi::xml_node node = root.first_child();
    while (node && deepest <= kMaxXmlDepth) {
        deepest = std::max(deepest, depth + 1);
        if (node.first_child()) {
            node = node.first_child();
            ++depth;
            continue;
        }
        while (node != root && !node.next_sibling()) {
            node = node.parent();
            --depth;
        }
        if (node == root) break;
        node = node.next_sibling();
    }
    return deepest;
}

bool has_document_type(const pugi::xml_document& document)
{
    return std::any_of(document.begin(), document.end(), [](const pugi::xml_node& node) {
        return node.type() == pugi::node_doctype;
    });
}

/// The child of that name whatever its namespace's prefix.
pugi::xml_node child_of(const pugi::xml_node& parent, std::string_view name)
{
    for (const pugi::xml_node& child : parent.children()) {
        std::string_view found = child.name();
        if (const std::size_t colon = found.find(':'); colon != std::string_view::npos)
            found.remove_prefix(colon + 1);
        if (found == name) return child;
    }
    return {};
}

std::string text_of(const pugi::xml_node& parent, std::string_view name)
{
    return clean_text(child_of(parent, name).child_value());
}

/// IES TM-27-14, table of spectral quantities, in whatever case a file has them.
std::optional<SpectrumKind> kind_of(std::string_view quantity)
{
    const auto is = [quantity](std::string_view word) { return same_letters(quantity, word); };
    for (const std::string_view ratio : {"reflectance", "transmittance", "R-Factor", "T-Factor"})
        if (is(ratio)) return SpectrumKind::reflectance;
    for (const std::string_view light :
         {"relative", "flux", "intensity", "irradiance", "radiance", "exitance"})
        if (is(light)) return SpectrumKind::emission;
    return std::nullopt;  // absorptance, other
}

std::string references_of(const pugi::xml_node& header)
{
    std::string references;
    for (const char* part : {"Manufacturer", "CatalogNumber", "Laboratory", "ReportNumber",
                             "ReportDate", "DocumentCreator"})
        if (const std::string text = text_of(header, part); !text.empty())
            references += references.empty() ? text : ", " + text;
    return references;
}

/// The document, parsed and within the limits. @throws InputError when it is not.
void parse_document(std::string_view text, const std::string& file, pugi::xml_document& document)
{
    const pugi::xml_parse_result result = document.load_buffer(
        text.data(), text.size(), pugi::parse_default | pugi::parse_doctype, pugi::encoding_utf8);
    if (!result)
        throw InputError({file,
                          LineCounter(text).at(result.offset),
                          {},
                          fmt::format("is not valid XML: {}", result.description())});
    if (has_document_type(document))
        throw InputError({file, 0, {}, "must not have a document type (<!DOCTYPE …>)"});
    if (depth_of(document) > kMaxXmlDepth)
        throw InputError(
            {file, 0, {}, fmt::format("is nested deeper than {} levels", kMaxXmlDepth)});
}

std::optional<Spectrum> read_samples(const pugi::xml_node& distribution, std::string_view text,
                                     FileProblems& problems)
{
    SampleList samples(problems);
    LineCounter lines(text);
    for (const pugi::xml_node& data : distribution.children()) {
        const std::string_view name = data.name();
        if (!name.ends_with("SpectralData")) continue;
        const int line = lines.at(data.offset_debug());
        if (!data.attribute("wavelength")) {
            problems.add(line, "SpectralData.wavelength", "is missing");
        } else if (!samples.add(line, trimmed(data.attribute("wavelength").value()),
                                trimmed(data.child_value()))) {
            break;
        }
    }
    return samples.finish();
}

}  // namespace

std::vector<NamedSpectrum> read_spdx(std::string_view text, std::string_view name)
{
    const std::string file(name);
    check_size(text, file);
    pugi::xml_document document;
    parse_document(text, file, document);
    const pugi::xml_node root = child_of(document, "IESTM2714");
    const pugi::xml_node distribution = child_of(root, "SpectralDistribution");
    if (!distribution) throw InputError({file, 0, "IESTM2714.SpectralDistribution", "is missing"});

    FileProblems problems(file);
    auto samples = read_samples(distribution, text, problems);
    problems.throw_if_any();
    const pugi::xml_node header = child_of(root, "Header");
    std::vector<NamedSpectrum> spectra;
    spectra.push_back({.key = {},
                       .name = text_of(header, "Description"),
                       .references = references_of(header),
                       .licence = {},
                       .comments = text_of(header, "Comments"),
                       .tags = {},
                       .kind = kind_of(text_of(distribution, "SpectralQuantity")),
                       .samples = std::move(*samples)});
    return spectra;
}

}  // namespace nacre::spectral
