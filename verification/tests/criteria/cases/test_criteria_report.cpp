#include <limits>

#include <gtest/gtest.h>

#include "verification/report/criteria_report.h"
#include "verification/support/build_info.h"

namespace type21 {
namespace {

std::vector<CriterionResult> two_results() {
    CriterionResult good;
    good.id = "good";
    good.case_name = "case";
    good.run = "run";
    good.kind = "ANALYTIC";
    good.got_number = 1.5;
    good.tolerance = 1e-9;
    good.unit = "N s";
    good.ok = true;
    CriterionResult bad = good;
    bad.id = "bad";
    bad.kind = "EXTERNAL";
    bad.difference = std::numeric_limits<double>::infinity();
    bad.detail = "a < b & \"c\"";
    bad.ok = false;
    return {good, bad};
}

TEST(CheckReport, TheTableCountsAndNamesTheFailed) {
    const std::string table = criteria_table(two_results());
    EXPECT_NE(table.find("FAILED"), std::string::npos);
    EXPECT_NE(table.find("run run: a < b"), std::string::npos);
    EXPECT_NE(table.find("2 criteria (1 ANALYTIC, 1 EXTERNAL) of 1 run in 1 case: 1 FAILED"), std::string::npos)
        << table;
    EXPECT_NE(criteria_table({two_results()[0]}).find("all hold"), std::string::npos);
}

TEST(CheckReport, JsonHasOneCompleteRecordACheck) {
    const nlohmann::ordered_json json = criteria_json(two_results());
    ASSERT_EQ(json.size(), 2U);
    for (const char* key : {"id", "case", "run", "kind", "equation", "expected", "got", "difference", "tolerance",
                            "unit", "reason", "verdict", "seconds", "version", "compiler", "cpu"})
        EXPECT_TRUE(json[0].contains(key)) << key;
    EXPECT_EQ(json[0]["got"], 1.5);
    EXPECT_EQ(json[0]["verdict"], "ok");
    EXPECT_EQ(json[1]["verdict"], "failed");
    EXPECT_EQ(json[1]["difference"], "inf");
    EXPECT_EQ(json[0]["version"], build_info().version);
    EXPECT_FALSE(build_info().version.empty());
    EXPECT_FALSE(build_info().commit.empty());
    EXPECT_NE(build_info().flags.find("-ffp-contract=off"), std::string::npos);
}

TEST(CheckReport, WhatWasSkippedIsCountedApart) {
    CriterionResult skipped = two_results()[0];
    skipped.skipped = true;
    const std::string table = criteria_table({two_results()[0], skipped});
    EXPECT_NE(table.find("all hold, 1 skipped"), std::string::npos) << table;
    EXPECT_EQ(criteria_json({skipped})[0]["verdict"], "skipped");
    EXPECT_NE(criteria_junit({skipped}).find("<skipped"), std::string::npos);
}

TEST(CheckReport, JunitIsEscaped) {
    const std::string xml = criteria_junit(two_results());
    EXPECT_NE(xml.find("tests=\"2\" failures=\"1\""), std::string::npos);
    EXPECT_NE(xml.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
}

}  // namespace
}  // namespace type21
