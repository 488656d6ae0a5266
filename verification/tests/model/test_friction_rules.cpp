// Lines 6 to 8: laws, filters, the function of temperature; /FRICTION has the same conditions.
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "interface_fixture.h"
#include "reference/deck/deck.h"
#include "reference/model/as_built_option.h"
#include "reference/model/friction_conditions.h"
#include "reference/model/model.h"
#include "reference/model/resolve.h"

namespace type21::test {
namespace {

constexpr auto error = Severity::error;
constexpr auto warning = Severity::warning;

const UnitSystem mg_mm_s{1e3, 1e-3, 1.0, "Mg", "mm", "s"};

/// Which of C1..C6 (1..6) are named, in order.
std::vector<size_t> faulty(const std::array<double, 6>& c) {
    std::vector<size_t> ranks;
    for (const ConditionFault& fault : renard_faults(c, mg_mm_s))
        ranks.push_back(fault.rank + 1);
    return ranks;
}

// @manual comment 13
TEST(Renard, ConditionsOfThePage) {
    using Ranks = std::vector<size_t>;
    EXPECT_EQ(faulty({0.1, 0.12, 0.2, 0.08, 800, 2500}), Ranks{}) << "that of the measured scene";
    EXPECT_EQ(faulty({0.1, 0.12, 0.2, 0.08, 0, 2500}), Ranks{5}) << "C5 > 0";
    EXPECT_EQ(faulty({0.1, 0.12, 0.2, 0.08, 2500, 2500}), Ranks{5}) << "C5 < C6";
    EXPECT_EQ(faulty({0.2, 0.12, 0.2, 0.08, 800, 2500}), Ranks{1}) << "C1 < C3";
    EXPECT_EQ(faulty({0.1, 0.2, 0.2, 0.08, 800, 2500}), Ranks{2}) << "C2 < C3";
    EXPECT_EQ(faulty({0.1, 0.12, 0.2, 0.1, 800, 2500}), Ranks{4}) << "C4 < C1";
    EXPECT_EQ(faulty({0.12, 0.1, 0.2, 0.1, 800, 2500}), Ranks{4}) << "C4 < C2";
    EXPECT_EQ(faulty({0.1, 0.12, 0.2, 0.3, 800, 2500}), (Ranks{4, 4})) << "both";
}

TEST(Renard, TheRuleShowsTheOtherNumberWithItsUnit) {
    const auto faults = renard_faults({0.1, 0.12, 0.2, 0.08, 2600, 2500}, mg_mm_s);
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].rule.find("C6 = 2500 mm/s"), std::string::npos) << faults[0].rule;
}

Problems problems_of(const Fields& fields, Model model = blank_over_tool()) {
    Problems problems;
    resolve_fields(model, fields, problems);
    return problems;
}

const Fields bad_renard{{"Ifric", "3"}, {"C1", "0.1"},   {"C2", "0.12"}, {"C3", "0.2"},
                        {"C4", "0.08"}, {"C5", "800.0"}, {"C6", "700.0"}};

// @manual field Ifric; comment 13
TEST(FrictionRules, TheCardsRenardLawIsChecked) {
    const Problems problems = problems_of(bad_renard);
    EXPECT_EQ(problems.error_count(), 1);
    const auto errors = about(problems, "C5", error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].value, "800 mm/s");
    Fields good = bad_renard;
    good["C6"] = "900.0";
    EXPECT_TRUE(problems_of(good).list().empty());
    good["Fric"] = "0.3";
    EXPECT_EQ(about(problems_of(good), "Fric", warning).size(), 1u) << "the law has no Fric";
    Fields coulomb = bad_renard;
    coulomb["Ifric"] = "0";
    EXPECT_EQ(problems_of(coulomb).error_count(), 0) << "another law has no such conditions";
}

// @manual departure D17
TEST(FrictionRules, D17DoesNotCheck) {
    Model model = blank_over_tool();
    model.as_built.set(Departure::D17);
    EXPECT_TRUE(problems_of(bad_renard, model).list().empty());
}

