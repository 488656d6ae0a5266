// How long a decision holds: rates of weights, balls around nodes, and the search of many nodes side by side.
#include <gtest/gtest.h>

#include "optimized/search/rates.h"
#include "optimized/search/search.h"
#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized {
namespace {

using testing::exhaustive;
using testing::grid;
using testing::same;

constexpr double reach = 0.15;

std::vector<Tool> ball_tools() {
    std::vector<Tool> made;
    for (const bool triangles : {false, true}) {
        made.push_back(grid(
            6, [](double, double) { return 0.0; }, triangles));
        made.push_back(grid(
            6, [](double x, double y) { return 0.5 * (x * x + y * y); }, triangles, 0.25));
        made.push_back(grid(
            6, [](double x, double y) { return 0.2 * std::sin(4 * x) * std::cos(3 * y); }, triangles, 0.2));
        made.push_back(grid(
            6, [](double x, double) { return -0.7 * std::abs(x); }, triangles, 0.1));
    }
    return made;
}

/// Anywhere over a sub-triangle, a little beyond its sides, too.
V3 somewhere_over(const Tool& tool, std::mt19937_64& random) {
    std::uniform_real_distribution<double> unit(-0.2, 1), height(-1.3 * reach, 1.3 * reach);
    const SegmentData s = tool.segment(static_cast<int>(random() % static_cast<unsigned>(tool.size())));
    double b = unit(random), c = unit(random);
    if (b + c > 1.2) {
        b = 1 - b;
        c = 1 - c;
    }
    const auto at = [&](const std::array<V3, 4>& v) { return v[2] * (1 - b - c) + v[0] * b + v[1] * c; };
    return at(s.node) + at(s.normal) * height(random);
}

V3 direction(std::mt19937_64& random) {
    std::normal_distribution<double> one;
    const V3 v{one(random), one(random), one(random)};
    return v * (1 / norm(v));
}

void put(const std::vector<V3>& y, double gap, Search::Batch& batch, std::vector<Memory>* memory) {
    batch.count = static_cast<int>(y.size());
    batch.depth = reach;
    batch.memory = memory == nullptr ? nullptr : memory->data();
    for (int i = 0; i < batch.count; ++i) {
        for (int a = 0; a < 3; ++a)
            batch.y[a][i] = y[static_cast<size_t>(i)][a];
        batch.gap[i] = gap;
        batch.asked[i] = memory != nullptr;
    }
}

TEST(Rates, OfAFlatTriangleAreOneOverItsWidth) {
    // Right-angled, sides 3 and 4: the width is the height over the side of 5, 12 / 5.
    const std::vector<V3> x{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    const Tool tool(x, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 2}});
    EXPECT_NEAR(double(piece_bounds(tool, 0.5).rate[0]), 5.0 / 12, 1e-5);
}

TEST(Rates, AreTheSameBitsOnEachMachine) {
    for (const Tool& tool : ball_tools()) {
        const PieceBounds two = piece_bounds(tool, reach, Machine::two);
        for (const Machine machine : {Machine::four, Machine::eight}) {
            if (machine > this_machine()) continue;
            EXPECT_TRUE(piece_bounds(tool, reach, machine) == two);
        }
    }
}

TEST(Rates, BoundHowWeightsChange) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> way(0, 1e-3);
    auto rows = std::make_unique<LandingRows>();
    double nearest = 0;  // share of the bound that is used
    for (const Tool& tool : ball_tools()) {
        const std::vector<float> rates = piece_bounds(tool, reach).rate;
        for (int round = 0; round < 2000; ++round) {
            const V3 from = somewhere_over(tool, random), to = from + direction(random) * way(random);
            const int place = place_of(static_cast<int>(random() % static_cast<unsigned>(tool.size())), 1);
            const std::array<int, 2> places{place, place};
            const std::array<V3, 2> y{from, to};
            for (size_t i = 0; i < 2; ++i)
                for (int a = 0; a < 3; ++a)
                    rows->y[a][i] = y[i][a];
            gather(*rows, tool, places.data(), 0, 2, reach);
            plain_landing(*rows, 0, 2, {reach, reach, reach, 0, false});
            const double rate = double(rates[static_cast<size_t>(place)]);
            const auto weights = [&](size_t i) {
                return std::array<double, 6>{rows->weight[0][i], rows->weight[1][i], rows->weight[2][i],
                                             rows->b[i],         rows->c[i],         1 - rows->b[i] - rows->c[i]};
            };
            const auto w = weights(0), v = weights(1);
            const double height = std::abs(rows->height[0]) / std::sqrt(rows->square[0]);
            if (!(std::min({w[0], w[1], w[2]}) > -rate_weights + 0.01) || !(height < reach) || rate >= no_rate)
                continue;
            for (size_t k = 0; k < 6; ++k) {
                EXPECT_LE(std::abs(v[k] - w[k]), rate * norm(to - from) * (1 + 1e-9) + 1e-12);
                nearest = std::max(nearest, std::abs(v[k] - w[k]) / (rate * norm(to - from)));
            }
            const double change = std::abs(kappa_of(v[3], v[4]) - kappa_of(w[3], w[4]));
            EXPECT_LE(change, 2 * rate * norm(to - from) * (1 + 1e-9) + 1e-12);
        }
    }
    EXPECT_GT(nearest, 0.8);
}

