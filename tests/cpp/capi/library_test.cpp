// SPDX-FileCopyrightText: Nacre contributors
// SPDX-License-Identifier: Apache-2.0
#include "nacre/capi/library.h"
#include "refusal.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace {

using nacre::test::error;

std::vector<std::string> found(int kind, const char* text, const char* tag)
{
    std::size_t count = 0;
    EXPECT_EQ(nacre_library_search(kind, text, tag, &count), NACRE_OK);
    std::vector<std::string> keys;
    for (std::size_t i = 0; i < count; ++i) keys.emplace_back(nacre_library_found(i));
    EXPECT_EQ(nacre_library_found(count), nullptr);
    return keys;
}

TEST(CapiLibrarySearch, FindsByTextAndTag)
{
    EXPECT_EQ(found(NACRE_MEDIA, nullptr, nullptr).size(), nacre_library_count());
    EXPECT_EQ(found(NACRE_SPECTRA, "", "").size(), nacre_library_spectrum_count());
    EXPECT_EQ(found(NACRE_MEDIA, nullptr, "metal").size(), 40U);
    EXPECT_EQ(found(NACRE_MEDIA, "gold", "dye").size(), 0U);
    EXPECT_EQ(found(NACRE_SPECTRA, "DARK SKIN", nullptr),
              std::vector<std::string>{"colorchecker/dark-skin"});
}

TEST(CapiLibrarySearch, SaysFormulaAndTags)
{
    nacre_library_words words{};
    ASSERT_EQ(nacre_library_words_of(NACRE_MEDIA, "TiO2/Devore-o", &words), NACRE_OK);
    EXPECT_STREQ(words.formula, "TiO2");
    EXPECT_NE(std::string(words.tags).find("oxide"), std::string::npos);
    ASSERT_EQ(nacre_library_words_of(NACRE_MEDIA, "brass/Querry-Cu70Zn30", &words), NACRE_OK);
    EXPECT_STREQ(words.tags, "metal\nalloy");
    ASSERT_EQ(nacre_library_words_of(NACRE_SPECTRA, "study/box", &words), NACRE_OK);
    EXPECT_STREQ(words.formula, "");
    EXPECT_STREQ(words.tags, "study");
}

TEST(CapiLibrarySearch, RefusesWhatItCannotAnswer)
{
    std::size_t count = 7;
    EXPECT_EQ(error(nacre_library_search(2, "", "", &count)),
              "kind: must be 0 for media or 1 for spectra (got 2)");
    EXPECT_EQ(count, 7U);
    EXPECT_EQ(error(nacre_library_search(NACRE_MEDIA, "", "", nullptr)), "count: must not be null");
    nacre_library_words words{};
    EXPECT_EQ(error(nacre_library_words_of(NACRE_MEDIA, nullptr, &words)), "key: must not be null");
    EXPECT_EQ(error(nacre_library_words_of(NACRE_MEDIA, "air", nullptr)),
              "words: must not be null");
    EXPECT_NE(error(nacre_library_words_of(NACRE_SPECTRA, "study/bx", &words)).find("study/box"),
              std::string::npos);
}

TEST(CapiLibrary, KeysAscendAndOpenMedia)
{
    const std::size_t count = nacre_library_count();
    ASSERT_GT(count, 40U);
    for (std::size_t i = 0; i < count; ++i) {
        const std::string key = nacre_library_key(i);
        if (i > 0) {
            EXPECT_LT(nacre_library_key(i - 1), key);
        }
        nacre_medium medium;
        ASSERT_EQ(nacre_library_medium(key.c_str(), &medium), NACRE_OK) << key;
        EXPECT_EQ(medium.key, key);
        EXPECT_STRNE(medium.name, "");
        EXPECT_STRNE(medium.references, "");
        EXPECT_LT(medium.first_nm, medium.last_nm);
    }
    EXPECT_EQ(nacre_library_key(count), nullptr);
    EXPECT_EQ(nacre_library_key(std::numeric_limits<std::size_t>::max()), nullptr);
}

