// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "colour/config.h"

#include <charconv>
#include <compare>
#include <filesystem>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "colour/config_process.h"
#include "modules/config_reader.h"
#include "modules/module_loader.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "shared/python_search.h"

namespace nacre::tool {
namespace {

struct Version {
    int major = 0, minor = 0;
    auto operator<=>(const Version&) const = default;
};

/// `2.5`, `2.5.0-dev`, `2`; 0.0 where no number is.
Version parse_version(std::string_view text)
{
    Version version;
    const char* const end = text.data() + text.size();
    const auto [at, error] = std::from_chars(text.data(), end, version.major);
    if (error == std::errc{} && at != end && *at == '.')
        std::from_chars(at + 1, end, version.minor);
    return version;
}

/// What a config asks of OpenColorIO.
struct Demand {
    Version at_least;
    /// Whether that is all it asks: a URI and an archive do not tell.
    bool is_certain = false;
    int line = 0;  ///< of `ocio_profile_version`
    std::string what;
};

constexpr const char* kThisTool = "this tool's";
constexpr Version kFirstWithBuiltIn{2, 2};
constexpr Version kFirstWithArchives{2, 2};

Demand demand_of_uri(std::string_view uri)
{
    // ocio://cg-config-v4.0.0_aces-v2.0_ocio-v2.5
    constexpr std::string_view kMark = "_ocio-v";
    const std::size_t at = uri.rfind(kMark);
    const Version named =
        at == std::string_view::npos ? Version{} : parse_version(uri.substr(at + kMark.size()));
    return {std::max(named, kFirstWithBuiltIn), false, 0, "a config inside OpenColorIO"};
}

/// By `ocio_profile_version`, on a line of its own in every config that OpenColorIO writes.
Demand demand_of_text(std::string_view text)
{
    constexpr std::string_view kKey = "ocio_profile_version:";
    int line = 1;
    for (std::size_t start = 0; start < text.size(); ++line) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        std::string_view words = text.substr(start, end - start);
        if (words.starts_with(kKey)) {
            words.remove_prefix(kKey.size());
            words.remove_prefix(std::min(words.find_first_not_of(" \"'"), words.size()));
            const Version version = parse_version(words);
            return {version, true, line,
                    fmt::format("a config of version {}.{}", version.major, version.minor)};
        }
        start = end + 1;
    }
    return {{}, true, 0, "a config"};
}

Demand demand_of(const std::string& config)
{
    if (config.starts_with("ocio://")) return demand_of_uri(config);
    const std::filesystem::path file = config;
    if (file.extension() == ".ocioz" && std::filesystem::is_regular_file(file))
        return {kFirstWithArchives, false, 0, "an archive"};
    return demand_of_text(read_text(file));  // which says that a file is missing
}

/// Of a config that no OpenColorIO at hand is new enough for, or that none could read.
class Refusals {
public:
    void add_version(const std::string& version, const std::string& origin)
    {
        at_hand_.push_back(version.empty() ? fmt::format("none in {}", origin)
                                           : fmt::format("{} ({})", version, origin));
    }
    /// Of several that fail the newest knows best.
    void add_failure(const std::string& version, const std::string& origin,
                     const std::string& reason)
    {
        if (!failure_.empty() && parse_version(version) <= failed_) return;
        failed_ = parse_version(version);
        failure_ = fmt::format("cannot be used as a colour config by OpenColorIO {} ({}): {}",
                               version, origin, reason);
    }
    [[noreturn]] void throw_error(const std::string& config, const Demand& demand) const
    {
        if (!failure_.empty()) throw InputError({config, 0, "", failure_});
        throw InputError(
            {config, demand.line, demand.line > 0 ? "ocio_profile_version" : "",
             fmt::format("{} needs OpenColorIO {}.{} or newer; at hand: {}; to get it: "
                         "pip install opencolorio, for a Python that NACRE_PYTHON "
                         "names or that is python3 on the path",
                         demand.what, demand.at_least.major, demand.at_least.minor,
                         fmt::join(at_hand_, ", "))});
    }

private:
    std::vector<std::string> at_hand_;
    Version failed_;
    std::string failure_;
};

/// Pythons that may have PyOpenColorIO, in the order in which they are asked.
std::vector<FoundProgram> candidates()
{
    std::vector<FoundProgram> found;
    const auto add_python_of = [&found](const std::filesystem::path& blender) {
        if (const auto python = python_of_blender(blender))
            found.push_back({*python, "Python of " + blender.string()});
    };
    if (const std::string python = environment_variable("NACRE_PYTHON"); !python.empty())
        found.push_back({python, "NACRE_PYTHON"});
    if (const std::string blender = environment_variable("NACRE_BLENDER"); !blender.empty())
        add_python_of(find_program(blender).value_or(blender));
    const auto others = pythons_at_hand();
    found.insert(found.end(), others.begin(), others.end());
    if (const auto blender = blender_at_hand()) add_python_of(blender->path);
    return found;
}

std::optional<ConfigSpace> read_by_process(const std::string& config, const std::string& space,
                                           const Demand& demand, Refusals& refusals)
{
    for (const FoundProgram& python : candidates()) {
        const auto process = ConfigProcess::start(python.path.string());
        const std::string version = process ? process->version() : "";
        const std::string origin = fmt::format("{}, {}", python.path.string(), python.origin);
        refusals.add_version(version, origin);
        if (version.empty() || parse_version(version) < demand.at_least) continue;
        try {
            return process->read(config, space);
        } catch (const std::runtime_error& error) {
            refusals.add_failure(version, origin, error.what());
        }
    }
    return std::nullopt;
}

}  // namespace

ConfigSpace read_config_space(const std::string& config, const std::string& space)
{
    const Demand demand = demand_of(config);
    const ConfigReader& reader = loaded_module<ConfigReader>();
    const std::string version = reader.version();
    Refusals refusals;
    refusals.add_version(version, kThisTool);
    const bool new_enough = parse_version(version) >= demand.at_least;
    if (new_enough) {
        try {
            return reader.read(config, space);
        } catch (const std::runtime_error& error) {
            refusals.add_failure(version, kThisTool, error.what());
        }
    }
    if (!new_enough || !demand.is_certain)
        if (auto found = read_by_process(config, space, demand, refusals)) return *found;
    refusals.throw_error(config, demand);
}

}  // namespace nacre::tool
