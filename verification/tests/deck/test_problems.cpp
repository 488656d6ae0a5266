#include <string>

#include <gtest/gtest.h>

#include "reference/deck/problem.h"

namespace type21 {
namespace {

Problem sample() {
    Problem problem;
    problem.place = {"a.rad", 41};
    problem.card = "/INTER/TYPE21/1";
    problem.field = "DEPTH";
    problem.value = "-1 mm";
    problem.rule = "DEPTH is not negative";
    problem.remedy = "Give 0 for the default";
    return problem;
}

TEST(Problems, CountTheSameProblemAtAnotherPlace) {
    Problems problems;
    problems.add(sample());
    Problem again = sample();
    again.place = {"b.rad", 7};
    problems.add(again);
    ASSERT_EQ(problems.list().size(), 1U);
    EXPECT_EQ(problems.list()[0].count, 2);
    EXPECT_EQ(problems.list()[0].place.file, "a.rad");
    EXPECT_EQ(problems.list()[0].place.line, 41);
}

TEST(Problems, KeepApartWhatDiffersInAnythingButThePlace) {
    Problems problems;
    problems.add(sample());
    Problem other = sample();
    other.value = "-2 mm";
    problems.add(other);
    other = sample();
    other.severity = Severity::warning;
    problems.add(other);
    other = sample();
    other.card = "/INTER/TYPE21/2";
    problems.add(other);
    EXPECT_EQ(problems.list().size(), 4U);
    EXPECT_EQ(problems.error_count(), 3);
    EXPECT_EQ(problems.warning_count(), 1);
    EXPECT_TRUE(problems.has_errors());
}

TEST(Problems, ManyValuesOfOneFieldShareAMessageAfterTheTwentieth) {
    Problems problems;
    for (int i = 0; i < 1000; ++i) {
        Problem problem = sample();
        problem.value = std::to_string(i);
        problems.add(problem);
    }
    ASSERT_EQ(problems.list().size(), 21U);
    EXPECT_EQ(problems.list().back().count, 980);
    EXPECT_EQ(problems.list().back().value, "(other values)");
}

TEST(Problems, OfEachSeverityFiveHundredAreKept) {
    Problems problems;
    for (int i = 0; i < 3000; ++i) {
        Problem problem = sample();
        problem.field = std::to_string(i);
        problem.severity = Severity::warning;
        problems.add(problem);
    }
    EXPECT_EQ(problems.list().size(), 501U);
    EXPECT_EQ(problems.list().back().count, 2500);
    EXPECT_FALSE(problems.has_errors());
    problems.add(sample());
    EXPECT_TRUE(problems.has_errors()) << "no number of warnings hides an error";
    EXPECT_EQ(problems.list().size(), 502U);
}

TEST(Problems, AValueOfAnyLengthIsShownInBounds) {
    Problems problems;
    Problem problem = sample();
    problem.value = std::string(100000, '[');
    problems.add(problem);
    EXPECT_LT(to_text(problems.list()[0]).size(), 600U);
}

TEST(Problems, WarningsAloneAreNoErrors) {
    Problems problems;
    Problem problem = sample();
    problem.severity = Severity::warning;
    problems.add(problem);
    EXPECT_FALSE(problems.has_errors());
}

TEST(Problems, TextHoldsPlaceCardFieldValueRuleAndRemedy) {
    EXPECT_EQ(to_text(sample()),
              "a.rad:41: error: /INTER/TYPE21/1, field 'DEPTH' = -1 mm: DEPTH is not negative. Give 0 for the default");
    Problem counted = sample();
    counted.count = 3;
    EXPECT_NE(to_text(counted).find("3 times"), std::string::npos);
    Problem file;
    file.place = {"a.rad", 0};
    file.value = "a.rad";
    file.rule = "there is no such file";
    EXPECT_EQ(to_text(file), "a.rad: error: a.rad: there is no such file");
}

}  // namespace
}  // namespace type21
