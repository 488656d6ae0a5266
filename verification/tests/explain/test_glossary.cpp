// The glossary: read from its text, found by every word that it names, printed with its place.
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include "verification/explain/glossary.h"

namespace type21 {
namespace {

TEST(Glossary, IsReadFromItsMarkdown) {
    const auto entries = read_glossary(
        "# Glossary\n\nIntroduction.\n\n## one\n\nSymbol: a, b. Unit: [-]\n\nAlso: first, uno\n\nTwo\nlines with "
        "`code`.\n\nFormula: `a + b`\n\nSee: Formulation 3, step 6; Formulation 4, step 3\n\nPicture: "
        "pictures/a.svg\n\n"
        "## two words\n\nText.");
    ASSERT_EQ(entries.size(), 2u);
    const GlossaryEntry& one = entries[0];
    EXPECT_EQ(one.term, "one");
    EXPECT_EQ(one.symbols, (std::vector<std::string>{"a", "b"}));
    EXPECT_EQ(one.unit, "[-]");
    EXPECT_EQ(one.also, (std::vector<std::string>{"first", "uno"}));
    EXPECT_EQ(one.meaning, "Two lines with code.");
    EXPECT_EQ(one.formula, "a + b");
    EXPECT_EQ(one.places, (std::vector<std::string>{"Formulation 3, step 6", "Formulation 4, step 3"}));
    EXPECT_EQ(one.picture, "pictures/a.svg");
    EXPECT_EQ(entries[1].term, "two words");
    EXPECT_EQ(entries[1].meaning, "Text.");
}

TEST(Glossary, EveryEntryIsWholeAndEveryPlaceExists) {
    ASSERT_GE(glossary().size(), 40u);
    std::set<std::string> terms;
    for (const GlossaryEntry& entry : glossary()) {
        EXPECT_TRUE(terms.insert(entry.term).second) << entry.term << " is there twice";
        EXPECT_GT(entry.meaning.size(), 40u) << entry.term;
        EXPECT_FALSE(entry.places.empty()) << entry.term;
        const std::string text = term_text(entry);
        EXPECT_EQ(text.find("()"), std::string::npos) << "a place without a file:\n" << text;
        const std::string picture = TYPE21_SOURCE_DIR "/reference/formulation/" + entry.picture;
        EXPECT_TRUE(entry.picture.empty() || std::filesystem::exists(picture)) << picture;
    }
}

TEST(Glossary, ATermIsFoundByItsOtherWordsAndItsSymbol) {
    const auto term = [](std::string_view word) {
        const GlossaryEntry* entry = find_term(word);
        return entry == nullptr ? std::string("none") : entry->term;
    };
    EXPECT_EQ(term("kappa"), "kappa");
    EXPECT_EQ(term("KAPPA"), "kappa");
    EXPECT_EQ(term("centrality"), "kappa");
    EXPECT_EQ(term("penetration offset"), "P0");
    EXPECT_EQ(term("penetration-offset"), "P0");
    EXPECT_EQ(term("p0"), "P0");
    EXPECT_EQ(term("delta"), "gap growth") << "another word comes before a symbol";
    EXPECT_EQ(term("A"), "area");
    EXPECT_EQ(term("a"), "barycentric weights") << "a symbol in its own case comes first";
    EXPECT_EQ(term("NU"), "contact normal") << "a symbol in any case";
    EXPECT_EQ(term("window seat"), "none");
    EXPECT_EQ(term(""), "none");
}

TEST(Glossary, NearMissesAreSuggested) {
    EXPECT_EQ(near_terms("kapa").front(), "kappa");
    EXPECT_EQ(near_terms("centralty").front(), "kappa");
    EXPECT_TRUE(near_terms("thermodynamics").empty());
    EXPECT_LE(near_terms("slop").size(), 3u);
}

TEST(Glossary, TheTextHasThePlaceWithItsFile) {
    const std::string text = term_text(*find_term("kappa"));
    EXPECT_EQ(text.substr(0, 12), "kappa       ");
    EXPECT_NE(text.find("see         Formulation 3, step 6 (reference/formulation/03_projection.md)\n"),
              std::string::npos);
    EXPECT_NE(text.find("formula     kappa = |1/3 - b|"), std::string::npos);
    EXPECT_NE(text.find("picture     reference/formulation/pictures/kappa.svg\n"), std::string::npos);
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = text.find('\n', begin);
        EXPECT_LE(end - begin, 112u);
        begin = end + 1;
    }
}

}  // namespace
}  // namespace type21
