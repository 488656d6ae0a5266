// 1400 queries with answers by rational arithmetic from elsewhere (cases/decisions/README.md).
#include <filesystem>

#include <gtest/gtest.h>

#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"

namespace type21 {
namespace {

std::vector<std::filesystem::path> truth_files() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(TYPE21_SOURCE_DIR "/cases/decisions"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    return files;
}

DecisionTally answer(const std::filesystem::path& path, DecideWith method) {
    std::vector<std::string> problems;
    DecisionFile file = read_decisions(path, problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
    return answer_all(file, method);
}

TEST(Truth, TheReferenceAnswersEveryQueryExactly) {
    const auto files = truth_files();
    ASSERT_EQ(files.size(), 15u);
    long compared = 0;
    long wrong_in_double = 0;
    for (const auto& file : files) {
        const DecisionTally tally = answer(file, DecideWith::reference);
        EXPECT_TRUE(tally.different.empty()) << file << ": " << tally.different.front();
        compared += tally.compared;
        wrong_in_double += tally.stage_counts.double_wrong;
    }
    EXPECT_EQ(compared, 1405);
    EXPECT_GT(wrong_in_double, 0) << "else the queries are not hard";
}

// The test above can fail: plain double does.
TEST(Truth, PlainDoubleDoesNot) {
    const auto tally = answer(TYPE21_SOURCE_DIR "/cases/decisions/flat_near_ties.json", DecideWith::plain);
    EXPECT_GT(tally.different.size(), 10u);
    // What the stage_counts counts as wrong in double is what double alone gets wrong.
    const auto staged = answer(TYPE21_SOURCE_DIR "/cases/decisions/flat_near_ties.json", DecideWith::reference);
    EXPECT_EQ(staged.stage_counts.double_wrong, static_cast<long>(tally.different.size()));
}

TEST(Truth, RationalNumbersAloneAgree) {
    const auto tally = answer(TYPE21_SOURCE_DIR "/cases/decisions/on_limits.json", DecideWith::exact);
    EXPECT_TRUE(tally.different.empty());
}

}  // namespace
}  // namespace type21
