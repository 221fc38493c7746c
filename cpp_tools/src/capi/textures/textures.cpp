// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/textures.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "base/guard.h"
#include "nacre/textures/spectrum_texture.h"
#include "nacre/textures/texture.h"

struct nacre_ftxt {
    nacre::spectral::TextTexture content;
    std::string text;
};

namespace nacre::capi {
namespace {

using spectral::kTextureSamples;
using spectral::TextureSamples;

static_assert(kTextureSamples == NACRE_TEXTURE_SAMPLES);
static_assert(spectral::kMaterialTexels == NACRE_MATERIAL_TEXELS);

spectral::SpectrumLayout layout_from(const char* layout)
{
    require(layout, "layout");
    const std::string_view name(layout);
    if (name == "packed") return spectral::SpectrumLayout::packed;
    if (name == "single") return spectral::SpectrumLayout::single;
    fail("layout", fmt::format("must be packed or single (got {})", name));
}

/// @throws InputError for what a float does not hold
void require_floats(const double* values, std::size_t count, std::size_t each, const char* field)
{
    constexpr double kMost = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < count * each; ++i)
        if (!(std::abs(values[i]) <= kMost))
            fail(fmt::format("{}[{}, {}]", field, i / each, i % each),
                 fmt::format("must be finite and within ±3.4e38, where float ends (got {:g})",
                             values[i]));
}

/// The same for several arrays of spectra.
void require_float_spectra(std::size_t count,
                           std::initializer_list<std::pair<const double*, const char*>> arrays)
{
    for (const auto& [values, field] : arrays) {
        require(values, field);
        require_floats(values, count, kTextureSamples, field);
    }
}

void require_float_colours(const double* colours, std::size_t count)
{
    require(colours, "colours");
    require_floats(colours, count, 3, "colours");
}

TextureSamples samples_at(const double* values, std::size_t i)
{
    TextureSamples samples;
    std::copy_n(values + i * kTextureSamples, kTextureSamples, samples.begin());
    return samples;
}

spectral::Vec3 colour_at(const double* colours, std::size_t i)
{
    return {colours[3 * i], colours[3 * i + 1], colours[3 * i + 2]};
}

spectral::Texture texture_from(const nacre_texture* texture)
{
    require(texture, "texture");
    require(texture->texels, "texture.texels");
    for (const int side : {texture->width, texture->height})
        if (side < 1 || side > spectral::kMaxTextureSide)
            fail("texture",
                 fmt::format("must have sides in [1, {}] (got {} x {})", spectral::kMaxTextureSide,
                             texture->width, texture->height));
    if (texture->channels < 1 || texture->channels > 4)
        fail("texture.channels", fmt::format("must be in [1, 4] (got {})", texture->channels));
    const auto count = static_cast<std::size_t>(texture->width) *
                       static_cast<std::size_t>(texture->height) *
                       static_cast<std::size_t>(texture->channels);
    return {.width = texture->width,
            .height = texture->height,
            .channels = texture->channels,
            .texels = {texture->texels, texture->texels + count}};
}

void copy(const spectral::Texture& texture, float* texels)
{
    std::ranges::copy(texture.texels, texels);
}

/// The comment at `index`; the end where there is none.
auto comment(const nacre_ftxt* ftxt, std::size_t index)
{
    const auto& comments = ftxt->content.comments;
    return std::next(comments.begin(),
                     static_cast<std::ptrdiff_t>(std::min(index, comments.size())));
}

}  // namespace
}  // namespace nacre::capi

extern "C" {

nacre_status nacre_texture_samples(size_t count, const double* wavelength_nm, const double* values,
                                   int reflectance, double* samples)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(wavelength_nm, "wavelength_nm");
        capi::require(values, "values");
        capi::require(samples, "samples");
        const spectral::NamedSpectrum spectrum{
            .key = {},
            .name = {},
            .references = {},
            .licence = {},
            .comments = {},
            .tags = {},
            .kind = reflectance != 0 ? spectral::SpectrumKind::reflectance
                                     : spectral::SpectrumKind::emission,
            .samples = {{wavelength_nm, wavelength_nm + count}, {values, values + count}}};
        std::ranges::copy(spectral::texture_samples(spectrum), samples);
    });
}

nacre_status nacre_pack_spectra(size_t count, const double* values, const char* layout,
                                size_t columns, float* texels)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require_float_spectra(count, {{values, "values"}});
        capi::require(texels, "texels");
        std::vector<spectral::TextureSamples> spectra(count);
        for (std::size_t i = 0; i < count; ++i) spectra[i] = capi::samples_at(values, i);
        capi::copy(spectral::pack_spectra(spectra, capi::layout_from(layout), columns), texels);
    });
}

