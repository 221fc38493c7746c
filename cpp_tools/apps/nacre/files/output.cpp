// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "files/output.h"

#include <cstdio>

#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "shared/signals.h"

namespace nacre::tool {

void write_text_output(const std::string& path, std::string_view text)
{
    if (!path.empty() && path != "-") {
        const WritingGuard guard;
        write_atomically(path, text);
        return;
    }
    const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
    if (!written || std::fflush(stdout) != 0)
        throw InputError({"standard output", 0, "", "cannot be written"});
}

void check_writable(const std::filesystem::path& path)
{
    const WritingGuard guard;
    const AtomicFile probe(path);
}

}  // namespace nacre::tool
