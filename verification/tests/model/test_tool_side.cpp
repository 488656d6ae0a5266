// Checks of both sides together: rigid body, shared nodes, elements, areas, direction of the main normals.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/model.h"

namespace type21::test {
namespace {

constexpr auto error = Severity::error;
constexpr auto warning = Severity::warning;

Interface resolved(Model& model, Problems& problems, const Fields& fields = {}) {
    return resolve_fields(model, fields, problems);
}

// @manual field IDrby, surf_IDm
TEST(ToolSide, MainNodesOutsideTheRigidBodyAreOneError) {
    Model model = blank_over_tool();
    model.rigid_bodies[0].nodes = {9};
    Problems problems;
    resolved(model, problems);
    const auto errors = about(problems, "surf_IDm", error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].value, "3 nodes: 2002, 2003, 2004");
}

TEST(ToolSide, LongListsNameTheFirstAndTheNumber) {
    Model model = blank_over_tool();
    for (int node = 0; node < 9; ++node)
        model.rigid_bodies[0].nodes.insert(model.rigid_bodies[0].nodes.begin() + node, node);
    Problems problems;
    resolved(model, problems);
    const auto errors = about(problems, "surf_IDs", error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].value, "9 nodes: 1001, 1002, 1003, 1004, 1005 and 4 more");
    EXPECT_NE(errors[0].rule.find("rigid body 5"), std::string::npos);
}

TEST(ToolSide, TheMainNodeOfTheBodyIsNoSecondaryNode) {
    Model model = blank_over_tool();
    model.rigid_bodies[0].main_node = 4;
    Problems problems;
    resolved(model, problems);
    ASSERT_EQ(about(problems, "surf_IDs", error).size(), 1u);
    EXPECT_EQ(about(problems, "surf_IDs", error)[0].value, "1 nodes: 1005");
}

Model shared_node() {
    // The tool's first corner is a node of the blank, and in the body as it must be.
    Model model = blank_over_tool();
    model.surfaces[1].segments[0].node[0] = 0;
    model.rigid_bodies[0].nodes = {0, 10, 11, 12};
    return model;
}

// @manual field surf_IDs, surf_IDm
TEST(ToolSide, ANodeOnBothSidesIsAnError) {
    Model model = shared_node();
    Problems problems;
    resolved(model, problems);
    const auto errors = about(problems, "surf_IDs", error);
    ASSERT_EQ(errors.size(), 1u) << "not a second one for being in the body";
    EXPECT_EQ(errors[0].value, "1 nodes: 1001");
    EXPECT_EQ(problems.error_count(), 1);
}

// @manual departure D18
TEST(ToolSide, D18AcceptsANodeOnBothSides) {
    Model model = shared_node();
    model.as_built.set(Departure::D18);
    Problems problems;
    resolved(model, problems);
    EXPECT_EQ(problems.error_count(), 0);
    EXPECT_EQ(about(problems, "surf_IDs", warning).size(), 1u);
}

// @manual comment 1
TEST(ToolSide, SegmentsWithoutElementAreNamed) {
    Model model = blank_over_tool();
    model.surfaces[0].segments[1].shell = -1;
    model.surfaces[0].segments[3].shell = -1;
    model.surfaces[1].segments[0].shell = -1;
    Problems problems;
    resolved(model, problems);
    EXPECT_EQ(problems.error_count(), 0);
    ASSERT_EQ(about(problems, "surf_IDs", warning).size(), 1u);
    EXPECT_EQ(about(problems, "surf_IDs", warning)[0].value, "2 segments: no. 2, 4");
    ASSERT_EQ(about(problems, "surf_IDm", warning).size(), 1u);
    EXPECT_EQ(about(problems, "surf_IDm", warning)[0].value, "1 segments: no. 1");
}

TEST(ToolSide, AMainSegmentWithoutAreaIsAnError) {
    Model model = blank_over_tool();
    Segment flat{{9, 10, 10, 10}, 4};
    model.surfaces[1].segments.push_back(flat);
    flat.node = {9, 11, 12, 12};
    model.surfaces[1].segments.push_back(flat);
    // Three nodes on a line at values that are not exact in binary: the cross product is rounding, not zero.
    model.nodes.position[9] = {0.3, 0.9, -2};
    model.nodes.position[11] = {1.1, 3.3, -2};
    model.nodes.position[12] = {2.3, 6.9, -2};
    Problems problems;
    resolved(model, problems);
    const auto errors = about(problems, "surf_IDm", error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].value, "2 segments: no. 2, 3");
}

TEST(ToolSide, TurnsUnlessItsThreeRotationsAreFixed) {
    const auto turns = [](std::vector<std::array<bool, 6>> conditions) {
        Model model = blank_over_tool();
        model.groups.push_back({8, "", {13}});
        for (const auto& fixed : conditions)
            model.boundary_conditions.push_back({1, fixed, 0});
        Problems problems;
        return resolved(model, problems).tool_rotates;
    };
    EXPECT_TRUE(turns({}));
    EXPECT_TRUE(turns({{true, true, true, true, true, false}}));
    EXPECT_FALSE(turns({{false, false, false, true, true, true}}));
    EXPECT_FALSE(turns({{false, false, false, true, false, false}, {false, false, false, false, true, true}}))
        << "two cards together";
    Model model = blank_over_tool();
    model.groups.push_back({8, "", {0}});
    model.boundary_conditions.push_back({1, {true, true, true, true, true, true}, 0});
    Problems problems;
    EXPECT_TRUE(resolved(model, problems).tool_rotates) << "fixed is another node";
}

