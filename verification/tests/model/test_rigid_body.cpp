#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

/// A body of nodes 301 (x = 0, 2 Mg) and 302 (x = 4, 6 Mg) with main node 303 (x = 0, y = 3, no mass), 8 Mg added, all
/// dofs free. J added: diag(10, 20, 30).
std::string body(const std::string& icog, const std::string& ispher = "0", const std::string& products = "") {
    return "/NODE\n       301                 0.0                 0.0                 0.0\n"
           "       302                 4.0                 0.0                 0.0\n"
           "       303                 0.0                 3.0                 0.0\n"
           "/GRNOD/NODE/31\na\n       301\n/GRNOD/NODE/32\nb\n       302\n/GRNOD/NODE/33\nall\n       303       302    "
           "   301\n"
           "/ADMAS/0/31\na\n" +
           fmt::format("{:>20}{:>10}\n", "2.0", 31) + "/ADMAS/0/32\nb\n" + fmt::format("{:>20}{:>10}\n", "6.0", 32) +
           fmt::format("/RBODY/9\nbody\n{:>10}{:>10}{:>10}{:>10}{:>20}{:>10}{:>10}{:>10}\n", 303, 0, 0, ispher, "8.0",
                       33, 0, icog) +
           reals({"10.0", "20.0", "30.0"}) + (products.empty() ? "\n" : products) + "\n";
}

RigidBody read(const std::string& cards) {
    const Resolved r = resolved(with_cards(cards));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.nodes.position[static_cast<size_t>(r.model.rigid_bodies.at(1).main_node)],
              r.model.rigid_bodies[1].center)
        << "the main node stands where its body has its centre";
    return r.model.rigid_bodies[1];
}

TEST(RigidBody, NodesAreThoseOfTheGroupWithoutTheMainNode) {
    const RigidBody b = read(body("4"));
    EXPECT_EQ(b.nodes.size(), 2U);
    EXPECT_EQ(b.title, "body");
}

TEST(RigidBody, IcogOneIsTheCentreOfMainAndSecondaryNodes) {
    for (const char* icog : {"0", "1"}) {
        const RigidBody b = read(body(icog));
        EXPECT_EQ(b.icog, 1);
        EXPECT_DOUBLE_EQ(b.mass, 16);
        EXPECT_TRUE(b.center.isApprox(Vec3(24.0 / 16, 24.0 / 16, 0)));
        // 2 Mg at (-1.5, -1.5), 6 Mg at (2.5, -1.5), 8 Mg at (-1.5, 1.5)
        EXPECT_NEAR(b.inertia(0, 0), 10 + 16 * 2.25, 1e-12);
        EXPECT_NEAR(b.inertia(1, 1), 20 + 10 * 2.25 + 6 * 6.25, 1e-12);
        EXPECT_NEAR(b.inertia(2, 2), 30 + 16 * 2.25 + 10 * 2.25 + 6 * 6.25, 1e-12);
        EXPECT_NEAR(b.inertia(0, 1), -(2 * 2.25 - 6 * 3.75 - 8 * 2.25), 1e-12);
    }
}

TEST(RigidBody, IcogTwoIsTheCentreOfTheSecondaryNodes) {
    const RigidBody b = read(body("2"));
    EXPECT_DOUBLE_EQ(b.mass, 16);
    EXPECT_TRUE(b.center.isApprox(Vec3(3, 0, 0)));
    EXPECT_NEAR(b.inertia(0, 0), 10, 1e-12);
    EXPECT_NEAR(b.inertia(2, 2), 30 + 2 * 9 + 6 * 1, 1e-12);
}

TEST(RigidBody, IcogThreeKeepsTheMainNodeAndCountsTheOthers) {
    const RigidBody b = read(body("3"));
    EXPECT_DOUBLE_EQ(b.mass, 16);
    EXPECT_EQ(b.center, Vec3(0, 3, 0));
    EXPECT_NEAR(b.inertia(0, 0), 10 + 8 * 9, 1e-12);
    EXPECT_NEAR(b.inertia(2, 2), 30 + 2 * 9 + 6 * 25, 1e-12);
}

