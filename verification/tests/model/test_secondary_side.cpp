// Gaps, stiffness, area and mass of the nodes at time 0, by hand.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/secondary_side.h"

namespace type21::test {
namespace {

constexpr auto warning = Severity::warning;

// The blank of the fixture: columns x = 0, 10, 20 of three nodes each; left quads 1.0 mm, right quads 1.4 mm.
// Node k of the secondary side is in column k mod 3.
constexpr int left = 0, middle = 1, right = 2, center = 4;

Interface with(const Fields& fields, Model model, Problems& problems, const std::vector<Departure>& departures = {}) {
    for (const Departure departure : departures)
        model.as_built.set(departure);
    Interface it = resolve_fields(model, fields, problems);
    EXPECT_EQ(problems.error_count(), 0) << to_text(problems.list().front());
    return it;
}

Interface with(const Fields& fields, const std::vector<Departure>& departures = {},
               const Model& model = blank_over_tool()) {
    Problems problems;
    return with(fields, model, problems, departures);
}

// @manual field surf_IDs
TEST(SecondarySide, NodesAscendAndEachIsThereOnce) {
    const Interface it = with({});
    EXPECT_EQ(it.secondary.node, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8}));
    EXPECT_EQ(it.main_nodes, (std::vector<int>{9, 10, 11, 12}));
    EXPECT_EQ(it.shortest_edge, 10.0);
}

TEST(SecondarySide, ThicknessIsTheLargestAtTheNode) {
    const Interface it = with({});
    EXPECT_EQ(it.secondary.thickness[left], 1.0);
    EXPECT_EQ(it.secondary.thickness[middle], 1.4);
    EXPECT_EQ(it.secondary.thickness[right], 1.4);
}

TEST(SecondarySide, VoidShellsHaveStiffnessButNoThickness) {
    // A void shell of 7 mm and E = 1000 over the first quad: S of a corner = mean(200000 * 1, 1000 * 7) = 103500.
    Model model = blank_over_tool();
    Shell shell = model.shells[0];
    shell.part = 2;
    shell.thickness = 7.0;
    model.shells.push_back(shell);
    const Interface it = with({}, {}, model);
    EXPECT_EQ(it.secondary.thickness[0], 1.0);
    EXPECT_EQ(it.secondary.element_stiffness[0], 103500.0);
}

TEST(SecondarySide, StiffnessIsTheMeanOfEtOverTheShells) {
    // Left 200000 * 1.0; right 200000 * 1.4 = 280000; middle: as many of each, 240000.
    const Interface it = with({});
    EXPECT_DOUBLE_EQ(it.secondary.element_stiffness[left], 200000);
    EXPECT_DOUBLE_EQ(it.secondary.element_stiffness[right], 280000);
    EXPECT_DOUBLE_EQ(it.secondary.element_stiffness[center], 240000);
}

TEST(SecondarySide, ShellsBesideTheSurfaceCount) {
    // Only the left quads in the surface: the middle nodes still see the right shells.
    Model model = blank_over_tool();
    model.surfaces[0].segments = {model.surfaces[0].segments[0], model.surfaces[0].segments[2]};
    const Interface it = with({}, {}, model);
    ASSERT_EQ(it.secondary.size(), 6);
    EXPECT_EQ(it.secondary.thickness[1], 1.4);
    EXPECT_DOUBLE_EQ(it.secondary.element_stiffness[1], 240000);
    EXPECT_DOUBLE_EQ(it.secondary.area[1], 25.0) << "area of the surface's own segment only";
}

TEST(SecondarySide, AreaIsAQuarterOfEachQuadAndAThirdOfEachTriangle) {
    // Quads of 100 mm^2: 25 at a corner of the sheet, 50 at an edge, 100 in the middle.
    const Interface it = with({});
    EXPECT_DOUBLE_EQ(it.secondary.area[0], 25.0);
    EXPECT_DOUBLE_EQ(it.secondary.area[1], 50.0);
    EXPECT_DOUBLE_EQ(it.secondary.area[center], 100.0);
    // First quad (0 1 4 3) as two triangles of 50 mm^2: nodes 0 and 4 are in both, 1 and 3 in one.
    Model model = blank_over_tool();
    model.surfaces[0].segments[0].node = {0, 1, 4, 4};
    model.surfaces[0].segments.push_back({{0, 4, 3, 3}, 0});
    const Interface tri = with({}, {}, model);
    EXPECT_DOUBLE_EQ(tri.secondary.area[0], 100.0 / 3);
    EXPECT_DOUBLE_EQ(tri.secondary.area[1], 50.0 / 3 + 25.0);
    EXPECT_DOUBLE_EQ(tri.secondary.area[center], 100.0 / 3 + 75.0);
    EXPECT_EQ(tri.shortest_edge, 10.0) << "the repeated node has no side";
}

