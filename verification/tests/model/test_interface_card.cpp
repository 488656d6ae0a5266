// The twelve lines: columns, versions, units, line count.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/field_table.h"
#include "reference/model/resolve_interfaces.h"

namespace type21::test {
namespace {

constexpr auto error = Severity::error;
constexpr auto warning = Severity::warning;

// Every field with a number of its own, typed here by column and not by the table that the reader uses.
const std::string full_card =
    "/INTER/TYPE21/7\n"
    "all fields\n"
    //        1|       20|       30|       40|       50|       60|       70|       80|       90|      100|
    "         1         2         1         0         1                             2         1         2\n"
    "                1.25                 8.0                 3.5               150.0         1\n"
    "                10.0                20.0                                    30.0\n"
    "              1000.0                0.12                 0.2              1.0e-3              2.0e-3\n"
    "       101                             5                 0.7                                    0.25\n"
    "         0         3                 0.0                   4         0                 2.0         0\n"
    "                0.01                0.02                0.03                0.04                0.05\n"
    "                0.06\n"
    "         4                 0.9                25.0\n"
    "                 1.5         0                 2.5               300.0         1\n"
    "                 0.3                 4.5                 0.6                   0                 5.5\n"
    "         5         0                 0.4                 0.8\n";

TEST(InterfaceCard, EveryFieldIsReadFromItsColumns) {
    Model model = blank_over_tool();
    model.sensors.push_back({4, ""});
    model.as_built.set(Departure::D09);  // so that Tstart and Tstop stay as read
    Problems problems;
    const Interface it = resolve_card(model, full_card, problems);
    for (const Problem& problem : problems.list())
        EXPECT_NE(problem.severity, error) << to_text(problem);
    EXPECT_EQ(it.id, 7);
    EXPECT_EQ(it.title, "all fields");
    EXPECT_EQ(it.surf_secondary, 1);
    EXPECT_EQ(it.surf_main, 2);
    EXPECT_EQ(it.istf, 1);
    EXPECT_EQ(it.ithe, 0);
    EXPECT_EQ(it.igap, 1);
    EXPECT_EQ(it.idel, 2);
    EXPECT_EQ(it.invn, 1);
    EXPECT_EQ(it.iadm, 2);
    EXPECT_EQ(it.fscalegap, 1.25);
    EXPECT_EQ(it.gapmax, 8.0);
    EXPECT_EQ(it.depth, 3.5);
    EXPECT_EQ(it.pmax, 1e30) << "150 in the deck, but used with Igap 2 only";
    EXPECT_EQ(it.itlim, 1);
    EXPECT_EQ(it.stmin, 0.0) << "10 in the deck, but used with Istf 0 only";
    EXPECT_EQ(it.stmax, 1e30);
    EXPECT_EQ(it.pskid, 30.0);
    EXPECT_EQ(it.stfac, 1000.0);
    EXPECT_EQ(it.fric, 0.12);
    EXPECT_EQ(it.gapmin, 0.2);
    EXPECT_EQ(it.tstart, 1e-3);
    EXPECT_EQ(it.tstop, 2e-3);
    EXPECT_EQ(it.ibc, 5) << "digits 101: 4 x + 2 y + z";
    EXPECT_EQ(it.inacti, 5);
    EXPECT_EQ(it.viss, 0.7);
    EXPECT_EQ(it.bumult, 0.25);
    EXPECT_EQ(it.ifric, 0);
    EXPECT_EQ(it.ifiltr, 0) << "3 in the deck, no filter since Xfreq is 0";
    EXPECT_EQ(it.sens_id, 4);
    EXPECT_EQ(it.ascalef, 2.0);
    for (size_t i = 0; i < 6; ++i)
        EXPECT_EQ(it.c[i], 0.01 * (static_cast<double>(i) + 1)) << "C" << i + 1;
    EXPECT_EQ(it.nradm, 4);
    EXPECT_EQ(it.padm, 0.9);
    EXPECT_EQ(it.angladm, 25.0);
    EXPECT_EQ(it.idrby, 5);
    EXPECT_EQ(it.idref, 0);
    EXPECT_EQ(it.damp, 0.4);
    EXPECT_EQ(it.dampr, 0.8);
    EXPECT_EQ(it.secondary_surface, 0);
    EXPECT_EQ(it.main_surface, 1);
    EXPECT_EQ(it.tool, 0);
}

TEST(InterfaceCard, FieldsBeginInTheirFirstColumn) {
    // The same numbers at the left end of their fields: a field that began too late would lose its first digit.
    const std::string left_justified =
        "/INTER/TYPE21/7\nleft\n"
        "1         2         1         1         1                             2         1         2\n"
        "1.25                8.0                 3.5                 150.0               1\n"
        "10.0                20.0                                    30.0\n"
        "1000.0              0.12                0.2                 1.0e-3              2.0e-3\n"
        "       111                    5         0.7                                     0.25\n"
        "0         3         0.0                           4         0         2.0                 0\n"
        "0.01                0.02                0.03                0.04                0.05\n"
        "0.06\n"
        "4         0.9                 25.0\n"
        "1.5                 0         2.5                 300.0               1\n"
        "0.3                 4.5                 0.6                           0         5.5\n"
        "5         0         0.4                 0.8\n";
    std::string right_justified = full_card;
    right_justified.replace(right_justified.find("         1         2         1         0"), 40,
                            "         1         2         1         1");
    right_justified.replace(right_justified.find("       101"), 10, "       111");
    const auto values = [](const std::string& text) {
        Model model = thermal_blank_over_tool();
        model.sensors.push_back({4, ""});
        Problems problems;
        const Interface it = resolve_card(model, text, problems);
        EXPECT_EQ(problems.error_count(), 0);
        for (const Problem& problem : problems.list())
            EXPECT_EQ(problem.field.find("columns"), std::string::npos) << to_text(problem);
        std::map<std::string, std::string> of_field;
        for (const FieldRow& row : field_table(it, model.units))
            of_field[row.name] = row.value;
        return of_field;
    };
    EXPECT_EQ(values(left_justified), values(right_justified));
}

TEST(InterfaceCard, HeatFieldsAreReadFromTheirColumns) {
    Model model = thermal_blank_over_tool();
    model.sensors.push_back({4, ""});
    Problems problems;
    std::string text = full_card;
    text.replace(text.find("         1         2         1         0"), 40, "         1         2         1         1");
    text = text.replace(text.find("                   0                 5.5"), 40,
                        "                   4                 3.5");
    const Interface it = resolve_card(model, text, problems);
    EXPECT_EQ(problems.error_count(), 0);
    EXPECT_EQ(it.ithe, 1);
    EXPECT_EQ(it.kthe, 1.5);
    EXPECT_EQ(it.ascalek, 2.5);
    EXPECT_EQ(it.tint, 300.0);
    EXPECT_EQ(it.ithe_form, 1);
    EXPECT_EQ(it.frad, 0.3);
    EXPECT_EQ(it.drad, 4.5);
    EXPECT_EQ(it.fheat, 0.6);
    EXPECT_EQ(it.fcond, 4);
    EXPECT_EQ(it.dcond, 3.5);
}

TEST(InterfaceCard, OriginsNameTheLineOfTheDeck) {
    // deck_of puts the keyword in line 7, the title in 8: card line n is line 8 + n.
    Model model = blank_over_tool();
    Problems problems;
    const Interface it = resolve_fields(model, {{"Fric", "0.1"}}, problems);
    EXPECT_EQ(it.line, 7);
    EXPECT_EQ(it.fric.origin.kind, Origin::Kind::deck);
    EXPECT_EQ(it.fric.origin.line, 12);
    EXPECT_EQ(it.idrby.origin.line, 20);
    EXPECT_EQ(it.istf.origin.kind, Origin::Kind::fallback);
    EXPECT_EQ(it.viss.origin.kind, Origin::Kind::fallback);
}

TEST(InterfaceCard, FewerLinesAreAnErrorThatCountsThem) {
    Model model = blank_over_tool();
    Problems problems;
    std::string text = card_text({});
    text.erase(text.rfind('\n', text.size() - 2) + 1);  // without line 12
    resolve_card(model, text, problems);
    ASSERT_EQ(problems.error_count(), 1) << "no second word about fields of a shifted card";
    EXPECT_NE(problems.list()[0].value.find("11 data lines"), std::string::npos);
    EXPECT_NE(problems.list()[0].remedy.find("blank lines"), std::string::npos);
}

TEST(InterfaceCard, NoLineAtAllIsAnError) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, "/INTER/TYPE21/1\n", problems);
    ASSERT_EQ(problems.error_count(), 1);
    EXPECT_NE(problems.list()[0].value.find("0 data lines"), std::string::npos);
}

