// The tree of boxes against all boxes, one after the other; segments into rows.
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "optimized/search/box_tree.h"
#include "optimized/search/gather.h"
#include "optimized/search/segment_boxes.h"
#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized {
namespace {

std::vector<Box> some_boxes(int count, std::mt19937_64& random) {
    std::uniform_real_distribution<double> at(-1, 1), size(0, 0.2);
    std::vector<Box> boxes;
    for (int i = 0; i < count; ++i) {
        Box box;
        const V3 low{at(random), at(random), at(random)};
        box.extend(low);
        box.extend(low + V3{size(random), size(random), size(random)});
        boxes.push_back(box);
    }
    return boxes;
}

double distance(const Box& box, const V3& y) {
    return norm({std::max({0.0, box.low.x - y.x, y.x - box.high.x}), std::max({0.0, box.low.y - y.y, y.y - box.high.y}),
                 std::max({0.0, box.low.z - y.z, y.z - box.high.z})});
}

class BoxTreeOf : public ::testing::TestWithParam<int> {};

TEST_P(BoxTreeOf, FindsWhatAllBoxesSay) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> at(-1.2, 1.2);
    const std::vector<Box> boxes = some_boxes(GetParam(), random);
    for (const SimdWidth machine : {SimdWidth::two, SimdWidth::four}) {
        if (machine > this_machine()) continue;
        const BoxTree tree(boxes, machine);
        for (int q = 0; q < 60; ++q) {
            const V3 y{at(random), at(random), at(random)};
            for (const double around : {0.0, 0.05, 0.4}) {
                std::set<int> found, near;
                tree.within(y, around, [&](int rank, double apart) {
                    EXPECT_TRUE(found.insert(rank).second);
                    const double exact = distance(boxes[static_cast<size_t>(rank)], y);
                    EXPECT_LE(apart, exact);
                    EXPECT_GE(apart, exact * (1 - 1e-5) - 1e-6);
                    EXPECT_LE(exact, around * (1 + 1e-5) + 1e-6);
                });
                tree.near(
                    y, [&] { return around; }, [&](int rank, double) { near.insert(rank); });
                for (size_t i = 0; i < boxes.size(); ++i) {
                    const double exact = distance(boxes[i], y);
                    EXPECT_TRUE(exact > around || found.contains(static_cast<int>(i)));
                    EXPECT_TRUE(exact >= around || near.contains(static_cast<int>(i)));
                }
            }
            Box box;
            box.extend(y);
            box.extend(y + V3{0.3, 0.1, 0.2});
            std::set<int> meeting;
            tree.meeting(box, [&](int rank) { meeting.insert(rank); });
            for (size_t i = 0; i < boxes.size(); ++i)
                EXPECT_TRUE(!boxes[i].meets(box) || meeting.contains(static_cast<int>(i)));
        }
    }
}

TEST_P(BoxTreeOf, KeepsTheNearestWhenTheLimitShrinks) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> at(-2, 2);
    const std::vector<Box> boxes = some_boxes(GetParam(), random);
    const BoxTree tree(boxes);
    for (int q = 0; q < 60; ++q) {
        const V3 y{at(random), at(random), at(random)};
        double least = HUGE_VAL, all = HUGE_VAL;
        tree.near(
            y, [&] { return least; },
            [&](int rank, double) { least = std::min(least, distance(boxes[static_cast<size_t>(rank)], y)); });
        for (const Box& box : boxes)
            all = std::min(all, distance(box, y));
        EXPECT_EQ(least, all);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, BoxTreeOf, ::testing::Values(0, 1, 2, 7, 8, 9, 64, 65, 513, 4100));

TEST(BoxTree, HidesNothingFarAwayOrHuge) {
    std::vector<Box> boxes(3);
    for (size_t i = 0; i < 3; ++i) {
        const double far = std::array<double, 3>{1e20, 1e39, 1.0}[i];
        boxes[i].extend(V3{far, -far, far});
        boxes[i].extend(V3{2 * far, -far, far});
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 3; ++i) {
        std::set<int> found, near;
        tree.at(boxes[static_cast<size_t>(i)].low, [&](int rank) { found.insert(rank); });
        tree.near(
            boxes[static_cast<size_t>(i)].middle(), [] { return 1e300; }, [&](int rank, double) { near.insert(rank); });
        EXPECT_TRUE(found.contains(i));
        EXPECT_TRUE(near.contains(i));
        for (const int rank : found)
            EXPECT_TRUE(0 <= rank && rank < 3);
    }
}

TEST(BoxTree, HidesNothingTinyOrBeyondSquares) {
    const double small = std::ldexp(1.0, -75) * 1.035;
    for (const double size : {small, 2e19}) {
        std::vector<Box> boxes(1);
        boxes[0].extend(V3{size, size, size});
        const double exact = std::sqrt(3.0) * size;
        int found = 0;
        BoxTree(boxes).within({0, 0, 0}, 1.0001 * exact, [&](int, double apart) {
            ++found;
            EXPECT_LE(apart, exact);
        });
        EXPECT_EQ(found, 1) << size;
    }
}

