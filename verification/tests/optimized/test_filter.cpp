// What the filter proves must be what integers say, near every limit and on every shape.
#include <gtest/gtest.h>

#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized {
namespace {

struct Shape {
    const char* name;
    double stretch, offset, scale, noise;
};

/// A random segment and a node near it, with coordinates that are sometimes coarse, so that ties and limits are met.
struct HostScene {
    SegmentData segment;
    V3 p;
    ContactReach reach;
};

HostScene random_scene(std::mt19937_64& random, const Shape& shape) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const bool coarse = random() % 3 == 0;
    const auto r = [&] { return coarse ? std::round(unit(random) * 8) / 8 : unit(random); };
    const auto place = [&](double x, double y, double z) {
        return V3{(shape.offset + x) * shape.scale, (shape.offset + y * shape.stretch) * shape.scale,
                  (shape.offset + z) * shape.scale};
    };
    HostScene scene;
    scene.segment.is_triangle = random() % 3 == 0;
    const double x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 1, 1};
    for (size_t j = 0; j < 4; ++j) {
        scene.segment.node[j] = place(x[j] + shape.noise * r(), y[j] + shape.noise * r(), shape.noise * r());
        scene.segment.normal[j] = {shape.noise * r(), shape.noise * r(), 1};
    }
    if (scene.segment.is_triangle) {
        scene.segment.node[3] = scene.segment.node[2];
        scene.segment.normal[3] = scene.segment.normal[2];
    }
    const double h = random() % 4 == 0 ? 0.0 : 0.5 * r();
    scene.p = place(0.5 + 0.8 * r(), 0.5 + 0.8 * r(), h);
    scene.reach = {0.25 * shape.scale, 0.5 * shape.scale, random() % 2 == 0 ? 0.0 : 0.4 * shape.scale};
    return scene;
}

class Filter : public ::testing::TestWithParam<Shape> {};

TEST_P(Filter, ProvesOnlyWhatIsTrue) {
    std::mt19937_64 random(7);
    int proven = 0, taken = 0;
    constexpr int scenes = 4000;
    for (int i = 0; i < scenes; ++i) {
        const HostScene s = random_scene(random, GetParam());
        const LocalSegment local = local_segment(s.segment);
        for (int k = 1; k <= s.segment.sub_triangles(); ++k) {
            const ExactProjection exact = project_exact(s.p, s.segment, k, s.reach, {});
            KappaDoubleDouble kappa;
            const FilterResult precise = filter_double_double(s.p, s.segment, k, s.reach, {}, kappa);
            if (precise.verdict != Verdict::unsure) {
                ASSERT_EQ(precise.verdict == Verdict::taken, exact.taken) << "scene " << i << " triangle " << k;
            }
            if (precise.verdict == Verdict::taken) {
                ASSERT_EQ(precise.projection.kind, exact.projection.kind);
                // The exact kappa, rounded to double and what that leaves, against the two doubles.
                const mpq_class truth(exact.kappa_over, 3 * exact.kappa_under);
                const mpq_class found = mpq_class(kappa.value.high) + mpq_class(kappa.value.low);
                ASSERT_TRUE(abs(truth - found) <= mpq_class(kappa.bound)) << "scene " << i << " triangle " << k;
            }
            const FilterResult fast = filter(s.p, s.segment, local, k, s.reach, {});
            if (fast.verdict == Verdict::unsure) continue;
            ++proven;
            ASSERT_EQ(fast.verdict == Verdict::taken, exact.taken) << "scene " << i << " triangle " << k;
            if (!exact.taken) continue;
            ++taken;
            const ProjectionResult &f = fast.projection, &e = exact.projection;
            ASSERT_EQ(f.kind, e.kind);
            if (f.side != 0) {
                ASSERT_EQ(f.side, e.side);
            }
            ASSERT_LE(std::abs(f.b - e.b), f.weight_bound + 1e-15);
            ASSERT_LE(std::abs(f.c - e.c), f.weight_bound + 1e-15);
            ASSERT_LE(std::abs(f.kappa - e.kappa), f.kappa_bound + 1e-15);
        }
    }
    EXPECT_GT(proven, scenes);
    // The bounds of a sliver of 1e-4 are too coarse to prove that it takes a node.
    if (GetParam().stretch == 1) {
        EXPECT_GT(taken, scenes / 10);
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, Filter,
                         ::testing::Values(Shape{"flat", 1, 0, 1, 0}, Shape{"warped", 1, 0, 1, 0.2},
                                           Shape{"leaning", 1, 0, 1, 0.8}, Shape{"sliver", 1e-4, 0, 1, 1e-5},
                                           Shape{"far", 1, 1e6, 1, 0.1}, Shape{"tiny", 1, 0, 1e-40, 0.1},
                                           Shape{"huge", 1, 0, 1e40, 0.1}),
                         [](const auto& shape) { return std::string(shape.param.name); });

TEST(FilterRange, GivesUpWhereItsBoundsDoNotHold) {
    for (const double scale : {1e-150, 1e150, 5e-324}) {
        SegmentData s;
        s.node = {V3{0, 0, 0}, V3{scale, 0, 0}, V3{scale, scale, 0}, V3{0, scale, 0}};
        s.normal = {V3{0, 0, 1}, V3{0, 0, 1}, V3{0, 0, 1}, V3{0, 0, 1}};
        const V3 p{0.5 * scale, 0.25 * scale, 0.125 * scale};
        const ContactReach reach{0.5 * scale, scale, 0};
        EXPECT_EQ(filter(p, s, local_segment(s), 1, reach, {}).verdict, Verdict::unsure) << scale;
        if (scale > 1e-300) {
            EXPECT_TRUE(project_exact(p, s, 1, reach, {}).taken) << scale;
        }
    }
}

}  // namespace
}  // namespace type21::optimized
