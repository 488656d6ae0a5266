// Segments that a surface holds more than once.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/repeated_segments.h"

namespace type21::test {
namespace {

Surface surface_of(const std::vector<std::array<int, 4>>& segments) {
    Surface surface;
    for (const auto& nodes : segments)
        surface.segments.push_back({nodes, -1});
    return surface;
}

TEST(RepeatedSegments, AreFoundByTheirNodesInAnyOrder) {
    using Ranks = std::vector<int>;
    EXPECT_EQ(repeated_segments(surface_of({})), Ranks{});
    EXPECT_EQ(repeated_segments(surface_of({{0, 1, 2, 3}, {1, 4, 5, 2}, {4, 6, 5, 5}})), Ranks{});
    EXPECT_EQ(repeated_segments(surface_of({{0, 1, 2, 3}, {2, 3, 0, 1}})), Ranks{1}) << "it begins elsewhere";
    EXPECT_EQ(repeated_segments(surface_of({{0, 1, 2, 3}, {3, 2, 1, 0}})), Ranks{1}) << "from the other side";
    EXPECT_EQ(repeated_segments(surface_of({{0, 1, 2, 2}, {1, 2, 0, 0}, {5, 6, 7, 8}, {0, 1, 2, 2}})), (Ranks{1, 3}));
    EXPECT_EQ(repeated_segments(surface_of({{0, 1, 2, 3}, {0, 1, 2, 2}})), Ranks{}) << "a quad and a part of it";
}

/// The fixture's blank with its first quad (left, 1.0 mm) three times.
Model with_a_triple() {
    Model model = blank_over_tool();
    auto& segments = model.surfaces[0].segments;
    segments.push_back(segments[0]);
    std::swap(segments.back().node[0], segments.back().node[2]);
    segments.push_back(segments[0]);
    return model;
}

// Quads of 100 mm^2: 25 at node 0. Listed three times and counted each time (D41): 75. Half of the mean thickness of
// the four quads, 1.0, 1.4, 1.0, 1.4 mm: 0.6; with the two more of 1.0 mm 0.5667.
// @manual field surf_IDs; departure D41
TEST(RepeatedSegments, CountOnceInAreasAndInTheMeanThickness) {
    Problems problems;
    Model model = with_a_triple();
    const Interface once = resolve_fields(model, {}, problems);
    EXPECT_DOUBLE_EQ(once.secondary.area[0], 25.0);
    EXPECT_DOUBLE_EQ(once.gapmin, 0.6);
    EXPECT_EQ(model.surfaces[0].repeated, (std::vector<int>{4, 5}));
    const auto said = about(problems, "surf_IDs", Severity::warning);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].value, "2 segments: no. 5, 6");
    EXPECT_NE(said[0].rule.find("counts once"), std::string::npos);

    Problems built_problems;
    Model built = with_a_triple();
    built.as_built.set(Departure::D41);
    const Interface thrice = resolve_fields(built, {}, built_problems);
    EXPECT_DOUBLE_EQ(thrice.secondary.area[0], 75.0);
    EXPECT_NEAR(thrice.gapmin, 0.5 * 6.8 / 6, 1e-15);
    EXPECT_TRUE(built.surfaces[0].repeated.empty());
    EXPECT_EQ(about(built_problems, "surf_IDs", Severity::warning).size(), 1U);
}

// @manual field surf_IDm; departure D41
TEST(RepeatedSegments, OfTheMainSurfaceAreNotedToo) {
    Problems problems;
    Model model = blank_over_tool();
    model.surfaces[1].segments.push_back(model.surfaces[1].segments[0]);
    resolve_fields(model, {}, problems);
    EXPECT_EQ(model.surfaces[1].repeated, std::vector<int>{1});
    EXPECT_EQ(about(problems, "surf_IDm", Severity::warning).size(), 1U);
    Problems none;
    Model sound = blank_over_tool();
    resolve_fields(sound, {}, none);
    EXPECT_TRUE(about(none, "surf_IDm", Severity::warning).empty() &&
                about(none, "surf_IDs", Severity::warning).empty());
}

}  // namespace
}  // namespace type21::test