nacre_status nacre_unpack_spectra(const nacre_texture* texture, const char* layout, size_t columns,
                                  size_t count, double* values)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(values, "values");
        const auto spectra = spectral::unpack_spectra(capi::texture_from(texture),
                                                      capi::layout_from(layout), columns, count);
        for (const auto& spectrum : spectra) values = std::ranges::copy(spectrum, values).out;
    });
}

nacre_status nacre_pack_materials(size_t count, const double* intensity, const double* n,
                                  const double* k, const double* colours, int normalise,
                                  float* texels)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require_float_spectra(count, {{intensity, "intensity"}, {n, "n"}, {k, "k"}});
        capi::require_float_colours(colours, count);
        capi::require(texels, "texels");
        std::vector<spectral::MaterialSpectra> materials(count);
        for (std::size_t i = 0; i < count; ++i)
            materials[i] = {.intensity = capi::samples_at(intensity, i),
                            .n = capi::samples_at(n, i),
                            .k = capi::samples_at(k, i),
                            .colour = capi::colour_at(colours, i)};
        capi::copy(spectral::pack_materials(materials, normalise != 0), texels);
    });
}

nacre_status nacre_unpack_materials(const nacre_texture* texture, double* intensity, double* n,
                                    double* k, double* colours)
{
    using namespace nacre;
    return capi::guarded([&] {
        for (const auto& [pointer, field] :
             {std::pair{intensity, "intensity"}, {n, "n"}, {k, "k"}, {colours, "colours"}})
            capi::require(pointer, field);
        for (const auto& material : spectral::unpack_materials(capi::texture_from(texture))) {
            intensity = std::ranges::copy(material.intensity, intensity).out;
            n = std::ranges::copy(material.n, n).out;
            k = std::ranges::copy(material.k, k).out;
            colours = std::ranges::copy(material.colour, colours).out;
        }
    });
}

nacre_status nacre_pack_lights(size_t count, const double* power, const double* colours,
                               float* texels)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require_float_spectra(count, {{power, "power"}});
        capi::require_float_colours(colours, count);
        capi::require(texels, "texels");
        std::vector<spectral::LightSpectra> lights(count);
        for (std::size_t i = 0; i < count; ++i)
            lights[i] = {.power = capi::samples_at(power, i),
                         .colour = capi::colour_at(colours, i)};
        capi::copy(spectral::pack_lights(lights), texels);
    });
}

nacre_status nacre_unpack_lights(const nacre_texture* texture, size_t count, double* power,
                                 double* colours)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(power, "power");
        capi::require(colours, "colours");
        for (const auto& light : spectral::unpack_lights(capi::texture_from(texture), count)) {
            power = std::ranges::copy(light.power, power).out;
            colours = std::ranges::copy(light.colour, colours).out;
        }
    });
}

nacre_status nacre_read_ftxt(const char* text, size_t length, const char* file, nacre_ftxt** result)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(text, "text");
        capi::require(file, "file");
        capi::require(result, "result");
        *result = new nacre_ftxt{spectral::read_ftxt({text, length}, file), {text, length}};
    });
}

nacre_status nacre_write_ftxt(const nacre_texture* texture, size_t comments,
                              const char* const* keys, const char* const* values,
                              nacre_ftxt** result)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(result, "result");
        if (comments > 0) capi::require(keys, "keys");
        if (comments > 0) capi::require(values, "values");
        auto made = std::make_unique<nacre_ftxt>();
        made->content.texture = capi::texture_from(texture);
        for (std::size_t i = 0; i < comments; ++i) made->content.comments[keys[i]] = values[i];
        made->text = spectral::write_ftxt(made->content);
        *result = made.release();
    });
}

nacre_status nacre_ftxt_texture(const nacre_ftxt* ftxt, nacre_texture* texture)
{
    using namespace nacre;
    return capi::guarded([&] {
        capi::require(ftxt, "ftxt");
        capi::require(texture, "texture");
        const spectral::Texture& source = ftxt->content.texture;
        *texture = {.width = source.width,
                    .height = source.height,
                    .channels = source.channels,
                    .texels = source.texels.data()};
    });
}

size_t nacre_ftxt_comments(const nacre_ftxt* ftxt)
{
    return ftxt == nullptr ? 0 : ftxt->content.comments.size();
}

const char* nacre_ftxt_key(const nacre_ftxt* ftxt, size_t index)
{
    if (index >= nacre_ftxt_comments(ftxt)) return nullptr;
    return nacre::capi::comment(ftxt, index)->first.c_str();
}

const char* nacre_ftxt_value(const nacre_ftxt* ftxt, size_t index)
{
    if (index >= nacre_ftxt_comments(ftxt)) return nullptr;
    return nacre::capi::comment(ftxt, index)->second.c_str();
}

const char* nacre_ftxt_text(const nacre_ftxt* ftxt)
{
    return ftxt == nullptr ? nullptr : ftxt->text.c_str();
}

void nacre_ftxt_free(nacre_ftxt* ftxt)
{
    delete ftxt;
}
}