TEST(RigidBody, IcogFourIgnoresTheSecondaryNodes) {
    const RigidBody b = read(body("4"));
    EXPECT_DOUBLE_EQ(b.mass, 8);
    EXPECT_EQ(b.center, Vec3(0, 3, 0));
    EXPECT_EQ(b.inertia, Mat3(Vec3(10, 20, 30).asDiagonal()));
}

TEST(RigidBody, ProductsOfInertiaAreElementsOfTheMatrix) {
    const RigidBody b = read(body("4", "0", reals({"1.0", "2.0", "3.0"})));
    EXPECT_EQ(b.inertia(0, 1), 1);
    EXPECT_EQ(b.inertia(1, 2), 2);
    EXPECT_EQ(b.inertia(0, 2), 3);
    EXPECT_EQ(b.inertia(2, 0), 3);
}

TEST(RigidBody, ASphericalBodyHasTheMeanMomentAboutEveryAxis) {
    const RigidBody b = read(body("4", "1"));
    EXPECT_TRUE(b.spherical);
    EXPECT_EQ(b.inertia, Mat3(20.0 * Mat3::Identity()));
}

TEST(RigidBody, AFreeBodyNeedsMassAndInertiaADrivenOneDoesNot) {
    const auto without_mass = [](const std::string& text) {
        return replaced(replaced(text, "                0.02         2", "                 0.0         2"),
                        reals({"1000.0", "1000.0", "1000.0"}), "\n");
    };
    EXPECT_TRUE(resolved(without_mass(driven_scene())).problems.list().empty()) << "fixed but for Z, which is driven";
    const Resolved free = resolved(without_mass(replaced(driven_scene(), "   110 111", "   100 111")));
    EXPECT_EQ(only(free.problems).field, "Mass");
    const Resolved turning = resolved(without_mass(replaced(driven_scene(), "   110 111", "   110 011")));
    EXPECT_EQ(only(turning.problems).field, "Jxx");
    const Problem inertia =
        only(resolved(replaced(with_cards(body("4")), reals({"10.0", "20.0", "30.0"}), reals({"10.0", "20.0", "0.0"})))
                 .problems);
    EXPECT_EQ(inertia.field, "Jxx");
}

TEST(RigidBody, WhatIsNotSupportedIsAnError) {
    const auto spoil = [](const char* from, const char* to) {
        return only(resolved(replaced(driven_scene(), from, to)).problems).field;
    };
    EXPECT_EQ(spoil("       201         0         0         0 ", "       201         1         0         0 "),
              "sens_ID");
    EXPECT_EQ(spoil("       201         0         0         0 ", "       201         0         1         0 "),
              "skew_ID");
    EXPECT_EQ(spoil("       201         0         0         0 ", "       201         0         0         3 "),
              "Ispher");
    EXPECT_EQ(spoil("         2         0         4\n", "         2         0         5\n"), "ICoG");
    EXPECT_EQ(spoil("         2         0         4\n", "         2         0         4         1\n"), "surf_ID");
    EXPECT_EQ(only(resolved(with_cards("/RBODY/LAGMUL/9\nx\n")).problems).card, "/RBODY/LAGMUL");
}

TEST(RigidBody, ANodeBelongsToOneBody) {
    const std::string second =
        "/GRNOD/NODE/31\nn\n         1       101\n/GRNOD/NODE/32\nm\n         5\n" +
        fmt::format("/RBODY/9\nbody\n{:>10}{:>10}{:>10}{:>10}{:>20}{:>10}{:>10}{:>10}\n", 5, 0, 0, 0, "8.0", 31, 0, 4) +
        reals({"10.0", "20.0", "30.0"}) + "\n\n";
    const Problem p = only(resolved(with_cards(second)).problems);
    EXPECT_EQ(p.value, "node 101");
    EXPECT_NE(p.rule.find("/RBODY/7"), std::string::npos);
}

}  // namespace
}  // namespace type21
