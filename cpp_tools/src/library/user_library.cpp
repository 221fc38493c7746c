// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/user_library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "nacre/core/diagnostics.h"
#include "nacre/core/file_io.h"
#include "nacre/core/limits.h"
#include "nacre/readers/refractiveindex_yaml.h"
#include "nacre/readers/spectrum_files.h"
#include "nacre/spectral/named_spectrum.h"
#include "shipped.h"

namespace nacre::spectral {

namespace fs = std::filesystem;

namespace {

fs::path absolute_folder(const char* variable)
{
    const char* const value = std::getenv(variable);
    const fs::path path = value == nullptr ? fs::path() : fs::path(value);
    return path.is_absolute() ? path : fs::path();
}

fs::path folder_of(EntryKind kind)
{
    const fs::path library = user_library_folder();
    return library.empty() ? library : library / entry_folder(kind);
}

bool is_name(std::string_view name) noexcept
{
    constexpr std::string_view kLetters =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._+-";
    return !name.empty() && name.front() != '.' &&
           name.find_first_not_of(kLetters) == std::string_view::npos;
}

/// What a reader of the library would say of the entry; nothing where it can be read.
std::optional<std::string> content_problem(const UserEntry& entry)
{
    try {
        if (entry.kind == EntryKind::medium) {
            (void)parse_refractiveindex_yaml(entry.text, {});
            return std::nullopt;
        }
        const NamedSpectrum spectrum = read_library_spectrum(entry.text, {});
        return kind_problem(spectrum.samples, *spectrum.kind);
    } catch (const InputError& error) {
        return error.diagnostics().front().text();
    }
}

void check_entries(const std::vector<UserEntry>& entries, bool replace)
{
    DiagnosticList problems;
    std::set<std::pair<EntryKind, std::string>> seen;
    for (const UserEntry& entry : entries) {
        const auto& key = entry.key;
        const EntryKind kind = entry.kind;
        const auto add = [&](std::string message) {
            problems.add({.file = {}, .field = key, .message = std::move(message)});
        };
        if (!is_library_key(key))
            add(
                fmt::format("must be up to four names between slashes, of letters, digits and . _ "
                            "+ -, none of which starts with a dot; at most {} bytes",
                            kMaxKeyBytes));
        else if (!seen.emplace(kind, key).second)
            add("must be there once only");
        else if (is_shipped(kind, key))
            add("comes with Nacre and is not replaced; choose another key");
        else if (const auto file = user_library_file(kind, key); file && !replace)
            add(fmt::format("is there already, see {}; to take the new one, replace it",
                            file->string()));
        else if (const auto problem = content_problem(entry))
            add("cannot be used: " + *problem);
    }
    problems.throw_if_any();
}

/// Puts back what was there before, unless commit() was called.
class Undo {
public:
    Undo() = default;
    Undo(const Undo&) = delete;
    Undo& operator=(const Undo&) = delete;
    ~Undo()
    {
        for (const auto& [path, before] : steps_) {
            std::error_code ignored;
            try {
                before ? write_atomically(path, *before) : void(fs::remove(path, ignored));
            } catch (
                const std::exception&) {  // NOLINT(bugprone-empty-catch): the first error counts
            }
        }
    }

    void remember(const fs::path& path)
    {
        std::error_code error;
        auto before = fs::exists(path, error) ? std::optional(read_text(path)) : std::nullopt;
        steps_.emplace_back(path, std::move(before));
    }
    void commit() noexcept { steps_.clear(); }

private:
    std::vector<std::pair<fs::path, std::optional<std::string>>> steps_;
};

}  // namespace

fs::path user_library_folder()
{
    if (const fs::path data = absolute_folder("XDG_DATA_HOME"); !data.empty())
        return data / "nacre";
    const fs::path home = absolute_folder("HOME");
    return home.empty() ? home : home / ".local" / "share" / "nacre";
}

bool is_library_key(std::string_view key) noexcept
{
    constexpr int kMostNames = 4;
    if (key.size() > kMaxKeyBytes) return false;
    for (int names = 1; names <= kMostNames; ++names) {
        const std::size_t slash = key.find('/');
        if (!is_name(key.substr(0, slash))) return false;
        if (slash == std::string_view::npos) return true;
        key.remove_prefix(slash + 1);
    }
    return false;
}

std::vector<std::string> user_library_keys(EntryKind kind)
{
    std::vector<std::string> keys;
    const fs::path folder = folder_of(kind);
    if (folder.empty()) return keys;
    // What cannot be read is not there for us; the user's other folders are no business of ours.
    std::error_code error;
    fs::recursive_directory_iterator entry(folder, fs::directory_options::skip_permission_denied,
                                           error);
    for (; !error && entry != fs::end(entry) && keys.size() < kMaxUserEntries;
         entry.increment(error)) {
        constexpr int kDeepest = 3;
        if (entry.depth() == kDeepest) entry.disable_recursion_pending();
        if (entry->path().extension() != entry_extension(kind)) continue;
        std::string key = fs::path(entry->path()).replace_extension().lexically_relative(folder);
        std::error_code unreadable;
        if (is_library_key(key) && entry->is_regular_file(unreadable))
            keys.push_back(std::move(key));
    }
    std::ranges::sort(keys);
    return keys;
}

std::optional<fs::path> user_library_file(EntryKind kind, std::string_view key)
{
    const fs::path folder = folder_of(kind);
    if (folder.empty() || !is_library_key(key)) return std::nullopt;
    fs::path file = folder / fmt::format("{}{}", key, entry_extension(kind));
    std::error_code unreadable;
    if (!fs::is_regular_file(file, unreadable)) return std::nullopt;
    return file;
}

std::vector<fs::path> save_user_entries(const std::vector<UserEntry>& entries, bool replace)
{
    if (user_library_folder().empty())
        throw InputError({.file = {},
                          .field = "XDG_DATA_HOME",
                          .message = "must be an absolute path, or else HOME: there is no folder "
                                     "for a library of your own"});
    check_entries(entries, replace);
    std::vector<fs::path> files;
    Undo undo;
    for (const auto& [kind, key, text] : entries) {
        const fs::path file = folder_of(kind) / fmt::format("{}{}", key, entry_extension(kind));
        std::error_code error;
        fs::create_directories(file.parent_path(), error);
        if (error)
            throw InputError({.file = file.parent_path().string(),
                              .field = {},
                              .message = "cannot be made: " + error.message()});
        undo.remember(file);
        write_atomically(file, text);
        files.push_back(file);
    }
    undo.commit();
    return files;
}

}  // namespace nacre::spectral
