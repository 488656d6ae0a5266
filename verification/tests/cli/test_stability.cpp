#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::Outcome;
using test::TempFolder;

TEST(StabilityVerb, RunsWhatIsNamedAndWritesTheSameAsJson) {
    TempFolder folder;
    const Outcome outcome =
        test::type21("stability bounce fold_convex --cycles 10000 --json " + test::in_quotes(folder / "s.json"));
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("bounce: holds"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find("rest: "), std::string::npos) << "it was not named";
    const auto json = nlohmann::json::parse(test::read_text(folder / "s.json"));
    ASSERT_EQ(json["long_runs"].size(), 2U);
    EXPECT_EQ(json["long_runs"][0]["name"], "fold_convex") << "in the order of all runs, not of the command line";
    EXPECT_EQ(json["long_runs"][1]["cycles"], 10000);
    EXPECT_TRUE(json["holds"]);
    EXPECT_FALSE(json.contains("sliding"));
    for (const auto& finding : json["long_runs"][1]["findings"])
        EXPECT_FALSE(finding["unit"].get<std::string>().empty());
}

TEST(StabilityVerb, RefusesWhatItDoesNotKnow) {
    EXPECT_EQ(test::type21("stability nonsense").code, 1);
    EXPECT_EQ(test::type21("stability bounce --cycles 10").code, 1) << "too short to show anything";
}

}  // namespace
}  // namespace type21
