/// @file Families of questions: generators of hard queries, each for one difficulty. `type21 fuzz` draws from them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "verification/decisions/queries/decision_block.h"
#include "verification/decisions/question_families/draw.h"

namespace type21 {

constexpr int queries_per_block = 32;

/// One kind of difficulty.
struct QuestionFamily {
    std::string_view name;
    std::string_view what;                   ///< what is hard in it
    DecisionBlock (*make)(Draw&) = nullptr;  ///< a tool with queries_per_block queries
};

/// All of them, in the order of the atlas.
std::span<const QuestionFamily> question_families();
/// @return nullptr where there is no such name
const QuestionFamily* question_family_named(std::string_view name);

/// The block with this index. A pure function: the same bits on every machine.
DecisionBlock block_of(const QuestionFamily& family, std::uint64_t seed, std::uint64_t index);

// What question_families() lists, by the file that makes them.

// shapes of segments: segments.cpp
DecisionBlock make_slivers(Draw& draw);
DecisionBlock make_quads(Draw& draw);
DecisionBlock make_high_aspect(Draw& draw);
DecisionBlock make_one_triangle(Draw& draw);
DecisionBlock make_leaning_normals(Draw& draw);
DecisionBlock make_soup(Draw& draw);

// connections of segments: connections.cpp
DecisionBlock make_duplicates(Draw& draw);
DecisionBlock make_t_junctions(Draw& draw);
DecisionBlock make_convex_folds(Draw& draw);
DecisionBlock make_concave_folds(Draw& draw);
DecisionBlock make_medial_axis(Draw& draw);
DecisionBlock make_cylinder(Draw& draw);
DecisionBlock make_thin_sheets(Draw& draw);

// equal candidates and limits met: ties.cpp
DecisionBlock make_on_features(Draw& draw);
DecisionBlock make_mesh_on_mesh(Draw& draw);
DecisionBlock make_fans(Draw& draw);
DecisionBlock make_limits_met(Draw& draw);

// sizes of numbers: scales.cpp
DecisionBlock make_tiny_gap(Draw& draw);
DecisionBlock make_far_away(Draw& draw);
DecisionBlock make_extreme_scales(Draw& draw);
DecisionBlock make_denormals(Draw& draw);

}  // namespace type21
