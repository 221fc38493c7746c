// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "toml_keys.h"

#include <algorithm>

#include "nacre/core/limits.h"

namespace nacre::material {
namespace {

/// Steps over what is no key: strings of TOML's four kinds and comments. Behind text that the
/// parser refuses anything may be returned, since it does not come that far.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    [[nodiscard]] bool done() const { return at_ >= text_.size(); }
    [[nodiscard]] int line() const { return line_; }

    /// The next character outside strings and comments; a string counts as one quote.
    char next()
    {
        const char c = take();
        if (c == '#') skip_comment();
        if (c == '"' || c == '\'') skip_string(c);
        return c == '#' ? '\n' : c;
    }

private:
    char take()
    {
        const char c = text_[at_++];
        line_ += c == '\n' ? 1 : 0;
        return c;
    }

    bool take_if(std::string_view expected)
    {
        if (!text_.substr(at_).starts_with(expected)) return false;
        at_ += expected.size();
        return true;
    }

    void skip_comment() { at_ = std::min(text_.find('\n', at_), text_.size()); }

    void skip_string(char quote)
    {
        const char quotes[] = {quote, quote, quote};
        const bool many_lines = take_if({quotes, 2});
        while (!done()) {
            if (!many_lines && text_[at_] == '\n') return;
            if (take_if({quotes, many_lines ? std::size_t{3} : std::size_t{1}})) {
                // The last of up to five quotes close it; those before belong to the text.
                if (many_lines && take_if({quotes, 1})) take_if({quotes, 1});
                return;
            }
            if (take() == '\\' && quote == '"' && !done()) take();
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 1;
};

}  // namespace

int line_of_endless_key(std::string_view toml)
{
    constexpr std::string_view kEndsOfKeys = "\n=,[]{}";
    std::size_t dots = 0;
    Scanner scanner(toml);
    while (!scanner.done()) {
        const int line = scanner.line();
        const char c = scanner.next();
        if (kEndsOfKeys.find(c) != std::string_view::npos) dots = 0;
        if (c == '.' && ++dots >= kMaxKeyParts) return line;
    }
    return 0;
}

}  // namespace nacre::material
