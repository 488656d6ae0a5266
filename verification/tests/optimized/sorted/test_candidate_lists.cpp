// Lists of candidates: complete up to the margin, by comparison with a test of every node against every box.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <tbb/global_control.h>

#include <gtest/gtest.h>

#include "optimized/search/sorted/candidate_lists.h"

namespace type21::optimized {
namespace {

/// Boxes of one size all over a cube, and for each kind of trouble a few more.
std::vector<Box> boxes_in_a_cube(int count, double side, double size, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0, side), share(0.2, 1);
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        const V3 low{place(random), place(random), place(random)};
        boxes.push_back({low, low + V3{size * share(random), size * share(random), size * share(random)}});
    }
    // One that holds everything, one that is flat, a long strip, and one far away.
    boxes.push_back({{-side, -side, -side}, {2 * side, 2 * side, 2 * side}});
    boxes.push_back({{0, 0, 0.5 * side}, {side, side, 0.5 * side}});
    boxes.push_back({{-side, 0.3 * side, 0.3 * side}, {2 * side, 0.3 * side + size, 0.3 * side + size}});
    boxes.push_back({{100 * side, 0, 0}, {101 * side, side, side}});
    return boxes;
}

/// Some nodes in a cube, some crowded in a corner of it, some far outside.
std::vector<V3> nodes_in_a_cube(int count, double side, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> place(0, side);
    std::vector<V3> nodes;
    for (int i = 0; i < count; ++i) {
        const double scale = i % 3 == 0 ? 0.01 : (i % 50 == 1 ? 20 : 1);
        nodes.push_back({scale * place(random), scale * place(random), scale * place(random)});
    }
    nodes.insert(nodes.end(), 40, nodes.front());  // more on one place than a group holds
    return nodes;
}

std::vector<int> near_by_hand(const std::vector<Box>& boxes, const V3& y, double margin) {
    std::vector<int> found;
    for (size_t s = 0; s < boxes.size(); ++s) {
        Box grown = boxes[s];
        grown.grow(margin);
        if (grown.holds(y)) found.push_back(static_cast<int>(s));
    }
    return found;
}

TEST(CandidateLists, HaveEveryGrownBoxThatHoldsTheNode) {
    for (const double margin : {0.0, 0.01, 0.3, 5.0}) {
        const std::vector<Box> boxes = boxes_in_a_cube(400, 4, 0.5, 1);
        const std::vector<V3> nodes = nodes_in_a_cube(3000, 4, 2);
        CandidateLists lists(boxes, margin);
        lists.sort(nodes);
        for (size_t i = 0; i < nodes.size(); ++i) {
            const auto list = lists.of(i);
            const std::vector<int> found = near_by_hand(boxes, nodes[i], margin);
            ASSERT_TRUE(std::is_sorted(list.begin(), list.end()));
            ASSERT_TRUE(std::includes(list.begin(), list.end(), found.begin(), found.end())) << "node " << i;
            // A list of its own has no more than that; a shared one is not twice as long.
            if (margin < 1) {
                ASSERT_LE(list.size(), found.size() > 16 ? 2 * found.size() : found.size()) << "node " << i;
            }
        }
    }
}

TEST(CandidateLists, CoverANodeUpToTheMarginAndNoFarther) {
    const std::vector<Box> boxes{{{0, 0, 0}, {8, 8, 8}}};
    CandidateLists lists(boxes, 0.25);
    const V3 from{1, 2, 3};
    lists.sort({from});
    for (const double way : {0.25, -0.25}) {
        EXPECT_TRUE(lists.covers(0, from + V3{way, 0, 0}));
        EXPECT_TRUE(lists.covers(0, from + V3{0, way, 0}));
        EXPECT_TRUE(lists.covers(0, from + V3{way, -way, way}));
        const auto farther = [&](double x) { return std::nextafter(x + way, x + 2 * way); };
        EXPECT_FALSE(lists.covers(0, {farther(from.x), from.y, from.z}));
        EXPECT_FALSE(lists.covers(0, {from.x, farther(from.y), from.z}));
        EXPECT_FALSE(lists.covers(0, {from.x, from.y, farther(from.z)}));
    }
}

// The box begins just beyond the margin, so it is not in the list. Twice the margin away the node would be in it.
TEST(CandidateLists, LeaveOutWhatANodeCannotReach) {
    const std::vector<Box> boxes{{{0, 0, 0}, {1, 1, 1}}, {{1.5, 0, 0}, {2, 1, 1}}};
    CandidateLists lists(boxes, 0.25);
    lists.sort({{1.125, 0.5, 0.5}});
    EXPECT_EQ(std::vector<int>(lists.of(0).begin(), lists.of(0).end()), std::vector<int>{0});
    EXPECT_FALSE(lists.covers(0, {1.5, 0.5, 0.5}));
    lists.sort({{1.25, 0.5, 0.5}});
    EXPECT_EQ(lists.of(0).size(), 2U);
    EXPECT_TRUE(lists.covers(0, {1.5, 0.5, 0.5}));
}

