/// @file The retained impact as real arithmetic on the given doubles would choose it (Formulation 10, step 6).
#pragma once

#include <functional>
#include <span>

#include "reference/contact/retained_impact.h"
#include "reference/contract/contact_query.h"
#include "reference/contract/decision_stage_counts.h"

namespace type21::reference {

/// Rank of a segment in the main surface -> its shape in the tool frame.
using ShapeOf = std::function<SegmentShape<double>(int segment)>;

/// The segments that may take a node, and where each of them lies. It refers to both and owns neither.
struct CandidateSegments {
    std::span<const int> ranks;  ///< in any order, each once; a segment that is left out must not be able to take it
    const ShapeOf& shape_of;     ///< must outlive the call
};

/// The reach of a query in the number type of one stage.
template <class Number>
ContactReach<Number> reach_of(const ContactQuery& query) {
    return {Number(query.gap), Number(query.depth), Number(query.proximity_reach)};
}

/// The limits of a query's projections in the number type of one stage.
template <class Number>
ProjectionLimits<Number> limits_of(const ContactQuery& query) {
    return {Number(query.lowest_weight), Number(query.highest_weight_sum), query.lift_leaning};
}

/// The query of a node whose reach and limits are at hand as the laws take them.
inline ContactQuery query_of(const Vec3& point, const ContactReach<double>& reach,
                             const ProjectionLimits<double>& limits, bool proximity_competes) {
    return {point,      reach.gap,   reach.depth,         reach.proximity,
            limits.low, limits.high, limits.lift_leaning, proximity_competes};
}

/// An exact decision with the numbers that the forces are computed from.
struct StagedImpact {
    Kind kind = Kind::none;
    int segment = -1;               ///< rank in the main surface, from 0; -1: nothing takes the node
    int triangle = 0;               ///< sub-triangle k, 1..4
    int side = 0;                   ///< +1 outward of the sub-triangle's plane or on it, -1 behind
    Stage stage = Stage::bounded;   ///< the last that was needed
    Projection<double> projection;  ///< on the retained sub-triangle, near the exact one (magnitudes.h)
};

/// The retained impact, exact. Each sub-triangle is asked in the first stage that can tell. Where the enclosures of
/// kappa of two impacts overlap, their exact kappas are compared. Every stage runs the same text: projection.h and
/// retained_impact.h with another number type.
///
/// The order of the candidates does not matter.
/// @param counts  the decision is added to them, where given
/// @throws nothing of its own; std::bad_alloc
StagedImpact staged_impact(const ContactQuery& query, const CandidateSegments& candidates,
                           DecisionStageCounts* counts = nullptr);

/// The same decision by rational numbers only. Slow: it is there to check the stages. The projection is the exact one,
/// each number rounded once.
StagedImpact exact_impact(const ContactQuery& query, const CandidateSegments& candidates);

/// The decision of plain double arithmetic, which may be wrong: it is there to count how often.
StagedImpact double_impact(const ContactQuery& query, const CandidateSegments& candidates);

/// How far the node may move, to first order, before its decision may be another [length]: the smallest |f| / |grad f|
/// over the comparisons that decide, where f is the difference of the two sides. These are the limits that the retained
/// impact keeps, the limits that reject the other sub-triangles, and the differences of kappa.
///
/// It is a lower estimate, since a sub-triangle that is no longer rejected need not win. It is infinite where nothing
/// near depends on the position of the node. Rounding limits its accuracy to about an ulp of the coordinates.
/// Formulation 10, step 8.
double decision_margin(const ContactQuery& query, const CandidateSegments& candidates);

}  // namespace type21::reference
