/// @file The scenes on which methods are compared: queries from easy to adversarial.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "verification/decisions/queries/decision_block.h"

namespace type21::accuracy {

/// One tool and queries about nodes near it.
struct QueryBlock {
    DecisionTool tool;
    std::vector<ContactQuery> queries;
    std::vector<Vec3> before;  ///< position of each node one cycle ago, for searches that remember [length]
};

/// A scene: how hard its queries are, and how they are made.
struct SceneKind {
    std::string_view name;
    std::string_view kind;  ///< "easy", "common", "adversarial"
    std::string_view what;
    /// @param count  queries
    std::vector<QueryBlock> (*make)(size_t count, std::uint64_t seed) = nullptr;
};

/// In the order of the report. Lengths of the first four are mm; each tool has 40 x 40 quads.
std::span<const SceneKind> scene_kinds();
/// @return nullptr where there is no such name
const SceneKind* scene_named(std::string_view name);

}  // namespace type21::accuracy
