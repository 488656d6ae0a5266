// Normals that lie exactly in the plane of a sub-triangle at their corner: there a node in that plane is not lifted,
// and what holds of lifted corners does not hold of these.
#include <gtest/gtest.h>

#include "optimized/search/search.h"
#include "verification/tests/optimized/lattice_tools.h"

namespace type21::optimized {
namespace {

using testing::exhaustive;
using testing::OnALattice;
using testing::same;

/// Decides the node by a full search, and with each sub-triangle in memory.
void expect_exact(const Tool& tool, const Search& search, const V3& y, const ContactReach& reach,
                  const Retained& expected) {
    EXPECT_TRUE(same(search.search(y, reach, {}), expected)) << "by a full search";
    std::vector<SubTriangleId> remembered{SubTriangleId::none()};
    for (int segment = 0; segment < tool.size(); ++segment)
        for (int k = 1; k <= (tool.is_triangle(segment) ? 1 : 4); ++k)
            remembered.emplace_back(segment, k);
    for (const SubTriangleId id : remembered) {
        Memory memory;
        memory.look_at(id);
        const Search::NodeQuery query{y, reach, &memory};
        Search::Found found;
        // Twice: what the first call remembers is what the second one begins with.
        for (int time = 0; time < 2; ++time) {
            search.find(&query, 1, {}, &found);
            ASSERT_TRUE(same(found.retained, expected)) << "from " << id.code() << ", time " << time;
        }
    }
}

/// Two walls of opposite orientation in one plane, which share a corner V of a sloped floor. They cancel at V, so n_V
/// lies in their plane.
TEST(VerticalWalls, ThatShareACornerWithAFloorAreNotTiedWithIt) {
    const std::vector<V3> position{{0, 0, 0}, {1, -1, -0.75}, {1, 1, 0.75}, {-1, 1, 0.75}, {-1, -1, -0.75},
                                   {0, 0, 2}, {0, -2, 0},     {0, 3, 0},    {0, 3, -2}};
    const std::vector<std::array<int, 4>> corner{{1, 2, 0, 0}, {2, 3, 0, 0}, {3, 4, 0, 0},
                                                 {4, 1, 0, 0}, {5, 6, 0, 0}, {7, 8, 0, 0}};
    const Tool tool(position, nodal_normals(position, corner), corner);
    ASSERT_EQ(tool.normal(0, 2).x, 0);
    const Search search(tool, {1, 1, 0.01, false}, {});
    const V3 p = tool.normal(0, 2) * 0.5;
    EXPECT_EQ(exhaustive(tool, p, {1, 1, 0}, {}).id.segment(), 4);
    for (const double x : {0.0, 0x1p-1074, -0x1p-1074, 0x1p-53, -0x1p-53})
        expect_exact(tool, search, {x, p.y, p.z}, {1, 1, 0}, exhaustive(tool, {x, p.y, p.z}, {1, 1, 0}, {}));
}

/// A warped quad: the normal of its centre lies in the planes of its sub-triangles 1 and 4. A node on it lies on the
/// diagonal to the first corner, and sub-triangle 4 takes it there; 2 takes it above the centre.
TEST(VerticalWalls, InAQuadAreNotTiedWithTheOthersAboveItsCentre) {
    const std::vector<V3> position{{1, -1, 1}, {1, 1, -1}, {-1, 1, 1}, {-1, -1, -1}};
    const std::vector<V3> normal{{0, -2, 1}, {2, 0, 1}, {1, -1, 1}, {1, -1, 1}};  // their mean is (1, -1, 1)
    const Tool tool(position, normal, {{0, 1, 2, 3}});
    const Search search(tool, {2, 2, 0.01, false}, {});
    EXPECT_EQ(exhaustive(tool, {0.5, -0.5, 0.5}, {2, 2, 0}, {}).id.triangle(), 4);
    EXPECT_EQ(exhaustive(tool, {0.5, -0.5, 0.5 + 0x1p-53}, {2, 2, 0}, {}).id.triangle(), 2);
    for (const double t : {0.25, 0.5, -0.5})
        for (const double beside : {0.0, 0x1p-53, -0x1p-53})
            expect_exact(tool, search, {t, -t, t + beside}, {2, 2, 0},
                         exhaustive(tool, {t, -t, t + beside}, {2, 2, 0}, {}));
}

TEST(VerticalWalls, OfManySmallToolsAreDecidedExactly) {
    int contact = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        OnALattice lattice(seed);
        const Tool tool = lattice.tool();
        const double gap = 0.5 * (1 + lattice.below(4));
        const Search search(tool, {gap, gap, 0.01, false}, {});
        for (int i = 0; i < 16; ++i) {
            const V3 y = lattice.node(tool);
            const ContactReach reach{gap, gap, 0};
            const Retained exact = exhaustive(tool, y, reach, {});
            expect_exact(tool, search, y, reach, exact);
            ASSERT_FALSE(HasFailure()) << "seed " << seed << ", node " << i;
            contact += exact.exists();
        }
    }
    EXPECT_GT(contact, 600);
}

}  // namespace
}  // namespace type21::optimized