TEST(SecondarySide, AreaOfASkewQuadIsHalfTheCrossProductOfItsDiagonals) {
    // (0,0) (3,0) (4,2) (0,1): d1 = (4,2), d2 = (-3,1): |4*1 + 2*3| / 2 = 5.
    Model model;
    for (const Vec3& x : {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(4, 2, 0), Vec3(0, 1, 0)}) {
        model.nodes.id.push_back(model.nodes.size() + 1);
        model.nodes.position.push_back(x);
    }
    Surface surface;
    surface.segments.push_back({{0, 1, 2, 3}, -1});
    EXPECT_DOUBLE_EQ(nodal_area(model, surface, {0, 1, 2, 3})[2], 1.25);
    EXPECT_DOUBLE_EQ(shortest_edge(model, surface), 1.0);
}

TEST(SecondarySide, MassComesFromTheModel) {
    const Interface it = with({});
    EXPECT_DOUBLE_EQ(it.secondary.mass[0], 0.001);
    EXPECT_DOUBLE_EQ(it.secondary.mass[8], 0.009);
}

// ---- gaps
// ----------------------------------------------------------------------------------------------------------------

// @manual field Igap, Gapmin; comment 2
TEST(Gap, Igap0IsGapmin) {
    const Interface it = with({{"Gapmin", "0.3"}});
    for (const double gap : it.secondary.gap)
        EXPECT_EQ(gap, 0.3);
    EXPECT_EQ(it.secondary.search_gap, it.secondary.gap);
    EXPECT_EQ(it.largest_gap, 0.3);
    EXPECT_EQ(it.smallest_gap_raw, 0.3);
}

Model three_thin_one_thick() {
    // Quads 1, 2, 3: 1.0 mm, quad 4: 3.0 mm. Mean over shells (1+1+1+3)/4 = 1.5. Nodal maxima: 3.0 at the four nodes of
    // quad 4 (5, 6, 8, 9), 1.0 at the other five: mean over nodes (4*3 + 5)/9 = 17/9.
    Model model = blank_over_tool();
    for (size_t i = 0; i < 4; ++i)
        model.shells[i].thickness = i == 3 ? 3.0 : 1.0;
    return model;
}

// @manual field Gapmin; comment 2
TEST(Gap, GapminDefaultIsHalfTheMeanOfTheShells) {
    const Interface it = with({}, {}, three_thin_one_thick());
    EXPECT_DOUBLE_EQ(it.gapmin, 0.75);
    EXPECT_EQ(it.gapmin.origin.kind, Origin::Kind::fallback);
    EXPECT_DOUBLE_EQ(it.secondary.gap[0], 0.75);
}

TEST(Gap, TheMeanOfEqualThicknessesIsThatThickness) {
    // 0.1 + 0.1 + 0.1 is not 0.3 in binary; the gap of an even sheet is half of its thickness all the same.
    Model model = blank_over_tool();
    model.surfaces[0].segments.pop_back();
    for (size_t i = 0; i < 4; ++i)
        model.shells[i].thickness = 0.1;
    EXPECT_EQ(with({}, {}, model).gapmin, 0.05);
    EXPECT_EQ(with({}, {Departure::D19}, model).gapmin, 0.05);
}

// @manual departure D19
TEST(Gap, D19GapminDefaultIsHalfTheMeanOfTheNodalMaxima) {
    const Interface it = with({}, {Departure::D19}, three_thin_one_thick());
    EXPECT_DOUBLE_EQ(it.gapmin, 0.5 * 17.0 / 9.0);
    EXPECT_DOUBLE_EQ(it.secondary.gap[0], 0.5 * 17.0 / 9.0);
    EXPECT_NE(it.gapmin.origin.why.find("D19"), std::string::npos);
}

