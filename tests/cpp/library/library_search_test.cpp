// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/library/library_search.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "nacre/library/media_library.h"
#include "nacre/library/spectrum_library.h"
#include "support/expect.h"
#include "support/own_library.h"

namespace nacre::spectral {
namespace {

using Keys = std::vector<std::string>;

bool holds(const Keys& keys, const std::string& key)
{
    return std::ranges::find(keys, key) != keys.end();
}

TEST(LibrarySearch, LooksIntoKeyNameFormulaTagAndCitation)
{
    const Medium medium{.key = "book/page",
                        .name = "Silver",
                        .references = "Phys. Rev. 1972",
                        .comments = "hidden",
                        .formula = "Ag2O",
                        .tags = {"metal", "alloy"},
                        .constants = constant_index(1.5)};
    for (const char* text : {"", "book/", "PAGE", "silv", "ag2o", "metal", "lloy", "rev. 19"})
        EXPECT_TRUE(matches(medium, {text, ""})) << text;
    for (const char* text : {"gold", "hidden", "metal alloy", "pagesilver"})
        EXPECT_FALSE(matches(medium, {text, ""})) << text;
}

TEST(LibrarySearch, TagIsAWholeOneAndBothAreWanted)
{
    const NamedSpectrum& sodium = library_spectrum("lamp/hps");
    ASSERT_FALSE(sodium.tags.empty());
    const std::string& tag = sodium.tags.front();
    EXPECT_TRUE(matches(sodium, {"SODIUM", tag}));
    EXPECT_FALSE(matches(sodium, {"mercury", tag}));
    EXPECT_FALSE(matches(sodium, {"sodium", tag.substr(1)}));
    EXPECT_FALSE(matches(sodium, {"sodium", tag + "x"}));
}

TEST(LibrarySearch, FindsKeysInTheirOrder)
{
    EXPECT_EQ(find_media({}), library_keys());
    EXPECT_EQ(find_spectra({}), library_spectrum_keys());
    const Keys metals = find_media({"", "metal"});
    EXPECT_EQ(metals.size(), 40U);
    EXPECT_TRUE(std::ranges::is_sorted(metals));
    EXPECT_TRUE(holds(metals, "Au/Johnson"));
    EXPECT_FALSE(holds(metals, "water/Daimon-20C"));
    EXPECT_EQ(find_media({"no such thing", ""}), Keys{});
}

TEST(LibrarySearch, FindsWhatCannotBeReadByItsKeyAlone)
{
    const test::OwnLibrary own;
    std::filesystem::create_directories(own.folder() / "spectra");
    std::ofstream(own.folder() / "spectra/broken.csv") << "# TAGS: led\nnonsense\n";
    EXPECT_TRUE(holds(find_spectra({}), "broken"));
    EXPECT_EQ(find_spectra({"BROK", ""}), Keys{"broken"});
    EXPECT_FALSE(holds(find_spectra({"", "led"}), "broken"));
    EXPECT_FALSE(holds(find_spectra({"nonsense", ""}), "broken"));
}

}  // namespace
}  // namespace nacre::spectral
