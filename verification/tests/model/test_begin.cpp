#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/model/model.h"

namespace type21 {
namespace {

using namespace test;

TEST(Begin, TheDrivenSceneHasNoProblem) {
    const Resolved r = resolved(driven_scene());
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.run_name, "scene");
    EXPECT_EQ(r.model.title, "a driven tool");
    EXPECT_EQ(r.model.version, 2025);
    EXPECT_EQ(r.model.units.mass_name, "Mg");
    EXPECT_EQ(r.model.units.length, 1e-3);
}

TEST(Begin, KnownVersions) {
    for (const char* version : {"120", "130", "140", "2017", "2018", "2024", "2026"}) {
        const Resolved r = resolved(replaced(driven_scene(), "      2025", fmt::format("{:>10}", version)));
        EXPECT_FALSE(r.problems.has_errors()) << version << all_of(r.problems);
        EXPECT_EQ(r.model.version, std::stoi(version));
    }
}

TEST(Begin, OtherVersionsAreErrors) {
    for (const char* version : {"44", "51", "100", "110", "125", "2016", "2027", "0"}) {
        const Resolved r = resolved(replaced(driven_scene(), "      2025", fmt::format("{:>10}", version)));
        const Problem p = only(r.problems);
        EXPECT_EQ(p.field, "Invers");
        EXPECT_EQ(p.value, version);
        EXPECT_EQ(p.place.line, 4);
    }
}

TEST(Begin, AWordThatIsNoUnit) {
    const Resolved r = resolved(replaced(driven_scene(), "                  Mg", "               stone"));
    const Problem p = only(r.problems);
    EXPECT_EQ(p.field, "mass unit (input)");
    EXPECT_EQ(p.value, "stone");
}

TEST(Begin, MissingOrTwice) {
    EXPECT_NE(find_rule(resolved(replaced(driven_scene(), "/BEGIN", "/TITLE")).problems, "has a /BEGIN"), nullptr);
    EXPECT_NE(only(resolved(with_cards("/BEGIN\nagain\n")).problems).rule.find("one /BEGIN"), std::string::npos);
}

TEST(Begin, NumbersTurnIntoWorkUnits) {
    // The input units are the first of the two lines.
    const Resolved r = resolved(replaced(driven_scene(), reals({"Mg", "mm", "s"}), reals({"kg", "m", "ms"})));
    EXPECT_FALSE(r.problems.has_errors()) << all_of(r.problems);
    const Model& m = r.model;
    EXPECT_DOUBLE_EQ(m.nodes.position[1].x(), 10e3);
    EXPECT_DOUBLE_EQ(m.materials[0].density, 7.8e-9 * 1e-3 / 1e9);
    EXPECT_DOUBLE_EQ(m.materials[0].young, 210000.0 * 1e-3 / 1e3 * 1e6);
    EXPECT_DOUBLE_EQ(m.properties[0].thickness, 1500);
    EXPECT_DOUBLE_EQ(m.imposed_motions[0].scale_y, -1000.0 * 1e3 * 1e3);
    EXPECT_DOUBLE_EQ(m.imposed_motions[0].scale_x, 1e-3);
    EXPECT_DOUBLE_EQ(m.rigid_bodies[0].mass, 0.02e-3);
    EXPECT_DOUBLE_EQ(m.rigid_bodies[0].inertia(1, 1), 1000.0 * 1e-3 * 1e6);
}

TEST(Unit, ACardMayNameItsOwnUnits) {
    const std::string unit = "/UNIT/5\nSI\n" + reals({"kg", "m", "s"});
    const Resolved r = resolved(replaced(with_cards(unit), "/PART/1\n", "/PART/1/5\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const std::string node = replaced(with_cards(unit), "/NODE\n", "/NODE/5\n");
    EXPECT_DOUBLE_EQ(resolved(node).model.nodes.position[1].x(), 10e3);
    const std::string added = with_cards(unit + "/ADMAS/0/1/5\nballast\n" + reals({"3.0"}).substr(0, 20) + ints({"3"}));
    EXPECT_DOUBLE_EQ(resolved(added).model.added_masses.at(0).mass, 3e-3);
}

TEST(Unit, AScaleLeftBlankIsOneInTheUnitsOfTheCard) {
    const Resolved r = resolved(
        with_cards("/UNIT/5\nms\n" + reals({"Mg", "m", "ms"}) + "/IMPDISP/2/5\nd\n" + ints({"1", "X", "", "", "3"}) + "\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.imposed_motions.size(), 2U);
    EXPECT_DOUBLE_EQ(r.model.imposed_motions[1].scale_x, 1e-3);
    EXPECT_DOUBLE_EQ(r.model.imposed_motions[1].scale_y, 1e3);
}

TEST(Unit, AnUnknownUnitIdIsAnError) {
    const Problem p = only(resolved(replaced(driven_scene(), "/NODE\n", "/NODE/9\n")).problems);
    EXPECT_EQ(p.field, "unit_ID");
    EXPECT_EQ(p.value, "9");
}

}  // namespace
}  // namespace type21
