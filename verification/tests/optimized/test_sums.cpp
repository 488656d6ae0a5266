// Exact sums: the bits of the reference's expansions, in any order and any blocks.
#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "optimized/sums/exact_accumulator.h"
#include "reference/contact/exact_sum.h"

namespace type21 {
namespace {

std::vector<double> numbers(int n, int exponents, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-1, 1);
    std::uniform_int_distribution<int> exponent(-exponents, exponents);
    std::vector<double> v;
    for (int i = 0; i < n; ++i)
        v.push_back(std::ldexp(unit(random), exponent(random)));
    return v;
}

double expansion(const std::vector<double>& v) {
    ExactSum sum;
    for (const double x : v)
        sum.add(x);
    return sum.value();
}

TEST(ExactAccumulator, HasTheBitsOfTheExpansionInAnyOrder) {
    std::mt19937_64 random(3);
    for (const int exponents : {0, 5, 40, 300}) {
        for (int n = 1; n < 600; n = 2 * n + 1) {
            std::vector<double> v = numbers(n, exponents, random);
            // A sum that nearly cancels.
            for (int i = 0; i + 1 < n; i += 2)
                if (i % 4 == 0) v[static_cast<size_t>(i) + 1] = -v[static_cast<size_t>(i)] * (1 + 0x1p-50);
            const double truth = expansion(v);
            optimized::ExactAccumulator forward, blocks, merged;
            for (const double x : v)
                forward.add(x);
            EXPECT_EQ(forward.value(), truth);
            std::shuffle(v.begin(), v.end(), random);
            const int half = n / 3;
            blocks.add_block(v.data(), half);
            blocks.add_block(v.data() + half, n - half);
            EXPECT_EQ(blocks.value(), truth) << n << " " << exponents;
            for (int i = half; i < n; ++i)
                merged.add(v[static_cast<size_t>(i)]);
            optimized::ExactAccumulator other;
            other.add_block(v.data(), half);
            merged.add(other);
            EXPECT_EQ(merged.value(), truth);
        }
    }
}

TEST(ExactAccumulator, KeepsWhatLiesFarBelowTheLargestOfABlock) {
    std::vector<double> v(16, 0.0);
    v[0] = 1;
    v[3] = -1;
    v[7] = 0x1p-200;
    v[9] = 0x1p-119 * 3;
    v[11] = -0x1p-119 * 3;
    optimized::ExactAccumulator sum;
    sum.add_block(v.data(), 16);
    EXPECT_EQ(sum.value(), 0x1p-200);
}

/// A block is quick when it is like those before: what is not must be seen.
TEST(ExactAccumulator, SeesWhatABlockHasThatOthersHadNot) {
    std::mt19937_64 random(4);
    const double odd[] = {0.0,      -0.0,    0x1.8p-95, -0x1.23456789abcdep-30, 0x1.fp-27, 0x1.7p3, 0x1.8p4,
                          -0x1.1p5, 0x1p200, 0x1p-1070, 0x1.fffffffffffffp-41};
    for (const double one : odd) {
        for (const size_t at : {0, 7, 40, 63}) {
            optimized::ExactAccumulator sum;
            std::vector<double> all;
            for (int block = 0; block < 5; ++block) {
                std::vector<double> v = numbers(64, 2, random);
                // Large ones cancel: what small ones left must still be there.
                if (block == 3) v[at] = one, v[(at + 16) % 64] = -one;
                for (size_t i = 0; block == 4 && i < 64; ++i)
                    v[i] = i < 32 ? one : -one;
                sum.add_block(v.data(), 64);
                all.insert(all.end(), v.begin(), v.end());
            }
            EXPECT_EQ(sum.value(), expansion(all)) << one << " " << at;
        }
    }
    for (const double one : {HUGE_VAL, -HUGE_VAL, std::nan("")}) {
        optimized::ExactAccumulator sum;
        std::vector<double> v = numbers(64, 2, random);
        sum.add_block(v.data(), 64);
        v[33] = one;
        sum.add_block(v.data(), 64);
        EXPECT_TRUE(std::isnan(one) ? std::isnan(sum.value()) : sum.value() == one);
    }
}

/// So many blocks of one sign that a double cannot hold the slices of a lane.
TEST(ExactAccumulator, HoldsManyBlocks) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(1.9, 2);
    optimized::ExactAccumulator sum, one_by_one;
    for (int block = 0; block < 100000; ++block) {
        std::vector<double> v(64);
        for (double& x : v)
            one_by_one.add(x = unit(random));
        sum.add_block(v.data(), 64);
    }
    EXPECT_EQ(sum.value(), one_by_one.value());
}

TEST(ExactAccumulator, RoundsOnceToNearestEven) {
    const auto sum = [](std::initializer_list<double> v) {
        optimized::ExactAccumulator a;
        for (const double x : v)
            a.add(x);
        return a.value();
    };
    EXPECT_EQ(sum({1, 0x1p-53}), 1.0);                     // half a unit: to even
    EXPECT_EQ(sum({1, 0x1p-53, 0x1p-1000}), 1 + 0x1p-52);  // a little more than half
    EXPECT_EQ(sum({1 + 0x1p-52, 0x1p-53}), 1 + 0x1p-51);   // half, from odd
    EXPECT_EQ(sum({-1, -0x1p-53, -0x1p-1074}), -(1 + 0x1p-52));
    EXPECT_EQ(sum({5e-324, 5e-324}), 1e-323);
    EXPECT_EQ(sum({1e308, 1e308, -1e308}), 1e308);  // beyond the range on the way
    EXPECT_EQ(sum({1e300, 1, -1e300}), 1);
    EXPECT_TRUE(std::isnan(sum({std::nan(""), 1})));
}

}  // namespace
}  // namespace type21
