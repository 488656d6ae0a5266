#include "verification/decisions/question_families/question_family.h"

#include <array>

namespace type21 {

std::span<const QuestionFamily> question_families() {
    static constexpr std::array<QuestionFamily, 21> all{{
        {"slivers", "segments flattened by 2^-1 to 2^-60, needles, and collinear ones", make_slivers},
        {"quads", "warped, folded, crossed and collapsed quads", make_quads},
        {"high_aspect", "segments 1e9 times longer than wide", make_high_aspect},
        {"one_triangle", "a tool of a single triangle, its normals leaning", make_one_triangle},
        {"leaning_normals", "nodal normals that cancel in the mean, vanish, or lean away", make_leaning_normals},
        {"soup", "random nodes, normals and segments, without any relation", make_soup},
        {"duplicates", "segments twice, nodes twice, segments that face each other", make_duplicates},
        {"t_junctions", "a fine mesh against a coarse one, with cracks from one ulp to 2 %", make_t_junctions},
        {"convex_folds", "two strips that meet at 1 to 179 degrees, measured through the material", make_convex_folds},
        {"concave_folds", "two strips that meet at 1 to 179 degrees, measured through free space", make_concave_folds},
        {"medial_axis", "a trough, its node at the centre of curvature, all segments at the same distance",
         make_medial_axis},
        {"cylinder", "a faceted cylinder: edges with nearly equal candidates", make_cylinder},
        {"thin_sheets", "two sheets closer than the gap, back to back or stacked", make_thin_sheets},
        {"on_features", "on faces, edges, corners and centre lines of an integer lattice, exactly", make_on_features},
        {"mesh_on_mesh", "a structured mesh right above a structured mesh of decimal pitch", make_mesh_on_mesh},
        {"fans", "3 to 12 segments around an apex: ties of many", make_fans},
        {"limits_met", "weights of -0.01 and 1.01, distances equal to gap, DEPTH and reach, and an ulp beside them",
         make_limits_met},
        {"tiny_gap", "a gap of 1e-9 on a tool at 1e6 or 1e9", make_tiny_gap},
        {"far_away", "a tool whose segments are 1 to 1e5 ulps of its offset long", make_far_away},
        {"extreme_scales", "coordinates of 1e-150 to 1e150", make_extreme_scales},
        {"denormals", "coordinates and limits of a few smallest doubles", make_denormals},
    }};
    return all;
}

const QuestionFamily* question_family_named(std::string_view name) {
    for (const QuestionFamily& family : question_families())
        if (family.name == name) return &family;
    return nullptr;
}

DecisionBlock block_of(const QuestionFamily& family, std::uint64_t seed, std::uint64_t index) {
    Draw draw(family.name, seed, index);
    return family.make(draw);
}

}  // namespace type21