TEST(Gap, Igap0WithoutThicknessWarns) {
    Model model = blank_over_tool();
    for (Segment& segment : model.surfaces[0].segments)
        segment.shell = -1;
    Problems problems;
    EXPECT_EQ(with({}, model, problems).gapmin, 0.0);
    EXPECT_EQ(about(problems, "Gapmin", warning).size(), 1u);
}

// @manual eq 1; field Igap; comment 2
TEST(Gap, Igap1IsHalfTheThickness) {
    const Interface it = with({{"Igap", "1"}});
    EXPECT_DOUBLE_EQ(it.secondary.gap[left], 0.5);
    EXPECT_DOUBLE_EQ(it.secondary.gap[middle], 0.7);
    EXPECT_DOUBLE_EQ(it.secondary.gap[right], 0.7);
    EXPECT_DOUBLE_EQ(it.largest_gap, 0.7);
    EXPECT_DOUBLE_EQ(it.smallest_gap_raw, 0.5);
    EXPECT_EQ(it.gapmin, 0.0) << "no default with Igap 1";
}

// @manual eq 1; field Fscalegap, Gapmin, Gapmax; comment 2
TEST(Gap, Igap1IsScaledAndBounded) {
    // Half thicknesses 0.5 and 0.7 times 2: 1.0 and 1.4; bounds 1.1 and 1.2.
    const Interface it = with({{"Igap", "1"}, {"Fscalegap", "2.0"}, {"Gapmin", "1.1"}, {"Gapmax", "1.2"}});
    EXPECT_DOUBLE_EQ(it.secondary.gap[left], 1.1);
    EXPECT_DOUBLE_EQ(it.secondary.gap[right], 1.2);
    EXPECT_DOUBLE_EQ(it.smallest_gap_raw, 1.0) << "before the bounds";
}

// @manual field Gapmin, Gapmax; comment 2
TEST(Gap, GapminWinsOverGapmax) {
    const Interface it = with({{"Igap", "1"}, {"Gapmin", "2.0"}, {"Gapmax", "1.0"}});
    for (const double gap : it.secondary.gap)
        EXPECT_EQ(gap, 2.0);
}

TEST(Gap, NodesWithoutShellHaveTheGapmin) {
    Model model = blank_over_tool();
    for (Segment& segment : model.surfaces[0].segments)
        segment.shell = -1;
    model.shells.erase(model.shells.begin(), model.shells.begin() + 4);
    model.surfaces[1].segments[0].shell = 0;
    const Interface it = with({{"Igap", "1"}, {"Gapmin", "0.2"}}, {}, model);
    EXPECT_EQ(it.secondary.gap[0], 0.2);
    EXPECT_EQ(it.smallest_gap_raw, 0.0);
}

// @manual eq 3; comment 2
TEST(Gap, ContactThicknessReplacesTheThickness) {
    // Part 0 (left) with Thick 3: half of it 1.5; the middle belongs to both parts, the larger holds; right keeps 0.7.
    Model model = blank_over_tool();
    model.parts[0].contact_thickness = 3.0;
    const Interface it = with({{"Igap", "1"}}, {}, model);
    EXPECT_EQ(it.secondary.contact_thickness[left], 3.0);
    EXPECT_DOUBLE_EQ(it.secondary.gap[left], 1.5);
    EXPECT_DOUBLE_EQ(it.secondary.gap[middle], 1.5);
    EXPECT_DOUBLE_EQ(it.secondary.gap[right], 0.7);
    EXPECT_EQ(it.secondary.contact_thickness[right], 0.0);
}

// The same at time 0 with Igap 2, scaled: 0.8 * 3 / 2 where the part has Thick 3, else 0.8 * 1.4 / 2.
// @manual eq 2, 4; field Igap, Fscalegap; comment 2
TEST(Gap, Igap2StartsFromTheContactThickness) {
    Model model = blank_over_tool();
    model.parts[0].contact_thickness = 3.0;
    const Interface it = with({{"Igap", "2"}, {"Fscalegap", "0.8"}}, {}, model);
    EXPECT_DOUBLE_EQ(it.secondary.gap[left], 1.2);
    EXPECT_DOUBLE_EQ(it.secondary.gap[middle], 1.2);
    EXPECT_DOUBLE_EQ(it.secondary.gap[right], 0.56);
}

