// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "develop/exchange.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "nacre/bands/response.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/text_lines.h"

namespace nacre::tool {
namespace {

[[noreturn]] void refuse(const char* option, std::string message)
{
    throw InputError({{}, 0, option, std::move(message)});
}

std::string groups_of(const SpectralPicture& picture)
{
    std::vector<std::string> names;
    for (const Layer& layer : picture.layers)
        if (!layer.name.empty()) names.push_back(layer.name);
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "));
}

class Mixer {
public:
    explicit Mixer(const SpectralPicture& picture) : picture_(picture)
    {
        for (const Layer& layer : picture.layers) factors_.emplace_back(layer.channels.size(), 1.0);
    }

    void give_light(const std::string& text)
    {
        const auto [name, light] = split(text);
        const std::size_t at = place("--light", name);
        const Layer& layer = picture_.layers[at];
        if (layer.power.empty())
            refuse("--light", name.empty()
                                  ? fmt::format("the lamps of {} are of several lights; say which "
                                                "group, GROUP=LIGHT; there are: {}",
                                                picture_.file, groups_of(picture_))
                                  : fmt::format("the lamps of {} are of several lights", name));
        multiply(at, bands::exchange(picture_.bands, layer.power, layer.light,
                                     bands::named_light(light)));
    }

    void give_strength(const std::string& text)
    {
        const auto [name, number] = split(text);
        const auto factor = parse_number(number);
        if (name.empty() || !factor || !std::isfinite(*factor) || *factor < 0.0)
            refuse("--strength",
                   fmt::format("must be GROUP=FACTOR, the factor ≥ 0 (got '{}')", text));
        const std::size_t at = place("--strength", name);
        multiply(at, std::vector<double>(factors_[at].size(), *factor));
    }

    [[nodiscard]] Mixture made() const
    {
        Mixture result;
        for (std::size_t at = 0; at < factors_.size(); ++at) {
            std::vector<double> factors = factors_[at];
            // A group is in the whole already.
            if (at > 0)
                for (double& factor : factors) factor -= 1.0;
            if (at == 0 || std::ranges::any_of(factors, [](double f) { return f != 0.0; }))
                result.parts.push_back({&picture_.layers[at], std::move(factors)});
        }
        if (whole_changed_ && result.parts.size() > 1)
            refuse("--light", "must name a group each, or one light for all of the picture");
        return result;
    }

private:
    const SpectralPicture& picture_;
    std::vector<std::vector<double>> factors_;
    bool whole_changed_ = false;

    /// What is before the first `=`, if there is one, and what is after it.
    static std::pair<std::string, std::string> split(const std::string& text)
    {
        const std::size_t at = text.find('=');
        if (at == std::string::npos) return {"", text};
        return {text.substr(0, at), text.substr(at + 1)};
    }

    std::size_t place(const char* option, const std::string& name) const
    {
        const auto found = std::ranges::find(picture_.layers, name, &Layer::name);
        if (found == picture_.layers.end())
            refuse(option, fmt::format("no light group '{}' in {}; there are: {}", name,
                                       picture_.file, groups_of(picture_)));
        return static_cast<std::size_t>(found - picture_.layers.begin());
    }

    void multiply(std::size_t at, const std::vector<double>& factors)
    {
        whole_changed_ = whole_changed_ || at == 0;
        for (std::size_t k = 0; k < factors.size(); ++k) factors_[at][k] *= factors[k];
    }
};

}  // namespace

std::vector<double> Mixture::radiance(const SpectralPicture& picture, const float* pixel) const
{
    std::vector<double> sum(picture.bands.size(), 0.0);
    for (const Part& part : parts)
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += part.factors[k] * double{pixel[part.layer->channels[k]]};
    return sum;
}

Mixture mixture(const SpectralPicture& picture, const std::vector<std::string>& lights,
                const std::vector<std::string>& strengths)
{
    Mixer mixer(picture);
    for (const std::string& light : lights) mixer.give_light(light);
    for (const std::string& strength : strengths) mixer.give_strength(strength);
    return mixer.made();
}

}  // namespace nacre::tool