/// Against 100 bits, with nodes as near as the bounds are asked for.
TEST(Rates, BoundHowFarKappaIsOff) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> unit(0, 1);
    auto rows = std::make_unique<LandingRows>();
    double nearest = 0;
    int judged = 0;
    for (const Tool& tool : ball_tools()) {
        for (const double growth : {1e-4, reach}) {
            const PieceBounds bounds = piece_bounds(tool, growth);
            for (int round = 0; round < 4000; ++round) {
                const int segment = static_cast<int>(random() % static_cast<unsigned>(tool.size()));
                const SegmentData data = tool.segment(segment);
                const int piece = 1 + static_cast<int>(random() % static_cast<unsigned>(data.pieces()));
                const int place = place_of(segment, piece);
                if (!std::isfinite(bounds.rate[static_cast<size_t>(place)])) continue;
                const double b = unit(random), c = (1 - b) * unit(random);
                const PieceCorners of = piece_corners(data.triangle, piece);
                const V3 y = landed_at(data, piece, b, c) +
                             data.normal[static_cast<size_t>(of.b)] * (growth * (2 * unit(random) - 1));
                for (int a = 0; a < 3; ++a)
                    rows->y[a][0] = y[a];
                gather(*rows, tool, &place, 0, 1, growth);
                plain_landing(*rows, 0, 1, {growth, growth, growth, 0, false});
                FineKappa fine;
                if (fine_filter(y, data, piece, {growth, growth, 0}, {}, fine).verdict != Verdict::taken) continue;
                ++judged;
                const double off = std::abs((TwoDoubles(kappa_of(rows->b[0], rows->c[0])) - fine.value).high);
                const double bound = std::ldexp(1.0, -int(bounds.kappa_bits[static_cast<size_t>(segment)]));
                ASSERT_LE(off, bound);
                nearest = std::max(nearest, off / bound);
            }
        }
    }
    EXPECT_GT(judged, 20000);
    EXPECT_GT(nearest, 3e-4);  // a bound is the sum of the worst of many steps
}

TEST(Balls, HoldWhatIsRetained) {
    std::mt19937_64 random(6);
    const Rules rules;
    auto batch = std::make_unique<Search::Batch>();
    int steady = 0, quiet = 0, crossed = 0;
    long pairs = 0;
    for (const Tool& tool : ball_tools()) {
        const Search search(tool, {reach, reach, 0.01, false}, {});
        for (int round = 0; round < 8; ++round) {
            std::vector<V3> y;
            for (int i = 0; i < Search::Batch::room; ++i)
                y.push_back(somewhere_over(tool, random));
            std::vector<Memory> memory(y.size());
            put(y, 0.9 * reach, *batch, &memory);
            search.find(*batch, rules);
            if (round >= 2) {
                // Again, from where it was retained: near a side the ball is that of two.
                for (Memory& one : memory)
                    one.forget();
                search.find(*batch, rules);
                pairs += batch->tally.paired;
            }
            for (const Memory& one : memory) {
                if (one.radius == 0) continue;
                ++(one.radius < 0 ? steady : quiet);
                // Another gap than that of the node: what is remembered does not hang on it.
                const Window window{reach * (round % 2 == 0 ? 1.0 : 0.7), reach, 0};
                for (int k = 0; k < 24; ++k) {
                    const V3 there = one.from + direction(random) * (0.999999 * std::abs(double(one.radius)));
                    ASSERT_TRUE(one.within(there));
                    const Retained found = search.search(there, window, rules);
                    if (one.radius > 0) {
                        ASSERT_LT(found.segment, 0) << there.x << " " << there.y << " " << there.z;
                        continue;
                    }
                    const int s = segment_of(one.place), piece = piece_of(one.place);
                    if (!exact_landing(there, tool.segment(s), piece, window, rules).taken) {
                        ++crossed;
                        continue;
                    }
                    ASSERT_EQ(found.segment, s) << there.x << " " << there.y << " " << there.z;
                    ASSERT_EQ(found.piece, piece);
                }
            }
        }
    }
    EXPECT_GT(steady, 3000);
    EXPECT_GT(quiet, 500);
    EXPECT_GT(crossed, 100);
    EXPECT_GT(pairs, 500);
}

