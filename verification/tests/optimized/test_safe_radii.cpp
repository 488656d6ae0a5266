// How long a decision holds: safe radii, and the search of many nodes side by side.
#include <gtest/gtest.h>

#include "optimized/search/search.h"
#include "verification/tests/optimized/safe_radius_tools.h"

namespace type21::optimized {
namespace {

using testing::direction;
using testing::exhaustive;
using testing::largest_reach;
using testing::safe_radius_tools;
using testing::same;
using testing::somewhere_over;

void put(const std::vector<V3>& y, double gap, Search::Batch& batch, std::vector<Memory>* memory) {
    batch.count = static_cast<int>(y.size());
    batch.depth = largest_reach;
    batch.memory = memory == nullptr ? nullptr : memory->data();
    for (int i = 0; i < batch.count; ++i) {
        for (int a = 0; a < 3; ++a)
            batch.y[a][i] = y[static_cast<size_t>(i)][a];
        batch.gap[i] = gap;
        batch.active[i] = memory != nullptr;
    }
}

TEST(SafeRadii, HoldWhatIsRetained) {
    std::mt19937_64 random(6);
    const ProjectionLimits rules;
    auto batch = std::make_unique<Search::Batch>();
    int ranking_safe = 0, separated = 0, crossed = 0;
    long pairs = 0;
    for (const Tool& tool : safe_radius_tools()) {
        const Search search(tool, {largest_reach, largest_reach, 0.01, false}, {});
        for (int round = 0; round < 8; ++round) {
            std::vector<V3> y;
            for (int i = 0; i < Search::Batch::capacity; ++i)
                y.push_back(somewhere_over(tool, random));
            std::vector<Memory> memory(y.size());
            put(y, 0.9 * largest_reach, *batch, &memory);
            search.find(*batch, rules);
            if (round >= 2) {
                // Again, from the retained sub-triangle: near a side the radius follows from two sub-triangles.
                for (Memory& one : memory)
                    one.forget();
                search.find(*batch, rules);
                pairs += batch->tally.edge_neighbour;
            }
            for (const Memory& one : memory) {
                if (one.radius == 0) continue;
                ++(one.radius < 0 ? ranking_safe : separated);
                // Another gap than that of the node: what is remembered does not depend on it.
                const ContactReach reach{largest_reach * (round % 2 == 0 ? 1.0 : 0.7), largest_reach, 0};
                for (int k = 0; k < 24; ++k) {
                    const V3 there = one.center + direction(random) * (0.999999 * std::abs(double(one.radius)));
                    ASSERT_TRUE(one.within(there));
                    const Retained found = search.search(there, reach, rules);
                    if (one.radius > 0) {
                        ASSERT_FALSE(found.exists()) << there.x << " " << there.y << " " << there.z;
                        continue;
                    }
                    if (!project_exact(there, tool.segment(one.last.segment()), one.last.triangle(), reach, rules)
                             .taken) {
                        ++crossed;
                        continue;
                    }
                    ASSERT_EQ(found.id, one.last) << there.x << " " << there.y << " " << there.z;
                }
            }
        }
    }
    EXPECT_GT(ranking_safe, 3000);
    EXPECT_GT(separated, 500);
    EXPECT_GT(crossed, 100);
    EXPECT_GT(pairs, 500);
}

TEST(SafeRadii, DecideWithoutAProjection) {
    std::mt19937_64 random(16);
    const ProjectionLimits rules;
    auto batch = std::make_unique<Search::Batch>();
    batch->exclusive_regions = false;
    int contact_safe = 0, nearly_out = 0;
    for (const Tool& tool : safe_radius_tools()) {
        const Search search(tool, {largest_reach, largest_reach, 0.01, false}, {});
        for (int round = 0; round < 12; ++round) {
            const double gap = round % 2 == 0 ? 0.9 * largest_reach : 0.4 * largest_reach,
                         depth = round % 3 == 0 ? 0.3 * largest_reach : largest_reach;
            std::vector<V3> y;
            for (int i = 0; i < Search::Batch::capacity; ++i)
                y.push_back(somewhere_over(tool, random));
            std::vector<Memory> memory(y.size());
            put(y, gap, *batch, &memory);
            batch->depth = depth;
            search.find(*batch, rules);
            search.select(*batch, rules);
            for (const Memory& one : memory) {
                if (one.contact_safe == 0) continue;
                ++contact_safe;
                ASSERT_LE(std::abs(one.contact_safe), -one.radius);
                for (int k = 0; k < 24; ++k) {
                    const V3 there = one.center + direction(random) * (0.999999 * std::abs(double(one.contact_safe)));
                    ASSERT_TRUE(one.within_contact_safe(there));
                    const Retained found = search.search(there, {gap, depth, 0}, rules);
                    ASSERT_TRUE(found.exists()) << there.x << " " << there.y << " " << there.z;
                    ASSERT_EQ(found.id, one.last);
                    ASSERT_EQ(found.projection.side, one.side());
                    ASSERT_EQ(found.projection.kind, Kind::contact);
                    const ProjectionResult& l = found.projection;
                    const double least = std::min(1 - l.b - l.c, std::min(l.b, l.c));
                    nearly_out += least < 1e-3 || std::abs(l.lift) < 1e-3 * largest_reach ||
                                  std::abs(l.lift) * norm(l.normal) > 0.98 * (l.side > 0 ? gap : depth);
                }
            }
        }
    }
    EXPECT_GT(contact_safe, 2000);
    EXPECT_GT(nearly_out, 200);
}

TEST(SafeRadii, SelectWhatTheSearchFindsAlongAPath) {
    std::mt19937_64 random(17);
    const ProjectionLimits rules;
    auto batch = std::make_unique<Search::Batch>(), other = std::make_unique<Search::Batch>();
    long ranking_safe = 0;
    for (const Tool& tool : safe_radius_tools()) {
        const Search search(tool, {largest_reach, largest_reach, 0.01, false}, {});
        for (const bool exclusive_regions : {false, true}) {
            std::vector<V3> y, way;
            for (int i = 0; i < 200; ++i) {
                y.push_back(somewhere_over(tool, random));
                way.push_back(direction(random) * (0.002 * largest_reach * static_cast<double>(1 + i % 9)));
            }
            std::vector<Memory> memory(y.size());
            for (int cycle = 0; cycle < 60; ++cycle) {
                batch->exclusive_regions = exclusive_regions;
                put(y, 0.8 * largest_reach, *batch, &memory);
                put(y, 0.8 * largest_reach, *other, nullptr);
                // Steps in between are those of a run.
                cycle % 7 == 3 ? search.find(*batch, rules) : search.select(*batch, rules);
                search.search(*other, rules);
                ranking_safe += batch->tally.ranking_safe;
                for (int i = 0; i < batch->count; ++i) {
                    ASSERT_EQ(batch->id[i], other->id[i]) << cycle << " " << i;
                    if (!batch->id[i].exists()) continue;
                    ASSERT_EQ(batch->side[i], other->side[i]);
                    ASSERT_EQ(batch->kind[i], other->kind[i]);
                }
                for (size_t i = 0; i < y.size(); ++i)
                    y[i] = y[i] + way[i];
            }
        }
    }
    EXPECT_GT(ranking_safe, 20000);
}

TEST(SafeRadii, AreUsedWhileTheNodeStays) {
    const Tool tool = safe_radius_tools()[1];
    const Search search(tool, {largest_reach, largest_reach, 0.01, false}, {});
    auto batch = std::make_unique<Search::Batch>();
    batch->exclusive_regions = false;
    std::mt19937_64 random(8);
    std::vector<V3> y;
    for (int i = 0; i < Search::Batch::capacity; ++i)
        y.push_back(somewhere_over(tool, random));
    std::vector<Memory> memory(y.size());
    put(y, largest_reach, *batch, &memory);
    search.find(*batch, {});
    EXPECT_EQ(batch->tally.searched, static_cast<long>(y.size()));
    for (V3& one : y)
        one = one + V3{1e-7, 1e-7, -1e-7};
    put(y, largest_reach, *batch, &memory);
    search.find(*batch, {});
    EXPECT_GT(batch->tally.ranking_safe + batch->tally.separated, static_cast<long>(y.size()) * 9 / 10);
    for (int i = 0; i < batch->count; ++i)
        EXPECT_TRUE(same(batch->retained(i),
                         exhaustive(tool, y[static_cast<size_t>(i)], {largest_reach, largest_reach, 0}, {})));
}

/// A node beside a triangle by less than the 1 % of a weight: its point is clipped, and the clipped one is farther
/// away.
TEST(ManyAtOnce, SeeTheClippedPoint) {
    const Tool tool({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 2}});
    const Search search(tool, {2, 2, 0.01, false}, {});
    auto batch = std::make_unique<Search::Batch>();
    const std::vector<V3> y{{30, -0.9, 0.5}, {30, 0.9, 0.5}, {30, -0.1, 0.5}, {30, -0.9, 1.7}, {-0.6, -0.3, -1.9}};
    // With memory as well: the radius of the first gap holds for all.
    std::vector<Memory> memory(y.size());
    long ranking_safe = 0;
    for (const double gap : {2.0, 0.505, 1.1, 0.6, 0.45}) {
        for (const bool remembers : {false, true}) {
            put(y, gap, *batch, remembers ? &memory : nullptr);
            batch->depth = 2;
            remembers ? search.find(*batch, {}) : search.search(*batch, {});
            ranking_safe += batch->tally.ranking_safe;
            for (int i = 0; i < batch->count; ++i)
                EXPECT_TRUE(same(batch->retained(i), exhaustive(tool, y[static_cast<size_t>(i)], {gap, 2, 0}, {})))
                    << i << " " << gap;
        }
    }
    EXPECT_GT(ranking_safe, 0);
}

/// A node that projects beyond an obtuse corner: two weights are clipped to 0, the third to 1.
TEST(ManyAtOnce, ClipWeightsAboveOne) {
    const Tool tool({{1, 0.3, 0}, {-1, 0.3, 0}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 2}});
    const Search search(tool, {0.0104, 0.0104, 0.01, false}, {});
    auto batch = std::make_unique<Search::Batch>();
    const V3 y{1.00002, 0.302994, 0.0005};
    for (const double gap : {0.0104, 0.010385, 0.01038, 0.0103}) {
        std::vector<Memory> memory(1);
        memory[0].look_at({0, 1});
        for (const bool remembers : {false, true}) {
            put({y}, gap, *batch, remembers ? &memory : nullptr);
            batch->depth = 0.0104;
            remembers ? search.find(*batch, {}) : search.search(*batch, {});
            EXPECT_TRUE(same(batch->retained(0), exhaustive(tool, y, {gap, 0.0104, 0}, {}))) << gap;
        }
    }
}