TEST(FrictionRules, LawsTakeTheirNumbersFromTheCard) {
    Model model = blank_over_tool();
    Problems problems;
    const Interface it =
        resolve_fields(model, {{"Ifric", "2"}, {"Fric", "0.1"}, {"C1", "0.5"}, {"C6", "-0.25"}}, problems);
    EXPECT_TRUE(problems.list().empty());
    EXPECT_EQ(it.ifric, 2);
    EXPECT_EQ(it.fric, 0.1);
    EXPECT_EQ(it.c[0], 0.5);
    EXPECT_EQ(it.c[5], -0.25);
}

// @manual field Xfreq; comment 15; departure D07
TEST(FrictionRules, XfreqOfEachFilter) {
    const auto errors = [](const std::string& ifiltr, const std::string& xfreq, bool d07 = false) {
        Model model = blank_over_tool();
        model.as_built.set(Departure::D07, d07);
        const Problems problems = problems_of({{"Fric", "0.1"}, {"Ifiltr", ifiltr}, {"Xfreq", xfreq}}, model);
        EXPECT_EQ(problems.error_count(), static_cast<int>(about(problems, "Xfreq", error).size()));
        return problems.error_count();
    };
    EXPECT_EQ(errors("1", "1.0"), 0);
    EXPECT_EQ(errors("1", "1.1"), 1);
    EXPECT_EQ(errors("2", "0.5"), 0);
    EXPECT_EQ(errors("2", "1.1"), 1);
    EXPECT_EQ(errors("3", "5000.0"), 0) << "a cutting frequency";
    // D07: a period of at least 2 pi = 6.2832 steps; as measured with 0.5 (refused) and 7 (taken).
    EXPECT_EQ(errors("2", "0.5", true), 1);
    EXPECT_EQ(errors("2", "6.28", true), 1);
    EXPECT_EQ(errors("2", "6.29", true), 0);
    EXPECT_EQ(errors("1", "1.1", true), 1) << "only Ifiltr 2";
    EXPECT_EQ(errors("2", "0.0", true), 0) << "no filter";
}

// @manual departure D28
TEST(FrictionRules, XfreqThatFrictionModelReplacesIsNotJudgedButForD28) {
    Model model = blank_over_tool();
    model.friction_models.push_back({});
    model.friction_models[0].id = 9;
    const Fields fields{{"fric_ID", "9"}, {"Ifiltr", "1"}, {"Xfreq", "3.0"}};
    const Problems documented = problems_of(fields, model);
    EXPECT_EQ(documented.error_count(), 0);
    EXPECT_EQ(about(documented, "Xfreq", warning).size(), 1u);
    EXPECT_EQ(about(documented, "Ifiltr", warning).size(), 1u);
    model.as_built.set(Departure::D28);
    const Problems built = problems_of(fields, model);
    EXPECT_EQ(about(built, "Xfreq", error).size(), 1u);
    EXPECT_EQ(about(built, "Ifiltr", warning).size(), 0u) << "D28 filters with it";
}

// ---- fct_IDF

// @manual field fct_IDF, AscaleF; comment 12
TEST(FrictionFunction, IsLinkedAndItsScaleIsOne) {
    Model model = thermal_blank_over_tool();
    Problems problems;
    const Interface it =
        resolve_fields(model, {{"Ithe", "1"}, {"Kthe", "2.0"}, {"Tint", "9.0"}, {"fct_IDF", "4"}}, problems);
    EXPECT_TRUE(problems.list().empty()) << to_text(problems.list().front());
    EXPECT_EQ(it.function_friction, 1);
    EXPECT_EQ(it.fric, 1.0) << "Fric becomes the scale of the function: 0 means 1 (manual page, comment 12)";
    EXPECT_EQ(it.fric.origin.kind, Origin::Kind::fallback);
    EXPECT_EQ(it.ascalef, 1.0);
    model.interfaces.clear();
    EXPECT_EQ(resolve_fields(model, {{"Ithe", "1"}, {"fct_IDF", "4"}, {"Fric", "0.3"}}, problems).fric, 0.3);
}

