// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/kinds/film.h"

#include <algorithm>
#include <utility>

#include "nacre/core/diagnostics.h"

namespace nacre::kinds {

std::optional<std::size_t> Film::varying_layer() const
{
    const auto it = std::ranges::find_if(
        layers, [](const LayerSpec& layer) { return layer.thickness_nm.varies; });
    if (it == layers.end()) return std::nullopt;
    return static_cast<std::size_t>(it - layers.begin());
}

Interior Film::interior() const
{
    if (diffuse_base) return Interior::diffuse;
    if (!transmission) return Interior::opaque;
    return ambient.value == substrate.value ? Interior::thin_wall : Interior::solid;
}

oslgen::Traits Film::traits() const
{
    return {.editable_stack = true, .probe = true, .truth = oslgen::Truth::stack};
}

std::vector<const material::MediumSpec*> Film::media() const
{
    std::vector<const material::MediumSpec*> media{&ambient};
    for (const LayerSpec& layer : layers) media.push_back(&layer.medium);
    media.push_back(&substrate);
    return media;
}

std::string Film::driven_socket() const
{
    return varying_layer() ? "thickness_nm" : scale ? "thickness_scale" : "";
}

void Film::check(const MaterialTemplate& source, const CompileOptions& options) const
{
    static_cast<void>(film_request(source, options));
}

std::variant<MaterialTemplate, std::string> Film::exported(const MaterialTemplate& source) const
{
    return source;
}

const Film& film_of(const MaterialTemplate& source, std::string_view problem)
{
    const auto* film = dynamic_cast<const Film*>(source.kind.get());
    if (!film) throw InputError(Diagnostic{source.file, 0, "", std::string(problem)});
    return *film;
}

MaterialTemplate with_film(MaterialTemplate source, Film film)
{
    source.kind = std::make_shared<const Film>(std::move(film));
    return source;
}

MaterialTemplate without_layers(const MaterialTemplate& source)
{
    Film bare = film_of(source);
    bare.layers.clear();
    bare.scale.reset();
    return with_film(source, std::move(bare));
}

}  // namespace nacre::kinds
