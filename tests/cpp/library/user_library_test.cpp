// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/user_library.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <string>
#include <vector>

#include "nacre/core/file_io.h"
#include "nacre/core/limits.h"
#include "nacre/library/lights.h"
#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"
#include "nacre/media/optical_constants.h"
#include "nacre/spectral/illuminant.h"
#include "support/expect.h"
#include "support/own_library.h"

namespace nacre::spectral {
namespace {

namespace fs = std::filesystem;
using Keys = std::vector<std::string>;

const std::string kLight = "# KIND: emission\n400,1\n700,2\n";
const std::string kGlass =
    "DATA:\n  - type: formula 5\n    wavelength_range: 0.3 2.5\n    coefficients: 1.6 0 0\n";

void write(const fs::path& file, const std::string& text)
{
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
}

TEST(UserLibrary, IsWhereTheXdgSpecificationHasIt)
{
    const test::OwnLibrary own;
    EXPECT_EQ(user_library_folder(), own.folder());
    ::setenv("XDG_DATA_HOME", "relative", 1);
    EXPECT_EQ(user_library_folder(), fs::path(std::getenv("HOME")) / ".local/share/nacre");
}

TEST(UserLibrary, KnowsWhatAKeyIs)
{
    for (const char* key : {"a", "user/my-lamp", "N-BK7/SCHOTT", "a/b/c/d", "x_1.5+"})
        EXPECT_TRUE(is_library_key(key)) << key;
    for (const char* key : {"", "/", "a/", "/a", "a//b", "..", "a/../b", ".a", "a/.b", "a b",
                            "a\\b", "a/b/c/d/e", "ä", "a\nb", "~", "C:"})
        EXPECT_FALSE(is_library_key(key)) << key;
    EXPECT_TRUE(is_library_key(std::string(kMaxKeyBytes, 'a')));
    EXPECT_FALSE(is_library_key(std::string(kMaxKeyBytes + 1, 'a')));
}

TEST(UserLibrary, StandsBesideTheOneThatComesWithNacre)
{
    const test::OwnLibrary own;
    const auto shipped = library_spectrum_keys();
    (void)save_user_entries(
        {{EntryKind::spectrum, "user/lamp", kLight}, {EntryKind::medium, "user/glass", kGlass}},
        false);
    EXPECT_EQ(user_library_keys(EntryKind::spectrum), Keys{"user/lamp"});
    EXPECT_EQ(user_library_keys(EntryKind::medium), Keys{"user/glass"});
    EXPECT_EQ(library_spectrum_keys().size(), shipped.size() + 1);
    EXPECT_EQ(library_spectrum("user/lamp").samples.values(), (std::vector<double>{1, 2}));
    EXPECT_EQ(library_spectrum("user/lamp").key, "user/lamp");
    EXPECT_EQ(named_illuminant("user/lamp").power.front(), 1.0);
    const Medium& glass = library_medium("user/glass");
    EXPECT_EQ(glass.key, "user/glass");
    EXPECT_EQ(glass.name, "user/glass");
    EXPECT_NEAR(glass.constants->at(550).real(), 1.6, 1e-12);
}

TEST(UserLibrary, ReadsAFileAgainThatWasChanged)
{
    const test::OwnLibrary own;
    const auto save = [](const std::string& text) {
        return save_user_entries({{EntryKind::spectrum, "lamp", text}}, true).front();
    };
    (void)save(kLight);
    const NamedSpectrum& before = library_spectrum("lamp");
    (void)save("# KIND: emission\n400,3\n700,4\n");
    EXPECT_EQ(library_spectrum("lamp").samples.values(), (std::vector<double>{3, 4}));
    EXPECT_EQ(before.samples.values(), (std::vector<double>{1, 2}));  // stays valid
    (void)save(kLight);
    EXPECT_EQ(&library_spectrum("lamp"), &before);  // what was read before is not read twice
}

/// The entry `x` with a number that tells versions apart; all are of one size.
struct Versions {
    EntryKind kind;
    std::string file;
    std::string (*text)(int number);
    double (*number)();
};

const Versions kVersions[] = {
    {EntryKind::medium, "optical_constants/x.yml",
     [](int i) {
         return "DATA:\n  - type: tabulated n\n    data: |\n        0.3 1." + std::to_string(i) +
                "\n        0.9 1." + std::to_string(i) + "\n";
     },
     [] { return (library_medium("x").constants->at(550).real() - 1.0) * 1000.0; }},
    {EntryKind::spectrum, "spectra/x.csv",
     [](int i) { return "# KIND: emission\n400," + std::to_string(i) + "\n700,1\n"; },
     [] { return library_spectrum("x").samples.values().front(); }},
};

// Whatever a file system says of two contents may be the same: size, inode and both times.
TEST(UserLibrary, TimesAndSizesHideNoChange)
{
    const auto in_place = [](const fs::path& file, const std::string& text) { write(file, text); };
    const auto by_rename = [](const fs::path& file, const std::string& text) {
        fs::path aside = file;
        aside += ".new";
        write(aside, text);
        fs::rename(aside, file);
    };
    const auto unpacked = [](const fs::path& file, const std::string& text) {
        const auto old_time = fs::file_time_type() + std::chrono::hours(1);
        fs::remove(file);
        write(file, text);
        fs::last_write_time(file, old_time);
    };
    const auto saved = [](const fs::path& file, const std::string& text) {
        const auto kind = file.extension() == ".yml" ? EntryKind::medium : EntryKind::spectrum;
        (void)save_user_entries({{kind, "x", text}}, true);
    };
    using Way = void (*)(const fs::path&, const std::string&);
    for (const Versions& versions : kVersions)
        for (const Way way : {Way(in_place), Way(by_rename), Way(unpacked), Way(saved)}) {
            const test::OwnLibrary own;
            for (int i = 100; i < 140; ++i) {
                way(own.folder() / versions.file, versions.text(i));
                ASSERT_NEAR(versions.number(), i, 1e-9) << versions.file;
            }
        }
}

TEST(UserLibrary, ShadowsNothing)
{
    const test::OwnLibrary own;
    for (const char* key : {"colorchecker/red", "cie/D65"})
        EXPECT_INPUT_ERROR((void)save_user_entries({{EntryKind::spectrum, key, kLight}}, true),
                           "comes with Nacre and is not replaced");
    EXPECT_INPUT_ERROR((void)save_user_entries({{EntryKind::medium, "air", kGlass}}, true),
                       "comes with Nacre and is not replaced");
    EXPECT_FALSE(fs::exists(own.folder()));

    // Put there by hand.
    write(own.folder() / "spectra/lamp/lps.csv", kLight);
    write(own.folder() / "optical_constants/SiO2/Malitson.yml", kGlass);
    EXPECT_INPUT_ERROR((void)library_spectrum("lamp/lps"), "lps.csv: has the key of an entry");
    EXPECT_INPUT_ERROR((void)library_medium("SiO2/Malitson"), "Malitson.yml: has the key");
    EXPECT_EQ(std::ranges::count(library_spectrum_keys(), "lamp/lps"), 1);
}

TEST(UserLibrary, WritesEverythingOrNothing)
{
    const test::OwnLibrary own;
    (void)save_user_entries({{EntryKind::spectrum, "old", kLight}}, false);
    EXPECT_INPUT_ERROR((void)save_user_entries({{EntryKind::spectrum, "new", kLight},
                                                {EntryKind::spectrum, "new", kLight},
                                                {EntryKind::spectrum, "../x", kLight},
                                                {EntryKind::spectrum, "old", kLight}},
                                               false),
                       "old: is there already");
    EXPECT_EQ(user_library_keys(EntryKind::spectrum), Keys{"old"});

    // The second cannot be written: a folder has its name. The first is taken back.
    fs::create_directories(own.folder() / "spectra/taken.csv");
    EXPECT_INPUT_ERROR(
        (void)save_user_entries({{EntryKind::spectrum, "old", "# KIND: emission\n400,3\n700,4\n"},
                                 {EntryKind::spectrum, "new", kLight},
                                 {EntryKind::spectrum, "taken", kLight}},
                                true),
        "folder");
    EXPECT_EQ(user_library_keys(EntryKind::spectrum), Keys{"old"});
    EXPECT_EQ(read_text(own.folder() / "spectra/old.csv"), kLight);
}

TEST(UserLibrary, TakesNothingThatItCouldNotRead)
{
    const test::OwnLibrary own;
    struct Case {
        EntryKind kind;
        std::string text, message;
    };
    for (const auto& [kind, text, message] :
         {Case{EntryKind::medium, "DATA: []\n", "new: cannot be used: "},
          Case{EntryKind::medium, kLight, "new: cannot be used: "},
          Case{EntryKind::spectrum, "400,1\n700,2\n", "KIND"},
          Case{EntryKind::spectrum, "# KIND: emission\n400,1\n700,-2\n", "emission must be"},
          Case{EntryKind::spectrum, std::string(kMaxTextBytes + 1, '#'), "not be larger than"}}) {
        EXPECT_INPUT_ERROR((void)save_user_entries(
                               {{EntryKind::spectrum, "good", kLight}, {kind, "new", text}}, true),
                           message);
        EXPECT_FALSE(fs::exists(own.folder()));
    }
}

TEST(UserLibrary, PassesOverWhatIsNoEntry)
{
    const test::OwnLibrary own;
    for (const char* name : {"note.txt", "with space.csv", ".hidden.csv", "a/b/c/d/e.csv"})
        write(own.folder() / "spectra" / name, kLight);
    write(own.folder() / "spectra/a/b/c/d.csv", kLight);
    EXPECT_EQ(user_library_keys(EntryKind::spectrum), Keys{"a/b/c/d"});
}

TEST(UserLibrary, NamesTheFileThatIsWrong)
{
    const test::OwnLibrary own;
    write(own.folder() / "spectra/bad.csv", "# KIND: emission\n400,x\n");
    EXPECT_INPUT_ERROR((void)library_spectrum("bad"),
                       (own.folder() / "spectra/bad.csv").string() + ":2: column 2: must be");
}

}  // namespace
}  // namespace nacre::spectral