TEST(Balls, TellWhoIsHeldWithoutAProjection) {
    std::mt19937_64 random(16);
    const Rules rules;
    auto batch = std::make_unique<Search::Batch>();
    batch->cores = false;
    int held = 0, nearly_out = 0;
    for (const Tool& tool : ball_tools()) {
        const Search search(tool, {reach, reach, 0.01, false}, {});
        for (int round = 0; round < 12; ++round) {
            const double gap = round % 2 == 0 ? 0.9 * reach : 0.4 * reach, depth = round % 3 == 0 ? 0.3 * reach : reach;
            std::vector<V3> y;
            for (int i = 0; i < Search::Batch::room; ++i)
                y.push_back(somewhere_over(tool, random));
            std::vector<Memory> memory(y.size());
            put(y, gap, *batch, &memory);
            batch->depth = depth;
            search.find(*batch, rules);
            search.select(*batch, rules);
            for (const Memory& one : memory) {
                if (one.held == 0) continue;
                ++held;
                ASSERT_LE(std::abs(one.held), -one.radius);
                for (int k = 0; k < 24; ++k) {
                    const V3 there = one.from + direction(random) * (0.999999 * std::abs(double(one.held)));
                    ASSERT_TRUE(one.within_held(there));
                    const Retained found = search.search(there, {gap, depth, 0}, rules);
                    ASSERT_GE(found.segment, 0) << there.x << " " << there.y << " " << there.z;
                    ASSERT_EQ(place_of(found.segment, found.piece), one.place);
                    ASSERT_EQ(found.landing.side, one.side());
                    ASSERT_EQ(found.landing.kind, Kind::contact);
                    const Landing& l = found.landing;
                    const double least = std::min(1 - l.b - l.c, std::min(l.b, l.c));
                    nearly_out += least < 1e-3 || std::abs(l.lift) < 1e-3 * reach ||
                                  std::abs(l.lift) * norm(l.normal) > 0.98 * (l.side > 0 ? gap : depth);
                }
            }
        }
    }
    EXPECT_GT(held, 2000);
    EXPECT_GT(nearly_out, 200);
}

TEST(Balls, SelectWhatTheSearchFindsAlongAWay) {
    std::mt19937_64 random(17);
    const Rules rules;
    auto batch = std::make_unique<Search::Batch>(), other = std::make_unique<Search::Batch>();
    long steady = 0;
    for (const Tool& tool : ball_tools()) {
        const Search search(tool, {reach, reach, 0.01, false}, {});
        for (const bool cores : {false, true}) {
            std::vector<V3> y, way;
            for (int i = 0; i < 200; ++i) {
                y.push_back(somewhere_over(tool, random));
                way.push_back(direction(random) * (0.002 * reach * static_cast<double>(1 + i % 9)));
            }
            std::vector<Memory> memory(y.size());
            for (int cycle = 0; cycle < 60; ++cycle) {
                batch->cores = cores;
                put(y, 0.8 * reach, *batch, &memory);
                put(y, 0.8 * reach, *other, nullptr);
                // Steps in between are those of a run.
                cycle % 7 == 3 ? search.find(*batch, rules) : search.select(*batch, rules);
                search.search(*other, rules);
                steady += batch->tally.steady;
                for (int i = 0; i < batch->count; ++i) {
                    ASSERT_EQ(batch->place[i], other->place[i]) << cycle << " " << i;
                    if (batch->place[i] < 0) continue;
                    ASSERT_EQ(batch->side[i], other->side[i]);
                    ASSERT_EQ(batch->kind[i], other->kind[i]);
                }
                for (size_t i = 0; i < y.size(); ++i)
                    y[i] = y[i] + way[i];
            }
        }
    }
    EXPECT_GT(steady, 20000);
}

TEST(Balls, AreUsedWhileTheNodeStays) {
    const Tool tool = ball_tools()[1];
    const Search search(tool, {reach, reach, 0.01, false}, {});
    auto batch = std::make_unique<Search::Batch>();
    batch->cores = false;
    std::mt19937_64 random(8);
    std::vector<V3> y;
    for (int i = 0; i < Search::Batch::room; ++i)
        y.push_back(somewhere_over(tool, random));
    std::vector<Memory> memory(y.size());
    put(y, reach, *batch, &memory);
    search.find(*batch, {});
    EXPECT_EQ(batch->tally.searched, static_cast<long>(y.size()));
    for (V3& one : y)
        one = one + V3{1e-7, 1e-7, -1e-7};
    put(y, reach, *batch, &memory);
    search.find(*batch, {});
    EXPECT_GT(batch->tally.steady + batch->tally.quiet, static_cast<long>(y.size()) * 9 / 10);
    for (int i = 0; i < batch->count; ++i)
        EXPECT_TRUE(same(batch->retained(i), exhaustive(tool, y[static_cast<size_t>(i)], {reach, reach, 0}, {})));
}