TEST(InterfaceCard, AThirteenthLineIsAnErrorThatNamesIt) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, card_text({}) + "        99\n", problems);
    ASSERT_EQ(problems.error_count(), 1);
    EXPECT_EQ(problems.list()[0].value, "99");
    EXPECT_EQ(problems.list()[0].place.line, 21);
}

TEST(InterfaceCard, BlankLinesBehindTheTwelveAreNoProblem) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, card_text({}) + "\n\n", problems);
    EXPECT_EQ(problems.list().size(), 0u);
}

TEST(InterfaceCard, NumbersBesideTheFieldsAreNamed) {
    Model model = blank_over_tool();
    Problems problems;
    std::string text = card_text({});
    const size_t line_3 = text.find('\n', text.find("contact of the test")) + 1 + 2 * 101;
    text.replace(line_3 + 45, 3, "0.5");  // columns 46 to 48 of line 3
    resolve_card(model, text, problems);
    ASSERT_EQ(about(problems, "columns 41 to 60", warning).size(), 1u);
    EXPECT_EQ(about(problems, "columns 41 to 60", warning)[0].value, "0.5");
    EXPECT_EQ(about(problems, "columns 41 to 60", warning)[0].place.line, 11);
}

TEST(InterfaceCard, IbcTakesThreeDigits) {
    const auto code = [](const std::string& text) {
        Model model = blank_over_tool();
        Problems problems;
        const Interface it = resolve_fields(model, {{"IBC", text}}, problems);
        EXPECT_EQ(problems.error_count(), 0);
        return it.ibc.value;
    };
    EXPECT_EQ(code("100"), 4);
    EXPECT_EQ(code("010"), 2);
    EXPECT_EQ(code("001"), 1);
    EXPECT_EQ(code("11"), 3);
    EXPECT_EQ(code("111"), 7);
    Model model = blank_over_tool();
    Problems problems;
    EXPECT_EQ(resolve_fields(model, {{"IBC", "120"}}, problems).ibc, 0);
    EXPECT_EQ(about(problems, "IBC", error).size(), 1u);
}

