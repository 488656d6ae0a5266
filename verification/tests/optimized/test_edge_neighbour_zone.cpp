// Nodes near the sides of sub-triangles, where two of them can take a node: the batch against the tree, decisions and
// bits, wherever the node looks first.
#include <cstring>

#include <gtest/gtest.h>

#include "optimized/search/search.h"
#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized {
namespace {

using testing::grid;

std::vector<Tool> tools() {
    std::vector<Tool> made;
    for (const bool triangles : {false, true}) {
        made.push_back(grid(
            12, [](double, double) { return 0.0; }, triangles));
        made.push_back(grid(
            12, [](double x, double y) { return 0.3 * (x * x + y * y); }, triangles));
        made.push_back(grid(
            12, [](double x, double y) { return 0.3 * (x * x + y * y); }, triangles, 0.2));
        made.push_back(grid(
            12, [](double x, double y) { return 0.2 * std::sin(4 * x) * std::cos(3 * y); }, triangles, 0.1));
        made.push_back(grid(
            10, [](double x, double) { return -0.3 * std::abs(x); }, triangles));
    }
    return made;
}

/// A node near side `side` of a sub-triangle, at a small height over it.
V3 near_side(const SegmentData& s, int triangle, int side, std::mt19937_64& random) {
    std::uniform_real_distribution<double> along(0, 1), across(-0.013, 0.013), height(-0.08, 0.08);
    std::array<double, 3> w{};
    const auto i = static_cast<size_t>(side);
    const double scales[] = {1, 1e-4, 1e-9, 0};
    w[i] = across(random) * scales[random() % 4];
    w[(i + 1) % 3] = (1 - w[i]) * along(random);
    w[(i + 2) % 3] = 1 - w[i] - w[(i + 1) % 3];
    const SubTriangleCorners k = sub_triangle_corners(s.is_triangle, triangle);
    const auto at = [&](const std::array<V3, 4>& v) {
        const V3 a = s.is_triangle ? v[2] : (((v[0] + v[1]) + v[2]) + v[3]) * 0.25;
        return a * w[0] + v[static_cast<size_t>(k.b)] * w[1] + v[static_cast<size_t>(k.c)] * w[2];
    };
    return at(s.node) + at(s.normal) * height(random);
}

bool same_bits(const ProjectionResult& one, const ProjectionResult& other) {
    const auto bits = [](const ProjectionResult& l) {
        return std::array<double, 6>{l.b, l.c, l.lift, l.normal.x, l.normal.y, l.normal.z};
    };
    const auto p = bits(one), q = bits(other);
    return std::memcmp(p.data(), q.data(), sizeof(p)) == 0;
}

TEST(Pairs, DecideAsTheTreeDoes) {
    std::mt19937_64 random(3);
    const ContactReach reach{0.1, 0.1, 0};
    const ProjectionLimits rules;
    for (const Tool& tool : tools()) {
        const Search search(tool, {0.1, 0.1, 0.01, false}, {});
        auto batch = std::make_unique<Search::Batch>();
        batch->depth = reach.depth;
        std::vector<Memory> memory(Search::Batch::capacity);
        batch->memory = memory.data();
        int neighbours = 0, double_double = 0;
        for (int round = 0; round < 40; ++round) {
            batch->count = Search::Batch::capacity - static_cast<int>(random() % 9);
            for (int i = 0; i < batch->count; ++i) {
                const int segment = static_cast<int>(random() % static_cast<unsigned>(tool.size()));
                const SegmentData s = tool.segment(segment);
                const int triangle = 1 + static_cast<int>(random() % static_cast<unsigned>(s.sub_triangles()));
                const V3 y = near_side(s, triangle, static_cast<int>(random() % 3), random);
                for (int a = 0; a < 3; ++a)
                    batch->y[a][i] = y[a];
                batch->gap[i] = reach.gap;
                memory[static_cast<size_t>(i)] = {};
                if (random() % 16 != 0) memory[static_cast<size_t>(i)].look_at(SubTriangleId(segment, triangle));
                batch->active[i] = true;
            }
            search.find(*batch, rules);
            for (int i = 0; i < batch->count; ++i) {
                const V3 y{batch->y[0][i], batch->y[1][i], batch->y[2][i]};
                Memory fresh;
                const Retained found = batch->retained(i), expected = search.find(y, reach, rules, fresh).retained;
                ASSERT_EQ(found.id, expected.id) << y.x << " " << y.y << " " << y.z;
                if (!expected.exists()) continue;
                ASSERT_EQ(found.projection.kind, expected.projection.kind);
                ASSERT_EQ(found.projection.side, expected.projection.side);
                ASSERT_TRUE(same_bits(found.projection, expected.projection));
                const V3 x = point_at(tool.segment(found.id.segment()), found.id.triangle(), found.projection.b,
                                      found.projection.c);
                ASSERT_EQ(x.x, batch->x[0][i]);
                ASSERT_EQ(x.y, batch->x[1][i]);
                ASSERT_EQ(x.z, batch->x[2][i]);
                neighbours += batch->path[i] == Path::edge_neighbour;
                double_double += batch->path[i] == Path::edge_neighbour && batch->settled[i] == Settled::double_double;
            }
        }
        EXPECT_GT(neighbours, 1000);
        RecordProperty("double_double", double_double);
    }
}

TEST(Machines, GiveTheSameBits) {
    const Tool tool = grid(
        6, [](double x, double y) { return 0.3 * (x * x + y * y); }, false, 0.2);
    std::mt19937_64 random(5);
    const auto fill = [&](ProjectionBatch& rows) {
        for (int i = 0; i < ProjectionBatch::capacity; ++i) {
            const int segment = i % tool.size();
            const SegmentData s = tool.segment(segment);
            const V3 y = near_side(s, 1 + i % 4, i % 3, random);
            for (int a = 0; a < 3; ++a) {
                rows.y[a][i] = y[a];
                for (int j = 0; j < 4; ++j) {
                    rows.corner[j][a][i] = s.node[static_cast<size_t>(j)][a];
                    rows.normal[j][a][i] = s.normal[static_cast<size_t>(j)][a];
                }
            }
            rows.code[i] = i % 4;
            rows.exclusive_margin[i] = 0.02;
            rows.size[i] = 1;
            rows.gap[i] = 0.1;
        }
    };
    auto first = std::make_unique<ProjectionBatch>();
    fill(*first);
    const auto two = std::make_unique<ProjectionBatch>(*first);
    KappaRows kappa_two{};
    const BatchLimits limits{0.1, 0.1, 0.1, 0, true};
    project_double(*two, 0, ProjectionBatch::capacity, limits, SimdWidth::two);
    project_double_double(*two, ProjectionBatch::capacity, kappa_two, SimdWidth::two);
    for (const SimdWidth machine : {SimdWidth::four, SimdWidth::eight}) {
        if (machine > this_machine()) continue;
        const auto wide = std::make_unique<ProjectionBatch>(*first);
        KappaRows kappa{};
        project_double(*wide, 0, ProjectionBatch::capacity, limits, machine);
        project_double_double(*wide, ProjectionBatch::capacity, kappa, machine);
        EXPECT_EQ(std::memcmp(two.get(), wide.get(), sizeof(ProjectionBatch)), 0) << static_cast<int>(machine);
        EXPECT_EQ(std::memcmp(&kappa_two, &kappa, sizeof(kappa)), 0) << static_cast<int>(machine);
    }
}

}  // namespace
}  // namespace type21::optimized
