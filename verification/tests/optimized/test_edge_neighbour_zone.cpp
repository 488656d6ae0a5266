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
V3 near_side(const SegmentData& s, int piece, int side, std::mt19937_64& random) {
    std::uniform_real_distribution<double> along(0, 1), across(-0.013, 0.013), height(-0.08, 0.08);
    std::array<double, 3> w{};
    const auto i = static_cast<size_t>(side);
    const double scales[] = {1, 1e-4, 1e-9, 0};
    w[i] = across(random) * scales[random() % 4];
    w[(i + 1) % 3] = (1 - w[i]) * along(random);
    w[(i + 2) % 3] = 1 - w[i] - w[(i + 1) % 3];
    const PieceCorners k = piece_corners(s.triangle, piece);
    const auto at = [&](const std::array<V3, 4>& v) {
        const V3 a = s.triangle ? v[2] : (((v[0] + v[1]) + v[2]) + v[3]) * 0.25;
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
    const ContactReach window{0.1, 0.1, 0};
    const ProjectionLimits rules;
    for (const Tool& tool : tools()) {
        const Search search(tool, {0.1, 0.1, 0.01, false}, {});
        auto batch = std::make_unique<Search::Batch>();
        batch->depth = window.depth;
        std::vector<Memory> memory(Search::Batch::room);
        batch->memory = memory.data();
        int paired = 0, fine = 0;
        for (int round = 0; round < 40; ++round) {
            batch->count = Search::Batch::room - static_cast<int>(random() % 9);
            for (int i = 0; i < batch->count; ++i) {
                const int segment = static_cast<int>(random() % static_cast<unsigned>(tool.size()));
                const SegmentData s = tool.segment(segment);
                const int piece = 1 + static_cast<int>(random() % static_cast<unsigned>(s.pieces()));
                const V3 y = near_side(s, piece, static_cast<int>(random() % 3), random);
                for (int a = 0; a < 3; ++a)
                    batch->y[a][i] = y[a];
                batch->gap[i] = window.gap;
                memory[static_cast<size_t>(i)] = {};
                if (random() % 16 != 0) memory[static_cast<size_t>(i)].look_at(place_of(segment, piece));
                batch->asked[i] = true;
            }
            search.find(*batch, rules);
            for (int i = 0; i < batch->count; ++i) {
                const V3 y{batch->y[0][i], batch->y[1][i], batch->y[2][i]};
                Memory fresh;
                const Retained found = batch->retained(i), expected = search.find(y, window, rules, fresh).retained;
                ASSERT_EQ(found.segment, expected.segment) << y.x << " " << y.y << " " << y.z;
                if (expected.segment < 0) continue;
                ASSERT_EQ(found.piece, expected.piece);
                ASSERT_EQ(found.landing.kind, expected.landing.kind);
                ASSERT_EQ(found.landing.side, expected.landing.side);
                ASSERT_TRUE(same_bits(found.landing, expected.landing));
                const V3 x = landed_at(tool.segment(found.segment), found.piece, found.landing.b, found.landing.c);
                ASSERT_EQ(x.x, batch->x[0][i]);
                ASSERT_EQ(x.y, batch->x[1][i]);
                ASSERT_EQ(x.z, batch->x[2][i]);
                paired += batch->path[i] == Path::paired;
                fine += batch->path[i] == Path::paired && batch->settled[i] == Settled::fine;
            }
        }
        EXPECT_GT(paired, 1000);
        RecordProperty("fine", fine);
    }
}

TEST(Machines, GiveTheSameBits) {
    const Tool tool = grid(
        6, [](double x, double y) { return 0.3 * (x * x + y * y); }, false, 0.2);
    std::mt19937_64 random(5);
    const auto fill = [&](ProjectionBatch& rows) {
        for (int i = 0; i < ProjectionBatch::room; ++i) {
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
            rows.core[i] = 0.02;
            rows.size[i] = 1;
            rows.gap[i] = 0.1;
        }
    };
    auto first = std::make_unique<ProjectionBatch>();
    fill(*first);
    const auto two = std::make_unique<ProjectionBatch>(*first);
    FineKappaRows fine_two{};
    const LandingLimits limits{0.1, 0.1, 0.1, 0, true};
    project_double(*two, 0, ProjectionBatch::room, limits, SimdWidth::two);
    project_double_double(*two, ProjectionBatch::room, fine_two, SimdWidth::two);
    for (const SimdWidth machine : {SimdWidth::four, SimdWidth::eight}) {
        if (machine > this_machine()) continue;
        const auto wide = std::make_unique<ProjectionBatch>(*first);
        FineKappaRows fine{};
        project_double(*wide, 0, ProjectionBatch::room, limits, machine);
        project_double_double(*wide, ProjectionBatch::room, fine, machine);
        EXPECT_EQ(std::memcmp(two.get(), wide.get(), sizeof(ProjectionBatch)), 0) << static_cast<int>(machine);
        EXPECT_EQ(std::memcmp(&fine_two, &fine, sizeof(fine)), 0) << static_cast<int>(machine);
    }
}

}  // namespace
}  // namespace type21::optimized
