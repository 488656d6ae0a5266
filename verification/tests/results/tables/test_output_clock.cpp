#include <vector>

#include <gtest/gtest.h>

#include "verification/results/tables/output_clock.h"

namespace type21 {
namespace {

/// Cycles of a run with a constant step that give a record.
std::vector<int> due_cycles(double interval, double step, int cycles) {
    OutputClock clock(interval);
    std::vector<int> due;
    for (int n = 0; n < cycles; ++n)
        if (clock.due(n * step, n == 0 ? 0 : step, n + 1 == cycles)) due.push_back(n);
    return due;
}

TEST(OutputClock, RecordsTheFirstTheLastAndTheInterval) {
    EXPECT_EQ(due_cycles(3.0, 1.0, 9), (std::vector<int>{0, 3, 6, 8}));
}

TEST(OutputClock, AnIntervalBetweenCyclesIsTakenAtTheNextCycle) {
    // Output times 0, 2.5, 5, 7.5, 10.
    EXPECT_EQ(due_cycles(2.5, 1.0, 12), (std::vector<int>{0, 3, 5, 8, 10, 11}));
}

TEST(OutputClock, ZeroOrLessThanTheStepIsEveryCycle) {
    const std::vector<int> all{0, 1, 2, 3, 4};
    EXPECT_EQ(due_cycles(0.0, 1.0, 5), all);
    EXPECT_EQ(due_cycles(0.5, 1.0, 5), all);
    EXPECT_EQ(due_cycles(1e-300, 1.0, 5), all);
    EXPECT_EQ(due_cycles(1.0, 1.0, 5), all);
}

TEST(OutputClock, CountsOnWhenTheStepShrinksBelowTheInterval) {
    OutputClock clock(1.0);
    EXPECT_TRUE(clock.due(0, 0, false));
    EXPECT_TRUE(clock.due(5, 5, false));
    EXPECT_TRUE(clock.due(5.25, 0.25, false));
    EXPECT_FALSE(clock.due(5.5, 0.25, false));
    EXPECT_FALSE(clock.due(5.75, 0.25, false));
    EXPECT_TRUE(clock.due(6.0, 0.25, false));
}

}  // namespace
}  // namespace type21
