#include <cmath>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/model/model.h"

namespace type21 {
namespace {

using namespace test;

const std::string plastic = "/MAT/LAW2/9\nsteel\n" + reals({"7.8e-9"});

TEST(Materials, LawsAndTheirNumbers) {
    const Resolved r = resolved(driven_scene());
    ASSERT_EQ(r.model.materials.size(), 2U);
    const Material& elastic = r.model.materials[0];
    EXPECT_EQ(elastic.law, MaterialLaw::elastic);
    EXPECT_EQ(elastic.title, "sheet");
    EXPECT_EQ(elastic.density, 7.8e-9);
    EXPECT_EQ(elastic.young, 210000);
    EXPECT_EQ(elastic.poisson, 0.3);
    const Material& tool = r.model.materials[1];
    EXPECT_EQ(tool.law, MaterialLaw::none);
    EXPECT_EQ(tool.density, 7.8e-9);
    EXPECT_EQ(tool.young, 210000);
}

TEST(Materials, JohnsonCookWithItsLimits) {
    const Resolved r = resolved(
        with_cards(plastic + reals({"210000", "0.3", "0"}) + reals({"200", "450", "0.35", "0", "900"}) + "\n\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const auto& p = r.model.materials.at(1).plastic;  // the laws follow one another: 1, 2, then void
    EXPECT_EQ(p, (std::array<double, 5>{200, 450, 0.35, 1e30, 900}));
}

TEST(Materials, JohnsonCookFromATensileTest) {
    const Resolved r = resolved(with_cards(plastic + fmt::format("{:>20}{:>20}{:>10}\n", "210000", "0.3", "1") +
                                           reals({"200", "400", "0.2"}) + "\n\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const auto& p = r.model.materials.at(1).plastic;
    const double strain = std::log(1.2);
    EXPECT_NEAR(p[0] + p[1] * std::pow(strain, p[2]), 400 * 1.2, 1e-9);      // passes through the point
    EXPECT_NEAR(p[2] * p[1] * std::pow(strain, p[2] - 1), 400 * 1.2, 1e-9);  // and necks there
    EXPECT_EQ(only(resolved(with_cards(plastic + fmt::format("{:>20}{:>20}{:>10}\n", "210000", "0.3", "1") +
                                       reals({"200", "100", "0.2"}) + "\n\n"))
                       .problems)
                  .field,
              "UTS");
}

TEST(Materials, ValuesOutOfRange) {
    const auto field = [](const char* from, const char* to) {
        return only(resolved(replaced(driven_scene(), from, to)).problems).field;
    };
    EXPECT_EQ(field("/MAT/ELAST/1\nsheet\n             7.8e-09", "/MAT/ELAST/1\nsheet\n                 0.0"), "rho");
    EXPECT_EQ(field("            210000.0                 0.3\n/MAT/VOID",
                    "                 0.0                 0.3\n/MAT/VOID"),
              "E");
    EXPECT_EQ(field("            210000.0                 0.3\n/MAT/VOID",
                    "            210000.0                 0.5\n/MAT/VOID"),
              "nu");
    EXPECT_EQ(field("            210000.0                 0.3\n/MAT/VOID",
                    "            210000.0                -1.1\n/MAT/VOID"),
              "nu");
}

TEST(Materials, TheLineOfAVoidMaterialMayBeBlank) {
    const Resolved r = resolved(
        replaced(driven_scene(), "tool\n             7.8e-09            210000.0                 0.3\n", "tool\n\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.materials.at(1).density, 0);
}

TEST(Materials, AMessageHasValueAndUnit) {
    const Problem p = only(resolved(replaced(driven_scene(), "/MAT/ELAST/1\nsheet\n             7.8e-09",
                                             "/MAT/ELAST/1\nsheet\n            -7.8e-09"))
                               .problems);
    EXPECT_EQ(p.value, "-7.8e-09 Mg/mm^3");
    EXPECT_EQ(p.card, "/MAT/ELAST/1");
}

TEST(Properties, ShellAndVoid) {
    const Model m = resolved(driven_scene()).model;
    ASSERT_EQ(m.properties.size(), 2U);
    EXPECT_EQ(m.properties[0].thickness, 1.5);
    EXPECT_EQ(m.properties[0].integration_points, 5);
    EXPECT_EQ(m.properties[0].thickness_change, 1);
    EXPECT_EQ(m.properties[1].kind, PropertyKind::none);
    EXPECT_EQ(m.properties[1].thickness, 1.0);
    std::string text = replaced(driven_scene(), "/PROP/SHELL/1", "/PROP/TYPE1/1");
    text = replaced(text, "/PROP/VOID/2", "/prop/type0/2");
    EXPECT_EQ(resolved(text).model.properties[1].thickness, 1.0);
}

TEST(Parts, ContactThickness) {
    const Resolved r = resolved(replaced(driven_scene(), "/PART/1\nsheet\n         1         1\n",
                                         "/PART/1\nsheet\n         1         1         0                 2.0\n"));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.parts[0].contact_thickness, 2.0);
    EXPECT_EQ(r.model.parts[0].property, 0);
    EXPECT_EQ(r.model.parts[1].material, 1);
}

TEST(Parts, UnknownPropertyOrMaterial) {
    const Resolved r = resolved(with_cards("/PART/9\nx\n" + ints({"77", "88"})));
    ASSERT_EQ(r.problems.list().size(), 2U) << all_of(r.problems);
    EXPECT_EQ(r.problems.list()[0].field, "prop_ID");
    EXPECT_EQ(r.problems.list()[0].value, "77");
    EXPECT_EQ(r.problems.list()[1].field, "mat_ID");
    EXPECT_GT(r.problems.list()[1].place.line, 0);
}

TEST(Parts, AnIdStandsOnceAndBothLinesAreNamed) {
    const Problem p = only(resolved(with_cards("/PART/1\nx\n" + ints({"1", "1"}))).problems);
    EXPECT_EQ(p.value, "1");
    EXPECT_NE(p.rule.find("_0000.rad:"), std::string::npos) << p.rule;
    EXPECT_GT(p.place.line, 40);
}

TEST(Parts, AnIdIsAPositiveInteger) {
    for (const char* id : {"/PART", "/PART/x", "/PART/0", "/PART/-3"}) {
        EXPECT_EQ(only(resolved(with_cards(std::string(id) + "\nx\n" + ints({"1", "1"}))).problems).field, "id") << id;
    }
}

}  // namespace
}  // namespace type21
