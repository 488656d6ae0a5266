// Stages, their counts and the margin, on configurations whose answers follow by hand.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "reference/exact/staged_impact.h"

namespace type21::reference {
namespace {

/// A flat row of unit squares in z = 0, normals up; square s spans s <= x <= s + 1, 0 <= y <= 1.
SegmentShape<double> square(int s) {
    SegmentShape<double> shape;
    shape.node = {Vec3(s, 0, 0), Vec3(s + 1, 0, 0), Vec3(s + 1, 1, 0), Vec3(s, 1, 0)};
    shape.normal.fill(Vec3::UnitZ());
    return shape;
}

const ShapeOf squares = square;
const std::vector<int> first_two{0, 1};

/// A node over the squares: gap 0.5, DEPTH 2.
ContactQuery query_at(const Vec3& p) {
    return {p, 0.5, 2.0, 0.0};
}

StagedImpact staged_at(const Vec3& p, DecisionStageCounts* counts = nullptr,
                       const std::vector<int>& segments = first_two) {
    return staged_impact(query_at(p), {segments, squares}, counts);
}

double margin_at(const Vec3& p) {
    return decision_margin(query_at(p), {first_two, squares});
}

TEST(StagedImpact, AnOrdinaryNodeIsSettledByDouble) {
    DecisionStageCounts counts;
    const auto impact = staged_at({0.5, 0.2, 0.3}, &counts);
    EXPECT_EQ(impact.kind, Kind::contact);
    EXPECT_EQ(impact.segment, 0);
    EXPECT_EQ(impact.triangle, 1) << "the triangle on the side from node 1 to node 2";
    EXPECT_EQ(impact.side, +1);
    EXPECT_EQ(impact.stage, Stage::bounded);
    EXPECT_EQ(counts.settled[0], 1);
    EXPECT_EQ(counts.decisions(), 1);
}

// On the common edge both squares see the node alike: kappa is equal exactly, the lower segment is retained.
TEST(StagedImpact, ATieGoesToTheLowerSegmentInAnyOrder) {
    for (const std::vector<int>& order : {std::vector<int>{0, 1}, std::vector<int>{1, 0}}) {
        DecisionStageCounts counts;
        const auto impact = staged_at({1.0, 0.1, 0.3}, &counts, order);
        EXPECT_EQ(impact.segment, 0);
        EXPECT_NE(impact.stage, Stage::bounded);
        EXPECT_EQ(counts.settled[0], 0);
        EXPECT_EQ(counts.settled[1] + counts.settled[2], 1);
    }
}

// One ulp beyond the edge the other square is retained, whatever double arithmetic makes of it.
TEST(StagedImpact, OneUlpBesideTheTieDecides) {
    const double right = std::nextafter(1.0, 2.0);
    const double left = std::nextafter(1.0, 0.0);
    EXPECT_EQ(staged_at({right, 0.1, 0.3}).segment, 1);
    EXPECT_EQ(staged_at({left, 0.1, 0.3}).segment, 0);
}

// d < g is strict: at z = g exactly there is nothing, one ulp below there is contact.
TEST(StagedImpact, TheGapIsStrict) {
    EXPECT_EQ(staged_at({0.5, 0.2, 0.5}).kind, Kind::none);
    EXPECT_EQ(staged_at({0.5, 0.2, std::nextafter(0.5, 0.0)}).kind, Kind::contact);
    EXPECT_EQ(staged_at({0.5, 0.2, -2.0}).kind, Kind::none);
    EXPECT_EQ(staged_at({0.5, 0.2, std::nextafter(-2.0, 0.0)}).kind, Kind::contact);
}

// On the surface the side is +; the smallest double below it is behind.
TEST(StagedImpact, TheSideOnTheSurface) {
    EXPECT_EQ(staged_at({0.5, 0.2, 0.0}).side, +1);
    EXPECT_EQ(staged_at({0.5, 0.2, -std::numeric_limits<double>::denorm_min()}).side, -1);
}

TEST(StagedImpact, NothingNearIsCountedApart) {
    DecisionStageCounts counts;
    const std::vector<int> none;
    EXPECT_EQ(staged_at({0, 0, 9}, &counts, none).kind, Kind::none);
    EXPECT_EQ(counts.nothing_near, 1);
    EXPECT_EQ(counts.settled[0], 0);
}

// Coordinates whose products leave the range of doubles: the answer is that of the same figure at size 1.
TEST(StagedImpact, ScaleDoesNotMatter) {
    for (const double size : {0x1p-500, 0x1p-300, 0x1p300, 0x1p500}) {
        const ShapeOf scaled = [size](int s) {
            auto shape = square(s);
            for (Vec3& x : shape.node)
                x *= size;
            return shape;
        };
        const ContactQuery query{Vec3(0.5, 0.2, 0.3) * size, 0.5 * size, 2 * size, 0};
        const auto impact = staged_impact(query, {first_two, scaled});
        EXPECT_EQ(impact.kind, Kind::contact) << size;
        EXPECT_EQ(impact.triangle, 1) << size;
        EXPECT_NEAR(impact.projection.weights.b + impact.projection.weights.c, 0.6, 1e-12) << size;
    }
}

// Above the middle of a flat square's triangle 1, the border nearest to a node at height z is the gap (0.5 - z away),
// while the diagonals to the next triangles are far: y - 0.2 of 0.5 at 45 degrees.
TEST(Margin, DistanceToTheGapOnAFlatTool) {
    EXPECT_NEAR(margin_at({0.5, 0.2, 0.45}), 0.05, 1e-12);
    EXPECT_NEAR(margin_at({0.5, 0.2, 0.49}), 0.01, 1e-12);
    EXPECT_NEAR(margin_at({0.5, 0.2, 0.52}), 0.02, 1e-12) << "from outside";
    EXPECT_NEAR(margin_at({0.5, 0.2, 0.01}), 0.01, 1e-12) << "the surface, where the side changes";
}

// Near the diagonal between triangles 1 and 2 of a square, kappa decides: it is equal on the diagonal x = 1 - y ...
// from (0.5, 0.5) to (1, 0), so the margin is the distance to it.
TEST(Margin, DistanceToTheTieOfKappa) {
    const double off = 1e-3;
    EXPECT_NEAR(margin_at({0.75 - off, 0.25 - off, 0.3}), off * std::sqrt(2.0), 1e-9);
}

TEST(Margin, TheDecisionHoldsWithinItAndChangesBeyond) {
    const Vec3 p(0.5, 0.2, 0.45);
    const double margin = margin_at(p);
    const auto before = staged_at(p);
    for (const Vec3& direction : {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
        const auto within = staged_at(p + 0.99 * margin * direction);
        EXPECT_EQ(within.kind, before.kind);
        EXPECT_EQ(within.triangle, before.triangle);
    }
    EXPECT_EQ(staged_at(p + 1.01 * margin * Vec3::UnitZ()).kind, Kind::none);
}

}  // namespace
}  // namespace type21::reference