// @manual field Dampr
TEST(ToolSide, DamprOfAToolThatCannotTurnHasNoEffect) {
    Model model = blank_over_tool();
    model.groups.push_back({8, "", {13}});
    model.boundary_conditions.push_back({1, {false, false, false, true, true, true}, 0});
    Problems problems;
    const Interface it = resolved(model, problems, {{"Dampr", "0.3"}});
    EXPECT_EQ(it.dampr, 0.0);
    EXPECT_EQ(about(problems, "Dampr", warning).size(), 1u);
    Model free = blank_over_tool();
    Problems none;
    EXPECT_EQ(resolved(free, none, {{"Dampr", "0.3"}}).dampr, 0.3);
}

// ---- main normals
// --------------------------------------------------------------------------------------------------------

void reverse(Model& model) {
    for (Segment& segment : model.surfaces[1].segments)
        std::reverse(segment.node.begin(), segment.node.end());
}

TEST(MainNormals, TowardTheBlankAreFine) {
    Model model = blank_over_tool();
    Problems problems;
    resolved(model, problems);
    EXPECT_TRUE(problems.list().empty());
}

// @manual field Invn; comment 21
TEST(MainNormals, AwayFromTheBlankAreAWarningWithTheRemedy) {
    Model model = blank_over_tool();
    reverse(model);
    Problems problems;
    resolved(model, problems);
    const auto notes = about(problems, "surf_IDm", warning);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].value.find("1 of 1 examined"), std::string::npos) << notes[0].value;
    EXPECT_NE(notes[0].value.find("no. 1 (nodes 2004, 2003, 2002, 2001)"), std::string::npos) << notes[0].value;
    EXPECT_NE(notes[0].remedy.find("negative id"), std::string::npos);
}

TEST(MainNormals, AFarToolIsJudgedToo) {
    Model model = blank_over_tool();
    for (size_t node = 9; node < 13; ++node)
        model.nodes.position[node].z() = -500;
    reverse(model);
    Problems problems;
    resolved(model, problems);
    EXPECT_EQ(about(problems, "surf_IDm", warning).size(), 1u);
}

TEST(MainNormals, ABlankInThePlaneOfTheToolSaysNothing) {
    Model model = blank_over_tool();
    for (size_t node = 9; node < 13; ++node)
        model.nodes.position[node].z() = 0;
    for (const bool turned : {false, true}) {
        if (turned) reverse(model);
        Problems problems;
        model.interfaces.clear();
        resolved(model, problems);
        EXPECT_TRUE(about(problems, "surf_IDm", warning).empty());
    }
}

/// A tool like a box: its lid at z = -2 below the blank, looking up, and its floor 60 mm deeper, looking down.
TEST(MainNormals, TheFarSideOfAClosedToolDoesNotCount) {
    Model model = blank_over_tool();
    const int base = model.nodes.size();
    for (int corner = 0; corner < 4; ++corner) {
        model.nodes.id.push_back(4001 + corner);
        model.nodes.position.push_back(model.nodes.position[static_cast<size_t>(9 + corner)] - Vec3(0, 0, 300));
        model.nodal_mass.push_back(0);
        model.rigid_bodies[0].nodes.push_back(base + corner);
    }
    for (int copy = 0; copy < 3; ++copy)
        model.surfaces[1].segments.push_back({{base + 3, base + 2, base + 1, base}, 4});
    Problems problems;
    resolved(model, problems);
    for (const Problem& problem : about(problems, "surf_IDm", warning))
        EXPECT_EQ(problem.rule.find("face away"), std::string::npos) << problem.rule;
}

/// A cylinder of radius 50 under the flat blank, its axis along y: convex, so its flanks look sideways.
Model cylinder(int around, int along) {
    Model model = blank_over_tool();
    model.surfaces[1].segments.clear();
    model.rigid_bodies[0].nodes.clear();
    const int base = model.nodes.size();
    for (int i = 0; i <= around; ++i)
        for (int j = 0; j <= along; ++j) {
            const double angle = 3.14159265358979 * i / around;
            model.nodes.id.push_back(10000 + model.nodes.size());
            model.nodes.position.emplace_back(10 - 50 * std::cos(angle), -30 + 80.0 * j / along,
                                              -52 + 50 * std::sin(angle));
            model.nodal_mass.push_back(0);
            model.rigid_bodies[0].nodes.push_back(model.nodes.size() - 1);
        }
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < along; ++j) {
            const int first = base + i * (along + 1) + j;
            model.surfaces[1].segments.push_back({{first, first + along + 1, first + along + 2, first + 1}, 4});
        }
    return model;
}

TEST(MainNormals, ACurvedToolIsJudgedByItsNearSegments) {
    for (const int along : {1, 8, 200}) {
        Model model = cylinder(40, along);
        Problems problems;
        resolved(model, problems);
        EXPECT_TRUE(about(problems, "surf_IDm", warning).empty()) << along;
        reverse(model);
        model.interfaces.clear();
        Problems turned;
        resolved(model, turned);
        EXPECT_EQ(about(turned, "surf_IDm", warning).size(), 1u) << along;
    }
}

}  // namespace
}  // namespace type21::test
