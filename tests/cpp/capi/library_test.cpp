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

}  // namespace
