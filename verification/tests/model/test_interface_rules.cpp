// Ranges, fields that exclude each other, fields without effect.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/model.h"

namespace type21::test {
namespace {

constexpr auto error = Severity::error;
constexpr auto warning = Severity::warning;

Problems problems_of(const Fields& fields, Model model = blank_over_tool()) {
    Problems problems;
    resolve_fields(model, fields, problems);
    return problems;
}

struct Wrong {
    const char* name;
    Fields fields;
    const char* field;  ///< that the message names
    const char* words;  ///< in its rule
};

class WrongField : public testing::TestWithParam<Wrong> {};

TEST_P(WrongField, IsOneErrorThatNamesFieldValueAndRule) {
    const Wrong& wrong = GetParam();
    const Problems problems = problems_of(wrong.fields);
    const auto errors = about(problems, wrong.field, error);
    ASSERT_EQ(errors.size(), 1u) << wrong.name;
    EXPECT_EQ(problems.error_count(), 1) << wrong.name;
    EXPECT_NE(errors[0].rule.find(wrong.words), std::string::npos) << errors[0].rule;
    EXPECT_FALSE(errors[0].remedy.empty());
    EXPECT_FALSE(errors[0].value.empty());
    EXPECT_EQ(errors[0].card, "/INTER/TYPE21/1");
    EXPECT_GT(errors[0].place.line, 8);
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongField,
    testing::Values(
        Wrong{"no_secondary", {{"surf_IDs", "0"}}, "surf_IDs", "must be given"},
        Wrong{"unknown_secondary", {{"surf_IDs", "77"}}, "surf_IDs", "no surface 77"},
        Wrong{"no_main", {{"surf_IDm", "0"}}, "surf_IDm", "must be given"},
        Wrong{"unknown_main", {{"surf_IDm", "78"}}, "surf_IDm", "no surface 78"},
        Wrong{"istf_2", {{"Istf", "2"}}, "Istf", "one of 0, 1"},
        Wrong{"istf_negative", {{"Istf", "-1"}}, "Istf", "one of 0, 1"},
        Wrong{"igap_3", {{"Igap", "3"}}, "Igap", "one of 0, 1, 2"},
        Wrong{"igap_huge", {{"Igap", "9999999999"}}, "Igap", "one of 0, 1, 2"},
        Wrong{"idel_3", {{"Idel", "3"}}, "Idel", "one of -2, -1, 0, 1, 2"},
        Wrong{"idel_negative", {{"Idel", "-3"}}, "Idel", "one of -2, -1, 0, 1, 2"},
        Wrong{"invn_2", {{"Invn", "2"}}, "Invn", "one of 0, 1"},
        Wrong{"iadm_3", {{"Iadm", "3"}}, "Iadm", "one of 0, 1, 2"},
        Wrong{"nradm", {{"Iadm", "2"}, {"Angladm", "30.0"}, {"NRadm", "-1"}}, "NRadm", "negative"},
        Wrong{"padm", {{"Iadm", "2"}, {"Angladm", "30.0"}, {"Padm", "-1.0"}}, "Padm", "negative"},
        Wrong{"angladm", {{"Iadm", "2"}, {"Angladm", "181.0"}}, "Angladm", "between 0 and 180"},
        Wrong{"angladm_negative", {{"Iadm", "2"}, {"Angladm", "-1.0"}}, "Angladm", "between 0 and 180"},
        Wrong{"fscalegap", {{"Igap", "1"}, {"Fscalegap", "-1.0"}}, "Fscalegap", "negative"},
        Wrong{"gapmax", {{"Igap", "1"}, {"Gapmax", "-1.0"}}, "Gapmax", "negative"},
        Wrong{"depth", {{"DEPTH", "-1.0"}}, "DEPTH", "negative"}, Wrong{"pmax", {{"Pmax", "-1.0"}}, "Pmax", "negative"},
        Wrong{"itlim_2", {{"ITlim", "2"}}, "ITlim", "one of 0, 1"},
        Wrong{"stmin", {{"Stmin", "-1.0"}}, "Stmin", "negative"},
        Wrong{"stmax", {{"Stmax", "-1.0"}}, "Stmax", "negative"},
        Wrong{"pskid", {{"Pskid", "-1.0"}}, "Pskid", "negative"},
        Wrong{"bounds_crossed", {{"Stmin", "3.0"}, {"Stmax", "2.0"}}, "Stmin", "larger than Stmax 2 N/mm"},
        Wrong{"stfac", {{"Stfac", "-1.0"}}, "Stfac", "negative"}, Wrong{"fric", {{"Fric", "-0.1"}}, "Fric", "negative"},
        Wrong{"gapmin", {{"Gapmin", "-0.1"}}, "Gapmin", "negative"},
        Wrong{"tstart", {{"Tstart", "-0.1"}}, "Tstart", "negative"},
        Wrong{"tstop", {{"Tstop", "-0.1"}}, "Tstop", "negative"},
        Wrong{"inacti_2", {{"Inacti", "2"}}, "Inacti", "do not exist"},
        Wrong{"inacti_4", {{"Inacti", "4"}}, "Inacti", "do not exist"},
        Wrong{"inacti_7", {{"Inacti", "7"}}, "Inacti", "one of 0, 1, 3, 5, 6"},
        Wrong{"viss", {{"VISs", "-0.1"}}, "VISs", "negative"},
        Wrong{"bumult", {{"Bumult", "-0.1"}}, "Bumult", "negative"},
        Wrong{"ifric_5", {{"Ifric", "5"}}, "Ifric", "one of 0, 1, 2, 3, 4"},
        Wrong{"xfreq_1", {{"Fric", "0.1"}, {"Ifiltr", "1"}, {"Xfreq", "1.01"}}, "Xfreq", "between 0 and 1"},
        Wrong{"xfreq_2", {{"Fric", "0.1"}, {"Ifiltr", "2"}, {"Xfreq", "20.0"}}, "Xfreq", "between 0 and 1"},
        Wrong{"xfreq_3", {{"Fric", "0.1"}, {"Ifiltr", "3"}, {"Xfreq", "-1.0"}}, "Xfreq", "negative"},
        Wrong{"ifiltr_4", {{"Ifiltr", "4"}}, "Ifiltr", "one of 0, 1, 2, 3"},
        Wrong{"xfreq", {{"Ifiltr", "0"}, {"Xfreq", "-0.5"}}, "Xfreq", "negative"},
        Wrong{"sensor", {{"sens_ID", "6"}}, "sens_ID", "no /SENSOR with"},
        Wrong{"fric_id", {{"fric_ID", "8"}}, "fric_ID", "no /FRICTION"},
        Wrong{"no_rbody", {{"IDrby", "0"}}, "IDrby", "must be given"},
        Wrong{"unknown_rbody", {{"IDrby", "6"}}, "IDrby", "no /RBODY"},
        Wrong{"unknown_ref", {{"IDref", "9"}, {"Damp", "0.1"}}, "IDref", "no /INTER/TYPE21"},
        Wrong{"ref_itself", {{"IDref", "1"}, {"Damp", "0.1"}}, "IDref", "its own reference"},
        Wrong{"damp", {{"Damp", "-0.1"}}, "Damp", "negative"}, Wrong{"dampr", {{"Dampr", "-0.1"}}, "Dampr", "negative"},
        Wrong{"not_a_number", {{"Fric", "0,1"}}, "Fric", "not a number"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

class IdleField : public testing::TestWithParam<Wrong> {};

TEST_P(IdleField, IsAWarning) {
    const Wrong& idle = GetParam();
    const Problems problems = problems_of(idle.fields);
    EXPECT_EQ(problems.error_count(), 0) << to_text(problems.list().front());
    const auto warnings = about(problems, idle.field, warning);
    ASSERT_EQ(warnings.size(), 1u) << idle.name;
    EXPECT_NE(warnings[0].rule.find(idle.words), std::string::npos) << warnings[0].rule;
}

INSTANTIATE_TEST_SUITE_P(
    All, IdleField,
    testing::Values(Wrong{"idel_negative", {{"Idel", "-1"}}, "Idel", "acts as 1"},
                    Wrong{"iadm", {{"Iadm", "1"}}, "Iadm", "no element is divided"},
                    Wrong{"angladm_0", {{"Iadm", "2"}}, "Angladm", "every bend"},
                    Wrong{"fscalegap", {{"Fscalegap", "2.0"}}, "Fscalegap", "Igap 0 is Gapmin"},
                    Wrong{"gapmax", {{"Gapmax", "2.0"}}, "Gapmax", "Igap 0 is Gapmin"},
                    Wrong{"pmax_igap0", {{"Pmax", "2.0"}}, "Pmax", "only with Igap 2"},
                    Wrong{"pmax_igap1", {{"Igap", "1"}, {"Pmax", "2.0"}}, "Pmax", "only with Igap 2"},
                    Wrong{"itlim", {{"ITlim", "1"}}, "ITlim", "only with Igap 2"},
                    Wrong{"itlim_igap2", {{"Igap", "2"}, {"ITlim", "1"}}, "ITlim", "Pmax is 0"},
                    Wrong{"pskid", {{"Pskid", "9.0"}}, "Pskid", "no friction"},
                    Wrong{"ifiltr", {{"Ifiltr", "1"}, {"Xfreq", "0.5"}}, "Ifiltr", "no friction"},
                    Wrong{"c6_law_1", {{"Ifric", "1"}, {"C6", "0.5"}}, "C6", "law 1 does not use it"},
                    Wrong{"c3_law_4", {{"Ifric", "4"}, {"C3", "0.5"}}, "C3", "law 4 does not use it"},
                    Wrong{"fct_idf_law_1", {{"Ifric", "1"}, {"fct_IDF", "13"}}, "fct_IDF", "Ifric 0 only"},
                    Wrong{"fct_idk", {{"fct_IDK", "13"}}, "fct_IDK", "Ithe is 0"},
                    Wrong{"fcond", {{"Fcond", "13"}}, "Fcond", "Ithe is 0"},
                    Wrong{"gapmin_above_gapmax",
                          {{"Igap", "1"}, {"Gapmin", "2.0"}, {"Gapmax", "1.0"}},
                          "Gapmin",
                          "larger than Gapmax 1 mm"},
                    Wrong{"stmin_istf1", {{"Istf", "1"}, {"Stfac", "9.0"}, {"Stmin", "1.0"}}, "Stmin", "Istf 0 only"},
                    Wrong{"stmax_istf1", {{"Istf", "1"}, {"Stfac", "9.0"}, {"Stmax", "1.0"}}, "Stmax", "Istf 0 only"},
                    Wrong{"no_stiffness", {{"Istf", "1"}}, "Stfac", "no stiffness"},
                    Wrong{"never_active", {{"Tstart", "2.0"}, {"Tstop", "1.0"}}, "Tstop", "never acts"},
                    Wrong{"xfreq", {{"Xfreq", "0.5"}}, "Xfreq", "Ifiltr is 0"},
                    Wrong{"ascalef", {{"AscaleF", "2.0"}}, "AscaleF", "fct_IDF is 0"},
                    Wrong{"c1", {{"C1", "0.1"}}, "C1", "Ifric is 0"}, Wrong{"c6", {{"C6", "0.1"}}, "C6", "Ifric is 0"},
                    Wrong{"nradm", {{"NRadm", "4"}}, "NRadm", "Iadm 2 only"},
                    Wrong{"padm", {{"Padm", "2.0"}}, "Padm", "Iadm 2 only"},
                    Wrong{"angladm", {{"Angladm", "2.0"}}, "Angladm", "Iadm 2 only"},
                    Wrong{"kthe", {{"Kthe", "2.0"}}, "Kthe", "Ithe is 0"},
                    Wrong{"ascalek", {{"AscaleK", "2.0"}}, "AscaleK", "Ithe is 0"},
                    Wrong{"tint", {{"Tint", "300.0"}}, "Tint", "Ithe is 0"},
                    Wrong{"ithe_form", {{"Ithe_form", "1"}}, "Ithe_form", "Ithe is 0"},
                    Wrong{"frad", {{"Frad", "1.0"}}, "Frad", "Ithe is 0"},
                    Wrong{"drad", {{"Drad", "9.0"}}, "Drad", "Ithe is 0"},
                    Wrong{"fheat", {{"Fheat", "0.5"}}, "Fheat", "Ithe is 0"},
                    Wrong{"dcond", {{"Dcond", "2.0"}}, "Dcond", "Ithe is 0"},
                    Wrong{"depth", {{"DEPTH", "11.0"}}, "DEPTH", "shortest secondary edge 10 mm"}),
    [](const auto& parameter) { return std::string(parameter.param.name); });

TEST(InterfaceRules, ACleanCardHasNoProblem) {
    EXPECT_TRUE(problems_of({}).list().empty());
    EXPECT_TRUE(
        problems_of({{"Igap", "1"}, {"Fric", "0.1"}, {"Istf", "1"}, {"Stfac", "5.0"}, {"Damp", "0.1"}}).list().empty());
    EXPECT_TRUE(
        problems_of(
            {{"Igap", "2"}, {"Pmax", "600.0"}, {"ITlim", "1"}, {"Fric", "0.1"}, {"Pskid", "50.0"}, {"Idel", "2"}})
            .list()
            .empty());
}

TEST(InterfaceRules, AllMistakesAreReportedAtOnce) {
    const Problems problems = problems_of(
        {{"Istf", "7"}, {"Igap", "3"}, {"Fric", "-1.0"}, {"Inacti", "2"}, {"IDrby", "66"}, {"VISs", "-1.0"}});
    EXPECT_EQ(problems.error_count(), 6);
}

TEST(InterfaceRules, ValuesAreShownWithTheirUnit) {
    EXPECT_EQ(about(problems_of({{"DEPTH", "-2.5"}}), "DEPTH", error)[0].value, "-2.5 mm");
    EXPECT_EQ(about(problems_of({{"Tstop", "-1.0"}}), "Tstop", error)[0].value, "-1 s");
}

TEST(InterfaceRules, ASurfaceWithoutSegmentsIsAnError) {
    Model model = blank_over_tool();
    model.surfaces[1].segments.clear();
    const auto errors = about(problems_of({}, model), "surf_IDm", error);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_NE(errors[0].rule.find("no segments"), std::string::npos);
}

// @manual field IDref
TEST(InterfaceRules, IdrefNamesAnInterfaceReadLater) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, card_text({{"IDref", "2"}, {"Damp", "0.1"}}) + card_text({}, "/INTER/TYPE21/2"), problems);
    ASSERT_EQ(model.interfaces.size(), 2u);
    EXPECT_EQ(problems.error_count(), 0);
    EXPECT_EQ(model.interfaces[0].reference_interface, 1);
    EXPECT_EQ(model.interfaces[1].reference_interface, -1);
}

TEST(InterfaceRules, IdrefWithoutDampingIsAWarning) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, card_text({{"IDref", "2"}}) + card_text({}, "/INTER/TYPE21/2"), problems);
    EXPECT_EQ(about(problems, "IDref", warning).size(), 1u);
}

}  // namespace
}  // namespace type21::test
