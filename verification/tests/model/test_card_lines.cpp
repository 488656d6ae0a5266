#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/model/card_lines.h"

namespace type21 {
namespace {

using namespace test;

/// The driven scene and one card of every other kind that has data lines.
std::string scene_of_all_cards() {
    return with_cards("/UNIT/5\nSI\n" + reals({"kg", "m", "s"}) + "/MAT/PLAS_JOHNS/3\nsteel\n" + reals({"7.8e-09"}) +
                      reals({"210000.0", "0.3"}) + reals({"300.0", "500.0", "0.5"}) + "\n\n" + "/IMPDISP/2\nd\n" +
                      ints({"1", "X", "0", "0", "4", "0", "0"}) + "\n/INIVEL/TRA/1\nv\n" +
                      reals({"0.0", "0.0", "0.0"}).substr(0, 60) + ints({"4"}) + "/ADMAS/0/1\nm\n" +
                      reals({"0.1"}).substr(0, 20) + ints({"4"}) + "/CLOAD/1\nf\n" + ints({"1", "Z", "0", "1", "4"}) +
                      "/GRNOD/NODE/4\nmore\n" + ints({"201"}) + "/SENSOR/TIME/1\ns\n" + reals({"0.0"}) +
                      "/FRICTION/1\nf\n" + ints({"0", "0"}) + "\n\n" + "/TH/NODE/1\nmain\nDEF\n" + ints({"201"}));
}

/// The lines of a deck, each with its end.
std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (size_t at = 0; at < text.size();) {
        const size_t end = text.find('\n', at) + 1;
        lines.push_back(text.substr(at, end - at));
        at = end;
    }
    return lines;
}

bool ends_early(const Problems& problems, const std::string& keyword) {
    for (const Problem& problem : problems.list()) {
        const bool said = problem.rule.find("ends early") != std::string::npos ||
                          problem.rule.find("always twelve") != std::string::npos;
        if (said && problem.card == keyword && problem.severity == Severity::error) return true;
    }
    return false;
}

TEST(CardLines, TheSceneItselfIsWhole) {
    const Resolved r = resolved(scene_of_all_cards());
    EXPECT_FALSE(r.problems.has_errors()) << all_of(r.problems);
}

TEST(CardLines, ALostLastLineOfAnyCardIsSaid) {
    const std::vector<std::string> lines = lines_of(scene_of_all_cards());
    int cards = 0;
    for (size_t i = 0; i < lines.size(); ++i) {
        if (lines[i][0] != '/') continue;
        const std::string keyword = lines[i].substr(0, lines[i].size() - 1);
        size_t last = i;
        while (last + 1 < lines.size() && lines[last + 1][0] != '/')
            ++last;
        // Lists, meshes, titles and functions of two points may be shorter; /PROP/VOID needs no thickness.
        bool list = last == i;
        for (const std::string word :
             {"/NODE", "/SHELL", "/SH3N", "/TITLE", "/GRNOD", "/SURF", "/FUNCT", "/PROP/VOID", "/TH", "/END"})
            list = list || keyword.starts_with(word);
        if (list) continue;
        ++cards;
        std::string text;
        for (size_t j = 0; j < lines.size(); ++j)
            if (j != last) text += lines[j];
        const Resolved r = resolved(text);
        EXPECT_TRUE(ends_early(r.problems, keyword)) << keyword << '\n' << all_of(r.problems);
    }
    EXPECT_EQ(cards, 19);
}

TEST(CardLines, TheMessageNamesTheLinesAndNoFieldOfAMissingOne) {
    const Resolved r = resolved(with_cards("/IMPVEL/9\nlost\n"));
    const Problem p = only(r.problems);
    EXPECT_EQ(p.value, "1 data line");
    EXPECT_NE(p.rule.find("needs 3 data lines (title; fct_IDT"), std::string::npos) << p.rule;
    EXPECT_EQ(p.card, "/IMPVEL/9");
}

TEST(CardLines, ABareCardIsShort) {
    // Sensors and groups are read where a card uses them.
    const std::string use = "/CLOAD/9\nf\n" + ints({"1", "Z", "0", "9", "9"});
    for (const std::string card : {"/MAT/VOID/9\n", "/MAT/VOID/9\ntool\n", "/SENSOR/TIME/9\n", "/SENSOR/TIME/9\ns\n",
                                   "/FUNCT/9\n", "/GRNOD/NODE/9\n", "/HEAT/MAT/1\n", "/PART/9\n"})
        EXPECT_TRUE(ends_early(resolved(with_cards(card + use)).problems, card.substr(0, card.find('\n')))) << card;
}

TEST(CardLines, APairOfFrictionHasThreeLines) {
    const std::string friction = "/FRICTION/1\nf\n" + ints({"0", "0"}) + "\n\n" + ints({"", "", "1", "2"}) + "\n";
    EXPECT_NE(find_rule(resolved(with_cards(friction)).problems, "needs three lines"), nullptr);
    EXPECT_EQ(find_rule(resolved(with_cards(friction + "\n")).problems, "needs three lines"), nullptr);
}

TEST(CardLines, EngineCardsWithoutTheirNumbers) {
    for (const std::string card : {"/TFILE\n", "/DTIX\n", "/DT/NODA\n", "/DT/NODA/CST/0\n"}) {
        const Resolved r = resolved(driven_scene(), "/RUN/scene/1\n0.001\n" + card + "/PRINT/-1\n");
        EXPECT_NE(find_rule(r.problems, "ends early"), nullptr) << card << all_of(r.problems);
        EXPECT_TRUE(r.problems.has_errors());
    }
}

}  // namespace
}  // namespace type21
