#include <gtest/gtest.h>

#include "verification/support/contact_choice.h"
#include "verification/support/prescribed_motion.h"
#include "verification/support/scene_builder.h"

namespace type21 {
namespace {

/// Two by one quads of unit size in the plane z = 0.
SurfaceMesh two_quads() {
    return grid(2, 1, [](int column, int row) { return Vec3(column, row, 0); });
}

TEST(Grid, IsNumberedRowByRowAndFacesUp) {
    const SurfaceMesh mesh = two_quads();
    ASSERT_EQ(mesh.node.size(), 6U);
    EXPECT_EQ(mesh.node[4], Vec3(1, 1, 0));
    EXPECT_EQ(mesh.segment, (std::vector<std::array<int, 4>>{{0, 1, 4, 3}, {1, 2, 5, 4}}));
    EXPECT_EQ(split_quads({mesh.segment[1]}), (std::vector<std::array<int, 4>>{{1, 2, 5, 5}, {1, 5, 4, 4}}));
}

TEST(SceneBuilder, IndicesFollowTheCallsAndSegmentsTheirNodes) {
    SceneBuilder builder;
    builder.blank({{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {}, 10).main_node({0, 0, -1}, 50).tool(two_quads(), 100);
    builder.blank_segments({{0, 1, 2, 2}});
    const HostScene scene = builder.scene();
    const Model& model = *scene.host;
    EXPECT_EQ(scene.model, scene.host);
    EXPECT_EQ(model.nodes.id, (std::vector<Id>{10, 11, 12, 50, 104, 105, 106, 107, 108, 109}));
    EXPECT_EQ(model.nodes.index.at(104), 4);
    EXPECT_EQ(builder.main_node(), 3);
    EXPECT_EQ(builder.blank_node(2), 2);
    const Interface& card = model.interfaces[0];
    EXPECT_EQ(card.main_nodes, (std::vector<int>{4, 5, 6, 7, 8, 9}));
    EXPECT_EQ(model.rigid_bodies[0].nodes, card.main_nodes);
    const auto segments_of = [&](int surface) { return model.surfaces[static_cast<size_t>(surface)].segments; };
    ASSERT_EQ(segments_of(card.main_surface).size(), 2U);
    EXPECT_EQ(segments_of(card.main_surface)[0].node, (std::array<int, 4>{4, 5, 8, 7}));
    ASSERT_EQ(segments_of(card.secondary_surface).size(), 1U);
    EXPECT_EQ(segments_of(card.secondary_surface)[0].node, (std::array<int, 4>{0, 1, 2, 2}));
}

TEST(SceneBuilder, ShellsLieUnderTheirSegments) {
    Material steel;
    steel.young = 210;
    SceneBuilder builder;
    builder.blank({{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}).blank_shells({{0, 1, 2, 3}}, 0.8, steel);
    const Model& model = builder.model();
    ASSERT_EQ(model.shells.size(), 1U);
    EXPECT_EQ(model.shells[0].thickness, 0.8);
    EXPECT_EQ(model.surfaces[0].segments[0].shell, 0);
    EXPECT_EQ(model.surfaces[0].segments[0].node, model.shells[0].node);
    EXPECT_EQ(model.materials[static_cast<size_t>(model.parts[0].material)].young, 210);
}

TEST(SceneBuilder, PlansTheEffectsThatItsCardAsksFor) {
    SceneBuilder builder;
    builder.main_node({0, 0, -1}).tool(two_quads()).blank({{0.5, 0.2, 0.3}});
    EXPECT_EQ(builder.scene().effects[0], (std::vector<Effect>{Effect::elastic}));
    builder.viss(1).fric(0.2);
    EXPECT_EQ(builder.scene().effects[0], (std::vector<Effect>{Effect::elastic, Effect::damping, Effect::friction}));
}

TEST(SceneBuilder, ALoadRisesAndADriveIsConstant) {
    SceneBuilder builder;
    builder.main_node({0, 0, 0}).load(0, 2, 7, 0.5).load(0, 1, 7).drive(0, 3, 4);
    builder.drive(0, 0, 3, ImposedMotion::Kind::displacement);
    const Model& model = builder.model();
    const auto of = [&](int function, double time) { return model.functions[static_cast<size_t>(function)](time); };
    EXPECT_EQ(of(model.loads[0].function, 0.25), 0.5);
    EXPECT_EQ(of(model.loads[0].function, 3), 1);
    EXPECT_EQ(of(model.loads[1].function, 0), 1);
    EXPECT_EQ(of(model.imposed_motions[0].function, 9), 1);
    EXPECT_EQ(of(model.imposed_motions[1].function, 9), 9);
    EXPECT_EQ(model.imposed_motions[0].direction, 3);
    EXPECT_EQ(model.groups[static_cast<size_t>(model.loads[1].group)].nodes, std::vector<int>{0});
}

// F = k p with k = 1000 and p = 0.5 - 0.3: both implementations step what was built.
class BuiltScene : public ::testing::TestWithParam<std::string> {};

TEST_P(BuiltScene, GivesThePenaltyForceByHand) {
    const HostScene scene = SceneBuilder().main_node({0, 0, -1}).tool(two_quads()).blank({{0.5, 0.2, 0.3}}).scene();
    PrescribedNode node(scene, contact_maker(GetParam()));
    EXPECT_NEAR(node.to({0.5, 0.2, 0.3}, Vec3::Zero(), 1).normal_force, 200, 1e-12);
    EXPECT_EQ(node.to({0.5, 0.2, 0.6}, Vec3::Zero(), 1).normal_force, 0);
}

TEST_P(BuiltScene, ASlidingToolCarriesItsEdgeAway) {
    const HostScene scene = SceneBuilder().main_node({0, 0, -1}).tool(two_quads()).blank({{0.5, 0.2, 0.3}}).scene();
    const SlidingTool tool(scene.model, Vec3::UnitX(), 0.25, 0.5);
    const auto contact = contact_maker(GetParam())(scene, 0);
    for (int cycle = 0; cycle < 5; ++cycle) {
        const Motion motion = tool.at(cycle);
        EXPECT_EQ(motion.time, 0.5 * cycle);
        EXPECT_EQ(motion.step, cycle == 0 ? 0 : 0.5);
        EXPECT_EQ(motion.tools[0].velocity, Vec3(0.5, 0, 0));
        // The tool begins at x = 0.25 cycle; the node is at x = 0.5.
        EXPECT_EQ(contact->step(motion).nodes[0].decision.kind, cycle < 3 ? Kind::contact : Kind::none) << cycle;
    }
}

INSTANTIATE_TEST_SUITE_P(By, BuiltScene, ::testing::ValuesIn(contact_choices()),
                         [](const auto& tested) { return tested.param; });

}  // namespace
}  // namespace type21
