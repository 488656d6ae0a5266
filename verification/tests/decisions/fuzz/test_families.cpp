#include <cmath>
#include <set>

#include <gtest/gtest.h>

#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/question_families/question_family.h"
#include "verification/decisions/question_families/tool_shapes.h"

namespace type21 {
namespace {

/// FNV-1a over the bits of all numbers of a block.
std::uint64_t fingerprint(const DecisionBlock& block) {
    const std::string text = to_json(DecisionFile{"", "", {block}}).dump();
    std::uint64_t hash = 0xcbf29ce484222325ULL;
    for (const char letter : text)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3ULL;
    return hash;
}

TEST(Draw, is_a_pure_function_of_name_seed_and_index) {
    Draw draw("", 0, 0);
    Draw same("", 0, 0);
    Draw other("", 0, 1);
    for (int i = 0; i < 100; ++i) {
        const auto bits = draw.bits();
        EXPECT_EQ(bits, same.bits());
        EXPECT_NE(bits, other.bits());
    }
}

TEST(Draw, fills_its_ranges_and_never_leaves_them) {
    Draw draw("range", 1, 2);
    std::set<int> seen;
    double sum = 0;
    for (int i = 0; i < 10000; ++i) {
        seen.insert(draw.below(7));
        const double u = draw.unit();
        ASSERT_GE(u, 0);
        ASSERT_LT(u, 1);
        sum += u;
    }
    EXPECT_EQ(seen, (std::set<int>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_NEAR(sum / 10000, 0.5, 0.015);  // 5 standard deviations of 1 / sqrt(12 * 10000)
}

TEST(Draw, moves_by_ulps) {
    EXPECT_EQ(moved(1.0, 1), std::nextafter(1.0, 2.0));
    EXPECT_EQ(moved(1.0, -2), 1.0 - 0x1p-52);
    EXPECT_EQ(moved(0.0, 1), 0x1p-1074);
    EXPECT_EQ(moved(3.0, 0), 3.0);
}

TEST(Draw, turns_like_the_mathematical_library) {
    for (double degrees = -180; degrees <= 360; degrees += 7.5) {
        const Turn here = turn(degrees);
        const double radians = degrees * std::acos(-1.0) / 180;
        EXPECT_NEAR(here.cosine, std::cos(radians), 4e-15) << degrees;
        EXPECT_NEAR(here.sine, std::sin(radians), 4e-15) << degrees;
    }
}

TEST(Draw, makes_unit_vectors_at_every_scale) {
    for (const double scale : {1e-320, 1e-150, 1.0, 1e150, 1e308}) {
        const Vec3 n = unit_vector(Vec3(3 * (scale / 5), 0, -4 * (scale / 5)));
        EXPECT_NEAR(n.norm(), 1, 1e-3) << scale;
        EXPECT_NEAR(n.x(), 0.6, scale < 1e-300 ? 1e-3 : 1e-15) << scale;
    }
    EXPECT_EQ(unit_vector(Vec3::Zero()), Vec3::Zero());
}

TEST(Families, have_names_of_their_own) {
    std::set<std::string_view> names;
    for (const QuestionFamily& family : question_families()) {
        EXPECT_TRUE(names.insert(family.name).second) << family.name;
        EXPECT_EQ(question_family_named(family.name), &family);
        EXPECT_FALSE(family.what.empty());
    }
    EXPECT_EQ(question_family_named("nothing"), nullptr);
}

TEST(Families, give_valid_blocks_that_depend_on_seed_and_index_alone) {
    for (const QuestionFamily& family : question_families()) {
        std::set<std::uint64_t> seen;
        for (std::uint64_t index = 0; index < 20; ++index) {
            const DecisionBlock block = block_of(family, 5, index);
            EXPECT_EQ(block.queries.size(), static_cast<size_t>(queries_per_block)) << family.name;
            EXPECT_EQ(block.tool.node.size(), block.tool.normal.size()) << family.name;
            // The reader knows what a valid block is: finite numbers, ranks of nodes, limits of 0 or more.
            std::vector<std::string> problems;
            decisions_of(nlohmann::json::parse(to_json(DecisionFile{"", "", {block}}).dump()), "block", problems);
            EXPECT_TRUE(problems.empty()) << family.name << " " << index << ": " << problems[0];
            EXPECT_EQ(fingerprint(block), fingerprint(block_of(family, 5, index))) << family.name;
            seen.insert(fingerprint(block));
            seen.insert(fingerprint(block_of(family, 6, index)));
        }
        EXPECT_EQ(seen.size(), 40U) << family.name;
    }
}

TEST(ToolShapes, have_the_nodal_normals_of_the_formulation) {
    // Two squares at a right angle: at the common nodes two unit normals of each, (0,0,1) and (-1,0,0).
    DecisionTool tool = drawn_profile(2, 1, 1, [](int i) { return Vec3(i < 2 ? i - 1.0 : 0.0, 0, i < 2 ? 0.0 : 1.0); });
    set_normals(tool);
    EXPECT_NEAR(tool.normal[0].z(), 1, 1e-15);
    EXPECT_NEAR(tool.normal[1].x(), -std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(tool.normal[1].z(), std::sqrt(0.5), 1e-15);
    EXPECT_NEAR(tool.normal[2].x(), -1, 1e-15);
    // Opposite segments on the same nodes leave none.
    tool = sheet(1, 1, [](int i, int j) { return Vec3(i, j, 0); });
    tool.segment.push_back({2, 3, 1, 0});
    set_normals(tool);
    EXPECT_EQ(tool.normal[0], Vec3::Zero());
}

}  // namespace
}  // namespace type21
