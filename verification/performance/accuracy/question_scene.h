/// @file Scenes of the comparison of methods: questions to a contact, from easy to adversarial.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "verification/decisions/queries/query.h"

namespace type21::accuracy {

/// Questions to one tool.
struct QuestionBlock {
    DecisionTool tool;
    std::vector<DecisionQuery> queries;
    std::vector<Vec3> before;  ///< where each node was one cycle ago: for searches that remember [length]
};

/// How hard the questions are.
struct SceneKind {
    std::string_view name;
    std::string_view kind;  ///< "easy", "common", "adversarial"
    std::string_view what;
    /// @param count  decisions
    std::vector<QuestionBlock> (*make)(size_t count, std::uint64_t seed) = nullptr;
};

/// In the order of the report. Lengths of the first four are mm; each tool has 40 x 40 quads.
std::span<const SceneKind> scene_kinds();
/// Nothing for a name that is not one.
const SceneKind* scene_named(std::string_view name);

}  // namespace type21::accuracy