/// Quads, triangles and both in one tool; slivers and normals that lean far, where prisms are grown.
TEST(SegmentBoxes, HoldThePrismsAndHardlyMore) {
    const CaptureLimits limits{0.1, 0.05, 0.01, false};
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto direction = [&] { return V3{unit(random), unit(random), 1.2}; };
    for (const int kind : {0, 1, 2}) {  // quads, triangles, both
        for (const double thin : {1.0, 1e-4, 1e-13}) {
            for (const bool leans : {false, true}) {
                std::vector<V3> position, normal;
                std::vector<std::array<int, 4>> corner;
                for (int s = 0; s < 61; ++s) {
                    const V3 at{10 * unit(random), 10 * unit(random), unit(random)};
                    const int a = static_cast<int>(position.size());
                    for (const V3& x : {V3{0, 0, 0}, V3{1, 0, 0}, V3{1, 1, 0}, V3{0, 1, 0}}) {
                        const V3 moved{x.x + 0.2 * unit(random), x.y + 0.2 * unit(random), 0.2 * unit(random)};
                        position.push_back(at + V3{moved.x, moved.y * thin, moved.z * thin});
                        const V3 n = leans && s % 3 == 0 ? V3{3, 0, 0.05 * unit(random)} : direction();
                        normal.push_back(n * (1 / norm(n)));
                    }
                    const bool triangle = kind == 1 || (kind == 2 && s % 2 == 0);
                    corner.push_back({a, a + 1, a + 2, triangle ? a + 2 : a + 3});
                }
                const Tool tool(position, normal, corner);
                int exact = 0;
                for (const SimdWidth machine : {SimdWidth::two, SimdWidth::four, SimdWidth::eight}) {
                    if (machine > this_machine()) continue;
                    const std::vector<Box> boxes = segment_boxes(tool, limits, machine);
                    for (int s = 0; s < tool.size(); ++s) {
                        Box prisms, grown;
                        bool all_grown = true;
                        for (int k = 1; k <= tool.segment(s).sub_triangles(); ++k) {
                            CaptureVolume one = capture_volume(tool.segment(s), k, limits);
                            prisms.extend(one.box().low);
                            prisms.extend(one.box().high);
                            all_grown = all_grown && one.distance_only;
                            one.distance_only = true;
                            grown.extend(one.box().low);
                            grown.extend(one.box().high);
                        }
                        const Box& box = boxes[static_cast<size_t>(s)];
                        for (int a = 0; a < 3; ++a) {
                            constexpr double rounding = 1e-12;  // of coordinates up to 11, far below the slack of 1e-7
                            ASSERT_LE(box.low[a], prisms.low[a] + rounding);
                            ASSERT_GE(box.high[a], prisms.high[a] - rounding);
                            ASSERT_GE(box.low[a], grown.low[a] - rounding);
                            ASSERT_LE(box.high[a], grown.high[a] + rounding);
                            exact += !all_grown && box.low[a] >= prisms.low[a] - rounding;
                        }
                    }
                }
                // Where a normal leans back capture_volume() alone sees that nothing is taken off the plane.
                EXPECT_GT(exact, !leans && thin == 1 ? 150 : -1);
            }
        }
    }
}

TEST(Gather, FillsTheSameRowsOnEachMachine) {
    std::mt19937_64 random(2);
    for (const bool triangles : {false, true}) {
        const Tool tool = testing::grid(
            5, [](double x, double y) { return x * y; }, triangles, 0.3);
        for (const int count : {1, 3, 4, 7, 64}) {
            std::vector<SubTriangleId> id;
            for (int i = 0; i < count; ++i)
                id.emplace_back(static_cast<int>(random() % static_cast<unsigned>(tool.size())),
                                triangles ? 1 : 1 + static_cast<int>(random() % 4));
            for (const SimdWidth machine : {SimdWidth::two, SimdWidth::four}) {
                if (machine > this_machine()) continue;
                auto rows = std::make_unique<ProjectionBatch>();
                gather(*rows, tool, id.data(), 0, count, 0.2, machine);
                for (size_t i = 0; i < id.size(); ++i) {
                    const int segment = id[i].segment();
                    for (int j = 0; j < 4; ++j) {
                        for (int a = 0; a < 3; ++a) {
                            EXPECT_EQ(rows->corner[j][a][i], tool.node(segment, j)[a]);
                            EXPECT_EQ(rows->normal[j][a][i], tool.normal(segment, j)[a]);
                        }
                    }
                    EXPECT_EQ(rows->code[i], triangles ? 4 : id[i].triangle() - 1);
                    EXPECT_GT(rows->size[i], tool.extent(segment));
                }
            }
        }
    }
}

}  // namespace
}  // namespace type21::optimized
