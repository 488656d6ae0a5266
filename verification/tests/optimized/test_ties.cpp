// Nodes on vertices, edges and along the diagonals of structured meshes: the ties that are proven must be ties.
#include <gtest/gtest.h>

#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized {
namespace {

using testing::exhaustive;
using testing::grid;
using testing::same;

Retained decide(const Tool& tool, const V3& p, const Window& window) {
    Decider decider(p, window, {});
    for (int s = 0; s < tool.size(); ++s)
        decider.add(s, tool.segment(s));
    return decider.retained([&](int s) { return tool.segment(s); });
}

struct Count {
    int taken = 0, tie = 0, whole = 0;
};

/// Nodes at multiples of `part` of an edge over a grid of 4 x 4 quads (edges 1/2), and a little beside them.
Count compare(const Tool& tool, double part, double height) {
    Count count;
    const Window window{0.25, 0.25, 0};
    for (double x = -1; x <= 1; x += part) {
        for (double y = -1; y <= 1; y += part) {
            for (const double beside : {0.0, 1.0 / 1024}) {
                const V3 p{x + beside, y, height};
                const Retained found = decide(tool, p, window);
                EXPECT_TRUE(same(found, exhaustive(tool, p, window, {}))) << x << " " << y << " " << beside;
                count.taken += found.segment >= 0;
                count.tie += found.settled == Settled::tie;
                count.whole += found.settled == Settled::whole;
            }
        }
    }
    return count;
}

TEST(Ties, OfAFlatGridAreProvenWithoutWholeNumbers) {
    for (const bool triangles : {false, true}) {
        const Tool tool = grid(
            4, [](double, double) { return 0.0; }, triangles);
        const Count count = compare(tool, 0.125, 0.125);
        EXPECT_GT(count.taken, 500);
        EXPECT_GT(count.tie, triangles ? 30 : 100);
        EXPECT_LT(count.whole, count.taken / 4);
    }
}

TEST(Ties, OfACylinderAreThoseOfWholeNumbers) {
    const Tool tool = grid(4, [](double x, double) { return 0.25 * x * x; });
    const Count count = compare(tool, 0.125, 0.25);
    EXPECT_GT(count.taken, 300);
    EXPECT_GT(count.tie, 10);
}

}  // namespace
}  // namespace type21::optimized
