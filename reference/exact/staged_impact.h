/// @file The retained impact as real arithmetic on the given doubles would choose it (formulation sections 4 and 10).
#pragma once

#include <functional>
#include <span>

#include "reference/contact/retained_impact.h"
#include "reference/contract/decision_stage_counts.h"

namespace type21::reference {

/// Rank of a segment -> its shape in the tool frame.
using ShapeOf = std::function<SegmentShape<double>(int)>;

/// What a decision is asked of: all doubles, taken as exact.
struct DecisionInput {
    Vec3 point = Vec3::Zero();      ///< node in the tool frame, finite [length]
    std::span<const int> segments;  ///< ranks of those that may reach it; others must not be able to
    const ShapeOf& shape_of;
    ContactReach<double> reach;
    ProjectionLimits<double> limits;
    bool proximity_competes = false;  ///< D11
};

/// The decision is exact, the magnitudes are doubles close to the exact ones (magnitudes.h).
struct StagedImpact {
    Kind kind = Kind::none;
    int segment = -1;
    int triangle = 0;
    int side = 0;
    Stage stage = Stage::bounded;   ///< the last that was needed
    Projection<double> projection;  ///< of the retained sub-triangle
};

/// Each sub-triangle is judged by the first stage that can tell; where the enclosures of kappa of two impacts overlap,
/// the exact ones are compared. The text that decides is retained_impact.h and projection.h in every stage.
/// @param stage_counts  counts, if any
StagedImpact staged_impact(const DecisionInput& input, DecisionStageCounts* stage_counts = nullptr);

/// The same by rational arithmetic alone: slow, for those who check the stages.
StagedImpact exact_impact(const DecisionInput& input);

/// The same by plain doubles alone, which may be wrong: for those who count how often.
StagedImpact double_impact(const DecisionInput& input);

/// How far the node is from another decision, to first order [length]: the smallest |f| / |grad f| over the comparisons
/// that decide, f being the difference of the two sides: the limits that the retained impact keeps, those that reject
/// the others, the advance in kappa. A lower estimate, since an impact that is no longer rejected need not win.
/// Infinite where nothing near depends on the node's position. Rounding limits it to about an ulp of the coordinates.
double decision_margin(const DecisionInput& input);

}  // namespace type21::reference