// ---- versions
// ------------------------------------------------------------------------------------------------------------

struct Since {
    const char* field;
    const char* text;
    int version;  ///< first that reads it
    int before;   ///< the layout before it
};

class VersionOfField : public testing::TestWithParam<Since> {};

TEST_P(VersionOfField, IsReadFromItsVersionOn) {
    const std::string field = GetParam().field;
    const std::string text = GetParam().text;
    const int version = GetParam().version;
    const int before = GetParam().before;
    const auto origin = [&](int of_deck, Problems& problems) {
        Model model = blank_over_tool();
        model.version = of_deck;
        const Interface it = resolve_fields(model, {{field, text}}, problems);
        for (const FieldRow& row : field_table(it, model.units))
            if (row.name == field) return row.origin;
        return Origin{};
    };
    Problems older;
    EXPECT_EQ(origin(before, older).kind, Origin::Kind::absent);
    const auto notes = about(older, field, warning);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_NE(notes[0].rule.find(std::to_string(version)), std::string::npos) << notes[0].rule;
    EXPECT_EQ(notes[0].value, text);
    Problems newer;
    EXPECT_NE(origin(version, newer).kind, Origin::Kind::absent);
    for (const Problem& problem : newer.list())
        EXPECT_EQ(problem.rule.find("is read from"), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(Fields, VersionOfField,
                         testing::Values(Since{"Idel", "1", 2019, 2018}, Since{"Invn", "1", 2017, 140},
                                         Since{"ITlim", "1", 2017, 140}, Since{"Pskid", "5.0", 2020, 2019},
                                         Since{"fct_IDF", "3", 140, 130}, Since{"AscaleF", "2.0", 140, 130},
                                         Since{"fric_ID", "9", 2025, 2024}, Since{"Ithe_form", "1", 2017, 140},
                                         Since{"Fheat", "0.5", 140, 130}, Since{"Fcond", "3", 2021, 2020},
                                         Since{"Dcond", "2.0", 2021, 2020}),
                         [](const auto& parameter) { return std::string(parameter.param.field); });

TEST(InterfaceVersion, ZeroOrTheDefaultOfAnAbsentFieldIsSilent) {
    for (const char* text : {"0", "0.0"}) {
        for (const char* field :
             {"Idel", "Invn", "ITlim", "Pskid", "AscaleF", "fric_ID", "Ithe_form", "Fheat", "Fcond"}) {
            Model model = blank_over_tool();
            model.version = 130;
            Problems problems;
            resolve_fields(model, {{field, text}}, problems);
            EXPECT_TRUE(problems.list().empty()) << field << " " << to_text(problems.list().front());
        }
    }
    for (const Fields& fields : {Fields{{"AscaleF", "1.0"}}, Fields{{"Pskid", "1e30"}}}) {
        Model model = blank_over_tool();
        model.version = 130;
        Problems problems;
        resolve_fields(model, fields, problems);
        EXPECT_TRUE(problems.list().empty());
    }
    Model model = blank_over_tool();
    model.version = 130;
    Problems problems;
    resolve_fields(model, {{"Fheat", "0x1"}}, problems);
    EXPECT_EQ(problems.error_count(), 1) << "what is no number is an error, read or not";
}

TEST(InterfaceVersion, AnAbsentFieldIsZeroOrItsDefault) {
    Model model = blank_over_tool();
    model.version = 130;
    Problems problems;
    const Interface it = resolve_fields(model, {{"Invn", "1"}, {"Pskid", "3.0"}}, problems);
    EXPECT_EQ(it.invn, 0);
    EXPECT_EQ(it.pskid, 1e30);
    EXPECT_EQ(it.pskid.origin.kind, Origin::Kind::absent);
}

TEST(InterfaceVersion, MultimpIsNotedInOldDecksOnly) {
    std::string text = card_text({});
    const size_t line_1 = text.find('\n', text.find("contact of the test")) + 1;
    text.replace(line_1 + 58, 2, "12");
    for (const int version : {120, 130, 140}) {
        Model model = blank_over_tool();
        model.version = version;
        Problems problems;
        resolve_card(model, text, problems);
        EXPECT_EQ(about(problems, "Multimp", warning).size(), 1u) << version;
        EXPECT_EQ(problems.list().size(), 1u) << version;
    }
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, text, problems);
    EXPECT_EQ(about(problems, "Multimp", warning).size(), 0u);
    EXPECT_EQ(about(problems, "columns 51 to 70", warning).size(), 1u);
}

// ---- keyword
// -------------------------------------------------------------------------------------------------------------

TEST(InterfaceKeyword, AnIdIsAskedForAndIsUnique) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_card(model, card_text({}, "/INTER/TYPE21") + card_text({}, "/INTER/TYPE21/x"), problems);
    EXPECT_EQ(about(problems, "inter_ID", error).size(), 2u);
    Model other = blank_over_tool();
    Problems twice;
    resolve_card(other, card_text({}, "/INTER/TYPE21/4") + card_text({}, "/INTER/TYPE21/4"), twice);
    ASSERT_EQ(about(twice, "inter_ID", error).size(), 1u);
    EXPECT_EQ(about(twice, "inter_ID", error)[0].value, "4");
}

TEST(InterfaceKeyword, OtherInterfacesAreNotRead) {
    Model model = blank_over_tool();
    Problems problems;
    resolve_interfaces(deck_of("/INTER/TYPE7/1\nanother\n         1         2\n"), model, problems);
    EXPECT_TRUE(model.interfaces.empty());
    EXPECT_TRUE(problems.list().empty());
}

}  // namespace
}  // namespace type21::test
