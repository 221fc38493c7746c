// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0

#include <cstdio>
#include <exception>
#include <optional>
#include <string>

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <CLI/CLI.hpp>

#include "commands.h"
#include "nacre/core/diagnostics.h"
#include "nacre/core/version.h"
#include "shared/session.h"
#include "shared/signals.h"

namespace nacre::tool {
namespace {

constexpr const char* kMainHelp = R"(
Exit status: 0 done, 1 wrong usage or input, 2 a check failed.

The reflectance of 300 nm of water in air, as numbers and as a texture over angle and thickness:
  nacre eval stack stack.json
  nacre bake stack osl/templates/soap_film.toml -o soap_film.exr
A material of one's own, then a picture of it:
  nacre compile my_film.toml -o materials
  nacre render --template my_film.toml --stage sphere -o my_film.png)";

void add_global_options(CLI::App& app, Session& session)
{
    app.set_version_flag("--version", fmt::format("nacre {}", version()));
    app.add_flag("-v,--verbose", session.verbose, "say more of what is done");
    app.add_flag("--quiet", session.quiet, "say nothing but errors");
    app.add_flag("--json", session.json, "print results as JSON");
    app.add_option("--threads", session.threads, "most threads to use; 0 is one a core")
        ->check(CLI::Range(0, 1024))
        ->capture_default_str()
        ->type_name("N");
}

/// `nacre bake stack` for a command line that got as far as that.
std::string command_name(const CLI::App& app)
{
    std::string name = app.get_name();
    for (const CLI::App* at = &app; !at->get_subcommands().empty();) {
        at = at->get_subcommands().front();
        name += " " + at->get_name();
    }
    return name;
}

int report_usage_error(const CLI::App& app, const Session& session, const CLI::ParseError& error)
{
    session.error(error.what());
    fmt::print(stderr, "try: {} --help\n", command_name(app));
    return kExitInputError;
}

int run_command(const Session& session)
{
    std::optional<tbb::global_control> limit;
    if (session.threads > 0)
        limit.emplace(tbb::global_control::max_allowed_parallelism,
                      static_cast<std::size_t>(session.threads));
    try {
        const int code = session.run();
        if (std::fflush(stdout) == 0) return code;
        session.error("standard output: cannot be written");
    } catch (const InputError& error) {
        for (const Diagnostic& diagnostic : error.diagnostics()) session.error(diagnostic.text());
    } catch (const Interrupted& interruption) {
        return interruption.exit_code();
    } catch (const std::bad_alloc&) {
        session.error("not enough memory");
    } catch (const std::exception& error) {
        session.error(error.what());
    }
    return kExitInputError;
}

int run(int argc, char** argv)
{
    install_signal_handlers();
    Session session;
    CLI::App app("Nacre: wave-optics materials as numbers, tables and shaders", "nacre");
    app.require_subcommand(1)->footer(kMainHelp);
    add_global_options(app, session);
    add_commands(app, session);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return app.exit(success);  // --help, --version
    } catch (const CLI::ParseError& error) {
        session.command = command_name(app);
        return report_usage_error(app, session, error);
    }
    session.command = command_name(app);
    return run_command(session);
}

}  // namespace
}  // namespace nacre::tool

int main(int argc, char** argv)
{
    try {
        return nacre::tool::run(argc, argv);
    } catch (const std::exception& error) {
        // Before a command is known: memory, or a mistake in the declaration of the options.
        std::fprintf(stderr, "nacre: %s\n", error.what());
        return nacre::tool::kExitInputError;
    }
}
