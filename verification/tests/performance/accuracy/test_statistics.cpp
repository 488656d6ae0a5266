#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "verification/performance/accuracy/force_error.h"
#include "verification/performance/accuracy/timing.h"

namespace type21::accuracy {
namespace {

TEST(ForceErrors, AreInSpacingsOfTheExactForce) {
    EXPECT_EQ(error_in_ulps(3.0, 3.0), 0);
    EXPECT_EQ(error_in_ulps(std::nextafter(3.0, 4.0), 3.0), 1);
    EXPECT_EQ(error_in_ulps(std::nextafter(1.0, 0.0), 1.0), 0.5) << "the doubles below a power of two lie closer";
    EXPECT_EQ(error_in_ulps(0.0, 1.0), 0x1p52);
}

TEST(ForceErrors, HaveThePercentilesOfGivenNumbers) {
    ForceErrors errors;
    EXPECT_EQ(errors.ulps(1), 0);
    for (int i = 1; i <= 200; ++i)
        errors.add(2 + i * 0x1p-51, 2, 8);
    EXPECT_EQ(errors.compared(), 200U);
    EXPECT_EQ(errors.ulps(0.99), 198);
    EXPECT_EQ(errors.ulps(1), 200);
    EXPECT_EQ(errors.relative(1), 200 * 0x1p-52);
    EXPECT_EQ(errors.scaled(1), 50) << "a unit of 8 is four of those of 2";
    EXPECT_EQ(errors.scaled(0.5), 25);
}

TEST(ForceErrors, CountWhatIsNoNumberApart) {
    ForceErrors errors;
    errors.add(std::numeric_limits<double>::quiet_NaN(), 1, 1);
    errors.add(std::numeric_limits<double>::infinity(), 1, 1);
    errors.add(1, 1, 1);
    errors.add_spurious();
    EXPECT_EQ(errors.compared(), 3U);
    EXPECT_EQ(errors.not_finite(), 2U);
    EXPECT_EQ(errors.spurious(), 1U);
    EXPECT_EQ(errors.ulps(1), 0);
}

TEST(Timing, PercentilesAreThoseOfTheValues) {
    const std::vector<double> values{7, 1, 3, 9, 5};
    EXPECT_EQ(percentile(values, 0), 1);
    EXPECT_EQ(percentile(values, 0.5), 5);
    EXPECT_EQ(percentile(values, 0.8), 7);
    EXPECT_EQ(percentile(values, 0.81), 9);
    const TimingSpread of = timing_spread(values);
    EXPECT_EQ(of.min, 1);
    EXPECT_EQ(of.p50, 5);
    EXPECT_EQ(of.p95, 9);
    EXPECT_EQ(of.max, 9);
    EXPECT_THROW(timing_spread({}), std::invalid_argument);
}

TEST(Timing, TheErrorOfAMedianFallsWithTheRootOfTheCount) {
    std::vector<double> values;
    for (int i = 0; i < 100; ++i)
        values.push_back(i % 10);
    const double one = error_of_median(values);
    // The middle 80 % of 0 to 9 are 8 wide: 1.2533 (8 / 2.563) / 10.
    EXPECT_NEAR(one, 0.3912, 1e-3);
    for (int i = 0; i < 300; ++i)
        values.push_back(i % 10);
    EXPECT_NEAR(error_of_median(values), one / 2, 1e-12);
    EXPECT_EQ(error_of_median({1}), 0);
}

TEST(Timing, EachHasItsTurnInEachRepeatAndNoneIsAlwaysFirst) {
    std::string order;
    std::vector<Timed> timed(4);
    for (size_t i = 0; i < 3; ++i)
        timed[i] = {[&order, i] { order += static_cast<char>('a' + i); }, i + 1, {}};
    interleave(timed, 3);
    EXPECT_EQ(order, "abcbcacab");
    for (size_t i = 0; i < 3; ++i) {
        ASSERT_EQ(timed[i].ns.size(), 3U);
        for (const double ns : timed[i].ns)
            EXPECT_GE(ns, 0);
    }
    EXPECT_TRUE(timed[3].ns.empty()) << "nothing to time";
}

}  // namespace
}  // namespace type21::accuracy