// Far from the origin the ways are a few units in the last place, and each difference is rounded.
TEST(CandidateLists, AreCompleteWhereRoundingIsAsLargeAsTheMargin) {
    std::mt19937_64 random(3);
    for (const double origin : {1e3, 1e6, -3e7}) {
        const double ulp = std::nextafter(std::abs(origin), 1e9) - std::abs(origin);
        std::uniform_int_distribution<int> steps(-12, 12);
        const auto place = [&] { return origin + ulp * steps(random); };
        for (int trial = 0; trial < 3000; ++trial) {
            std::vector<Box> boxes(3);
            for (Box& box : boxes) {
                box.extend(V3{place(), place(), place()});
                box.extend(V3{place(), place(), place()});
            }
            // Margins that are no multiples of an ulp, so that "low - margin" is rounded.
            CandidateLists lists(boxes, ulp * (0.3 + 0.37 * std::abs(steps(random))));
            const V3 before{place(), place(), place()}, now{place(), place(), place()};
            lists.sort({before});
            if (!lists.covers(0, now)) continue;
            for (const int s : near_by_hand(boxes, now, 0))
                ASSERT_TRUE(std::binary_search(lists.of(0).begin(), lists.of(0).end(), s)) << origin << " " << trial;
        }
    }
}

// The way from -1e-18 to 0.25 is 0.25 when it is rounded. So the node is covered, and the box must be in the list.
TEST(CandidateLists, AreCompleteWhereTheWayIsRoundedDown) {
    const std::vector<Box> boxes{{{0.25, 0, 0}, {1, 1, 1}}};
    CandidateLists lists(boxes, 0.25);
    lists.sort({{-1e-18, 0.5, 0.5}});
    ASSERT_TRUE(lists.covers(0, {0.25, 0.5, 0.5}));
    EXPECT_EQ(lists.of(0).size(), 1U);
}

TEST(CandidateLists, ANodeOutsideOfAllBoxesNeedsNoList) {
    const double inf = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Box> boxes{{{0, 0, 0}, {1, 1, 1}}};
    CandidateLists lists(boxes, 0.25);
    lists.sort({{50, 0, 0}, {nan, 0, 0}, {inf, 0, 0}, {0.5, 0.5, 0.5}});
    for (const size_t i : {0U, 1U, 2U})
        EXPECT_TRUE(lists.of(i).empty());
    EXPECT_EQ(lists.of(3).size(), 1U);
    for (const V3& away : {V3{80, 0, 0}, V3{nan, nan, nan}, V3{-inf, 0, 0}})
        for (const size_t i : {0U, 1U, 2U, 3U})
            EXPECT_TRUE(lists.covers(i, away));
    // Back in the box it does.
    for (const size_t i : {0U, 1U, 2U})
        EXPECT_FALSE(lists.covers(i, {0.5, 0.5, 0.5}));
}

TEST(CandidateLists, AHugeMarginNeedsNoMemoryForEachPair) {
    const std::vector<Box> boxes = boxes_in_a_cube(2000, 4, 0.5, 4);
    const std::vector<V3> nodes = nodes_in_a_cube(4000, 4, 5);
    CandidateLists lists(boxes, 1e6);
    lists.sort(nodes);
    for (size_t i = 0; i < nodes.size(); ++i)
        ASSERT_EQ(lists.of(i).size(), boxes.size());
    // A place, a span, and a share of a group for each node, and the list once.
    EXPECT_LT(lists.bytes(), nodes.size() * 60 + 2 * boxes.size() * sizeof(int));
}

TEST(CandidateLists, AreTheSameForAnyNumberOfThreads) {
    const std::vector<Box> boxes = boxes_in_a_cube(3000, 4, 0.2, 6);
    const std::vector<V3> nodes = nodes_in_a_cube(20000, 4, 7);
    std::vector<std::vector<int>> one;
    for (const size_t threads : {1U, 2U, 4U}) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        CandidateLists lists(boxes, 0.1);
        lists.sort(nodes);
        std::vector<std::vector<int>> all;
        for (size_t i = 0; i < nodes.size(); ++i)
            all.emplace_back(lists.of(i).begin(), lists.of(i).end());
        if (one.empty()) one = all;
        EXPECT_TRUE(all == one) << threads;
    }
}

}  // namespace
}  // namespace type21::optimized
