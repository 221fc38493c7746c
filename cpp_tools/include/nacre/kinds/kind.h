// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nacre/kinds/compile_options.h"
#include "nacre/kinds/template.h"
#include "nacre/lut/table.h"
#include "nacre/material/medium.h"
#include "nacre/oslgen/program.h"

/// @file
/// The contract of a kind of material: what everybody may ask without knowing which kind it is.
/// Each lies in a folder of its own, src/kinds/<kind>, and is listed in src/kinds/all_kinds.h. What
/// a kind does not answer does not compile.

namespace nacre::kinds {

/// What becomes of a template.
struct Prepared {
    oslgen::Program program;  ///< without the colours' names and the media's ends
    std::vector<lut::Table> tables;
};

/// What a material is made of.
class Kind {
public:
    virtual ~Kind();

    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual oslgen::Traits traits() const = 0;
    /// All that it is made of, from the ambient or the cover down.
    [[nodiscard]] virtual std::vector<const material::MediumSpec*> media() const = 0;
    /// Name of the socket that sources of a thickness can drive; empty where there is none.
    [[nodiscard]] virtual std::string driven_socket() const = 0;

    /// Bakes the tables and describes the program.
    /// @throws InputError with the template's lines
    [[nodiscard]] virtual Prepared prepare(const MaterialTemplate& source,
                                           const CompileOptions& options) const = 0;
    /// Looks for what prepare() would throw, as far as that is quick.
    /// @throws InputError with the template's lines
    virtual void check(const MaterialTemplate& source, const CompileOptions& options) const = 0;
    /// The film that stands for it in programs without its shader, or why there is none, as in
    /// "has no counterpart in glTF: …".
    [[nodiscard]] virtual std::variant<MaterialTemplate, std::string> exported(
        const MaterialTemplate& source) const = 0;

protected:
    Kind() = default;
    Kind(const Kind&) = default;
    Kind(Kind&&) = default;
    Kind& operator=(const Kind&) = default;
    Kind& operator=(Kind&&) = default;
};

}  // namespace nacre::kinds
