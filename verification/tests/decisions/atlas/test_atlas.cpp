#include <gtest/gtest.h>

#include "verification/decisions/atlas/atlas.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

std::vector<AtlasEntry> atlas() {
    std::vector<std::string> problems;
    auto entries = read_atlas(test::cases() / "atlas", {}, problems);
    EXPECT_TRUE(problems.empty()) << problems[0];
    return entries;
}

TEST(Atlas, every_answer_is_the_exact_one) {
    const auto entries = atlas();
    EXPECT_GE(entries.size(), 39U);
    for (const AtlasEntry& entry : entries) {
        const auto answers = answers_of(entry, DecideWith::reference);
        for (size_t q = 0; q < answers.size(); ++q) {
            EXPECT_TRUE(answers[q].ok) << entry.name << ", " << entry.note[q] << ": " << in_words(answers[q].program);
            EXPECT_GE(answers[q].program.margin, 0) << entry.name << ", " << entry.note[q];
        }
    }
}

// The answers of doubles in the files come from another language: the order of operations is the text's, no
// contraction.
TEST(Atlas, plain_double_answers_as_it_does_elsewhere) {
    for (const AtlasEntry& entry : atlas()) {
        const auto answers = answers_of(entry, DecideWith::reference);
        ASSERT_EQ(entry.double_answers.size(), answers.size()) << entry.name;
        for (size_t q = 0; q < answers.size(); ++q)
            EXPECT_TRUE(answers[q].plain.same_decision(entry.double_answers[q]))
                << entry.name << ", " << entry.note[q] << ": " << in_words(answers[q].plain);
    }
}

// Both sides: an entry whose answers are all the same would show nothing.
TEST(Atlas, each_entry_has_more_than_one_answer) {
    for (const AtlasEntry& entry : atlas()) {
        bool different = false;
        for (const DecisionAnswer& answer : entry.block.answers)
            different = different || !answer.same_decision(entry.block.answers[0]);
        EXPECT_TRUE(different) << entry.name;
    }
}

TEST(Atlas, warns_of_segments_without_area) {
    std::vector<std::string> problems;
    const auto entries = read_atlas(test::cases() / "atlas", {"zero_area_quad"}, problems);
    ASSERT_EQ(entries.size(), 1U);
    ASSERT_EQ(entries[0].warnings.size(), 1U);
    EXPECT_EQ(entries[0].warnings[0], "1 segments have no area: nothing touches them");
}

TEST(AtlasProgram, shows_entries_and_writes_them_for_a_drawing) {
    test::TempFolder folder;
    const auto outcome = test::type21("atlas fan medial_axis --folder " + test::in_quotes(test::cases() / "atlas") +
                                      " --json " + test::in_quotes(folder / "atlas.json"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("Eight triangles round an apex"), std::string::npos);
    EXPECT_EQ(outcome.out.find("warped_quad"), std::string::npos);
    const auto json = nlohmann::json::parse(test::read_text(folder / "atlas.json"));
    ASSERT_EQ(json["entries"].size(), 2U);
    for (const auto& entry : json["entries"]) {
        const auto& block = entry["blocks"][0];
        for (const char* key : {"note", "answers", "double", "program"})
            EXPECT_EQ(block[key].size(), block["queries"].size()) << key;
        EXPECT_TRUE(block["program"][0].contains("stage"));
        EXPECT_TRUE(block["program"][0].contains("margin"));
        EXPECT_FALSE(block["nodes"].empty());
    }
}

TEST(AtlasProgram, exits_with_3_when_an_answer_differs) {
    const std::string folder = " --folder " + test::in_quotes(test::cases() / "atlas");
    EXPECT_EQ(test::type21("atlas fan --with double" + folder).code, 3);
    EXPECT_EQ(test::type21("atlas nothing" + folder).code, 2);
}

}  // namespace
}  // namespace type21
