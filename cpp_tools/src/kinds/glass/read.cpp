// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "glass/glass.h"
#include "glass/sliders.h"
#include "nacre/kinds/film.h"
#include "nacre/material/schema.h"

namespace nacre::kinds {
namespace glass {
namespace {

std::shared_ptr<const Kind> read(material::Section& root, material::TemplateHead& head)
{
    auto result = std::make_shared<Glass>();
    if (auto section = root.section(Glass::kName)) {
        result->medium = read_medium(*section);
        if (result->medium.absorbs()) section->report("k", "must be 0: the glass is clear");
        section->report_unknown_keys();
    }
    read_surface(root, head);
    return result;
}

KindSchema schema()
{
    return {.properties = {{Glass::kName, material::reference_schema("medium")}},
            .required = {Glass::kName}};
}

}  // namespace
}  // namespace glass

template <>
KindInfo kind_info<Glass>()
{
    return {.name = Glass::kName,
            .section = Glass::kName,
            .sliders = {glass::kDispersion, material::kRoughness},
            .surface = {},
            .schema = glass::schema,
            .read = glass::read};
}

std::variant<MaterialTemplate, std::string> Glass::exported(const MaterialTemplate& source) const
{
    Film film;
    film.ambient.value = material::LibraryMedium{"air"};
    film.substrate = medium;
    film.transmission = true;
    return with_film(source, std::move(film));
}

}  // namespace nacre::kinds
