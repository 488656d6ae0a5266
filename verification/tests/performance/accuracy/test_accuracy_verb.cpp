#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using nlohmann::json;

void expect_number(const json& object, const char* key) {
    ASSERT_TRUE(object.contains(key)) << key;
    ASSERT_TRUE(object[key].is_number()) << key;
    EXPECT_TRUE(std::isfinite(object[key].get<double>())) << key;
}

TEST(AccuracyVerb, WritesAllThatTheReportShows) {
    test::TempFolder folder;
    const test::Outcome outcome =
        test::type21("accuracy --quick --quiet --repeats 3 --scene mesh_bowl --scene adversarial --json " +
                     test::in_quotes(folder / "a.json"));
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("methods that promise exact decisions: 0 wrong"), std::string::npos) << outcome.out;
    const json found = json::parse(test::read_text(folder / "a.json"));
    for (const char* key :
         {"command", "version", "commit", "cpu", "compiler", "flags", "flags_optimized", "build_type", "clock"})
        EXPECT_FALSE(found[key].get<std::string>().empty()) << key;
    EXPECT_EQ(found["repeats"], 3);
    EXPECT_EQ(found["seed"], 1);
    EXPECT_EQ(found["quick"], true);
    EXPECT_EQ(found["exact_ones_are_right"], true);
    ASSERT_EQ(found["scenes"].size(), 2U);
    EXPECT_EQ(found["scenes"][0]["scene"], "mesh_bowl") << "in the order of all scenes";
    ASSERT_EQ(found["rows"].size(), 2U * 13);
    for (const json& row : found["rows"]) {
        for (const char* key : {"scene", "kind", "group", "method", "what"})
            EXPECT_FALSE(row[key].get<std::string>().empty()) << key;
        for (const char* key : {"timed", "decisions", "wrong", "undecided"})
            expect_number(row, key);
        for (const char* key : {"p50", "p95", "max", "min"})
            expect_number(row["ns"], key);
        for (const char* key : {"judged", "spurious", "not_finite", "ulps_p99", "ulps_max", "relative_p99",
                                "relative_max", "scaled_p99", "scaled_max"})
            expect_number(row["force"], key);
        EXPECT_LE(row["ns"]["p50"], row["ns"]["p95"]);
    }
    ASSERT_EQ(found["stage_counts"].size(), 4U);
    for (const json& stage_counts : found["stage_counts"])
        for (const json& stage : stage_counts["stages"])
            EXPECT_EQ(stage["settled"] > 0, stage.contains("ns")) << stage_counts;
    EXPECT_TRUE(found["effects"].empty()) << "scenes were named";
}

TEST(AccuracyVerb, ListsItsScenesAndRefusesOthers) {
    const test::Outcome list = test::type21("accuracy --list");
    EXPECT_EQ(list.code, 0);
    EXPECT_EQ(test::count_lines(list.out), 5U);
    EXPECT_EQ(test::type21("accuracy --scene nowhere").code, 1);
    EXPECT_EQ(test::type21("accuracy --repeats 0").code, 1);
}

}  // namespace
}  // namespace type21