TEST(ExclusiveRegionPolicy, PaysWhenManyNodesAreSearchedFor) {
    ExclusiveRegionPolicy policy;
    PathTally all, many, few;
    all.searched = 1000;
    many.searched = 100;
    few.searched = 10;
    policy.add(all, 1000, 2000);  // the first cycle searches for all nodes and does not count
    EXPECT_FALSE(policy.pays());
    for (int c = 0; c < 24; ++c)
        policy.add(many, 1000, 2000);
    EXPECT_TRUE(policy.pays());
    for (int c = 0; c < 24; ++c)
        policy.add(few, 1000, 2000);
    EXPECT_TRUE(policy.pays()) << "what is set up is used";
    ExclusiveRegionPolicy other;
    for (int c = 0; c < 24; ++c)
        other.add(few, 1000, 2000);
    EXPECT_FALSE(other.pays());
    ExclusiveRegionPolicy wide;
    for (int c = 0; c < 24; ++c)
        wide.add(many, 1000, 10000);
    EXPECT_FALSE(wide.pays()) << "few nodes meet each sub-triangle";
}

/// Above corners, sides, middles and centres, on the surface, and anywhere.
V3 hard_position(const Tool& tool, std::mt19937_64& random) {
    const SegmentData s = tool.segment(static_cast<int>(random() % static_cast<unsigned>(tool.size())));
    const auto j = random() % 4, k = random() % 4;
    const double h = std::array<double, 3>{0.0, 0.1, -0.0625}[random() % 3];
    const V3 normal = (s.normal[j] + s.normal[k]) * 0.5;
    const double share = std::array<double, 4>{0.5, 0.25, 1.0 / 3, 0.0}[random() % 4];
    V3 at = s.node[j] * (1 - share) + s.node[k] * share;
    if (random() % 4 == 0) at = ((s.node[0] + s.node[1]) + (s.node[2] + s.node[3])) * 0.25;
    return random() % 4 == 0 ? somewhere_over(tool, random) : at + normal * h;
}

