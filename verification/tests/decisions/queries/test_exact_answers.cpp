#include <algorithm>

#include <gtest/gtest.h>

#include "verification/decisions/fuzz/second_opinion.h"
#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"

namespace type21 {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> truth() {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(fs::path(TYPE21_SOURCE_DIR) / "cases" / "decisions"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

DecisionFile read(const fs::path& file) {
    std::vector<std::string> problems;
    DecisionFile decisions = read_decisions(file, problems);
    EXPECT_TRUE(problems.empty()) << problems[0];
    return decisions;
}

TEST(ExactAnswers, the_reference_gives_every_one) {
    ASSERT_EQ(truth().size(), 15U);
    for (const fs::path& file : truth()) {
        DecisionFile decisions = read(file);
        const DecisionTally tally = answer_all(decisions, DecideWith::reference);
        EXPECT_GE(tally.compared, 5) << file;
        EXPECT_TRUE(tally.different.empty()) << file << ": " << tally.different[0];
    }
}

TEST(ExactAnswers, the_second_opinion_gives_every_one) {
    for (const fs::path& file : truth())
        for (const DecisionBlock& block : read(file).blocks)
            for (size_t q = 0; q < block.queries.size(); ++q)
                EXPECT_TRUE(second_opinion(block.tool, block.queries[q]).same_decision(block.answers[q]))
                    << file << ", query " << q;
}

// So that the two above are known to be able to fail: these are hard questions.
TEST(ExactAnswers, plain_double_misses_some) {
    size_t wrong = 0;
    for (const fs::path& file : truth()) {
        DecisionFile decisions = read(file);
        wrong += answer_all(decisions, DecideWith::plain).different.size();
    }
    EXPECT_GT(wrong, 15U);  // 1 % of 1405
}

}  // namespace
}  // namespace type21
