#include <gtest/gtest.h>

#include "verification/decisions/fuzz/judgement.h"
#include "verification/decisions/fuzz/shrink.h"
#include "verification/decisions/queries/decide.h"
#include "verification/decisions/question_families/question_family.h"

namespace type21 {
namespace {

bool double_is_wrong(const SingleQuery& question) {
    return !judge(question.tool, question.query, DecideWith::plain, Scrutiny::decision).wrong.empty();
}

/// The first question of a family that plain double gets wrong.
SingleQuery wrong_question(const char* family) {
    for (std::uint64_t index = 0; index < 100; ++index) {
        const DecisionBlock block = block_of(*question_family_named(family), 3, index);
        for (const ContactQuery& query : block.queries)
            if (double_is_wrong({block.tool, query})) return {block.tool, query};
    }
    throw std::runtime_error("plain double is always right");
}

TEST(Shrink, leaves_a_smaller_question_that_still_fails) {
    for (const char* family : {"mesh_on_mesh", "cylinder", "fans", "denormals"}) {
        const SingleQuery question = wrong_question(family);
        const SingleQuery small = shrink(question, double_is_wrong);
        EXPECT_TRUE(double_is_wrong(small)) << family;
        // A tie needs two segments at most, and eight nodes.
        EXPECT_LE(small.tool.segment.size(), 2U) << family;
        EXPECT_LE(small.tool.node.size(), 8U) << family;
        EXPECT_LT(small.tool.segment.size(), question.tool.segment.size()) << family;
        EXPECT_EQ(small.tool.node.size(), small.tool.normal.size()) << family;
    }
}

TEST(Shrink, keeps_what_the_failure_needs_and_nothing_else) {
    SingleQuery question;
    for (int i = 0; i < 8; ++i) {
        question.tool.node.push_back({i + 0.1, 1.3 * i, 0.7});
        question.tool.normal.push_back(Vec3::UnitZ());
    }
    question.tool.segment = {{0, 1, 2, 3}, {2, 3, 4, 5}, {4, 5, 6, 7}};
    question.query = {{0.1, 0.2, 0.3}, 0.4, 0.5, 0.6};
    // "Fails" while some segment has the node at x = 4.1 and the gap is above 0.25.
    const auto fails = [](const SingleQuery& q) {
        for (const auto& segment : q.tool.segment)
            for (const int corner : segment)
                if (q.tool.node[static_cast<size_t>(corner)].x() == 4.1 && q.query.gap > 0.25) return true;
        return false;
    };
    const SingleQuery small = shrink(question, fails);
    EXPECT_EQ(small.tool.segment.size(), 1U);
    EXPECT_EQ(small.tool.segment[0][2], small.tool.segment[0][3]);
    EXPECT_EQ(small.tool.node.size(), 3U);
    EXPECT_EQ(small.query.point, Vec3::Zero());
    EXPECT_EQ(small.query.gap, 0.5);  // one bit
    EXPECT_EQ(small.query.depth, 0);
}

}  // namespace
}  // namespace type21