Model tool_has_lowest_ids() {
    // Four lone nodes 1..4 in front, so that no node of the blank is among the lowest ids.
    Model model = blank_over_tool();
    const auto shift = [](auto& nodes) {
        for (int& node : nodes)
            node += 4;
    };
    for (Shell& shell : model.shells)
        shift(shell.node);
    for (Surface& surface : model.surfaces)
        for (Segment& segment : surface.segments)
            shift(segment.node);
    shift(model.rigid_bodies[0].nodes);
    model.rigid_bodies[0].main_node += 4;
    model.nodes.id.insert(model.nodes.id.begin(), {1, 2, 3, 4});
    model.nodes.position.insert(model.nodes.position.begin(), 4, Vec3(500, 0, 0));
    model.nodal_mass.insert(model.nodal_mass.begin(), 4, 0.0);
    return model;
}

// @manual departure D29
TEST(Gap, D29TakesThePartOfTheLastSegment) {
    // The lowest four nodes never get a value, so each corner takes the part of the segment at hand: the last one
    // visited wins. Part 0 has 3.0, part 1 has 0: the middle nodes end with quad 2 (row 0), quad 4 (rows 1, 2), that is
    // 0 -> thickness 1.4.
    Model model = tool_has_lowest_ids();
    model.parts[0].contact_thickness = 3.0;
    const Interface it = with({{"Igap", "1"}}, {Departure::D29}, model);
    EXPECT_DOUBLE_EQ(it.secondary.gap[left], 1.5);
    EXPECT_DOUBLE_EQ(it.secondary.gap[middle], 0.7);
    EXPECT_DOUBLE_EQ(it.secondary.gap[center], 0.7);
    const Interface documented = with({{"Igap", "1"}}, {}, model);
    EXPECT_DOUBLE_EQ(documented.secondary.gap[middle], 1.5);
}

TEST(Gap, D29LowestNodesOfTheBlankPolluteTheOthers) {
    // Blank nodes 0..3 are the model's lowest four. Quad 1 (nodes 0 1 4 3, Thick 3): corner 1 -> node 0: max(tc[0], 3)
    // = 3, corner 2 -> node 1: max(tc[1], 3) = 3, corner 3 -> node 4: max(tc[2] = 0, 3) = 3, corner 4 -> node 3: 3.
    // Quad 2 (1 2 5 4, Thick 0): node 1: tc[0] = 3; node 2: tc[1] = 3; node 5: tc[2] = 3; node 4: tc[3] = 3. And so on:
    // all 3.
    Model model = blank_over_tool();
    model.parts[0].contact_thickness = 3.0;
    const Interface it = with({{"Igap", "1"}}, {Departure::D29}, model);
    for (const double thickness : it.secondary.contact_thickness)
        EXPECT_EQ(thickness, 3.0);
}

TEST(Gap, D29TriangleRepeatsItsThirdNodeAsTheFourth) {
    // One triangle (0 1 4): corner 3 -> node 4 := max(tc[2], Thick), corner 4 -> node 4 again := max(tc[3], Thick).
    // Node 3 holds 3.0 from a triangle before (3 ... ) so that the fourth corner brings it: first triangle (3 4 7) of
    // part 0, Thick 3, gives nodes 3, 4, 7 the 3.0; second (1 2 5) of part 1, Thick 0: node 1 <- tc[0] = 0, node 2 <-
    // tc[1] = 0, node 5 <- tc[2] = 0 as corner 3, then <- tc[3] = 3 as corner 4.
    Model model = blank_over_tool();
    model.parts[0].contact_thickness = 3.0;
    model.surfaces[0].segments = {{{3, 4, 7, 7}, 2}, {{1, 2, 5, 5}, 1}};
    const Interface it = with({{"Igap", "1"}}, {Departure::D29}, model);
    EXPECT_EQ(it.secondary.node, (std::vector<int>{1, 2, 3, 4, 5, 7}));
    EXPECT_EQ(it.secondary.contact_thickness, (std::vector<double>{0, 0, 3, 3, 3, 3}));
}

