/// @file The single retained impact of a node (formulation section 4).
#pragma once

#include <span>

#include "reference/contact/decision.h"
#include "reference/contact/projection.h"

namespace type21::reference {

/// How far a node is seen by the tool.
template <class Number>
struct Reach {
    Number gap{0};        ///< g: contact below it, on the outward side [length]
    Number depth{0};      ///< DEPTH: contact below it, behind [length]
    Number proximity{0};  ///< largest reach of the active effects, outward side [length]
};

/// Contact, proximity or nothing; all comparisons strict. Formulation section 3, step 5.
/// @page field DEPTH; comment 4
template <class Number>
Kind classify(const Approach<Number>& near, const Reach<Number>& reach) {
    const Number& d2 = near.squared_distance;
    if (near.side > 0 && d2 < reach.gap * reach.gap) return Kind::contact;
    if (near.side < 0 && d2 < reach.depth * reach.depth) return Kind::contact;
    if (near.side > 0 && d2 < reach.proximity * reach.proximity) return Kind::proximity;
    return Kind::none;
}

/// A sub-triangle that would take the node.
template <class Number>
struct Impact {
    Kind kind = Kind::none;
    int segment = -1;
    int triangle = 0;
    int side = 0;
    Projection<Number> projection;
    Number kappa{0};
};

/// True when `one` is retained rather than `other`: contact before proximity, then the smaller kappa, then the lower
/// segment, then the lower sub-triangle. No two different impacts are equal, so the order of candidates cannot matter.
/// @param one_race  D11: contact and proximity compete on kappa alone
/// @page departure D11
template <class Number>
bool precedes(const Impact<Number>& one, const Impact<Number>& other, bool one_race = false) {
    const bool race = one_race && one.kind != Kind::none && other.kind != Kind::none;
    if (one.kind != other.kind && !race) {
        return one.kind != Kind::none && (other.kind == Kind::none || one.kind == Kind::contact);
    }
    if (one.kappa < other.kappa) return true;
    if (other.kappa < one.kappa) return false;
    if (one.segment != other.segment) return one.segment < other.segment;
    return one.triangle < other.triangle;
}

/// The retained impact of a node over the segments that may reach it. kind is none where nothing takes it.
/// @param shape_of  rank of a segment -> SegmentShape<Number>
template <class Number, class ShapeOf>
Impact<Number> retained_impact(const Vector<Number>& p, std::span<const int> segments, const ShapeOf& shape_of,
                               const Reach<Number>& reach, const ProjectionLimits<Number>& limits,
                               bool one_race = false) {
    Impact<Number> best;
    for (const int segment : segments) {
        const SegmentShape<Number> shape = shape_of(segment);
        for (int k = 1; k <= shape.sub_triangles(); ++k) {
            const SubTriangle<Number> t = sub_triangle(shape, k);
            const auto projection = project(p, t, limits);
            if (!projection) continue;
            const Approach<Number> near = approach(p, t, projection->weights);
            const Kind kind = classify(near, reach);
            if (kind == Kind::none) continue;
            const Impact<Number> impact{kind, segment, k, near.side, *projection, centrality(projection->weights)};
            if (precedes(impact, best, one_race)) best = impact;
        }
    }
    return best;
}

}  // namespace type21::reference
