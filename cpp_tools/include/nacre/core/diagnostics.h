// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <vector>

/// @file
/// Problems with a user's input: where, which field, what is wrong and what is allowed.

namespace nacre {

struct Diagnostic {
    std::string file;     ///< as the user named it; empty when there is none
    int line = 0;         ///< 1-based; 0 when unknown
    std::string field;    ///< e.g. `layer[0].thickness_nm`; empty when the whole file is meant
    std::string message;  ///< e.g. `must be ≥ 0 (got -5)`

    /// `file:line: field: message`, without the parts that are empty.
    [[nodiscard]] std::string text() const;
};

/// All that is wrong with an input, thrown at once so that a user mends a file in one pass.
class InputError : public std::runtime_error {
public:
    explicit InputError(std::vector<Diagnostic> diagnostics);
    explicit InputError(Diagnostic diagnostic);

    [[nodiscard]] std::span<const Diagnostic> diagnostics() const noexcept { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

/// Collects problems while a reader goes on, then throws them together.
class DiagnosticList {
public:
    void add(Diagnostic diagnostic) { diagnostics_.push_back(std::move(diagnostic)); }
    [[nodiscard]] bool empty() const noexcept { return diagnostics_.empty(); }
    /// @throws InputError when anything was added.
    void throw_if_any();
    /// The same for the problems of one file: the first kMaxProblems, and that there are more.
    void throw_first_if_any();

private:
    std::vector<Diagnostic> diagnostics_;
};

}  // namespace nacre
