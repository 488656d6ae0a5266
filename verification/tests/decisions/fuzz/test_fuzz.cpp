#include <gtest/gtest.h>

#include "verification/decisions/fuzz/fuzz.h"
#include "verification/decisions/fuzz/fuzz_text.h"
#include "verification/decisions/fuzz/judgement.h"
#include "verification/decisions/fuzz/second_opinion.h"

namespace type21 {
namespace {

void quiet(double) {}

// A few seconds of what `type21 fuzz` does for hours.
TEST(Fuzz, the_reference_is_right_in_every_family) {
    FuzzOptions options;
    options.count = 320;
    options.seed = 20;
    options.full_every = 16;
    options.jobs = 2;
    for (const QuestionFamily& family : question_families()) {
        const FuzzTally tally = fuzz(family, options, quiet);
        EXPECT_EQ(tally.different, 0) << to_text({tally}, options);
        EXPECT_EQ(tally.decisions, 320);
        // A family that nothing touches would be right for free.
        EXPECT_GT(tally.contact, 32) << family.name;
        EXPECT_LT(tally.contact, 320) << family.name;
    }
}

// The same questions, but the segments come from a search that looks from another place.
TEST(Fuzz, both_searches_are_right_in_every_family) {
    for (const char* method : {"optimized-tree", "optimized-sorted"}) {
        FuzzOptions options;
        options.method = method_named(method);
        EXPECT_EQ(name(options.method), method);
        options.count = 160;
        options.seed = 33;
        options.jobs = 2;
        for (const QuestionFamily& family : question_families()) {
            const FuzzTally tally = fuzz(family, options, quiet);
            EXPECT_EQ(tally.different, 0) << to_text({tally}, options);
            EXPECT_GT(tally.contact, 8) << family.name;
        }
    }
}

TEST(Fuzz, finds_what_plain_double_gets_wrong) {
    FuzzOptions options;
    options.count = 640;
    options.method = DecideWith::plain;
    const FuzzTally tally = fuzz(*question_family_named("mesh_on_mesh"), options, quiet);
    EXPECT_GT(tally.different, 0);
    EXPECT_EQ(tally.different, tally.double_wrong);
    EXPECT_EQ(tally.failures.size(), options.keep);
}

TEST(Fuzz, does_not_depend_on_the_number_of_threads) {
    FuzzOptions options;
    options.count = 500;
    options.method = DecideWith::plain;
    const QuestionFamily& family = *question_family_named("fans");
    const FuzzTally one = fuzz(family, options, quiet);
    options.jobs = 3;
    const FuzzTally three = fuzz(family, options, quiet);
    EXPECT_EQ(one.decisions, 500);
    EXPECT_EQ(one.decisions, three.decisions);
    EXPECT_EQ(one.contact, three.contact);
    EXPECT_EQ(one.different, three.different);
    ASSERT_EQ(one.failures.size(), three.failures.size());
    for (size_t i = 0; i < one.failures.size(); ++i) {
        EXPECT_EQ(one.failures[i].block, three.failures[i].block);
        EXPECT_EQ(one.failures[i].number, three.failures[i].number);
    }
}

// The second opinion without intervals would be as right and slow; that they are used at all is seen here.
TEST(SecondOpinion, is_settled_by_intervals_where_nothing_is_close) {
    const DecisionTool tool{
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()}, {{0, 1, 2, 2}}};
    const DecisionAnswer inside = second_opinion(tool, {{0.3, 0.2, 0.1}, 0.25, 0.25, 0});
    EXPECT_EQ(inside.kind, Kind::contact);
    EXPECT_EQ(inside.side, 1);
    EXPECT_EQ(inside.stage, Stage::interval);
    const DecisionAnswer at_gap = second_opinion(tool, {{0.3, 0.2, 0.1}, 0.1, 0.25, 0.2});
    EXPECT_EQ(at_gap.kind, Kind::proximity);  // 0.1 is not below 0.1
    EXPECT_EQ(at_gap.stage, Stage::exact);
}

}  // namespace
}  // namespace type21
