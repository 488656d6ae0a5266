#include <gtest/gtest.h>

#include "verification/performance/accuracy/effect_cost.h"

namespace type21::accuracy {
namespace {

class EffectOf : public ::testing::TestWithParam<size_t> {};

TEST_P(EffectOf, WhenOffNothingOfItIsThere) {
    const EffectCard& card = effect_cards()[GetParam()];
    for (const bool fast : {false, true}) {
        const EffectCost cost = effect_cost(card, fast, 6, 4);
        EXPECT_TRUE(cost.same_program) << card.name;
        EXPECT_EQ(cost.bytes_off, cost.bytes_absent) << card.name;
        EXPECT_GE(cost.bytes_on, cost.bytes_off) << card.name;
        // The test of the normals only looks at them; all others change what comes out, or they were not measured.
        EXPECT_EQ(cost.changes_forces, card.name.find("normals") == std::string::npos) << card.name;
        EXPECT_GT(cost.absent.p50, 0);
        EXPECT_GT(cost.off.p50, 0);
        EXPECT_GT(cost.on.p50, 0);
        EXPECT_EQ(cost.cycles, 4U);
    }
}

INSTANTIATE_TEST_SUITE_P(Effects, EffectOf, ::testing::Range(size_t{0}, effect_cards().size()));

TEST(Effects, ACardThatIsNotOffIsSeen) {
    EffectCard card = effect_cards()[1];
    card.off = card.on;
    const EffectCost cost = effect_cost(card, true, 6, 4);
    EXPECT_FALSE(cost.same_program);
    EXPECT_GT(cost.bytes_off, cost.bytes_absent);
    EXPECT_FALSE(cost.changes_forces) << "off and on are the same card";
}

}  // namespace
}  // namespace type21::accuracy
