// The number types of the stages against CGAL's rational numbers (GMP), which share nothing with them.
#include <cfloat>
#include <limits>

#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>

#include "reference/exact/bounded.h"
#include "reference/exact/fraction.h"
#include "reference/exact/interval.h"
#include "verification/tests/exact/expressions.h"

namespace type21::reference {
namespace {

using Rational = CGAL::Gmpq;

constexpr int trials = 400;

bool within(const Rational& value, double low, double high) {
    // Infinite bounds hold everything.
    if (low == -std::numeric_limits<double>::infinity() || high == std::numeric_limits<double>::infinity()) return true;
    return Rational(low) <= value && value <= Rational(high);
}

TEST(Fraction, IsExactInRandomExpressions) {
    for (unsigned seed = 0; seed < trials; ++seed) {
        const Expression expression(seed, 5, 14, 40);
        const auto possible = expression.possible<Fraction>();
        const auto accept = [&](size_t i, const auto&) { return bool(possible[i]); };
        const auto ours = expression.values<Fraction>(accept);
        const auto theirs = expression.values<Rational>(accept);
        for (size_t i = 0; i < ours.size(); ++i) {
            ASSERT_EQ(ours[i].sign(), static_cast<int>(CGAL::sign(theirs[i]))) << seed << " step " << i;
            const auto [low, high] = ours[i].enclosure();
            ASSERT_TRUE(within(theirs[i], low, high)) << seed << " step " << i;
            // Any two values compare as the rational ones do.
            const size_t j = (i * 7 + seed) % ours.size();
            ASSERT_EQ(ours[i] < ours[j], theirs[i] < theirs[j]) << seed;
            ASSERT_EQ(ours[i] == ours[j], theirs[i] == theirs[j]) << seed;
        }
    }
}

TEST(Fraction, OneThirdThreeTimesIsOne) {
    const Fraction third = Fraction(1) / Fraction(3);
    EXPECT_TRUE(third + third + third == Fraction(1));
    EXPECT_TRUE(third * Fraction(3) == Fraction(1));
    EXPECT_FALSE(third == Fraction(1.0 / 3.0)) << "the double is not a third";
    EXPECT_DOUBLE_EQ(third.to_double(), 1.0 / 3.0);
}

TEST(Fraction, TheSignOfANegativeDivisorCounts) {
    const Fraction minus_three(-3);
    EXPECT_EQ((Fraction(1) / minus_three).sign(), -1);
    EXPECT_EQ((Fraction(1) / minus_three / minus_three).sign(), +1);
    EXPECT_TRUE(Fraction(1) / minus_three < Fraction(0));
}

TEST(Fraction, DividingByZeroThrows) {
    EXPECT_THROW(Fraction(1) / (Fraction(0.1) - Fraction(0.1)), std::domain_error);
}

TEST(Fraction, HoldsTheWholeRangeOfDoubles) {
    const double tiny = std::numeric_limits<double>::denorm_min();
    EXPECT_EQ(Fraction(tiny).sign(), 1);
    EXPECT_TRUE(Fraction(tiny) / Fraction(2) < Fraction(tiny));
    EXPECT_TRUE(Fraction(1e300) * Fraction(1e300) > Fraction(DBL_MAX));
    EXPECT_TRUE(Fraction(1e300) * Fraction(1e-300) < Fraction(1.0000000000000002));
}

TEST(Bounded, ItsBoundHoldsInRandomExpressions) {
    int undecided = 0;
    for (unsigned seed = 0; seed < trials; ++seed) {
        const Expression expression(seed, 5, 12, 6);
        const auto possible = expression.possible<Fraction>();
        const auto accept = [&](size_t i, const auto&) { return bool(possible[i]); };
        const auto exact = expression.values<Rational>(accept);
        try {
            const auto ours = expression.values<Bounded>(accept);
            for (size_t i = 0; i < ours.size(); ++i) {
                if (!std::isfinite(ours[i].value()) || !std::isfinite(ours[i].error())) continue;
                ASSERT_LE(abs(exact[i] - Rational(ours[i].value())), Rational(ours[i].error())) << seed << " " << i;
            }
        } catch (const Undecided&) {
            ++undecided;  // a divisor that it cannot tell from zero
        }
    }
    EXPECT_LT(undecided, trials / 10) << "else nothing was tested";
}

TEST(Bounded, DoesNotAnswerWhatItCannotTell) {
    const Bounded tenth(0.1);
    const Bounded three_tenths = tenth + tenth + tenth;  // 0.30000000000000004 with a bound
    EXPECT_THROW((void)(three_tenths < Bounded(0.30000000000000004)), Undecided);
    EXPECT_TRUE(three_tenths < Bounded(0.31));
    EXPECT_TRUE(Bounded(0.25) == Bounded(0.25)) << "two doubles without error";
    EXPECT_THROW(tenth / (three_tenths - three_tenths), Undecided);
}

TEST(Bounded, UnderflowAndOverflowAreUndecided) {
    const Bounded tiny(1e-200);
    EXPECT_THROW((void)(tiny * tiny > Bounded(0.0)), Undecided) << "1e-400 is 0 in double, not in truth";
    const Bounded huge(1e200);
    EXPECT_THROW((void)(huge * huge - huge * huge < Bounded(1.0)), Undecided) << "infinite minus infinite";
}

TEST(Interval, HoldsTheExactValue) {
    const Interval::Upward upward;
    for (unsigned seed = 0; seed < trials; ++seed) {
        const Expression expression(seed, 5, 12, 6);
        const auto possible = expression.possible<Fraction>();
        const auto accept = [&](size_t i, const auto&) { return bool(possible[i]); };
        const auto ours = expression.values<Interval>(accept);
        const auto exact = expression.values<Rational>(accept);
        for (size_t i = 0; i < ours.size(); ++i)
            ASSERT_TRUE(within(exact[i], ours[i].low(), ours[i].high())) << seed << " " << i;
    }
}

TEST(Interval, APointWhereTheOperationsAreExact) {
    const Interval::Upward upward;
    const Interval half(0.5);
    EXPECT_TRUE(half * half == Interval(0.25));
    EXPECT_THROW((void)(Interval(0.1) * Interval(0.1) == Interval(0.010000000000000002)), Undecided);
}

}  // namespace
}  // namespace type21::reference