TEST(FrictionFunction, NeedsTemperaturesAndAFunction) {
    const auto without = about(problems_of({{"fct_IDF", "4"}}, thermal_blank_over_tool()), "fct_IDF", error);
    ASSERT_EQ(without.size(), 1u);
    EXPECT_NE(without[0].rule.find("temperatures"), std::string::npos);
    const auto unknown = about(
        problems_of({{"Ithe", "1"}, {"Kthe", "2.0"}, {"Tint", "9.0"}, {"fct_IDF", "13"}}, thermal_blank_over_tool()),
        "fct_IDF", error);
    ASSERT_EQ(unknown.size(), 1u);
    EXPECT_NE(unknown[0].rule.find("no /FUNCT"), std::string::npos);
}

TEST(FrictionFunction, OfAnotherLawIsIdle) {
    Model model = thermal_blank_over_tool();
    Problems problems;
    const Interface it = resolve_fields(model, {{"Ifric", "1"}, {"fct_IDF", "4"}}, problems);
    EXPECT_EQ(problems.error_count(), 0) << "so it needs no temperatures";
    EXPECT_EQ(about(problems, "fct_IDF", warning).size(), 1u);
    EXPECT_EQ(it.fct_idf, 0);
    EXPECT_EQ(it.function_friction, -1);
    EXPECT_EQ(it.fric, 0.0) << "no scale either";
}

// ---- /FRICTION

Problems of_card(const std::string& first, const std::string& coefficients, const std::string& pair = "",
                 const std::string& as_built = "") {
    const TempFolder folder;
    folder.write("scene_0001.rad", driven_engine());
    Problems problems;
    const AsBuilt set = parse_as_built(as_built, problems);
    const Deck deck = read_deck(
        folder.write("scene_0000.rad", with_cards("/FRICTION/9\nt\n" + first + coefficients + pair)), problems);
    problems = {};
    resolve(deck, set, problems);
    return problems;
}

const std::string renard = "         3         0                 0.0\n";
const std::string good = reals({"0.1", "0.12", "0.2", "0.08", "800.0"}) + reals({"2500.0", "0.0"});
const std::string bad = reals({"0.1", "0.12", "0.2", "0.08", "800.0"}) + reals({"700.0", "0.0"});

TEST(FrictionCard, RenardOfTheDefaultAndOfEachPair) {
    EXPECT_TRUE(of_card(renard, good).list().empty());
    const Problem p = only(of_card(renard, bad));
    EXPECT_EQ(p.field, "C5");
    EXPECT_EQ(p.value, "800 mm/s");
    const std::string head = ints({"0", "0", "1", "2"});
    EXPECT_TRUE(of_card(renard, good, head + good).list().empty());
    const Problem of_pair = only(of_card(renard, good, head + bad));
    EXPECT_EQ(of_pair.field, "C5");
    EXPECT_EQ(of_pair.place.line, p.place.line + 3);
    EXPECT_TRUE(of_card(renard, bad, "", "D17").list().empty());
}

TEST(FrictionCard, XfreqOfEachFilter) {
    const auto field = [](const std::string& ifiltr, const std::string& xfreq, const std::string& as_built = "") {
        const Problems problems = of_card("         0" + ints({ifiltr}).substr(0, 10) + reals({xfreq}),
                                          reals({""}) + reals({"", "0.1"}), "", as_built);
        return problems.list().empty() ? "" : only(problems).field;
    };
    EXPECT_EQ(field("1", "0.3"), "");
    EXPECT_EQ(field("1", "1.3"), "Xfreq");
    EXPECT_EQ(field("2", "20.0"), "Xfreq");
    EXPECT_EQ(field("2", "20.0", "D07"), "");
    EXPECT_EQ(field("2", "0.5", "D07"), "Xfreq");
    EXPECT_EQ(field("3", "5000.0"), "");
    EXPECT_EQ(field("3", "-1.0"), "Xfreq");
}

}  // namespace
}  // namespace type21::test
