/// @file The single retained impact of a node (chapter 4 of the formulation).
#pragma once

#include <span>

#include "reference/contact/projection.h"
#include "reference/contract/decision.h"

namespace type21::reference {

/// How far a node is seen by the tool.
template <class Number>
struct ContactReach {
    Number gap{0};        ///< g: contact below it, on the outward side [length]
    Number depth{0};      ///< DEPTH: contact below it, behind [length]
    Number proximity{0};  ///< largest reach of the active effects, outward side [length]
};

/// Contact, proximity or nothing; all comparisons strict.
/// @param near   distance and side of the node
/// @param reach  gap, DEPTH and reach of heat, >= 0 [length].  Formulation 3, step 5.
/// @manual field DEPTH; comment 4
template <class Number>
Kind classify(const Approach<Number>& near, const ContactReach<Number>& reach) {
    const Number& d2 = near.squared_distance;
    if (near.side > 0 && d2 < reach.gap * reach.gap) return Kind::contact;
    if (near.side < 0 && d2 < reach.depth * reach.depth) return Kind::contact;
    if (near.side > 0 && d2 < reach.proximity * reach.proximity) return Kind::proximity;
    return Kind::none;
}

/// A sub-triangle that would take the node. kind is none where it does not.
template <class Number>
struct Impact {
    Kind kind = Kind::none;
    int segment = -1;  ///< rank in the main surface
    int triangle = 0;  ///< k, 1..4
    int side = 0;      ///< +1 outward or on the plane, -1 behind
    Projection<Number> projection;
    Number kappa{0};  ///< centrality, 0 to about 4/3 [-]
};

/// Which of two impacts comes first by its kind: contact before proximity, anything before nothing.
/// @param proximity_competes  contact and proximity compete on kappa alone; as built: D11
/// @return < 0: the first kind wins, > 0: the second, 0: kappa decides.  Formulation 4, step 2.
/// @manual departure D11
inline int order_of_kinds(Kind one, Kind other, bool proximity_competes = false) {
    if (one == other) return 0;
    if (one == Kind::none) return +1;
    if (other == Kind::none) return -1;
    if (proximity_competes) return 0;
    return one == Kind::contact ? -1 : +1;
}

/// True when `one` is retained rather than `other`: contact before proximity, then the smaller kappa, then the lower
/// segment, then the lower sub-triangle. No two different impacts are equal, so the order of candidates cannot matter.
/// Formulation 4, step 2 to step 4.
template <class Number>
bool precedes(const Impact<Number>& one, const Impact<Number>& other, bool proximity_competes = false) {
    const int kinds = order_of_kinds(one.kind, other.kind, proximity_competes);
    if (kinds != 0) return kinds < 0;
    if (one.kind == Kind::none) return false;
    if (one.kappa < other.kappa) return true;
    if (other.kappa < one.kappa) return false;
    if (one.segment != other.segment) return one.segment < other.segment;
    return one.triangle < other.triangle;
}

/// The impact of a node on one sub-triangle; kind is none where it rejects the node or does not reach it.
/// @param p        node in the tool frame [length]
/// @param shape    the segment in the tool frame
/// @param segment  its rank, only handed on
/// @param k        sub-triangle, 1..4; 1 for a triangle.  Formulation 3, step 1 to step 6.
template <class Number>
Impact<Number> impact_on(const Vector<Number>& p, const SegmentShape<Number>& shape, int segment, int k,
                         const ContactReach<Number>& reach, const ProjectionLimits<Number>& limits) {
    const SubTriangle<Number> t = sub_triangle(shape, k);
    const auto projection = project(p, t, limits);
    if (!projection) return {};
    const Approach<Number> near = approach(p, t, projection->weights);
    const Kind kind = classify(near, reach);
    if (kind == Kind::none) return {};
    return {kind, segment, k, near.side, *projection, centrality(projection->weights)};
}

/// The retained impact of a node over the segments that may reach it, all in one arithmetic. kind is none where nothing
/// takes it. A run decides by exact/staged_impact.h, which asks the same functions in the cheapest arithmetic that can
/// tell.
/// @param p         node in the tool frame [length]
/// @param segments  ranks of the candidates, in any order
/// @param shape_of  rank of a segment -> SegmentShape<Number>.  Formulation 4, step 5.
template <class Number, class ShapeOf>
Impact<Number> retained_impact(const Vector<Number>& p, std::span<const int> segments, const ShapeOf& shape_of,
                               const ContactReach<Number>& reach, const ProjectionLimits<Number>& limits,
                               bool proximity_competes = false) {
    Impact<Number> best;
    for (const int segment : segments) {
        const SegmentShape<Number> shape = shape_of(segment);
        for (int k = 1; k <= shape.sub_triangles(); ++k) {
            const Impact<Number> impact = impact_on(p, shape, segment, k, reach, limits);
            if (precedes(impact, best, proximity_competes)) best = impact;
        }
    }
    return best;
}

}  // namespace type21::reference