// @manual departure D33
TEST(Gap, D33SearchesWithTheLargestGap) {
    // Gaps 0.5 and 0.7 with Gapmin 0.6: g0 = 0.6, 0.7; G = 0.7; search: max(min(g_s, Gapmax), G) = 0.7 everywhere.
    const Fields fields{{"Igap", "1"}, {"Gapmin", "0.6"}};
    const Interface documented = with(fields);
    EXPECT_DOUBLE_EQ(documented.secondary.search_gap[left], 0.6);
    const Interface built = with(fields, {Departure::D33});
    EXPECT_DOUBLE_EQ(built.secondary.search_gap[left], 0.7);
    EXPECT_DOUBLE_EQ(built.secondary.search_gap[right], 0.7);
    EXPECT_DOUBLE_EQ(built.secondary.gap[left], 0.6) << "the force keeps the node's own gap";
    const Interface igap0 = with({{"Gapmin", "0.3"}}, {Departure::D33});
    EXPECT_EQ(igap0.secondary.search_gap[left], 0.3);
}

// ---- DEPTH
// ---------------------------------------------------------------------------------------------------------------

// @manual field DEPTH; comment 4
TEST(Depth, DefaultIsTheLargerOfGapAndShortestEdge) {
    EXPECT_EQ(with({}).depth, 10.0);
    EXPECT_EQ(with({{"Gapmin", "12.0"}}).depth, 12.0);
    EXPECT_EQ(with({}).depth.origin.kind, Origin::Kind::fallback);
}

TEST(Depth, IsRaisedToTheLargestGap) {
    const Interface it = with({{"Igap", "1"}, {"DEPTH", "0.1"}});
    EXPECT_DOUBLE_EQ(it.depth, 0.7);
    EXPECT_EQ(it.depth.origin.kind, Origin::Kind::rule);
    EXPECT_NE(it.depth.origin.why.find("0.1"), std::string::npos);
    EXPECT_EQ(with({{"Igap", "1"}, {"DEPTH", "0.9"}}).depth, 0.9);
}

TEST(Depth, LargerThanTheMeshIsNamedWithBothNumbers) {
    Problems problems;
    with({{"DEPTH", "10.5"}}, blank_over_tool(), problems);
    const auto notes = about(problems, "DEPTH", warning);
    ASSERT_EQ(notes.size(), 1u);
    EXPECT_EQ(notes[0].value, "10.5 mm");
    EXPECT_NE(notes[0].rule.find("10 mm"), std::string::npos);
    Problems none;
    with({{"DEPTH", "10.0"}}, blank_over_tool(), none);
    EXPECT_TRUE(none.list().empty());
}

/// DEPTH is raised to the gap, so a gap longer than an edge is the cause, and the field that makes it so is named.
TEST(Depth, AGapLongerThanTheMeshIsNamedByWhatMakesIt) {
    const auto blamed = [](const Fields& fields) {
        Problems problems;
        with(fields, blank_over_tool(), problems);
        EXPECT_EQ(problems.list().size(), 1u);
        return problems.list().empty() ? Problem{} : problems.list()[0];
    };
    const Problem gapmin = blamed({{"Gapmin", "12.0"}, {"DEPTH", "2.5"}});
    EXPECT_EQ(gapmin.field, "Gapmin");
    EXPECT_EQ(gapmin.value, "12 mm");
    EXPECT_NE(gapmin.remedy.find("smaller Gapmin"), std::string::npos);
    EXPECT_EQ(blamed({{"Igap", "1"}, {"Gapmin", "12.0"}}).field, "Gapmin");
    const Problem scaled = blamed({{"Igap", "1"}, {"Fscalegap", "20.0"}});
    EXPECT_EQ(scaled.field, "Fscalegap");
    EXPECT_NE(scaled.remedy.find("Gapmax"), std::string::npos);
    Problems none;
    with({{"Igap", "1"}, {"Fscalegap", "20.0"}, {"Gapmax", "9.0"}}, blank_over_tool(), none);
    EXPECT_TRUE(none.list().empty());
}

}  // namespace
}  // namespace type21::test
