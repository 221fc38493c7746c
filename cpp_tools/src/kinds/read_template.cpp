// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/read_template.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "all_kinds.h"
#include "base/kind_info.h"
#include "nacre/core/sha256.h"
#include "nacre/material/schema.h"
#include "nacre/oslgen/shader_source.h"
#include "shader/hand_written.h"

namespace nacre::kinds {
namespace {

using material::SchemaJson, material::Section;

template <class... K>
std::vector<KindInfo> infos_of(const std::tuple<K...>*)
{
    static_assert((!std::is_abstract_v<K> && ...), "a kind has to answer all of Kind");
    return {kind_info<K>()...};
}

const std::vector<KindInfo>& all_kinds()
{
    static const std::vector<KindInfo> kinds = infos_of(static_cast<AllKinds*>(nullptr));
    return kinds;
}

const KindInfo& kind_of(Section& root)
{
    const KindInfo *found = nullptr, *without_section = nullptr;
    for (const KindInfo& kind : all_kinds()) {
        if (kind.section.empty()) {
            without_section = &kind;
            continue;
        }
        if (!root.allows(kind.section)) continue;
        if (found)
            root.report(kind.section,
                        fmt::format("excludes [{}]: a material is of one kind", found->section));
        else
            found = &kind;
    }
    return found ? *found : *without_section;
}

void read_template(Section& root, MaterialTemplate& result)
{
    root.require("schema", "1");
    root.integer("schema", 1, 1);
    read_material(root, result);
    const KindInfo& kind = kind_of(root);
    result.kind = kind.read(root, result);
    read_parameters(root, kind.sliders, result);
    read_look(root, !result.kind->driven_socket().empty(), result);
    root.report_unknown_keys();
}

}  // namespace

MaterialTemplate parse_template(std::string_view text, std::string_view file)
{
    if (oslgen::is_shader_text(text)) return read_shader(text, file);
    MaterialTemplate result;
    result.file = file;
    result.text = text;
    result.sha256 = sha256_hex(text);
    material::read_toml(text, file, [&](Section& root) { read_template(root, result); });
    return result;
}

std::string template_json_schema()
{
    SchemaJson properties{{"schema", {{"const", 1}}}}, definitions = SchemaJson::object(),
                                                       alternatives = SchemaJson::array();
    definitions["medium"] = material::medium_schema();
    std::vector<material::FieldInfo> surface;
    std::vector<material::SliderInfo> sliders;
    for (const KindInfo& kind : all_kinds()) {
        const KindSchema part = kind.schema();
        properties.update(part.properties);
        definitions.update(part.definitions);
        alternatives.push_back({{"required", part.required}});
        surface.insert(surface.end(), kind.surface.begin(), kind.surface.end());
        sliders.insert(sliders.end(), kind.sliders.begin(), kind.sliders.end());
    }
    properties.update(material::head_schema(surface, sliders));
    SchemaJson head{{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                    {"title", "Nacre material template"}};
    head.update(material::object_schema(std::move(properties), {"schema", "material"}));
    head["oneOf"] = std::move(alternatives);
    head["$defs"] = std::move(definitions);
    return head.dump(2) + "\n";
}

}  // namespace nacre::kinds
