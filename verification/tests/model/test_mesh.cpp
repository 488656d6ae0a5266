#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/model/model.h"

namespace type21 {
namespace {

using namespace test;

TEST(Mesh, NodesAreSortedById) {
    const Resolved r =
        resolved(replaced(driven_scene(), "\n/SHELL/1\n",
                          "\n/NODE\n9999999999                 1.0                 2.0                 3.0\n"
                          "        50                 4.0\n/SHELL/1\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const Nodes& nodes = r.model.nodes;
    ASSERT_EQ(nodes.size(), 12);
    EXPECT_TRUE(std::is_sorted(nodes.id.begin(), nodes.id.end()));
    EXPECT_EQ(nodes.index.at(9999999999), 11);
    EXPECT_EQ(nodes.position[11], Vec3(1, 2, 3));
    EXPECT_EQ(nodes.position[nodes.index.at(50)], Vec3(4, 0, 0)) << "a short line has zeros";
    EXPECT_GT(nodes.line[11], 0);
}

TEST(Mesh, ShellsOfFourAndThreeNodes) {
    const Model m = resolved(driven_scene()).model;
    ASSERT_EQ(m.shells.size(), 3U);
    EXPECT_EQ(m.shells[0].id, 1);
    EXPECT_EQ(m.shells[0].thickness, 1.5);
    EXPECT_FALSE(m.shells[0].is_triangle());
    EXPECT_EQ(m.shells[1].id, 3) << "all quads come first";
    EXPECT_EQ(m.shells[1].thickness, 1.0);
    EXPECT_TRUE(m.shells[2].is_triangle());
    EXPECT_EQ(m.shells[2].node, (std::array<int, 4>{1, 4, 2, 2}));
}

TEST(Mesh, AQuadMayRepeatOrOmitItsFourthNode) {
    for (const char* fourth : {"3", "0", ""}) {
        const Resolved r = resolved(with_cards("/SHELL/1\n" + ints({"9", "1", "2", "3", fourth})));
        EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
        EXPECT_TRUE(r.model.shells.at(2).is_triangle());
    }
}

TEST(Mesh, AQuadThatRepeatsAnotherNodeIsATriangleWithOneWarning) {
    using Corners = std::array<int, 4>;
    const auto all = [](const std::vector<std::vector<std::string>>& shells) {
        std::string lines = "/SHELL/1\n";
        for (const auto& shell : shells)
            lines += ints(shell);
        return resolved(with_cards(lines));
    };
    const Resolved r = all({{"7", "1", "1", "3", "4"}, {"8", "1", "2", "2", "4"}, {"9", "1", "2", "3", "1"}});
    const Problem warning = only(r.problems);
    EXPECT_EQ(warning.severity, Severity::warning);
    EXPECT_EQ(warning.count, 3);
    EXPECT_NE(warning.rule.find("read as a triangle"), std::string::npos) << warning.rule;
    EXPECT_EQ(r.model.shells.at(2).node, (Corners{0, 2, 3, 3}));
    EXPECT_EQ(r.model.shells.at(3).node, (Corners{0, 1, 3, 3}));
    EXPECT_EQ(r.model.shells.at(4).node, (Corners{0, 1, 2, 2}));
}

TEST(Mesh, NodesThatAreNeitherAQuadNorATriangleAreAnError) {
    for (const auto& nodes : {std::vector<std::string>{"9", "1", "2", "3", "2"},
                              {"9", "1", "2", "1", "4"},
                              {"9", "1", "1", "3", "3"},
                              {"9", "1", "2", "2", "1"}}) {
        const Problem p = only(resolved(with_cards("/SHELL/1\n" + ints(nodes))).problems);
        EXPECT_EQ(p.severity, Severity::error);
        EXPECT_NE(p.rule.find("three different nodes"), std::string::npos);
        EXPECT_EQ(p.value, "shell 9");
    }
    EXPECT_EQ(only(resolved(with_cards("/SH3N/1\n" + ints({"9", "1", "2", "2"}))).problems).value, "shell 9");
}

TEST(Mesh, TheThicknessOfAShellBeatsItsProperty) {
    const Resolved r = resolved(with_cards("/SHELL/1\n" + ints({"9", "1", "2", "3", "4", "", "", ""}) + "/SH3N/1\n" +
                                           ints({"9", "1", "2", "3", "", "", "", "", "", "0.7"})));
    EXPECT_EQ(r.model.shells.at(2).thickness, 1.5);
    EXPECT_EQ(r.model.shells.at(4).thickness, 0.7);
    EXPECT_EQ(r.problems.error_count(), 0) << "the ids of quads and triangles are two sets";
}

TEST(Mesh, AShellWithoutThicknessIsAnErrorOncePerCard) {
    const std::string shells = "/PROP/SHELL/9\nthin\n\n\n\n/PART/9\nthin\n" + ints({"9", "1"}) + "/SHELL/9\n";
    const Problem p =
        only(resolved(with_cards(shells + ints({"8", "1", "2", "3", "4"}) + ints({"9", "1", "2", "3", "4"}))).problems);
    EXPECT_EQ(p.field, "Thick");
    EXPECT_EQ(p.value, "0 mm");
    EXPECT_EQ(p.count, 2);
}

TEST(Mesh, AWordInPlaceOfAnIdIsOneProblem) {
    EXPECT_EQ(only(resolved(with_cards("/SHELL/1\n" + ints({"x", "1", "2", "3", "4"}))).problems).value, "x");
    EXPECT_EQ(only(resolved(with_cards("/SHELL/1\n" + ints({"9", "1", "x", "3", "4"}))).problems).value, "x");
    EXPECT_EQ(only(resolved(with_cards("/SHELL/1\n" + ints({"-9", "1", "2", "3", "4"}))).problems).value, "-9");
}

TEST(Mesh, AMissingNodeIsNamedOnceHoweverOftenItIsUsed) {
    const Resolved r =
        resolved(with_cards("/SHELL/1\n" + ints({"8", "1", "2", "3", "777"}) + ints({"9", "777", "2", "3", "4"})));
    const Problem p = only(r.problems);
    EXPECT_EQ(p.value, "777");
    EXPECT_EQ(p.count, 2);
}

TEST(Mesh, DuplicateIdsNameBothLines) {
    const Problem node = only(resolved(with_cards("/NODE\n         3                 0.0\n")).problems);
    EXPECT_EQ(node.field, "node_ID");
    EXPECT_NE(node.rule.find("_0000.rad:"), std::string::npos);
    const Problem shell = only(resolved(with_cards("/SHELL/1\n" + ints({"1", "1", "2", "3", "3"}))).problems);
    EXPECT_EQ(shell.field, "shell_ID");
    EXPECT_EQ(shell.value, "1");
}

TEST(Mesh, AnUnknownPartIsOneProblem) {
    const Problem p =
        only(resolved(with_cards("/SHELL/66\n" + ints({"8", "1", "2", "3", "4"}) + ints({"9", "1", "2", "3", "4"})))
                 .problems);
    EXPECT_EQ(p.value, "66");
    EXPECT_EQ(p.card, "/SHELL/66");
}

TEST(NodalMass, QuarterOfAQuadAndAngleOfATriangle) {
    const Model m = resolved(driven_scene()).model;
    const double area_mass = 7.8e-9 * 1.5;
    const double quad = area_mass * 100 / 4;
    const double triangle = area_mass * 50;
    EXPECT_DOUBLE_EQ(m.nodal_mass[0], quad);
    EXPECT_DOUBLE_EQ(m.nodal_mass[1], quad + triangle * 0.5);
    EXPECT_DOUBLE_EQ(m.nodal_mass[2], quad + triangle * 0.25);
    EXPECT_DOUBLE_EQ(m.nodal_mass[4], triangle * 0.25);
    EXPECT_DOUBLE_EQ(m.nodal_mass[5], 7.8e-9 * 1.0 * 600 / 4) << "void shells have their mass";
    EXPECT_EQ(m.nodal_mass[9], 0) << "no shell at the main node";
}

TEST(NodalMass, AWarpedQuadHasHalfTheProductOfItsDiagonals) {
    const Model m =
        resolved(replaced(driven_scene(), "         3                10.0                10.0                 0.0",
                          "         3                10.0                10.0                 5.0"))
            .model;
    const double area = 0.5 * Vec3(10, 10, 5).cross(Vec3(-10, 10, 0)).norm();
    EXPECT_DOUBLE_EQ(m.nodal_mass[0], 7.8e-9 * 1.5 * area / 4);
}

TEST(NodalMass, AddedMasses) {
    const double plain = resolved(driven_scene()).model.nodal_mass[0];
    const auto mass = [](const char* type) {
        return resolved(with_cards("/ADMAS/" + std::string(type) + "/1\nballast\n" +
                                   fmt::format("{:>20}{:>10}\n", "5.0", "1")))
            .model.nodal_mass[0];
    };
    EXPECT_DOUBLE_EQ(mass("0"), plain + 5);
    EXPECT_DOUBLE_EQ(mass("1"), plain + 1) << "five nodes share it";
}

TEST(NodalMass, AddedMassesOfOtherTypesAndNegativeOnesAreRefused) {
    EXPECT_EQ(only(resolved(with_cards("/ADMAS/5/1\nballast\n")).problems).card, "/ADMAS");
    EXPECT_EQ(only(resolved(with_cards("/ADMAS/0/1\nx\n" + fmt::format("{:>20}{:>10}\n", "-5.0", "1"))).problems).field,
              "Mass");
}

}  // namespace
}  // namespace type21
