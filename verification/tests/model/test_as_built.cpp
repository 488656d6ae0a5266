// The set of departures and its text.
#include <gtest/gtest.h>

#include "reference/contract/departures.h"
#include "reference/model/as_built_option.h"

namespace type21 {
namespace {

AsBuilt parsed(const std::string& text) {
    Problems problems;
    const AsBuilt set = parse_as_built(text, problems);
    EXPECT_TRUE(problems.list().empty()) << text << ": " << to_text(problems.list().front());
    return set;
}

TEST(AsBuilt, TableHasEveryDepartureOnceInOrder) {
    ASSERT_EQ(departures().size(), 44u);
    for (size_t i = 0; i < 37; ++i) {
        const DepartureRow& row = departures()[i];
        EXPECT_EQ(static_cast<size_t>(row.id), i + 1);
        EXPECT_FALSE(row.documented.empty());
        EXPECT_FALSE(row.as_built.empty());
        EXPECT_EQ(row.available, row.reason.empty()) << name(row.id);
    }
}

TEST(AsBuilt, AllMeansTheAvailableOnes) {
    EXPECT_EQ(AsBuilt::all().text(),
              "D01, D02, D03, D04, D05, D06, D07, D08, D09, D10, D11, D12, D13, D14, D15, D16, D17, D18, D19, D20, "
              "D24, D25, D26, D28, D29, D30, D31, D32, D33, D34, D35, D36, D37, D38, D39, D40, D41, D42, D43");
    EXPECT_EQ(parsed("all").text(), AsBuilt::all().text());
    EXPECT_EQ(parsed(" ALL ").text(), AsBuilt::all().text());
}

TEST(AsBuilt, NothingMeansNone) {
    for (const std::string text : {"", "  ", "none", "None"}) {
        EXPECT_FALSE(parsed(text).any()) << text;
        EXPECT_EQ(parsed(text).text(), "none");
    }
}

TEST(AsBuilt, NamesInAnyCaseAndOrder) {
    EXPECT_EQ(parsed("D24,D03").text(), "D03, D24");
    EXPECT_EQ(parsed(" d03 , d24 ").text(), "D03, D24");
    EXPECT_TRUE(parsed("D03").has(Departure::D03));
    EXPECT_FALSE(parsed("D03").has(Departure::D04));
}

TEST(AsBuilt, AMinusTakesAway) {
    AsBuilt expected = AsBuilt::all();
    expected.set(Departure::D04, false);
    EXPECT_EQ(parsed("all,-D04").text(), expected.text());
    EXPECT_EQ(parsed("D03,D04,- d04").text(), "D03");
}

TEST(AsBuilt, TextReadsBackAsTheSameSet) {
    EXPECT_EQ(parsed(AsBuilt::all().text()).text(), AsBuilt::all().text());
    EXPECT_EQ(parsed(parsed("D12").text()).text(), "D12");
}

TEST(AsBuilt, WrongNamesAreOneProblemEach) {
    Problems problems;
    const AsBuilt set = parse_as_built("D03,D45,D3,xyz,,D05x", problems);
    EXPECT_EQ(set.text(), "D03") << "what is right is kept";
    ASSERT_EQ(problems.error_count(), 5);
    for (const Problem& problem : problems.list()) {
        EXPECT_EQ(problem.card, "--as-built");
        EXPECT_NE(problem.remedy.find("D01, D02, D03"), std::string::npos) << "lists what can be given";
        EXPECT_EQ(problem.remedy.find("D21"), std::string::npos) << "and not what cannot";
    }
    EXPECT_EQ(problems.list()[0].value, "D45");
}

TEST(AsBuilt, UnavailableNamesSayWhy) {
    Problems problems;
    EXPECT_FALSE(parse_as_built("D21,D22,D23,D27", problems).any());
    ASSERT_EQ(problems.error_count(), 4);
    for (const Problem& problem : problems.list())
        EXPECT_NE(problem.rule.find("not reproduced"), std::string::npos) << problem.value;
}

TEST(AsBuilt, TakingAwayWhatIsNotThereIsAProblem) {
    Problems problems;
    parse_as_built("D03,-D04", problems);
    EXPECT_EQ(problems.error_count(), 1);
}

}  // namespace
}  // namespace type21