/// A node beside a triangle by less than the 1 % of a weight: its landing is clipped, and that point is farther away.
TEST(ManyAtOnce, SeeTheClippedPoint) {
    const Tool tool({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 2}});
    const Search search(tool, {2, 2, 0.01, false}, {});
    auto batch = std::make_unique<Search::Batch>();
    const std::vector<V3> y{{30, -0.9, 0.5}, {30, 0.9, 0.5}, {30, -0.1, 0.5}, {30, -0.9, 1.7}, {-0.6, -0.3, -1.9}};
    // With what they remember, too: the ball of the first gap holds for all.
    std::vector<Memory> memory(y.size());
    long steady = 0;
    for (const double gap : {2.0, 0.505, 1.1, 0.6, 0.45}) {
        for (const bool remembers : {false, true}) {
            put(y, gap, *batch, remembers ? &memory : nullptr);
            batch->depth = 2;
            remembers ? search.find(*batch, {}) : search.search(*batch, {});
            steady += batch->tally.steady;
            for (int i = 0; i < batch->count; ++i)
                EXPECT_TRUE(same(batch->retained(i), exhaustive(tool, y[static_cast<size_t>(i)], {gap, 2, 0}, {})))
                    << i << " " << gap;
        }
    }
    EXPECT_GT(steady, 0);
}

/// A node that lands beyond an obtuse corner: two weights are clipped to 0, the third to 1.
TEST(ManyAtOnce, ClipWeightsAboveOne) {
    const Tool tool({{1, 0.3, 0}, {-1, 0.3, 0}, {0, 0, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 2}});
    const Search search(tool, {0.0104, 0.0104, 0.01, false}, {});
    auto batch = std::make_unique<Search::Batch>();
    const V3 y{1.00002, 0.302994, 0.0005};
    for (const double gap : {0.0104, 0.010385, 0.01038, 0.0103}) {
        std::vector<Memory> memory(1);
        memory[0].look_at(0);
        for (const bool remembers : {false, true}) {
            put({y}, gap, *batch, remembers ? &memory : nullptr);
            batch->depth = 0.0104;
            remembers ? search.find(*batch, {}) : search.search(*batch, {});
            EXPECT_TRUE(same(batch->retained(0), exhaustive(tool, y, {gap, 0.0104, 0}, {}))) << gap;
        }
    }
}

TEST(AskedAgain, WantsCoresWhenManyAreAskedAgain) {
    AskedAgain judge;
    PathTally all, many, few;
    all.searched = 1000;
    many.searched = 100;
    few.searched = 10;
    judge.add(all, 1000, 2000);  // the first cycle searches for all, which says nothing
    EXPECT_FALSE(judge.often());
    for (int c = 0; c < 24; ++c)
        judge.add(many, 1000, 2000);
    EXPECT_TRUE(judge.often());
    for (int c = 0; c < 24; ++c)
        judge.add(few, 1000, 2000);
    EXPECT_TRUE(judge.often()) << "cores that are there are used";
    AskedAgain other;
    for (int c = 0; c < 24; ++c)
        other.add(few, 1000, 2000);
    EXPECT_FALSE(other.often());
    AskedAgain wide;
    for (int c = 0; c < 24; ++c)
        wide.add(many, 1000, 10000);
    EXPECT_FALSE(wide.often()) << "few nodes pass each sub-triangle";
}

/// Above corners, sides, middles and centres, on the surface, and anywhere.
V3 hard_place(const Tool& tool, std::mt19937_64& random) {
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
    for (const Tool& tool : ball_tools()) {
        for (const bool lift : {false, true}) {
            Rules rules;
            rules.lift_leaning = lift;
            const Search search(tool, {reach, reach, 0.01, lift}, {});
            std::vector<V3> y;
            for (int i = 0; i < 100; ++i)
                y.push_back(hard_place(tool, random));
            put(y, 0.8 * reach, *batch, nullptr);
            search.search(*batch, rules);
            EXPECT_EQ(batch->tally.searched, 100);
            for (int i = 0; i < batch->count; ++i) {
                const V3& at = y[static_cast<size_t>(i)];
                ASSERT_TRUE(same(batch->retained(i), exhaustive(tool, at, {0.8 * reach, reach, 0}, rules)))
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
