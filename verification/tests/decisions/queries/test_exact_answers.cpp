// The 1405 queries of cases/decisions with answers by rational arithmetic from elsewhere (cases/decisions/README.md).
#include <algorithm>
#include <filesystem>

#include <gtest/gtest.h>

#include "verification/decisions/fuzz/second_opinion.h"
#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"

namespace type21 {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> decision_files() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(TYPE21_SOURCE_DIR "/cases/decisions"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

DecisionFile read(const fs::path& file) {
    std::vector<std::string> problems;
    DecisionFile decisions = read_decisions(file, problems);
    EXPECT_TRUE(problems.empty()) << problems.front();
    return decisions;
}

DecisionTally answered(const fs::path& file, DecideWith method) {
    DecisionFile decisions = read(file);
    return answer_all(decisions, method);
}

/// What both implementations must pass.
class ExactAnswers : public ::testing::TestWithParam<DecideWith> {};

TEST_P(ExactAnswers, are_given_to_every_query) {
    const auto files = decision_files();
    ASSERT_EQ(files.size(), 15U);
    long compared = 0;
    for (const fs::path& file : files) {
        const DecisionTally tally = answered(file, GetParam());
        EXPECT_TRUE(tally.different.empty()) << file << ": " << tally.different.front();
        compared += tally.compared;
    }
    EXPECT_EQ(compared, 1405);
}

INSTANTIATE_TEST_SUITE_P(By, ExactAnswers, ::testing::Values(DecideWith::reference, DecideWith::optimized),
                         [](const auto& tested) { return std::string(name(tested.param)); });

TEST(RationalNumbers, give_the_exact_answers) {
    const DecisionTally tally = answered(TYPE21_SOURCE_DIR "/cases/decisions/on_limits.json", DecideWith::exact);
    EXPECT_TRUE(tally.different.empty()) << tally.different.front();
    EXPECT_GT(tally.compared, 0);
}

TEST(SecondOpinion, gives_the_exact_answers) {
    long compared = 0;
    for (const fs::path& file : decision_files())
        for (const DecisionBlock& block : read(file).blocks)
            for (size_t q = 0; q < block.queries.size(); ++q, ++compared)
                EXPECT_TRUE(second_opinion(block.tool, block.queries[q]).same_decision(block.answers[q]))
                    << file << ", query " << q;
    EXPECT_EQ(compared, 1405);
}

// The tests above can fail: these are hard queries, and plain double answers some of them wrongly.
TEST(PlainDouble, misses_some) {
    size_t wrong = 0;
    long counted = 0;
    for (const fs::path& file : decision_files()) {
        wrong += answered(file, DecideWith::plain).different.size();
        counted += answered(file, DecideWith::reference).stage_counts.double_wrong;
    }
    EXPECT_GT(wrong, 15U);  // 1 % of 1405
    EXPECT_EQ(counted, static_cast<long>(wrong)) << "the reference counts as wrong what plain double gets wrong";
}

// The optimized implementation and the second opinion know the documented limits only: they refuse others instead of
// giving the answer to another query.
TEST(OtherLimits, are_refused_where_they_are_not_known) {
    const DecisionTool tool{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, std::vector<Vec3>(3, Vec3::UnitZ()), {{0, 1, 2, 2}}};
    ContactQuery query{{-0.02, 0.5, 0.1}, 0.25, 0.25, 0};
    EXPECT_EQ(decide(tool, query, DecideWith::optimized).kind, Kind::none);
    query.lowest_weight = -0.05;
    EXPECT_EQ(decide(tool, query, DecideWith::reference).kind, Kind::contact);
    EXPECT_THROW(decide(tool, query, DecideWith::optimized), std::invalid_argument);
    EXPECT_THROW(second_opinion(tool, query), std::invalid_argument);
}

}  // namespace
}  // namespace type21
