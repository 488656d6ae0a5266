#include <gtest/gtest.h>

#include "selecting.h"

namespace type21 {
namespace {

using namespace test;

using Corners = std::array<int, 4>;

/// The only problem of surface 9, of group 10.
Problem problem_of_surface(const std::string& cards) {
    Selecting deck(with_cards(cards));
    deck.surface(9);
    return only(deck.problems);
}

Problem problem_of_group(const std::string& cards) {
    Selecting deck(with_cards(cards));
    deck.nodes(10);
    return only(deck.problems);
}

TEST(Surfaces, OfPartsInTheOrderOfTheShells) {
    for (const char* keyword : {"/SURF/PART/9", "/SURF/PART/EXT/9", "/SURF/PART/ALL/9"}) {
        Selecting r(with_cards(std::string(keyword) + "\nboth\n" + ints({"2", "1"})));
        const std::vector<Segment> s = r.surface(9);
        EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
        ASSERT_EQ(s.size(), 3U);
        EXPECT_EQ(s[0].node, (Corners{0, 1, 2, 3}));
        EXPECT_EQ(s[1].node, (Corners{5, 6, 7, 8}));
        EXPECT_EQ(s[2].node, (Corners{1, 4, 2, 2}));
        EXPECT_EQ(s[2].shell, 2);
    }
}

TEST(Surfaces, ANegativePartTurnsItsSegmentsRound) {
    Selecting r(with_cards("/SURF/PART/9\nturned\n" + ints({"-1", "2"})));
    const std::vector<Segment> s = r.surface(9);
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(s[0].node, (Corners{3, 2, 1, 0}));
    EXPECT_EQ(s[1].node, (Corners{5, 6, 7, 8}));
    EXPECT_EQ(s[2].node, (Corners{4, 1, 2, 2})) << "a triangle still repeats its third node";
}

TEST(Surfaces, OfSegmentsFindTheirShell) {
    Selecting r(with_cards("/SURF/SEG/9\nsegments\n" + ints({"1", "4", "3", "2", "1"}) + ints({"2", "2", "5", "3"}) +
                           ints({"3", "1", "2", "5", "5"})));
    const std::vector<Segment> s = r.surface(9);
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(s.size(), 3U);
    EXPECT_EQ(s[0].node, (Corners{3, 2, 1, 0})) << "the order of the card holds";
    EXPECT_EQ(s[0].shell, 0);
    EXPECT_EQ(s[1].node, (Corners{1, 4, 2, 2}));
    EXPECT_EQ(s[1].shell, 2);
    EXPECT_EQ(s[2].shell, -1);
}

TEST(Surfaces, OfSeveralShellsTheThickestThenTheStiffest) {
    const std::string doubles =
        "/PART/8\nsoft\n" + ints({"2", "2"}) + "/SHELL/8\n         8         1         2         3         4" +
        std::string(30, ' ') + "                 2.0\n/MAT/VOID/9\nstiff\n" + reals({"0", "300000"}) +
        "/PART/9\nstiff\n" + ints({"2", "9"}) + "/SHELL/9\n         9         1         2         3         4" +
        std::string(30, ' ') + "                 2.0\n/SURF/SEG/9\ns\n" + ints({"1", "1", "2", "3", "4"});
    Selecting r(with_cards(doubles));
    const int shell = r.surface(9).at(0).shell;
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_GE(shell, 0);
    EXPECT_EQ(r.model.shells[static_cast<size_t>(shell)].id, 9);
}

TEST(Surfaces, OddSpellingsOfATriangleAreMendedWithAWarning) {
    struct Spelling {
        std::vector<std::string> written;
        Corners read;
    };
    for (const Spelling& s :
         {Spelling{{"1", "1", "2", "3", "1"}, {0, 1, 2, 2}}, Spelling{{"1", "1", "2", "2", "3"}, {0, 1, 2, 2}},
          Spelling{{"1", "1", "1", "2", "3"}, {0, 1, 2, 2}}}) {
        Selecting r(with_cards("/SURF/SEG/9\ns\n" + ints(s.written)));
        EXPECT_EQ(r.surface(9).at(0).node, s.read);
        EXPECT_EQ(only(r.problems).severity, Severity::warning);
    }
}

TEST(Surfaces, CrossedOrCollapsedSegmentsAreErrors) {
    for (const auto& nodes : {std::vector<std::string>{"1", "1", "2", "1", "4"},
                              {"1", "1", "2", "3", "2"},
                              {"1", "1", "1", "2", "2"},
                              {"1", "1", "2", "2", "2"}}) {
        EXPECT_EQ(problem_of_surface("/SURF/SEG/9\ns\n" + ints(nodes)).severity, Severity::error);
    }
}

TEST(Surfaces, OfSurfacesInAnyOrderWithSigns) {
    Selecting r(with_cards("/SURF/SURF/9\nouter\n" + ints({"-8", "2"}) + "/SURF/SURF/8\ninner\n" + ints({"1", "-2"})));
    const std::vector<Segment> s = r.surface(9);
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(s.size(), 4U);
    EXPECT_EQ(s[0].node, (Corners{3, 2, 1, 0}));
    EXPECT_EQ(s[2].node, (Corners{5, 6, 7, 8})) << "turned twice";
    EXPECT_EQ(s[3].node, (Corners{5, 6, 7, 8}));
}

TEST(Surfaces, ACircleOfSurfacesIsAnErrorAndEnds) {
    Selecting r(with_cards("/SURF/SURF/9\na\n" + ints({"8"}) + "/SURF/SURF/8\nb\n" + ints({"9"})));
    EXPECT_TRUE(r.surface(9).empty());
    EXPECT_EQ(r.problems.error_count(), 1);
    EXPECT_NE(find_rule(r.problems, "contain itself"), nullptr);
}

TEST(Surfaces, UnknownMembers) {
    EXPECT_EQ(problem_of_surface("/SURF/PART/9\ns\n" + ints({"66"})).value, "66");
    EXPECT_EQ(problem_of_surface("/SURF/SURF/9\ns\n" + ints({"66"})).field, "surf_ID");
    EXPECT_EQ(problem_of_surface("/SURF/SEG/9\ns\n" + ints({"1", "1", "2", "66", "66"})).value, "66");
}

TEST(Groups, OfNodesPartsSurfacesAndGroups) {
    Selecting r(with_cards("/GRNOD/NODE/10\nn\n" + ints({"5", "1", "5"}) + ints({"2"}) + "/GRNOD/PART/11\np\n" +
                           ints({"1"}) + "/GRNOD/SURF/12\ns\n" + ints({"2"}) + "/GRNOD/GRNOD/13\ng\n" +
                           ints({"12", "14"}) + "/GRNOD/GRNOD/14\ng\n" + ints({"10"})));
    EXPECT_EQ(r.nodes(10), (std::vector<Id>{1, 2, 5})) << "ascending, each once";
    EXPECT_EQ(r.nodes(11), (std::vector<Id>{1, 2, 3, 4, 5}));
    EXPECT_EQ(r.nodes(12), (std::vector<Id>{101, 102, 103, 104}));
    EXPECT_EQ(r.nodes(13), (std::vector<Id>{1, 2, 5, 101, 102, 103, 104}));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
}

TEST(Groups, MistakesAreNamed) {
    EXPECT_EQ(problem_of_group("/GRNOD/NODE/10\nn\n" + ints({"66"})).value, "66");
    EXPECT_EQ(problem_of_group("/GRNOD/NODE/10\nn\n" + ints({"-1"})).value, "-1");
    EXPECT_EQ(problem_of_group("/GRNOD/GRNOD/10\nn\n" + ints({"10"})).card, "/GRNOD/GRNOD/10");
    // Eleven ids on one line: the eleventh begins in column 101.
    const std::string eleven = ints({"1", "2", "3", "4", "5", "1", "2", "3", "4", "1", "5"});
    const Problem beyond = problem_of_group("/GRNOD/NODE/10\nn\n" + eleven);
    EXPECT_EQ(beyond.severity, Severity::warning);
    EXPECT_EQ(beyond.value, "5");
    EXPECT_EQ(problem_of_group("/GRNOD/BOX/10\nn\n" + ints({"1"})).field, "box_ID");
}

}  // namespace
}  // namespace type21
