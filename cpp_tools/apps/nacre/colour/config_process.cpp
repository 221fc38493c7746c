// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "colour/config_process.h"

#include <cstdlib>
#include <stdexcept>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"

namespace nacre::tool {

using nlohmann::json;
using spectral::Vec3;

namespace {

constexpr const char* kEnded = "the Python that reads the config has ended";

json parsed_line(Dialogue& dialogue)
{
    return json::parse(dialogue.read_line().value_or(""), nullptr, false);
}

}  // namespace

ConfigProcess::ConfigProcess(const std::string& python)
    // Files beside the user are no modules of ours.
    : dialogue_({python, "-c", std::string(find_resource("ocio/read_config.py").value())},
                {{"PYTHONSAFEPATH", "1"}})
{
    const json version = parsed_line(dialogue_);
    if (version.is_string()) version_ = version.get<std::string>();
}

std::shared_ptr<ConfigProcess> ConfigProcess::start(const std::string& python)
{
    try {
        return std::shared_ptr<ConfigProcess>(new ConfigProcess(python));
    } catch (const InputError&) {
        return nullptr;
    }
}

ConfigSpace ConfigProcess::read(const std::string& config, const std::string& space)
{
    dialogue_.write_line(json{config, space, kInterchangeRole}.dump());
    const json answer = parsed_line(dialogue_);
    if (!answer.is_object()) throw std::runtime_error(kEnded);
    if (answer.contains("error")) throw std::runtime_error(answer["error"].get<std::string>());
    ConfigSpace result;
    answer.at("names").get_to(result.names);
    answer.at("is_known").get_to(result.is_known);
    answer.at("is_data").get_to(result.is_data);
    answer.at("has_interchange").get_to(result.has_interchange);
    answer.at("failure").get_to(result.failure);
    result.from_xyz_d65 = [self = shared_from_this()](const Vec3& xyz) {
        return self->convert(xyz);
    };
    return result;
}

Vec3 ConfigProcess::convert(const Vec3& xyz_d65)
{
    const std::lock_guard lock(turn_);
    dialogue_.write_line(fmt::format("{} {} {}", xyz_d65[0], xyz_d65[1], xyz_d65[2]));
    const auto line = dialogue_.read_line();
    if (!line) throw std::runtime_error(kEnded);
    Vec3 rgb{};
    const char* at = line->c_str();
    for (double& value : rgb) {
        char* end = nullptr;
        value = std::strtod(at, &end);  // also nan and inf, as a curve may answer
        if (end == at) throw std::runtime_error(kEnded);
        at = end;
    }
    return rgb;
}

}  // namespace nacre::tool
