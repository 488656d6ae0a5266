#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/model/model.h"

namespace type21 {
namespace {

using namespace test;

const Surface& surface(const Model& model, Id id) {
    for (const Surface& candidate : model.surfaces) {
        if (candidate.id == id) return candidate;
    }
    throw std::runtime_error("no such surface");
}

using Corners = std::array<int, 4>;

TEST(Surfaces, OfPartsInTheOrderOfTheShells) {
    for (const char* keyword : {"/SURF/PART/9", "/SURF/PART/EXT/9", "/SURF/PART/ALL/9"}) {
        const Resolved r = resolved(with_cards(std::string(keyword) + "\nboth\n" + ints({"2", "1"})));
        EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
        const Surface& s = surface(r.model, 9);
        ASSERT_EQ(s.segments.size(), 3U);
        EXPECT_EQ(s.segments[0].node, (Corners{0, 1, 2, 3}));
        EXPECT_EQ(s.segments[1].node, (Corners{5, 6, 7, 8}));
        EXPECT_EQ(s.segments[2].node, (Corners{1, 4, 2, 2}));
        EXPECT_EQ(s.segments[2].shell, 2);
    }
}

TEST(Surfaces, ANegativePartTurnsItsSegmentsRound) {
    const Resolved r = resolved(with_cards("/SURF/PART/9\nturned\n" + ints({"-1", "2"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const Surface& s = surface(r.model, 9);
    EXPECT_EQ(s.segments[0].node, (Corners{3, 2, 1, 0}));
    EXPECT_EQ(s.segments[1].node, (Corners{5, 6, 7, 8}));
    EXPECT_EQ(s.segments[2].node, (Corners{4, 1, 2, 2})) << "a triangle still repeats its third node";
}

TEST(Surfaces, OfSegmentsFindTheirShell) {
    const Resolved r = resolved(with_cards("/SURF/SEG/9\nsegments\n" + ints({"1", "4", "3", "2", "1"}) +
                                           ints({"2", "2", "5", "3"}) + ints({"3", "1", "2", "5", "5"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const Surface& s = surface(r.model, 9);
    ASSERT_EQ(s.segments.size(), 3U);
    EXPECT_EQ(s.segments[0].node, (Corners{3, 2, 1, 0})) << "the order of the card holds";
    EXPECT_EQ(s.segments[0].shell, 0);
    EXPECT_EQ(s.segments[1].node, (Corners{1, 4, 2, 2}));
    EXPECT_EQ(s.segments[1].shell, 2);
    EXPECT_EQ(s.segments[2].shell, -1);
}

TEST(Surfaces, OfSeveralShellsTheThickestThenTheStiffest) {
    const std::string doubles =
        "/PART/8\nsoft\n" + ints({"2", "2"}) + "/SHELL/8\n         8         1         2         3         4" +
        std::string(30, ' ') + "                 2.0\n/MAT/VOID/9\nstiff\n" + reals({"0", "300000"}) +
        "/PART/9\nstiff\n" + ints({"2", "9"}) + "/SHELL/9\n         9         1         2         3         4" +
        std::string(30, ' ') + "                 2.0\n/SURF/SEG/9\ns\n" + ints({"1", "1", "2", "3", "4"});
    const Resolved r = resolved(with_cards(doubles));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const int shell = surface(r.model, 9).segments.at(0).shell;
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
        const Resolved r = resolved(with_cards("/SURF/SEG/9\ns\n" + ints(s.written)));
        EXPECT_EQ(only(r.problems).severity, Severity::warning);
        EXPECT_EQ(surface(r.model, 9).segments.at(0).node, s.read);
    }
}

TEST(Surfaces, CrossedOrCollapsedSegmentsAreErrors) {
    for (const auto& nodes : {std::vector<std::string>{"1", "1", "2", "1", "4"},
                              {"1", "1", "2", "3", "2"},
                              {"1", "1", "1", "2", "2"},
                              {"1", "1", "2", "2", "2"}}) {
        EXPECT_EQ(only(resolved(with_cards("/SURF/SEG/9\ns\n" + ints(nodes))).problems).severity, Severity::error);
    }
}

TEST(Surfaces, OfSurfacesInAnyOrderWithSigns) {
    const Resolved r =
        resolved(with_cards("/SURF/SURF/9\nouter\n" + ints({"-8", "2"}) + "/SURF/SURF/8\ninner\n" + ints({"1", "-2"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const Surface& s = surface(r.model, 9);
    ASSERT_EQ(s.segments.size(), 4U);
    EXPECT_EQ(s.segments[0].node, (Corners{3, 2, 1, 0}));
    EXPECT_EQ(s.segments[2].node, (Corners{5, 6, 7, 8})) << "turned twice";
    EXPECT_EQ(s.segments[3].node, (Corners{5, 6, 7, 8}));
}

TEST(Surfaces, ACircleOfSurfacesIsAnErrorAndEnds) {
    const Resolved r = resolved(with_cards("/SURF/SURF/9\na\n" + ints({"8"}) + "/SURF/SURF/8\nb\n" + ints({"9"})));
    EXPECT_EQ(r.problems.error_count(), 2);
    EXPECT_NE(find_rule(r.problems, "contain itself"), nullptr);
}

TEST(Surfaces, UnknownMembers) {
    EXPECT_EQ(only(resolved(with_cards("/SURF/PART/9\ns\n" + ints({"66"}))).problems).value, "66");
    EXPECT_EQ(only(resolved(with_cards("/SURF/SURF/9\ns\n" + ints({"66"}))).problems).field, "SURF_ID");
    EXPECT_EQ(only(resolved(with_cards("/SURF/SEG/9\ns\n" + ints({"1", "1", "2", "66", "66"}))).problems).value, "66");
}

TEST(Groups, OfNodesPartsSurfacesAndGroups) {
    const Resolved r =
        resolved(with_cards("/GRNOD/NODE/10\nn\n" + ints({"5", "1", "5"}) + ints({"2"}) + "/GRNOD/PART/11\np\n" +
                            ints({"1"}) + "/GRNOD/SURF/12\ns\n" + ints({"2"}) + "/GRNOD/GRNOD/13\ng\n" +
                            ints({"12", "14"}) + "/GRNOD/GRNOD/14\ng\n" + ints({"10"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const auto nodes = [&](Id id) {
        for (const NodeGroup& group : r.model.groups) {
            if (group.id == id) return group.nodes;
        }
        return std::vector<int>{};
    };
    EXPECT_EQ(nodes(10), (std::vector<int>{0, 1, 4})) << "ascending, each once";
    EXPECT_EQ(nodes(11), (std::vector<int>{0, 1, 2, 3, 4}));
    EXPECT_EQ(nodes(12), (std::vector<int>{5, 6, 7, 8}));
    EXPECT_EQ(nodes(13), (std::vector<int>{0, 1, 4, 5, 6, 7, 8}));
}

TEST(Groups, MistakesAreNamed) {
    EXPECT_EQ(only(resolved(with_cards("/GRNOD/NODE/10\nn\n" + ints({"66"}))).problems).value, "66");
    EXPECT_EQ(only(resolved(with_cards("/GRNOD/NODE/10\nn\n" + ints({"-1"}))).problems).value, "-1");
    EXPECT_EQ(only(resolved(with_cards("/GRNOD/GRNOD/10\nn\n" + ints({"10"}))).problems).card, "/GRNOD/GRNOD/10");
    // Eleven ids on one line: the eleventh begins in column 101.
    const std::string eleven = ints({"1", "2", "3", "4", "5", "1", "2", "3", "4", "1", "5"});
    const Problem beyond = only(resolved(with_cards("/GRNOD/NODE/10\nn\n" + eleven)).problems);
    EXPECT_EQ(beyond.severity, Severity::warning);
    EXPECT_EQ(beyond.value, "5");
    EXPECT_EQ(only(resolved(with_cards("/GRNOD/BOX/10\nn\n" + ints({"1"}))).problems).card, "/GRNOD/BOX");
}

}  // namespace
}  // namespace type21
