/// @file Groups of nodes, shells and parts and the surfaces made of them, worked out by hand on a strip of shells.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "selecting.h"

namespace type21 {
namespace {

using namespace test;

using Ids = std::vector<Id>;

/// The driven scene and a strip beside it: nodes 301 to 306 below, 311 to 316 above (x = 0, 10, ... 50; y = 50 and 60).
/// Shells 31 to 33 (part 3: material 2, property 2, subset 7), 34 (part 4: material 2, property 4, subset 8) and, as
/// two triangles, 41 and 42 (part 4). The card of part 4 comes first.
std::string strip(const std::string& cards) {
    std::string text = "/NODE\n";
    for (int i = 0; i < 6; ++i) {
        text += fmt::format("{:>10}", 301 + i) + reals({fmt::format("{}.0", 10 * i), "50.0", "0.0"});
        text += fmt::format("{:>10}", 311 + i) + reals({fmt::format("{}.0", 10 * i), "60.0", "0.0"});
    }
    const auto quad = [](int id, int i) {
        return ints({fmt::format("{}", id), fmt::format("{}", 301 + i), fmt::format("{}", 302 + i),
                     fmt::format("{}", 312 + i), fmt::format("{}", 311 + i)});
    };
    text += "/PROP/VOID/4\nother\n" + reals({"2.0"}) + "/PART/4\nb\n" + ints({"4", "2", "8"}) + "/PART/3\na\n" +
            ints({"2", "2", "7"}) + "/SHELL/4\n" + quad(34, 3) + "/SHELL/3\n" + quad(33, 2) + quad(31, 0) +
            quad(32, 1) + "/SH3N/4\n" + ints({"41", "305", "306", "316"}) + ints({"42", "305", "316", "315"}) +
            "/SUBSET/9\nall\n" + ints({"7", "8"}) + "/SUBSET/7\nquads\n" + "/SUBSET/8\nrest\n";
    return with_cards(text + cards);
}

TEST(ShellGroups, ByEveryKind) {
    Selecting s(strip(list_card("/GRSHEL/SHEL/1", {"33", "31", "33"}) + list_card("/GRSHEL/PART/2", {"4"}) +
                      list_card("/GRSHEL/MAT/3", {"2"}) + list_card("/GRSHEL/PROP/4", {"2"}) +
                      list_card("/GRSHEL/SUBSET/5", {"9"}) + list_card("/GRSHEL/GENE/6", {"30", "32", "34", "99"}) +
                      list_card("/GRSHEL/GEN_INCR/7", {"31", "34", "2"}) + list_card("/GRSHEL/GRSHEL/8", {"2", "1"}) +
                      list_card("/GRSHEL/GRSHEL/9", {"5", "-1"})));
    EXPECT_EQ(s.shells(1), (Ids{33, 31})) << "in the order of the deck, each once";
    EXPECT_EQ(s.shells(2), (Ids{34})) << "the triangles of the part belong to /GRSH3N";
    EXPECT_EQ(s.shells(3), (Ids{3, 34, 33, 31, 32})) << "the tool of the scene, too";
    EXPECT_EQ(s.shells(4), (Ids{3, 33, 31, 32}));
    EXPECT_EQ(s.shells(5), (Ids{34, 33, 31, 32}));
    EXPECT_EQ(s.shells(6), (Ids{34, 31, 32}));
    EXPECT_EQ(s.shells(7), (Ids{33, 31}));
    EXPECT_EQ(s.shells(8), (Ids{34, 33, 31}));
    EXPECT_EQ(s.shells(9), (Ids{34, 32})) << "a negative id takes away";
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(ShellGroups, OfTriangles) {
    Selecting s(strip(list_card("/GRSH3N/SH3N/1", {"42"}) + list_card("/GRSH3N/PART/2", {"4", "1"}) +
                      list_card("/GRSH3N/GENE/3", {"1", "41"}) + list_card("/GRSH3N/GRSH3N/4", {"2", "-1"})));
    EXPECT_EQ(s.sh3n(1), (Ids{42}));
    EXPECT_EQ(s.sh3n(2), (Ids{2, 41, 42}));
    EXPECT_EQ(s.sh3n(3), (Ids{2, 41}));
    EXPECT_EQ(s.sh3n(4), (Ids{2, 41}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(PartGroups, ByEveryKind) {
    Selecting s(strip(list_card("/GRPART/PART/1", {"3", "1"}) + list_card("/GRPART/MAT/2", {"2"}) +
                      list_card("/GRPART/PROP/3", {"4"}) + list_card("/GRPART/SUBSET/4", {"9"}) +
                      list_card("/GRPART/GENE/5", {"2", "3"}) + list_card("/GRPART/GEN_INCR/6", {"1", "4", "2"}) +
                      list_card("/GRPART/GRPART/7", {"2", "-1"})));
    EXPECT_EQ(s.parts(1), (Ids{1, 3})) << "in the order of the deck";
    EXPECT_EQ(s.parts(2), (Ids{2, 4, 3}));
    EXPECT_EQ(s.parts(3), (Ids{4}));
    EXPECT_EQ(s.parts(4), (Ids{4, 3}));
    EXPECT_EQ(s.parts(5), (Ids{2, 3}));
    EXPECT_EQ(s.parts(6), (Ids{1, 3}));
    EXPECT_EQ(s.parts(7), (Ids{2, 4}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(NodeGroups, ByEveryKind) {
    Selecting s(strip(list_card("/GRSHEL/SHEL/1", {"31"}) + list_card("/GRSH3N/SH3N/1", {"41"}) +
                      list_card("/GRPART/PART/1", {"1"}) + list_card("/GRNOD/MAT/11", {"1"}) +
                      list_card("/GRNOD/PROP/12", {"4"}) + list_card("/GRNOD/SUBSET/13", {"8"}) +
                      list_card("/GRNOD/GRSHEL/14", {"1"}) + list_card("/GRNOD/GRSH3N/15", {"1"}) +
                      list_card("/GRNOD/GRPART/16", {"1"}) + list_card("/GRNOD/GENE/17", {"300", "302", "316", "400"}) +
                      list_card("/GRNOD/GEN_INCR/18", {"301", "306", "2"}) + list_card("/GRNOD/NODENS/19", {"5", "1"}) +
                      list_card("/GRNOD/GRNOD/20", {"17", "18", "-14"})));
    EXPECT_EQ(s.nodes(11), (Ids{1, 2, 3, 4, 5}));
    EXPECT_EQ(s.nodes(12), (Ids{304, 305, 306, 314, 315, 316}));
    EXPECT_EQ(s.nodes(13), s.nodes(12));
    EXPECT_EQ(s.nodes(14), (Ids{301, 302, 311, 312}));
    EXPECT_EQ(s.nodes(15), (Ids{305, 306, 316}));
    EXPECT_EQ(s.nodes(16), (Ids{1, 2, 3, 4, 5}));
    EXPECT_EQ(s.nodes(17), (Ids{301, 302, 316}));
    EXPECT_EQ(s.nodes(18), (Ids{301, 303, 305}));
    EXPECT_EQ(s.nodes(19), (Ids{1, 5}));
    EXPECT_EQ(s.nodes(20), (Ids{303, 305, 316}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Surfaces, ByEveryKind) {
    const std::string of_3 = "303 304 314 313, 301 302 312 311, 302 303 313 312";
    const std::string of_4 = "304 305 315 314, ";
    const std::string triangles = "305 306 316 316, 305 316 315 315";
    Selecting s(strip(
        list_card("/GRSHEL/PART/1", {"3"}) + list_card("/GRSHEL/SHEL/2", {"31"}) + list_card("/GRSH3N/PART/1", {"4"}) +
        list_card("/GRPART/PART/1", {"4"}) + list_card("/SURF/GRSHEL/11", {"1"}) + list_card("/SURF/GRSH3N/12", {"1"}) +
        list_card("/SURF/PROP/13", {"4"}) + list_card("/SURF/SUBSET/14", {"9"}) + list_card("/SURF/GRPART/15", {"1"}) +
        list_card("/SURF/MAT/EXT/16", {"-1"}) + list_card("/SURF/GRSHEL/17", {"1", "-2"}) +
        list_card("/SURF/SUBSET/ALL/18", {"-8"}) + list_card("/SURF/SURF/19", {"-12", "13"})));
    EXPECT_EQ(s.segments(11), of_3) << "the order of the deck, not of the ids";
    EXPECT_EQ(s.segments(12), triangles);
    EXPECT_EQ(s.segments(13), of_4 + triangles) << "shells of four nodes first";
    EXPECT_EQ(s.segments(14), of_4 + of_3 + ", " + triangles);
    EXPECT_EQ(s.segments(15), of_4 + triangles);
    EXPECT_EQ(s.segments(16), "4 3 2 1, 5 2 3 3") << "turned round";
    EXPECT_EQ(s.segments(17), "303 304 314 313, 311 312 302 301, 302 303 313 312")
        << "the last listing gives the sense";
    EXPECT_EQ(s.segments(18), "314 315 305 304, 306 305 316 316, 316 305 315 315");
    EXPECT_EQ(s.segments(19), "306 305 316 316, 316 305 315 315, " + of_4 + triangles);
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Selections, UnknownIdsAreNamedAtTheCard) {
    struct Mistake {
        std::string cards, field, value;
    };
    for (const Mistake& m :
         {Mistake{list_card("/GRNOD/GRSHEL/10", {"1"}) + list_card("/GRSHEL/SHEL/1", {"31", "77"}), "shell_ID", "77"},
          Mistake{list_card("/GRNOD/GRSHEL/10", {"1"}) + list_card("/GRSHEL/SHEL/1", {"41"}), "shell_ID", "41"},
          Mistake{list_card("/GRNOD/GRSH3N/10", {"1"}) + list_card("/GRSH3N/SH3N/1", {"31"}), "sh3n_ID", "31"},
          Mistake{list_card("/GRNOD/GRSHEL/10", {"5"}), "grshel_ID", "5"},
          Mistake{list_card("/GRNOD/MAT/10", {"55"}), "mat_ID", "55"},
          Mistake{list_card("/GRNOD/PROP/10", {"55"}), "prop_ID", "55"},
          Mistake{list_card("/GRNOD/SUBSET/10", {"55"}), "subset_ID", "55"},
          Mistake{list_card("/GRNOD/PART/10", {"-3"}), "part_ID", "-3"},
          Mistake{list_card("/GRNOD/GENE/10", {"9", "3"}), "Ifirst", "9 3 1"},
          Mistake{list_card("/GRNOD/GEN_INCR/10", {"3", "9", "-1"}), "Ifirst", "3 9 -1"},
          Mistake{list_card("/GRNOD/GRBRIC/10", {"1"}), "", "GRBRIC"},
          Mistake{list_card("/GRNOD/GRSHEL/10", {"-1"}) + list_card("/GRSHEL/SHEL/1", {"31"}), "grshel_ID", "-1"}}) {
        Selecting s(strip(m.cards));
        s.nodes(10);
        const Problem problem = only(s.problems);
        EXPECT_EQ(problem.severity, Severity::error);
        EXPECT_EQ(problem.field, m.field) << m.cards;
        EXPECT_EQ(problem.value, m.value) << m.cards;
        EXPECT_FALSE(problem.remedy.empty());
    }
}

TEST(Selections, WhatNothingNamesDoesNoHarm) {
    const Resolved r = resolved(strip(list_card("/GRNOD/NODE/50", {"77777"}) + list_card("/GRNOD/GRBRIC/51", {"1"}) +
                                      list_card("/SURF/ELLIPS/52", {"1"}) + list_card("/GRSHEL/GRSHEL/53", {"53"}) +
                                      "/BOX/RECTA/54\nb\n" + ints({"0", "0", "12"}) + "/SET/GENERAL/55\ns\nWHAT\n" +
                                      list_card("/GRBRIC/BRIC/56", {"1"}) + list_card("/LINE/SURF/57", {"9"}) +
                                      list_card("/GRPART/PART/58", {"99"}) + list_card("/SURF/PART/59", {"66"}) +
                                      list_card("/SUBSET/60", {"99"}) + list_card("/GRSHEL/UNHEARD_OF/61", {"1"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.surfaces.size(), 2U) << "those of the interface";
    EXPECT_EQ(r.model.groups.size(), 3U) << "those that cards name";
}

TEST(Selections, AWordInAnUnusedListIsStillNoNumber) {
    EXPECT_EQ(only(resolved(strip(list_card("/GRSHEL/SHEL/50", {"3x"}))).problems).value, "3x");
}

TEST(Selections, AnIdThatTwoCardsHaveIsAnError) {
    EXPECT_EQ(
        only(resolved(strip(list_card("/GRSHEL/SHEL/50", {"31"}) + list_card("/GRSHEL/PART/50", {"3"}))).problems).card,
        "/GRSHEL/PART/50");
    EXPECT_TRUE(resolved(strip(list_card("/GRSHEL/SHEL/50", {"31"}) + list_card("/GRNOD/PART/50", {"3"})))
                    .problems.list()
                    .empty())
        << "each family counts for itself";
}

TEST(Selections, SubsetsMayBeNestedAndMayListEachOther) {
    Selecting s(strip(list_card("/SUBSET/20", {"21", "7"}) + list_card("/SUBSET/21", {"20", "8"}) +
                      list_card("/GRPART/SUBSET/1", {"21"})));
    EXPECT_EQ(s.parts(1), (Ids{4, 3}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Selections, AChainOfAnyLengthEndsAndACircleIsSaid) {
    constexpr int length = 20000;
    for (const std::string kind : {"GRNOD", "GRSHEL", "GRPART", "SURF", "BOX"}) {
        std::string cards;
        for (int i = 0; i < length; ++i)
            cards += list_card(fmt::format("/{}/{}/{}", kind, kind, 1000 + i), {fmt::format("{}", 1001 + i)});
        const std::string last = fmt::format("{}", 1000 + length);
        const std::string end = kind == "GRNOD"    ? list_card("/GRNOD/NODE/" + last, {"301"})
                                : kind == "GRSHEL" ? list_card("/GRSHEL/SHEL/" + last, {"31"})
                                : kind == "GRPART" ? list_card("/GRPART/PART/" + last, {"3"})
                                : kind == "SURF"   ? list_card("/SURF/PART/" + last, {"3"})
                                                   : "/BOX/SPHER/" + last + "\nb\n" + ints({"301"}) + "";
        const auto ask = [&](Selecting& s) {
            return kind == "GRNOD"    ? s.nodes(1000).size()
                   : kind == "GRSHEL" ? s.shells(1000).size()
                   : kind == "GRPART" ? s.parts(1000).size()
                   : kind == "SURF"   ? s.surface(1000).size()
                                      : s.nodes(900).size();
        };
        const std::string boxed = list_card("/GRNOD/BOX/900", {"1000"});
        const std::string sphere = "/BOX/SPHER/" + last + "\nb\n" + fmt::format("{:>10}{:>30}\n", 301, "1.0");
        Selecting whole(strip(cards + (kind == "BOX" ? sphere + boxed : end)));
        EXPECT_EQ(ask(whole), kind == "SURF" ? 3U : 1U) << kind;
        EXPECT_TRUE(whole.problems.list().empty()) << all_of(whole.problems);
        Selecting circle(strip(cards + boxed + list_card(fmt::format("/{}/{}/{}", kind, kind, last), {"1000"})));
        ask(circle);
        EXPECT_NE(only(circle.problems).rule.find("contain itself"), std::string::npos) << kind;
    }
}

TEST(Selections, ASurfaceThatDoublesAtEveryLevelIsAnError) {
    std::string cards = list_card("/SURF/PART/1000", {"3"});
    for (int i = 1; i <= 60; ++i)
        cards +=
            list_card(fmt::format("/SURF/SURF/{}", 1000 + i), {fmt::format("{}", 999 + i), fmt::format("{}", 999 + i)});
    Selecting s(strip(cards));
    EXPECT_TRUE(s.surface(1060).empty());
    EXPECT_NE(only(s.problems).rule.find("at most"), std::string::npos);
    Selecting twice(strip(cards));
    EXPECT_EQ(twice.surface(1001).size(), 6U) << "twice is as written: the areas of the interface see to it";
}

TEST(Selections, DifferencesOfDifferences) {
    Selecting s(strip(list_card("/GRNOD/NODE/21", {"301", "302", "303", "304"}) +
                      list_card("/GRNOD/NODE/22", {"302", "303"}) + list_card("/GRNOD/NODE/23", {"303"}) +
                      list_card("/GRNOD/GRNOD/24", {"22", "-23"}) + list_card("/GRNOD/GRNOD/25", {"21", "-24"}) +
                      list_card("/GRNOD/GRNOD/26", {"25", "24"})));
    EXPECT_EQ(s.nodes(25), (Ids{301, 303, 304})) << "21 without (22 without 23)";
    EXPECT_EQ(s.nodes(26), (Ids{301, 302, 303, 304})) << "what is taken away inside does not touch the rest";
}

}  // namespace
}  // namespace type21
