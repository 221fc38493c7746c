// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include <CLI/CLI.hpp>

#include "files/output.h"
#include "nacre/kinds/read_template.h"
#include "shared/session.h"

namespace nacre::tool {

void add_library_schema(CLI::App& library, Session& session)
{
    CLI::App* schema = library.add_subcommand("schema", "JSON Schema of templates, for editors");
    schema->fallthrough()->footer("\n  nacre library schema >template.schema.json");
    schema->callback([&session] {
        session.run = [] {
            write_text_output("", kinds::template_json_schema());
            return kExitOk;
        };
    });
}

}  // namespace nacre::tool
