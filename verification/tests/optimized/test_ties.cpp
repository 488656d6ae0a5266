// Nodes on vertices, edges and along the diagonals of structured meshes: the ties that are proven must be ties.
#include <gtest/gtest.h>

#include "optimized/search/search.h"
#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized {
namespace {

using testing::exhaustive;
using testing::grid;
using testing::same;

Retained decide(const Tool& tool, const V3& p, const ContactReach& reach) {
    Decider decider(p, reach, {});
    for (int s = 0; s < tool.size(); ++s)
        decider.add(s, tool.segment(s));
    return decider.retained([&](int s) { return tool.segment(s); });
}

struct Count {
    int taken = 0, tie = 0, integer = 0;
};

/// Nodes at multiples of `part` of an edge over a grid of 4 x 4 quads (edges 1/2), and a little beside them.
Count compare(const Tool& tool, double part, double height) {
    Count count;
    const ContactReach reach{0.25, 0.25, 0};
    for (double x = -1; x <= 1; x += part) {
        for (double y = -1; y <= 1; y += part) {
            for (const double beside : {0.0, 1.0 / 1024}) {
                const V3 p{x + beside, y, height};
                const Retained found = decide(tool, p, reach);
                EXPECT_TRUE(same(found, exhaustive(tool, p, reach, {}))) << x << " " << y << " " << beside;
                count.taken += found.exists();
                count.tie += found.settled == Settled::tie;
                count.integer += found.settled == Settled::integer;
            }
        }
    }
    return count;
}

TEST(Ties, OfAFlatGridAreProvenWithoutIntegers) {
    for (const bool triangles : {false, true}) {
        const Tool tool = grid(
            4, [](double, double) { return 0.0; }, triangles);
        const Count count = compare(tool, 0.125, 0.125);
        EXPECT_GT(count.taken, 500);
        EXPECT_GT(count.tie, triangles ? 30 : 100);
        EXPECT_LT(count.integer, count.taken / 4);
    }
}

TEST(Ties, OfACylinderAreThoseOfIntegers) {
    const Tool tool = grid(4, [](double x, double) { return 0.25 * x * x; });
    const Count count = compare(tool, 0.125, 0.25);
    EXPECT_GT(count.taken, 300);
    EXPECT_GT(count.tie, 10);
}

/// A plane of n x n quads of edge 1 that rises with x, its normals of a length that keeps them exact.
Tool slope(int n, double rise) {
    std::vector<V3> position;
    std::vector<std::array<int, 4>> corner;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            position.push_back({double(i), double(j), rise * i});
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
            corner.push_back({j * (n + 1) + i, j * (n + 1) + i + 1, (j + 1) * (n + 1) + i + 1, (j + 1) * (n + 1) + i});
    std::vector<V3> normal(position.size(), V3{-rise, 0, 1});
    return {position, normal, corner};
}

/// Where on a quad: its centre, a corner, the middle of an edge, half way from the centre to a corner.
constexpr std::array<std::array<double, 2>, 4> spots{{{0.5, 0.5}, {0, 0}, {0.5, 0}, {0.25, 0.25}}};

TEST(Ties, OverCentresCornersEdgesAndDiagonalsAreProven) {
    const ContactReach reach{0.25, 0.25, 0};
    for (const double rise : {0.0, 0.5}) {
        const Tool tool = slope(4, rise);
        // 0.1 keeps P - V from being a double.
        for (const double height : {0.125, -0.125, rise == 0 ? 0.1 : 0.0625}) {
            for (const auto& [u, v] : spots) {
                const V3 p{1 + u - rise * height, 2 + v, rise * (1 + u) + height};
                const Retained found = decide(tool, p, reach);
                ASSERT_TRUE(found.exists());
                EXPECT_EQ(found.settled, Settled::tie) << rise << " " << height << " " << u << " " << v;
                EXPECT_TRUE(same(found, exhaustive(tool, p, reach, {})));
                // A little beside there is no tie.
                const V3 beside{p.x, std::nextafter(p.y, 0.0), p.z};
                EXPECT_TRUE(same(decide(tool, beside, reach), exhaustive(tool, beside, reach, {})));
            }
        }
    }
}

TEST(Ties, AreFoundAgainWithoutTheTree) {
    const ContactReach reach{0.25, 0.25, 0};
    for (const double rise : {0.0, 0.5}) {
        const Tool tool = slope(4, rise);
        const Search search(tool, {0.25, 0.25, 0.01, false}, {});
        for (const auto& [u, v] : spots) {
            Memory memory;
            for (int step = 0; step < 3; ++step) {
                const double height = std::ldexp(0.125, -step);
                const V3 y{1 + u - rise * height, 2 + v, rise * (1 + u) + height};
                Search::NodeQuery query{y, reach, &memory};
                Search::Found found;
                search.find(&query, 1, {}, &found);
                EXPECT_EQ(found.path == Path::searched, step == 0) << rise << " " << u << " " << v;
                EXPECT_EQ(found.retained.settled, Settled::tie) << rise << " " << u << " " << v;
                EXPECT_TRUE(same(found.retained, exhaustive(tool, y, reach, {})));
            }
        }
    }
}

TEST(Ties, ARememberedSubTriangleThatDoesNotLeadIsLeft) {
    const ContactReach reach{0.25, 0.25, 0};
    const Tool tool = slope(4, 0);
    const Search search(tool, {0.25, 0.25, 0.01, false}, {});
    for (const auto& [u, v] : spots) {
        const V3 y{1 + u, 2 + v, 0.125};
        for (int code = 0; code < 4 * tool.size(); ++code) {
            Memory memory;
            memory.look_at(SubTriangleId::from_code(code));
            Search::NodeQuery query{y, reach, &memory};
            Search::Found found;
            search.find(&query, 1, {}, &found);
            EXPECT_TRUE(same(found.retained, exhaustive(tool, y, reach, {}))) << code;
        }
    }
}

}  // namespace
}  // namespace type21::optimized
