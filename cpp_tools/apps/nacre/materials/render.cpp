// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <memory>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "files/output.h"
#include "files/staged_folder.h"
#include "materials/compile.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/resources.h"
#include "shared/child_process.h"
#include "shared/python_search.h"
#include "shared/session.h"
#include "shared/share_files.h"
#include "shared/signals.h"

namespace nacre::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHowToInstall =
    "no Blender was found: set NACRE_PYTHON to a Python with bpy (pip install \"bpy==4.5.*\" on "
    "Python 3.11), or NACRE_BLENDER to a Blender of 4.2 or newer";

/// A program that runs the driver, and how it was found.
struct Renderer {
    std::vector<std::string> command;
    std::string description;
};

bool has_bpy(const fs::path& python)
{
    constexpr const char* kProbe =
        "import importlib.util, sys; sys.exit(importlib.util.find_spec('bpy') is None)";
    return run_child({python.string(), "-c", kProbe},
                     {.folder = {}, .environment = {}, .capture = true})
               .exit_code == 0;
}

Renderer python_renderer(const fs::path& python, const std::string& origin)
{
    return {{python.string(), share_path("addon/background/driver.py").string(), "render"},
            fmt::format("bpy of {} ({})", python.string(), origin)};
}

Renderer blender_renderer(const fs::path& blender, const std::string& origin)
{
    return {{blender.string(), "-b", "--factory-startup", "--python-exit-code", "1", "--python",
             share_path("addon/background/driver.py").string(), "--", "render"},
            fmt::format("{} ({})", blender.string(), origin)};
}

/// What the user named has to work: falling back would hide a mistyped path.
std::optional<Renderer> named_renderer()
{
    if (const std::string python = environment_variable("NACRE_PYTHON"); !python.empty()) {
        const auto program = find_program(python);
        if (!program || !has_bpy(*program))
            throw InputError(
                {"", 0, "NACRE_PYTHON",
                 fmt::format("must be a Python that can import bpy (got {})", python)});
        return python_renderer(*program, "NACRE_PYTHON");
    }
    if (const std::string blender = environment_variable("NACRE_BLENDER"); !blender.empty()) {
        const auto program = find_program(blender);
        if (!program)
            throw InputError({"", 0, "NACRE_BLENDER",
                              fmt::format("must be a Blender program (got {})", blender)});
        return blender_renderer(*program, "NACRE_BLENDER");
    }
    return std::nullopt;
}

Renderer find_renderer()
{
    if (auto named = named_renderer()) return *named;
    for (const FoundProgram& python : pythons_at_hand())
        if (has_bpy(python.path)) return python_renderer(python.path, python.origin);
    if (const auto blender = blender_at_hand())
        return blender_renderer(blender->path, blender->origin);
    throw InputError({"", 0, "", kHowToInstall});
}

/// Folder for one run's compiled template, removed with it.
class ScratchFolder {
public:
    ScratchFolder()
    {
        std::string name = (fs::temp_directory_path() / "nacre-render.XXXXXX").string();
        if (!mkdtemp(name.data())) throw InputError({name, 0, "", "cannot be made"});
        path_ = name;
    }
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    ~ScratchFolder()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    [[nodiscard]] const fs::path& path() const noexcept { return path_; }

private:
    fs::path path_;
};

bool is_given(const std::vector<std::string>& arguments,
              std::initializer_list<std::string_view> options)
{
    return std::ranges::find_first_of(arguments, options) != arguments.end();
}

/// Takes `--template FILE` or `--template=FILE` out of the arguments.
std::optional<std::string> take_template(std::vector<std::string>& arguments)
{
    for (auto at = arguments.begin(); at != arguments.end(); ++at) {
        const bool joined = at->starts_with("--template=");
        if (!joined && *at != "--template") continue;
        if (!joined && at + 1 == arguments.end())
            throw InputError({"", 0, "--template", "must be followed by a file"});
        const std::string file =
            joined ? at->substr(std::string_view("--template=").size()) : at[1];
        arguments.erase(at, at + (joined ? 1 : 2));
        return file;
    }
    return std::nullopt;
}

/// Options of `nacre` that stand before the command are the driver's too.
void pass_global_options(const Session& session, std::vector<std::string>& arguments)
{
    if (session.quiet) arguments.emplace_back("--quiet");
    if (session.verbose) arguments.emplace_back("--verbose");
    if (session.json) arguments.emplace_back("--json");
    if (session.threads > 0)
        arguments.insert(arguments.end(), {"--threads", std::to_string(session.threads)});
}

/// Standard output is for reports alone. When quiet, what Blender and its libraries say is kept
/// until it is known whether it tells why there is no picture.
int run_driver(const Session& session, const std::vector<std::string>& command)
{
    ChildOptions options{.folder = {},
                         .environment = {},
                         .capture = session.quiet,
                         .reports = true,
                         .chatter = session.verbose && !session.quiet};
    if (environment_variable("NACRE_MATERIALS").empty())
        options.environment["NACRE_MATERIALS"] = share_path("materials").string();
    const ChildResult child = run_child(command, options);
    if (child.exit_code != 0) fmt::print(stderr, "{}", child.output);
    check_interrupted();
    if (child.signal != 0)
        session.error(fmt::format("Blender was ended by a signal: {}", strsignal(child.signal)));
    return child.exit_code;
}

int render(Session session, std::vector<std::string> arguments)
{
    if (arguments.empty() || is_given(arguments, {"-h", "--help"})) {
        // Written by write_render_help.py: the options are those of the program that renders.
        write_text_output("", std::string(find_resource("help/render.txt").value()));
        return arguments.empty() ? kExitInputError : kExitOk;
    }
    pass_global_options(session, arguments);
    session.quiet = is_given(arguments, {"--quiet"});
    session.verbose = is_given(arguments, {"-v", "--verbose"});
    const WritingGuard guard;
    const ScratchFolder scratch;
    if (const auto file = take_template(arguments)) {
        const auto compiled = compile_templates(session, {{*file}, scratch.path(), {}, false});
        arguments.insert(arguments.end(), {"--compiled", compiled.front().folder.string()});
    }
    Renderer renderer = find_renderer();
    session.note("uses " + renderer.description);
    renderer.command.insert(renderer.command.end(), arguments.begin(), arguments.end());
    return run_driver(session, renderer.command);
}

}  // namespace

void add_render(CLI::App& app, Session& session)
{
    // The driver owns these options; only its --template is ours to act on.
    CLI::App* command =
        app.add_subcommand("render", "a picture of a material, by Blender's Cycles");
    command->set_help_flag();
    command->prefix_command();
    command->callback([&session, command] {
        session.run = [&session, arguments = command->remaining()] {
            return render(session, arguments);
        };
    });
}

}  // namespace nacre::tool
