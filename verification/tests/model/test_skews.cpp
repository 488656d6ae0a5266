// Local axes: /SKEW/FIX and /FRAME/FIX, and the cards that use them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

std::string vector(const char* x, const char* y, const char* z) {
    return reals({x, y, z});
}

/// Turned by 30 degrees about z: Y' = (-0.5, c, 0). Z' leans, so that it must be put upright.
const std::string turned = "/SKEW/FIX/5\nturned\n" + vector("1.0", "2.0", "3.0") +
                           vector("-0.5", "0.8660254037844386", "0.0") + vector("-1.0", "1.7320508075688772", "7.0");
const double c30 = 0.8660254037844386;

TEST(Skew, IsAnOrthonormalTriadThatKeepsItsYAxis) {
    const Resolved r = resolved(with_cards(turned));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.skews.size(), 1U);
    const Skew& skew = r.model.skews[0];
    EXPECT_EQ(skew.id, 5);
    EXPECT_EQ(skew.origin, Vec3(1, 2, 3));
    Mat3 expected;
    expected << c30, -0.5, 0, 0.5, c30, 0, 0, 0, 1;
    EXPECT_LT((skew.axes - expected).norm(), 1e-15);
}

TEST(Skew, LengthsAreInTheUnitsOfTheCard) {
    const std::string unit = "/UNIT/3\nSI\n" + reals({"kg", "m", "s"});
    const Resolved r = resolved(with_cards(unit + "/FRAME/FIX/5/3\nf\n" + vector("1.0", "2.0", "3.0") +
                                           vector("0.0", "9.0", "0.0") + vector("0.0", "0.0", "0.1")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.skews.at(0).origin, Vec3(1000, 2000, 3000));
    EXPECT_LT((r.model.skews[0].axes - Mat3::Identity()).norm(), 1e-15);
}

TEST(Skew, AxesThatSpanNoPlaneAreErrors) {
    for (const auto& z : {vector("0.0", "2.0", "0.0"), vector("0.0", "0.0", "0.0")}) {
        const std::string skew = "/SKEW/FIX/5\ns\n" + vector("0.0", "0.0", "0.0") + vector("0.0", "1.0", "0.0") + z;
        EXPECT_TRUE(resolved(with_cards(skew)).problems.list().empty()) << "nothing uses it";
        const Problem p = only(resolved(with_cards(skew + "/BCS/9\nb\n   111 000" + ints({"5", "1"}))).problems);
        EXPECT_EQ(p.card, "/BCS/9");
        EXPECT_EQ(p.field, "skew_ID");
        EXPECT_NE(p.rule.find("0 or parallel"), std::string::npos) << p.rule;
    }
}

TEST(Skew, ConditionsLoadsAndVelocitiesUseIt) {
    const Resolved r = resolved(with_cards(
        turned + "/FRAME/FIX/6\nf\n" + vector("1.0", "0.0", "0.0") + vector("0.0", "0.0", "1.0") +
        vector("1.0", "0.0", "0.0") + "/BCS/9\nb\n   100 000" + ints({"5", "1"}) + "/IMPVEL/9\nv\n" +
        ints({"1", "X", "5", "", "3"}) + "\n/IMPDISP/8\nd\n" + ints({"1", "Y", "", "", "3", "6"}) + "\n/CLOAD/9\nf\n" +
        ints({"1", "Z", "5", "", "3"}) + "/IMPACC/7\na\n" + ints({"1", "ZZ", "5", "", "3"}) + reals({"", "2.0"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.boundary_conditions.back().skew, 0);
    EXPECT_EQ(r.model.imposed_motions.at(1).skew, 0);
    EXPECT_EQ(r.model.imposed_motions.at(2).skew, 1) << "the frame";
    EXPECT_EQ(r.model.loads.at(0).skew, 0);
    const ImposedMotion& acceleration = r.model.imposed_motions.at(3);
    EXPECT_EQ(acceleration.kind, ImposedMotion::Kind::acceleration);
    EXPECT_EQ(acceleration.skew, 0);
    EXPECT_EQ(acceleration.scale_y, 2);
    EXPECT_EQ(r.model.boundary_conditions.front().skew, -1) << "0 is global";
}

TEST(Skew, InitialVelocitiesAreTurnedIntoGlobalAxes) {
    const std::string frame = "/FRAME/FIX/6\nf\n" + vector("1.0", "0.0", "0.0") + vector("0.0", "0.0", "1.0") +
                              vector("1.0", "0.0", "0.0");  // X' = y, Y' = z, Z' = x
    const Resolved r = resolved(
        with_cards(turned + frame + "/INIVEL/TRA/9\nt\n" +
                   fmt::format("{:>20}{:>20}{:>20}{:>10}{:>10}\n", "2.0", "0.0", "3.0", 1, 5) + "\n/INIVEL/ROT/8\nr\n" +
                   fmt::format("{:>20}{:>20}{:>20}{:>10}{:>10}\n", "0.0", "4.0", "0.0", 3, 5) +
                   "\n/INIVEL/AXIS/7\na\n" + ints({"X", "6", "3"}) + reals({"1.0", "2.0", "3.0", "5.0"}) + "\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.initial_velocities.size(), 3U);
    EXPECT_LT((r.model.initial_velocities[0].velocity - Vec3(2 * c30, 1, 3)).norm(), 1e-15);
    EXPECT_EQ(r.model.initial_velocities[1].kind, InitialVelocity::Kind::rotation);
    EXPECT_LT((r.model.initial_velocities[1].angular_velocity - Vec3(-2, 4 * c30, 0)).norm(), 1e-15);
    const InitialVelocity& axis = r.model.initial_velocities[2];
    EXPECT_EQ(axis.origin, Vec3(1, 0, 0));
    EXPECT_LT((axis.velocity - Vec3(3, 1, 2)).norm(), 1e-15);
    EXPECT_LT((axis.angular_velocity - Vec3(0, 5, 0)).norm(), 1e-15);
}

TEST(Skew, TheInertiaOfABodyIsInIt) {
    const std::string body =
        "/NODE\n       301                 0.0                 0.0                50.0\n"
        "/GRNOD/NODE/31\na\n       301\n/RBODY/9\nbody\n" +
        fmt::format("{:>10}{:>10}{:>10}{:>10}{:>20}{:>10}{:>10}{:>10}\n", 301, 0, 5, 0, "8.0", 31, 0, 4) +
        reals({"10.0", "20.0", "30.0"}) + "\n\n";
    const Resolved r = resolved(with_cards(turned + body));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const Mat3& inertia = r.model.rigid_bodies.at(1).inertia;
    // R diag(10, 20, 30) R^T, 30 degrees about z
    EXPECT_NEAR(inertia(0, 0), 10 * 0.75 + 20 * 0.25, 1e-13);
    EXPECT_NEAR(inertia(0, 1), (10 - 20) * 0.5 * c30, 1e-13);
    EXPECT_NEAR(inertia(2, 2), 30, 1e-13);
}

// Axes that move are harmless until a card refers to them; then they are refused by name.
TEST(Skew, MovingAxesAreRefusedWhereACardUsesThem) {
    const std::string moving = "/SKEW/MOV/5\nm\n" + ints({"1", "2", "3"}) + "/FRAME/MOV/6\nm\n" +
                               ints({"1", "2", "3"}) + "/FRAME/NOD/7\nn\n" + ints({"1"});
    EXPECT_TRUE(resolved(with_cards(moving)).problems.list().empty());
    const Problem skew = only(resolved(with_cards(moving + "/BCS/9\nb\n   111 000" + ints({"5", "1"}))).problems);
    EXPECT_EQ(skew.field, "skew_ID");
    EXPECT_NE(skew.rule.find("/SKEW/MOV"), std::string::npos) << skew.rule;
    EXPECT_NE(skew.remedy.find("/SKEW/FIX"), std::string::npos) << skew.remedy;
    const Problem frame =
        only(resolved(with_cards(moving + "/IMPVEL/9\nv\n" + ints({"1", "X", "", "", "3", "7"}) + "\n")).problems);
    EXPECT_EQ(frame.field, "frame_ID");
    EXPECT_NE(frame.rule.find("/FRAME/NOD"), std::string::npos) << frame.rule;
    EXPECT_EQ(only(resolved(with_cards("/CLOAD/9\nf\n" + ints({"1", "Z", "44", "", "3"}))).problems).field, "skew_ID");
}

TEST(Gravity, AllItsFields) {
    const std::string unit = "/UNIT/3\nSI\n" + reals({"kg", "m", "s"});
    const Resolved r = resolved(with_cards(
        unit + turned + "/SENSOR/TIME/4\ns\n" + reals({"1e-4"}) + "/GRAV/2/3\ng\n" +
        fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>20}{:>20}\n", 1, "Z", 5, 4, 3, "", "2.0", "-9.81") +
        "/GRAV/1\ng\n" +
        fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>20}{:>20}\n", "", "X", "", "", "", "", "", "")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.gravities.size(), 2U);
    const Gravity& g = r.model.gravities[0];
    EXPECT_EQ(g.function, 0);
    EXPECT_EQ(g.direction, 2);
    EXPECT_EQ(g.skew, 0);
    EXPECT_EQ(g.sensor, 0);
    EXPECT_EQ(r.model.groups[static_cast<size_t>(g.group)].id, 3);
    EXPECT_EQ(g.scale_x, 2);
    EXPECT_DOUBLE_EQ(g.scale_y, -9810) << "mm/s^2";
    EXPECT_EQ(r.model.gravities[1].function, -1) << "constant";
    EXPECT_EQ(r.model.gravities[1].group, -1) << "all nodes";
    EXPECT_EQ(r.model.gravities[1].scale_y, 1);
    EXPECT_EQ(only(resolved(with_cards("/GRAV/1\ng\n" + ints({"1", "XX"}))).problems).field, "Dir");
}

/// Nodes 301 (2 Mg, x = 0) and 302 (6 Mg, x = 4) in a body without a main node.
std::string without_main_node(const std::string& icog) {
    return "/NODE\n       301                 0.0                 0.0                50.0\n"
           "       302                 4.0                 0.0                50.0\n"
           "/GRNOD/NODE/31\na\n       301\n/GRNOD/NODE/32\nb\n       302\n/GRNOD/NODE/33\nall\n       302       301\n"
           "/ADMAS/0/31\na\n" +
           fmt::format("{:>20}{:>10}\n", "2.0", 31) + "/ADMAS/0/32\nb\n" + fmt::format("{:>20}{:>10}\n", "6.0", 32) +
           "/RBODY/9\nbody\n" +
           fmt::format("{:>10}{:>10}{:>10}{:>10}{:>20}{:>10}{:>10}{:>10}\n", "", 0, 0, 0, "8.0", 33, 0, icog) +
           reals({"10.0", "20.0", "30.0"}) + "\n\n";
}

TEST(RigidBodyWithoutMainNode, GetsOneAtTheCentreOfMass) {
    for (const char* icog : {"0", "2", "3"}) {
        const Resolved r = resolved(with_cards(without_main_node(icog)));
        EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
        const RigidBody& body = r.model.rigid_bodies.at(1);
        ASSERT_EQ(body.main_node, r.model.nodes.size() - 1) << "behind all nodes of the deck";
        EXPECT_EQ(r.model.nodes.id.back(), 303);
        EXPECT_EQ(r.model.nodes.index.at(303), body.main_node);
        EXPECT_EQ(r.model.nodal_mass.size(), r.model.nodes.id.size());
        EXPECT_EQ(body.center, Vec3(3, 0, 50));
        EXPECT_EQ(body.nodes.size(), 2U);
        EXPECT_EQ(body.mass, 16);
        EXPECT_NEAR(body.inertia(2, 2), 30 + 2 * 9 + 6 * 1, 1e-12);
    }
}

TEST(RigidBodyWithoutMainNode, WhatActsOnAllItsNodesActsOnIt) {
    const std::string velocity =
        "/INIVEL/TRA/5\nv\n" + fmt::format("{:>20}{:>20}{:>20}{:>10}{:>10}\n", "2.0", "0.0", "3.0", 33, "") + "\n" +
        "/INIVEL/TRA/6\nv\n" + fmt::format("{:>20}{:>20}{:>20}{:>10}{:>10}\n", "9.0", "0.0", "3.0", 31, "") + "\n";
    const Resolved r = resolved(with_cards(without_main_node("0") + velocity));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.initial_velocities.size(), 3U) << "31 is a part of the body only";
    const InitialVelocity& copy = r.model.initial_velocities[2];
    EXPECT_EQ(copy.velocity, Vec3(2, 0, 3));
    EXPECT_EQ(r.model.groups[static_cast<size_t>(copy.group)].nodes,
              std::vector<int>{r.model.rigid_bodies.at(1).main_node});
}

TEST(RigidBodyWithoutMainNode, NeedsNodesWithMass) {
    std::string text = without_main_node("0");
    text = replaced(text, fmt::format("{:>20}{:>10}\n", "2.0", 31), fmt::format("{:>20}{:>10}\n", "0.0", 31));
    text = replaced(text, fmt::format("{:>20}{:>10}\n", "6.0", 32), fmt::format("{:>20}{:>10}\n", "0.0", 32));
    const Problem p = only(resolved(with_cards(text)).problems);
    EXPECT_EQ(p.field, "node_ID");
    EXPECT_NE(p.rule.find("have no mass"), std::string::npos);
}

}  // namespace
}  // namespace type21
