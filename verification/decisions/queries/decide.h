/// @file Answers to questions, by any of the implementations.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reference/contact/projection.h"
#include "reference/contract/decision_stage_counts.h"
#include "verification/decisions/queries/query.h"

namespace type21 {

enum class DecideWith {
    reference,  ///< stages, exact
    optimized,  ///< the other implementation, exact
    exact,      ///< rational numbers alone: slow, to check the others
    plain       ///< double alone: may be wrong
};

/// "reference", "optimized", "exact", "double": the words of --with.
std::string_view name(DecideWith method);
std::vector<std::string> method_names();
/// @throws std::invalid_argument for a name that is not one
DecideWith method_named(std::string_view name);

/// The answer without its margin.
/// @param stage_counts  counts, where the method has stages
DecisionAnswer decide(const DecisionTool& tool, const DecisionQuery& query, DecideWith method,
                      DecisionStageCounts* stage_counts = nullptr);

/// The rules of a decision, for those who change one.
struct DecisionRules {
    reference::ProjectionLimits<double> limits;
    bool proximity_competes = false;  ///< D11: contact and proximity compete on kappa alone
};

/// The reference by other rules than those of the page.
DecisionAnswer decide_by(const DecisionTool& tool, const DecisionQuery& query, const DecisionRules& rules);

/// How far the node may move before another answer, to first order [length]; infinite where nothing is in reach.
double margin(const DecisionTool& tool, const DecisionQuery& query);

/// A length in units of the last place of the point's largest coordinate.
double in_ulps(double length, const Vec3& point);

/// Named warnings on a tool: segments without area, normals that are not of unit length; each once with a count.
std::vector<std::string> warnings(const DecisionTool& tool);

}  // namespace type21
