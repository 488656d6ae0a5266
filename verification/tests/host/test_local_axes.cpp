// Drives, loads, gravity and initial velocities in local axes, against motions whose exact answer is known.
#include <cmath>

#include <gtest/gtest.h>

#include "../contact/small_scene.h"
#include "reference/contract/make_contact.h"
#include "reference/host/conditions.h"
#include "reference/host/march.h"

namespace type21::local_axes {
namespace {

using test::over_a_square;

/// 30 degrees about z.
const Vec3 x_axis(std::sqrt(0.75), 0.5, 0);
const Vec3 y_axis(-0.5, std::sqrt(0.75), 0);

Skew turned() {
    Skew skew;
    skew.id = 5;
    skew.axes.col(0) = x_axis;
    skew.axes.col(1) = y_axis;
    skew.axes.col(2) = Vec3::UnitZ();
    return skew;
}

/// Of 20 steps, each turned into the axes and back.
constexpr double rounding = 1e-13;

struct Last {
    double time = 0;
    std::vector<Vec3> displacement;
    std::vector<Vec3> velocity;
    ToolMotion tool;
};

Last run(const SceneBuilder& small) {
    Last last;
    march(
        small.scene(), [](const Scene& scene, int i) { return reference::make_contact(scene, i); },
        [&](const CycleRecord& r) {
            last = {
                r.time, *r.displacement, {r.motion->velocity.begin(), r.motion->velocity.end()}, r.motion->tools[0]};
        });
    return last;
}

/// A tool and a node far from each other; the skew is there, nothing uses it yet.
SceneBuilder apart() {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.model().skews = {turned()};
    small.model().engine.end_time = 0.0205;
    return small;
}

TEST(LocalAxes, AVelocityAlongAnAxisOfASkew) {
    for (const auto kind : {ImposedMotion::Kind::velocity, ImposedMotion::Kind::displacement}) {
        SceneBuilder small = apart();
        small.hold(0);
        const int node = small.blank_node(0);
        small.fix(node, {false, true, true, false, false, false});
        small.model().boundary_conditions.back().skew = 0;
        small.drive(node, 0, 3.0, kind);
        small.model().imposed_motions.back().skew = 0;
        const Last last = run(small);
        EXPECT_LT((last.displacement[static_cast<size_t>(node)] - 3.0 * last.time * x_axis).norm(), rounding);
    }
}

// One direction fixed: the load's part along it is held, the rest accelerates.
TEST(LocalAxes, ABoundaryConditionHoldsOneDirectionOfASkew) {
    SceneBuilder small = apart();
    small.hold(0);
    const int node = small.blank_node(0);
    small.fix(node, {true, false, true, false, false, false});
    small.model().boundary_conditions.back().skew = 0;
    small.load(node, 0, 4.0);
    const Last last = run(small);
    const double along = 4.0 * y_axis.x();
    EXPECT_LT((last.displacement[static_cast<size_t>(node)] - 0.5 * along * last.time * last.time * y_axis).norm(),
              1e-15);
}

// A condition in global axes goes with one in a skew where they share the direction.
TEST(LocalAxes, DirectionsOfTwoSetsOfAxesMustBeTheSame) {
    SceneBuilder small = apart();
    small.hold(0);
    const int node = small.blank_node(0);
    small.fix(node, {true, false, false, false, false, false});
    small.model().boundary_conditions.back().skew = 0;
    small.fix(node, {false, false, true, false, false, false});  // z is the same in both
    Problems problems;
    check_runnable(small.scene(), problems);
    EXPECT_FALSE(problems.has_errors());
    small.load(node, 2, 4.0);
    EXPECT_EQ(run(small).displacement[static_cast<size_t>(node)], Vec3(0, 0, 0));
    small.fix(node, {false, true, false, false, false, false});  // y is none of the axes
    small.model().boundary_conditions.back().id = 77;
    check_runnable(small.scene(), problems);
    ASSERT_EQ(problems.error_count(), 1);
    EXPECT_EQ(problems.list().back().card, "/BCS/77");
    EXPECT_EQ(problems.list().back().field, "skew_ID");
}

// All three directions are the same in any axes.
TEST(LocalAxes, AllThreeFixedGoWithAnySkew) {
    SceneBuilder small = apart();
    small.hold(0);
    const int node = small.blank_node(0);
    small.hold(node);
    small.drive(node, 1, 2.0);
    small.model().imposed_motions.back().skew = 0;
    Problems problems;
    check_runnable(small.scene(), problems);
    EXPECT_FALSE(problems.has_errors());
    const Last last = run(small);
    EXPECT_LT((last.displacement[static_cast<size_t>(node)] - 2.0 * last.time * y_axis).norm(), rounding);
}

TEST(LocalAxes, AToolTurnsAboutAnAxisOfASkew) {
    SceneBuilder small = apart();
    small.hold(small.blank_node(0));
    small.fix(0, {true, true, true, false, true, true});
    small.model().boundary_conditions.back().skew = 0;
    small.drive(0, 3, 10.0);
    small.model().imposed_motions.back().skew = 0;
    const Last last = run(small);
    const Mat3 exact = Eigen::AngleAxisd(10.0 * last.time, x_axis).toRotationMatrix();
    EXPECT_LT((last.tool.rotation - exact).norm(), 1e-13);
}

TEST(LocalAxes, ALoadInASkew) {
    SceneBuilder small = apart();
    small.hold(0);
    const int node = small.blank_node(0);
    small.load(node, 1, 4.0);
    small.model().loads.back().skew = 0;
    const Last last = run(small);
    EXPECT_LT((last.displacement[static_cast<size_t>(node)] - 2.0 * last.time * last.time * y_axis).norm(), 1e-15);
}

TEST(Drives, AnAccelerationGivesAParabola) {
    SceneBuilder small = apart();
    small.hold(small.blank_node(0));
    small.fix(0, {true, true, false, true, true, true});
    small.drive(0, 2, 6.0, ImposedMotion::Kind::acceleration);
    Model& model = small.model();
    model.functions[static_cast<size_t>(model.imposed_motions.back().function)] = {1, "", {0}, {1}};
    model.imposed_motions.back().scale_y = 6.0;
    const Last last = run(small);
    EXPECT_NEAR(last.displacement[0].z(), 3.0 * last.time * last.time, 1e-14);
}

// A body falls as a whole when its main node is in the group; a node of the blank with its own mass.
TEST(Gravity, TheFallDoesNotDependOnTheMass) {
    SceneBuilder small = apart();
    Model& model = small.model();
    Gravity gravity;
    gravity.direction = 0;
    gravity.skew = 0;
    gravity.scale_y = -9810;
    model.gravities = {gravity};
    const Last last = run(small);
    const Vec3 fall = -0.5 * 9810 * last.time * last.time * x_axis;
    EXPECT_LT((last.displacement[static_cast<size_t>(small.blank_node(0))] - fall).norm(), 1e-12);
    EXPECT_LT((last.tool.position - fall).norm(), 1e-12);
    EXPECT_LT((last.tool.rotation - Mat3::Identity()).norm(), 1e-15) << "at the centre of mass: no torque";
}

TEST(Gravity, ActsOnItsGroupByItsFunctionWhileItsSensorIsOn) {
    SceneBuilder small = apart();
    small.hold(0);
    Model& model = small.model();
    const int node = small.blank_node(0);
    small.load(node, 0, 0.0);  // for its group
    Gravity gravity;
    gravity.direction = 2;
    gravity.group = model.loads.back().group;
    gravity.function = static_cast<int>(model.functions.size());
    gravity.scale_y = 2.0;
    model.functions.push_back({9, "", {0, 1}, {3, 3}});
    Sensor late;
    late.delay = 0.0105;
    model.sensors = {late};
    model.sensor_order = {0};
    gravity.sensor = 0;
    model.gravities = {gravity};
    const Last last = run(small);
    // On from cycle 11 on: v at n - 1/2 of cycle 20 is that of 9 cycles.
    EXPECT_NEAR(last.velocity[static_cast<size_t>(node)].z(), 6.0 * 9e-3, 1e-15);
    EXPECT_EQ(last.displacement[0], Vec3(0, 0, 0));
}

TEST(InitialVelocities, ATurningToolThatNothingDrives) {
    SceneBuilder small = apart();
    small.hold(small.blank_node(0));
    Model& model = small.model();
    InitialVelocity initial;
    initial.kind = InitialVelocity::Kind::axis;
    initial.velocity = {0, 0, 2};
    initial.angular_velocity = {0, 0, 4};
    initial.origin = {0, -1, 0};
    small.load(0, 0, 0.0);  // for its group
    initial.group = model.loads.back().group;
    model.initial_velocities = {initial};
    const Last last = run(small);
    EXPECT_LT((last.tool.velocity - Vec3(-4, 0, 2)).norm(), 1e-15);
    EXPECT_LT((last.tool.angular_velocity - Vec3(0, 0, 4)).norm(), 1e-13);
    EXPECT_NEAR(std::atan2(last.tool.rotation(1, 0), last.tool.rotation(0, 0)), 4 * last.time, 1e-13);
}

}  // namespace
}  // namespace type21::local_axes
