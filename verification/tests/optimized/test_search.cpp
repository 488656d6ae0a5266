// The search with its certificates against every sub-triangle of the tool in integers.
#include <gtest/gtest.h>

#include "optimized/search/search.h"
#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized {
namespace {

using testing::exhaustive;
using testing::grid;
using testing::same;

struct Surface {
    const char* name;
    std::function<Tool()> make;
};

std::vector<Surface> surfaces() {
    return {
        {"flat", [] { return grid(4, [](double, double) { return 0.0; }); }},
        {"bowl",
         [] {
             return grid(
                 6, [](double x, double y) { return 0.5 * (x * x + y * y); }, false, 0.2);
         }},
        {"ridge",
         [] {
             return grid(
                 6, [](double x, double) { return -std::abs(x); }, true, 0.1);
         }},
        {"wavy",
         [] {
             return grid(
                 6, [](double x, double y) { return 0.3 * std::sin(4 * x) * std::cos(3 * y); }, true);
         }},
        {"steep",
         [] {
             return grid(
                 4, [](double x, double y) { return 2 * x * x * x + y; }, false, 0.3);
         }},
        {"coarse", [] { return grid(2, [](double x, double y) { return 0.8 * x * y; }); }},
    };
}

class SearchOf : public ::testing::TestWithParam<int> {};

TEST_P(SearchOf, EqualsTheExhaustiveOneWhateverTheMotion) {
    const Tool tool = surfaces()[static_cast<size_t>(GetParam())].make();
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> unit(-1, 1);
    int exclusive = 0, separated = 0, taken = 0;
    for (const bool lift : {false, true}) {
        for (const double proximity : {0.0, 0.3}) {
            ProjectionLimits rules;
            rules.lift_leaning = lift;
            rules.proximity_competes = lift;
            const CaptureLimits limits{std::max(0.2, proximity), 0.25, 0.01, lift};
            const Search search(tool, limits, {});
            for (int path = 0; path < 8; ++path) {
                // Small steps, now and then a leap; the node's own gap is anything up to the largest.
                Memory memory;
                V3 y{1.2 * unit(random), 1.2 * unit(random), unit(random)};
                V3 step{0.01 * unit(random), 0.01 * unit(random), 0.01 * unit(random)};
                const ContactReach reach{0.2 * std::abs(unit(random)), 0.25, proximity};
                for (int i = 0; i < 40; ++i) {
                    if (i % 16 == 15) y = V3{unit(random), unit(random), 0.5 * unit(random)};
                    y = y + step;
                    if (i % 9 == 4) y = V3{std::round(y.x * 4) / 4, std::round(y.y * 4) / 4, y.z};
                    const Search::NodeQuery query{y, reach, &memory};
                    Search::Found found;
                    search.find(&query, 1, rules, &found);
                    ASSERT_TRUE(same(found.retained, exhaustive(tool, y, reach, rules)))
                        << "path " << path << " step " << i << " at " << y.x << " " << y.y << " " << y.z;
                    if (found.retained.exists()) {
                        // A node without a past has the same bits.
                        Memory fresh;
                        const ProjectionResult &one = found.retained.projection,
                                               &other = search.find(y, reach, rules, fresh).retained.projection;
                        ASSERT_EQ(one.b, other.b);
                        ASSERT_EQ(one.c, other.c);
                        ASSERT_EQ(one.lift, other.lift);
                        ASSERT_EQ(one.normal.x, other.normal.x);
                        ASSERT_EQ(one.normal.z, other.normal.z);
                    }
                    exclusive += found.path == Path::exclusive_region;
                    separated += found.path == Path::separated;
                    taken += found.retained.exists();
                }
            }
        }
    }
    EXPECT_GT(taken, 100);
    EXPECT_GT(separated, 20);
    RecordProperty("exclusive_region", exclusive);
}

INSTANTIATE_TEST_SUITE_P(Surfaces, SearchOf, ::testing::Range(0, 6),
                         [](const auto& i) { return std::string(surfaces()[static_cast<size_t>(i.param)].name); });

TEST(ExclusiveRegions, CoverMostOfAFineMesh) {
    // On a fine, smooth mesh only the band of 1 % along the edges needs a search: three bands of about 3 % of the area.
    const Tool tool = grid(40, [](double x, double y) { return 0.05 * (x * x + y * y); });
    const Search search(tool, {0.05, 0.05, 0.01, false}, {});
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(-0.9, 0.9);
    int exclusive = 0;
    constexpr int nodes = 2000;
    for (int i = 0; i < nodes; ++i) {
        Memory memory;
        const double x = unit(random), y = unit(random);
        const V3 at{x, y, 0.05 * (x * x + y * y) + 0.02};
        search.find(at, {0.05, 0.05, 0}, {}, memory);
        const Search::NodeQuery query{at, {0.05, 0.05, 0}, &memory};
        Search::Found found;
        search.find(&query, 1, {}, &found);
        exclusive += found.path == Path::exclusive_region;
    }
    EXPECT_GT(exclusive, nodes * 85 / 100);
}

}  // namespace
}  // namespace type21::optimized
