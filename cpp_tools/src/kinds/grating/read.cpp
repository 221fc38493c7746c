// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "grating/fields.h"
#include "nacre/material/schema.h"

namespace nacre::kinds {
namespace grating {
namespace {

std::shared_ptr<const Kind> read(material::Section& root, material::TemplateHead& head)
{
    auto result = std::make_shared<Grating>();
    if (auto section = root.section(Grating::kName)) {
        read_fields(*section, kFields, *result);
        section->report_unknown_keys();
    }
    read_surface(root, head);
    return result;
}

KindSchema schema()
{
    return {.properties = {{Grating::kName, material::fields_schema(infos(kFields))}},
            .required = {Grating::kName}};
}

}  // namespace
}  // namespace grating

template <>
KindInfo kind_info<Grating>()
{
    return {.name = Grating::kName,
            .section = Grating::kName,
            .sliders = {material::kRoughness, grating::kStrength},
            .surface = {},
            .schema = grating::schema,
            .read = grating::read};
}

}  // namespace nacre::kinds
