/// @file Answers to queries, by the reference, by the optimized implementation, or in one arithmetic only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/contract/decision_stage_counts.h"
#include "verification/decisions/queries/decision_block.h"

namespace type21 {

enum class DecideWith {
    reference,   ///< the reference, exact: in stages
    optimized,   ///< the optimized implementation, exact; every segment competes
    by_tree,     ///< the same, among the segments that its tree finds
    by_sorting,  ///< the same, among those that its sorted search finds
    exact,       ///< rational numbers only: slow, to check the others
    plain        ///< plain double only: may be wrong
};

/// "reference", "optimized", "exact", "double": the words of --with. And "optimized-tree", "optimized-sorted".
std::string_view name(DecideWith method);
/// The words of --with.
std::vector<std::string> method_names();
/// @throws std::invalid_argument for a name that is not one
DecideWith method_named(std::string_view name);

/// The answer, without its margin.
/// @param counts  the decision is added to them, where the method has stages (reference)
/// @throws std::invalid_argument where `optimized` is asked with limits other than the documented ones
DecisionAnswer decide(const DecisionTool& tool, const ContactQuery& query, DecideWith method,
                      DecisionStageCounts* counts = nullptr);

/// How far the node may move before another answer, to first order [length]; infinite where nothing is in reach.
/// reference::decision_margin() says what it means.
double margin(const DecisionTool& tool, const ContactQuery& query);

/// A length in units of the last place of the point's largest coordinate.
double in_ulps(double length, const Vec3& point);

/// Warnings about a tool: segments without area, normals that are not of unit length. One line each, with a count.
std::vector<std::string> warnings(const DecisionTool& tool);

}  // namespace type21
