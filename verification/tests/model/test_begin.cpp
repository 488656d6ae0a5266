#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/deck/deck.h"
#include "reference/model/model.h"
#include "reference/model/resolve.h"

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

/// The driven scene with these input and work units in place of Mg mm s.
std::string with_units(const std::vector<std::string>& input, const std::vector<std::string>& work) {
    const std::string both = reals({"Mg", "mm", "s"}) + reals({"Mg", "mm", "s"});
    return replaced(driven_scene(), both, reals(input) + reals(work));
}

TEST(Begin, BlankUnitsInBothLinesLeaveTheNumbersAsTheyAre) {
    const Resolved named = resolved(driven_scene());
    for (const std::string& lines : {reals({"", "", ""}) + reals({"", "", ""}), std::string("\n\n")}) {
        const Resolved r =
            resolved(replaced(driven_scene(), reals({"Mg", "mm", "s"}) + reals({"Mg", "mm", "s"}), lines));
        EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
        EXPECT_EQ(r.model.nodes.position[1].x(), named.model.nodes.position[1].x());
        EXPECT_EQ(r.model.materials[0].young, named.model.materials[0].young);
        EXPECT_FALSE(r.model.units.named);
        EXPECT_EQ(r.model.units.name(dim::density), "M/L^3") << "letters stand for the units";
    }
}

TEST(Begin, AUnitThatIsBlankInOneLineIsThatOfTheOther) {
    for (const auto& [input, work] :
         {std::pair<std::vector<std::string>, std::vector<std::string>>{{"Mg", "mm", "s"}, {"", "", ""}},
          {{"", "", ""}, {"Mg", "mm", "s"}},
          {{"Mg", "", "s"}, {"Mg", "mm", ""}}}) {
        const Resolved r = resolved(with_units(input, work));
        EXPECT_FALSE(r.problems.has_errors()) << all_of(r.problems);
        EXPECT_NE(find_rule(r.problems, "nothing is converted"), nullptr);
        EXPECT_EQ(r.model.nodes.position[1].x(), 10);
        EXPECT_EQ(r.model.units.length_name, "mm");
        EXPECT_EQ(r.model.input_units.time_name, "s");
    }
}

TEST(Begin, AUnitThatIsBlankInBothLinesBesideOthersIsAnError) {
    const Resolved r = resolved(with_units({"Mg", "", "s"}, {"Mg", "", "s"}));
    EXPECT_EQ(r.problems.error_count(), 2) << all_of(r.problems);
    EXPECT_EQ(r.problems.list()[0].field, "length unit (input)");
}

TEST(Begin, UnitIdsNeedUnitsToConvertTo) {
    const std::string blank = with_units({"", "", ""}, {"", "", ""});
    const std::string unit = replaced(blank, "/END\n", "/UNIT/5\nSI\n" + reals({"kg", "m", "s"}) + "/END\n");
    EXPECT_TRUE(resolved(unit).problems.list().empty()) << "nobody uses it";
    const Problem p = only(resolved(replaced(unit, "/NODE\n", "/NODE/5\n")).problems);
    EXPECT_EQ(p.field, "unit_ID");
    EXPECT_NE(p.rule.find("names no units"), std::string::npos);
}

TEST(Begin, UnitsOfAnIncludedBeginCountForNothingAndOtherOnesAreSaid) {
    const TempFolder folder;
    const auto problems_with = [&](const std::vector<std::string>& units) {
        folder.write("set.inc", "/BEGIN\nset\n" + ints({"2025", "0"}) + reals(units) + reals(units) +
                                    "/GRNOD/NODE/9\nmain\n" + ints({"201"}) + "/END\n");
        Problems problems;
        const Deck deck = read_deck(
            folder.write("x_0000.rad", replaced(driven_scene(), "/END\n", "#include set.inc\n/END\n")), problems);
        const Model model = resolve(deck, AsBuilt(), problems);
        EXPECT_EQ(model.units.length_name, "mm");
        return problems;
    };
    EXPECT_EQ(find_rule(problems_with({"Mg", "mm", "s"}), "/BEGIN"), nullptr);
    EXPECT_EQ(find_rule(problems_with({"Mg", "mm", "s"}), "that of an included file"), nullptr);
    EXPECT_NE(find_rule(problems_with({"kg", "m", "s"}), "that of an included file"), nullptr);
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
    const Resolved r = resolved(with_cards("/UNIT/5\nms\n" + reals({"Mg", "m", "ms"}) + "/IMPDISP/2/5\nd\n" +
                                           ints({"1", "X", "", "", "3"}) + "\n"));
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
