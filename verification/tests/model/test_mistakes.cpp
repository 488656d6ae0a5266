#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

TEST(Vocabulary, AKeywordThatIsNotSupportedIsOneErrorWithItsCount) {
    const Problem p =
        only(resolved(with_cards("/THERM_STRESS/MAT/1\n1\n/THERM_STRESS/MAT/2\n1\n/THERM_STRESS/MAT/1/5\n")).problems);
    EXPECT_EQ(p.severity, Severity::error);
    EXPECT_EQ(p.card, "/THERM_STRESS/MAT");
    EXPECT_EQ(p.count, 3);
    EXPECT_FALSE(p.remedy.empty());
}

TEST(Vocabulary, KeywordsOfOtherPhysicsAreErrors) {
    for (const char* keyword : {"/BRICK", "/THERM_STRESS/MAT", "/PFLUID", "/RWALL/PLANE", "/DAMP", "/INTER/TYPE7",
                                "/MAT/LAW27", "/PROP/SOLID", "/DEFAULT/INTER/TYPE21", "/XYZ"}) {
        const Problem p = only(resolved(with_cards(std::string(keyword) + "/99\nx\n")).problems);
        EXPECT_EQ(p.severity, Severity::error) << keyword;
        EXPECT_EQ(p.card, keyword);
    }
}

TEST(Vocabulary, WhatUsesAnUnsupportedCardIsNoSecondProblem) {
    const std::string cards = "/MAT/LAW27/50\nglass\n/PROP/SOLID/51\nblock\n/PART/52\nblock\n" + ints({"51", "50"});
    EXPECT_EQ(resolved(with_cards(cards)).problems.list().size(), 2U);
}

TEST(Vocabulary, NamesOfGroupsAndAxesAreSilent) {
    EXPECT_TRUE(resolved(with_cards("/SUBSET/1\nx\n/SKEW/FIX/1\nx\n/IOFLAG\n0\n/SPMD\n0\n")).problems.list().empty());
}

TEST(Vocabulary, TwoDimensionalAnalysisIsAnError) {
    EXPECT_TRUE(resolved(with_cards("/ANALY\n" + ints({"0", "1"}))).problems.list().empty());
    EXPECT_EQ(only(resolved(with_cards("/ANALY\n" + ints({"2", "1"}))).problems).field, "N2D3D");
}

TEST(Vocabulary, LinesBehindACardAreAWarning) {
    const Problem p =
        only(resolved(with_cards("/ADMAS/0/1\nx\n" + fmt::format("{:>20}{:>10}\n", "1.0", 1) + "  lost\n")).problems);
    EXPECT_EQ(p.severity, Severity::warning);
    EXPECT_NE(p.rule.find("not read"), std::string::npos);
}

TEST(TenMistakes, YieldTenMessages) {
    std::string text = driven_scene();
    text = replaced(text, "      2025         0", "      1999         0");  // 1 version
    text = replaced(text, "            210000.0                 0.3\n/MAT/VOID",
                    "            210000.0                 0.7\n/MAT/VOID");  // 2 Poisson
    text = replaced(text, "                20.0                 0.0                 0.0\n",
                    "                20.0                 abc                 0.0\n");                      // 3 a word
    text = replaced(text, "/SHELL/2\n", "/SHELL/2\n        88       101       102       103       999\n");  // 4 a node
    text = replaced(text, "/SURF/PART/2\ntool\n", "/SURF/PART/2\ntool\n        77\n");                      // 5 a part
    text = replaced(text, "   111 111         0         1", "   111 131         0         1");              // 6 a code
    text = replaced(text, reals({"1.0", "1.0"}), reals({"-1.0", "1.0"}));                       // 7 abscissa
    text = replaced(text, "         1         Z         0", "         1         Q         0");  // 8 direction
    text = replaced(text, "/INTER/TYPE21/1\n", "/GRAV/1\ng\n/INTER/TYPE21/1\n");                // 9 keyword
    text = replaced(text, "/END\n", "/PART/1\ntwin\n" + ints({"1", "1"}) + "/END\n");           // 10 an id
    const Resolved r = resolved(text);
    EXPECT_EQ(r.problems.list().size(), 10U) << all_of(r.problems);
    EXPECT_EQ(r.problems.error_count(), 10);
    std::set<std::string> messages;
    for (const Problem& p : r.problems.list()) {
        messages.insert(to_text(p));
        EXPECT_FALSE(p.place.file.empty()) << to_text(p);
        EXPECT_GT(p.place.line, 0) << to_text(p);
        EXPECT_FALSE(p.card.empty()) << to_text(p);
        EXPECT_FALSE(p.rule.empty()) << to_text(p);
        EXPECT_FALSE(p.remedy.empty()) << to_text(p);
    }
    EXPECT_EQ(messages.size(), 10U);
    for (const char* words : {"Invers", "'nu' = 0.7", "'Y' = abc", "999", "77", "Tra rot", "ascend", "'Dir' = Q",
                              "/GRAV", "the id is taken"}) {
        EXPECT_NE(all_of(r.problems).find(words), std::string::npos) << words;
    }
}

}  // namespace
}  // namespace type21