TEST(CapiLibrary, IndexOfGlassAtTheSodiumLine)
{
    const double nm[] = {587.5618, 400.0};
    double n[4];
    ASSERT_EQ(nacre_library_index("N-BK7/SCHOTT", 2, nm, n), NACRE_OK);
    EXPECT_NEAR(n[0], 1.5168, 5e-6);  // n_d of the SCHOTT data sheet
    EXPECT_GT(n[2], n[0]);
    EXPECT_EQ(nacre_library_index("N-BK7/SCHOTT", 0, nullptr, nullptr), NACRE_OK);
}

TEST(CapiLibrary, RefusesUnknownMediaAndWavelengthsOutsideTheData)
{
    nacre_medium medium{};
    medium.key = "before";
    EXPECT_NE(error(nacre_library_medium("water/Daimon", &medium)).find("water/Daimon-20C"),
              std::string::npos);  // names near ones
    EXPECT_STREQ(medium.key, "before");
    EXPECT_EQ(error(nacre_library_medium(nullptr, &medium)), "key: must not be null");
    EXPECT_EQ(error(nacre_library_medium("Au/Johnson", nullptr)), "medium: must not be null");

    const double nm[] = {550.0, 100.0};
    double n[4] = {-7.0, -7.0, -7.0, -7.0};
    const std::string outside = error(nacre_library_index("Au/Johnson", 2, nm, n));
    EXPECT_NE(outside.find("Au/Johnson"), std::string::npos) << outside;
    EXPECT_NE(outside.find("100"), std::string::npos) << outside;
    EXPECT_EQ(n[0], -7.0);
    EXPECT_EQ(error(nacre_library_index(nullptr, 1, nm, n)), "key: must not be null");
    EXPECT_EQ(error(nacre_library_index("Au/Johnson", 1, nullptr, n)),
              "wavelength_nm: must not be null");
    EXPECT_EQ(error(nacre_library_index("Au/Johnson", 1, nm, nullptr)), "n: must not be null");
}

TEST(CapiLibrary, SpectraComeWithTheirSamples)
{
    const std::size_t count = nacre_library_spectrum_count();
    ASSERT_GT(count, 160U);
    EXPECT_EQ(nacre_library_spectrum_key(count), nullptr);
    for (std::size_t i = 0; i < count; ++i) {
        nacre_spectrum spectrum;
        ASSERT_EQ(nacre_library_spectrum(nacre_library_spectrum_key(i), &spectrum), NACRE_OK);
        EXPECT_STREQ(spectrum.key, nacre_library_spectrum_key(i));
        EXPECT_STRNE(spectrum.references, "") << spectrum.key;
        EXPECT_STRNE(spectrum.licence, "") << spectrum.key;
        ASSERT_GE(spectrum.count, 2U);
        EXPECT_LT(spectrum.wavelength_nm[0], spectrum.wavelength_nm[spectrum.count - 1]);
    }
    nacre_spectrum box{};
    ASSERT_EQ(nacre_library_spectrum("study/box", &box), NACRE_OK);
    EXPECT_STREQ(box.kind, "emission");
    EXPECT_EQ(box.count, 471U);
    EXPECT_EQ(box.values[0], 0.0);
    EXPECT_EQ(box.values[100], 1.0);

    EXPECT_NE(error(nacre_library_spectrum("study/bx", &box)).find("study/box"), std::string::npos);
    EXPECT_STREQ(box.key, "study/box");
    EXPECT_EQ(error(nacre_library_spectrum(nullptr, &box)), "key: must not be null");
    EXPECT_EQ(error(nacre_library_spectrum("study/box", nullptr)), "spectrum: must not be null");
}

TEST(CapiLibrary, MayBeReadByThreads)
{
    std::vector<std::thread> threads;
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([] {
            for (std::size_t j = 0; j < nacre_library_count(); ++j) {
                nacre_medium medium;
                EXPECT_EQ(nacre_library_medium(nacre_library_key(j), &medium), NACRE_OK);
            }
        });
    for (std::thread& thread : threads) thread.join();
}

}  // namespace