TEST(ManyAtOnce, AreSearchedForAsTheExhaustiveSearchDoes) {
    std::mt19937_64 random(12);
    auto batch = std::make_unique<Search::Batch>();
    std::array<int, 4> settled{};
    for (const Tool& tool : safe_radius_tools()) {
        for (const bool lift : {false, true}) {
            ProjectionLimits rules;
            rules.lift_leaning = lift;
            const Search search(tool, {largest_reach, largest_reach, 0.01, lift}, {});
            std::vector<V3> y;
            for (int i = 0; i < 100; ++i)
                y.push_back(hard_position(tool, random));
            put(y, 0.8 * largest_reach, *batch, nullptr);
            search.search(*batch, rules);
            EXPECT_EQ(batch->tally.searched, 100);
            for (int i = 0; i < batch->count; ++i) {
                const V3& at = y[static_cast<size_t>(i)];
                ASSERT_TRUE(
                    same(batch->retained(i), exhaustive(tool, at, {0.8 * largest_reach, largest_reach, 0}, rules)))
                    << at.x << " " << at.y << " " << at.z;
                ++settled[static_cast<size_t>(batch->settled[i])];
            }
        }
    }
    EXPECT_GT(settled[static_cast<size_t>(Settled::filter)], 200);
    EXPECT_GT(settled[static_cast<size_t>(Settled::tie)], 100);
}

}  // namespace
}  // namespace type21::optimized
