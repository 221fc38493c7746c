// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/core/diagnostics.h"

#include "nacre/core/limits.h"

namespace nacre {

namespace {

std::string join_texts(const std::vector<Diagnostic>& diagnostics)
{
    std::string joined;
    for (const Diagnostic& diagnostic : diagnostics) {
        if (!joined.empty()) joined += '\n';
        joined += diagnostic.text();
    }
    return joined;
}

}  // namespace

std::string Diagnostic::text() const
{
    std::string text = file;
    if (line > 0) text += (text.empty() ? "line " : ":") + std::to_string(line);
    for (const std::string& part : {field, message}) {
        if (part.empty()) continue;
        if (!text.empty()) text += ": ";
        text += part;
    }
    return text;
}

InputError::InputError(std::vector<Diagnostic> diagnostics)
    : std::runtime_error(join_texts(diagnostics)), diagnostics_(std::move(diagnostics))
{}

InputError::InputError(Diagnostic diagnostic)
    : InputError(std::vector<Diagnostic>{std::move(diagnostic)})
{}

void DiagnosticList::throw_if_any()
{
    if (!diagnostics_.empty()) throw InputError(std::move(diagnostics_));
}

void DiagnosticList::throw_first_if_any()
{
    constexpr auto kMost = static_cast<std::size_t>(kMaxProblems);
    if (diagnostics_.size() > kMost) {
        diagnostics_.resize(kMost);
        diagnostics_.back().message += "; there is more that is wrong";
    }
    throw_if_any();
}

}  // namespace nacre
