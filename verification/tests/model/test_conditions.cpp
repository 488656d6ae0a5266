#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

TEST(Conditions, BoundaryCodes) {
    const Resolved r = resolved(with_cards("/BCS/9\nb\n   101 010" + ints({"0", "1"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.boundary_conditions.size(), 3U);
    EXPECT_EQ(r.model.boundary_conditions[2].fixed, (std::array<bool, 6>{true, false, true, false, true, false}));
    EXPECT_EQ(r.model.boundary_conditions[2].group, 1) << "groups stand in the order of their kinds: NODE, PART";
}

TEST(Conditions, BoundaryCodesOutOfPlaceAreErrors) {
    EXPECT_EQ(only(resolved(with_cards("/BCS/9\nb\n   121 000" + ints({"0", "1"}))).problems).field, "Tra rot");
    EXPECT_EQ(only(resolved(with_cards("/BCS/9\nb\n 1 111 000" + ints({"0", "1"}))).problems).field, "Tra rot");
    EXPECT_EQ(only(resolved(with_cards("/BCS/9\nb\n   111 000" + ints({"4", "1"}))).problems).field, "skew_ID");
    EXPECT_EQ(only(resolved(with_cards("/BCS/9\nb\n   111 000" + ints({"0", "0"}))).problems).field, "grnod_ID");
}

TEST(Conditions, ImposedVelocityWithAllItsFields) {
    const std::string sensor = "/SENSOR/TIME/4\ns\n" + reals({"1e-4"});
    const Resolved r = resolved(with_cards(sensor + "/IMPVEL/9\nturn\n" + ints({"1", "YY", "0", "4", "3", "0", "0"}) +
                                           reals({"2.0", "-3.0", "0.1", "0.2"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const ImposedMotion& m = r.model.imposed_motions.at(1);
    EXPECT_EQ(m.kind, ImposedMotion::Kind::velocity);
    EXPECT_EQ(m.function, 0);
    EXPECT_EQ(m.direction, 4);
    EXPECT_EQ(m.sensor, 0);
    EXPECT_EQ(m.scale_x, 2);
    EXPECT_EQ(m.scale_y, -3);
    EXPECT_EQ(m.start, 0.1);
    EXPECT_EQ(m.stop, 0.2);
}

TEST(Conditions, BlankScalesAreOneAndABlankStopIsNever) {
    const Resolved r = resolved(with_cards("/IMPDISP/9\nd\n" + ints({"1", "X", "", "", "3"}) + "\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const ImposedMotion& m = r.model.imposed_motions.at(1);
    EXPECT_EQ(m.kind, ImposedMotion::Kind::displacement);
    EXPECT_EQ(m.scale_x, 1);
    EXPECT_EQ(m.scale_y, 1);
    EXPECT_EQ(m.stop, 1e30);
    EXPECT_EQ(m.sensor, -1);
}

TEST(Conditions, FieldsThatAreNotSupportedAreErrors) {
    const auto field = [](const std::vector<std::string>& line) {
        return only(resolved(with_cards("/IMPVEL/9\nv\n" + ints(line) + "\n")).problems).field;
    };
    EXPECT_EQ(field({"1", "X", "5", "", "3"}), "skew_ID");
    EXPECT_EQ(field({"1", "X", "", "", "3", "5"}), "frame_ID");
    EXPECT_EQ(field({"1", "X", "", "", "3", "", "1"}), "Icoor");
    EXPECT_EQ(field({"1", "W", "", "", "3"}), "Dir");
    EXPECT_EQ(field({"66", "X", "", "", "3"}), "fct_IDT");
    EXPECT_EQ(field({"1", "X", "", "66", "3"}), "sens_ID");
    EXPECT_EQ(field({"1", "X", "", "", "66"}), "grnod_ID");
}

TEST(Loads, InitialVelocity) {
    const Resolved r =
        resolved(with_cards("/INIVEL/TRA/9\nthrow\n                 1.0                 2.0                 3.0" +
                            ints({"1", "0"}) + "                 0.0         0\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.initial_velocities.at(0).velocity, Vec3(1, 2, 3));
    EXPECT_EQ(r.model.groups[static_cast<size_t>(r.model.initial_velocities[0].group)].id, 1);
    const Problem p =
        only(resolved(with_cards("/INIVEL/TRA/9\nthrow\n                 1.0                 2.0                 3.0" +
                                 ints({"1", "0"}) + "                 0.1         0\n"))
                 .problems);
    EXPECT_EQ(p.field, "Tstart");
    EXPECT_EQ(only(resolved(with_cards("/INIVEL/NODE/9\nthrow\n")).problems).card, "/INIVEL/NODE");
}

TEST(Loads, ConcentratedForceAndMomentInBothForms) {
    const std::string unit = "/UNIT/5\nSI\n" + reals({"kg", "m", "s"});
    const auto card = [](const std::string& type, const char* direction) {
        return "/CLOAD/9/5\nload\n" + fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}{:>10}{:>20}{:>20}\n", 1, direction, 0,
                                                  0, 3, type, "", "2.0");
    };
    const Resolved force = resolved(with_cards(unit + card("1", "Z")));
    EXPECT_TRUE(force.problems.list().empty()) << all_of(force.problems);
    EXPECT_EQ(force.model.loads.at(0).direction, 2);
    EXPECT_DOUBLE_EQ(force.model.loads[0].scale_y, 2);
    EXPECT_DOUBLE_EQ(resolved(with_cards(unit + card("", "ZZ"))).model.loads.at(0).scale_y, 2000) << "N m in N mm";
    EXPECT_EQ(only(resolved(with_cards(unit + card("2", "Z"))).problems).field, "Itypfun");
    std::string old = with_cards(unit + card("2", "Z"));
    EXPECT_FALSE(resolved(replaced(old, "      2025", "      2021")).problems.has_errors())
        << "no such field before 2023";
}

TEST(Friction, TableWithAPair) {
    const std::string unit = "/UNIT/5\nSI\n" + reals({"kg", "m", "s"});
    const std::string head = "/FRICTION/9/5\ntable\n         1         3                50.0         2\n";
    const Resolved r = resolved(with_cards(unit + head + reals({"1.0", "2.0"}) + reals({"", "0.1"}) +
                                           ints({"0", "0", "1", "2", "", "0"}) + reals({"3.0"}) + reals({"", "0.2"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const FrictionModel& f = r.model.friction_models.at(0);
    EXPECT_EQ(f.ifric, 1);
    EXPECT_EQ(f.ifiltr, 3);
    EXPECT_EQ(f.xfreq, 50);
    EXPECT_DOUBLE_EQ(f.fallback.c[0], 1e6) << "1/Pa in 1/MPa";
    EXPECT_DOUBLE_EQ(f.fallback.c[1], 2e-3) << "s/m in s/mm";
    EXPECT_EQ(f.fallback.fric, 0.1);
    ASSERT_EQ(f.pairs.size(), 1U);
    EXPECT_EQ(f.pairs[0].part_a, 0);
    EXPECT_EQ(f.pairs[0].part_b, 1);
    EXPECT_EQ(f.pairs[0].coefficients.fric, 0.2);
    EXPECT_DOUBLE_EQ(f.pairs[0].coefficients.c[0], 3e6);
}

TEST(Friction, GroupsOfPartsAreAllTheirPairs) {
    const std::string groups = "/PART/3\nthird\n" + ints({"1", "1"}) + "/GRPART/PART/31\nblank\n" + ints({"1", "3"}) +
                               "/GRPART/GENE/32\ntool\n" + ints({"2", "2"}) + "/GRPART/SUBSET/33\nempty\n" +
                               ints({"7"}) + "/SUBSET/7\nno part\n";
    const std::string head = "/FRICTION/9\ntable\n" + ints({"0", "0"}) + reals({""}) + reals({"", "0.1"});
    const Resolved r = resolved(with_cards(groups + head + ints({"31", "32"}) + reals({""}) + reals({"", "0.2"}) +
                                           ints({"", "32", "1", ""}) + reals({""}) + reals({"", "0.3"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const std::vector<FrictionPair>& pairs = r.model.friction_models.at(0).pairs;
    ASSERT_EQ(pairs.size(), 3U);
    const auto is = [](const FrictionPair& pair, int a, int b, double fric) {
        return pair.part_a == a && pair.part_b == b && pair.coefficients.fric == fric;
    };
    EXPECT_TRUE(is(pairs[0], 0, 1, 0.2));
    EXPECT_TRUE(is(pairs[1], 2, 1, 0.2));
    EXPECT_TRUE(is(pairs[2], 0, 1, 0.3)) << "a group and a part";
    const Problem empty =
        only(resolved(with_cards(groups + head + ints({"33", "32"}) + reals({""}) + reals({"", "0.2"}))).problems);
    EXPECT_EQ(empty.field, "grpart_ID1");
    EXPECT_NE(empty.rule.find("no parts"), std::string::npos);
}

TEST(Friction, XfreqIsAFrequencyWithFilterThreeOnly) {
    const std::string unit = "/UNIT/5\nms\n" + reals({"Mg", "mm", "ms"});
    const auto xfreq = [&](const char* filter) {
        return resolved(with_cards(unit + "/FRICTION/9/5\nt\n" + ints({"0", filter, "", "0.5"})))
            .model.friction_models.at(0)
            .xfreq;
    };
    EXPECT_EQ(xfreq("1"), 0.5);
    EXPECT_EQ(xfreq("2"), 0.5);
    EXPECT_DOUBLE_EQ(xfreq("3"), 500);
}

TEST(Friction, MistakesAreNamed) {
    const auto field = [](const std::string& first, const std::string& pair) {
        return only(resolved(with_cards("/FRICTION/9\nt\n" + first + reals({""}) + reals({"", "0.1"}) + pair)).problems)
            .field;
    };
    EXPECT_EQ(field(ints({"5", "0"}), ""), "Ifric");
    EXPECT_EQ(field(ints({"0", "4"}), ""), "Ifiltr");
    EXPECT_EQ(field(ints({"0", "0"}), ints({"3", "0", "", "2"}) + "\n\n"), "grpart_ID1") << "no such group";
    EXPECT_EQ(field(ints({"0", "0"}), ints({"3", "0", "1", "2"}) + "\n\n"), "part_ID1") << "a group and a part";
    EXPECT_EQ(field(ints({"0", "0"}), ints({"0", "0", "1", ""}) + "\n\n"), "part_ID2") << "neither";
    EXPECT_EQ(field(ints({"0", "0"}), ints({"0", "0", "1", "66"}) + "\n\n"), "part_ID2");
    EXPECT_EQ(field(ints({"0", "0"}), ints({"0", "0", "1", "2", "", "1"}) + "\n\n"), "Idir");
}

}  // namespace
}  // namespace type21
