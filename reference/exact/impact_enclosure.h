/// @file The impact on one sub-triangle, computed in one number type, and what is certain of it.
#pragma once

#include <optional>

#include "reference/exact/staged_impact.h"

namespace type21::reference {

template <class Number>
Vector<Number> convert_to(const Vec3& v) {
    return Vector<Number>(Number(v.x()), Number(v.y()), Number(v.z()));
}

template <class Number>
SegmentShape<Number> convert_to(const SegmentShape<double>& shape) {
    SegmentShape<Number> same;
    for (size_t j = 0; j < 4; ++j) {
        same.node[j] = convert_to<Number>(shape.node[j]);
        same.normal[j] = convert_to<Number>(shape.normal[j]);
    }
    same.triangle = shape.triangle;
    return same;
}

/// The impact of a query on sub-triangle k of a segment, in one number type.
/// @param shape  of the segment, tool frame [length]
/// @param k      1..4 for a quad, 1 for a triangle
/// @throws Undecided where Number cannot tell
template <class Number>
Impact<Number> impact_in(const ContactQuery& query, const SegmentShape<double>& shape, int segment, int k) {
    return impact_on(convert_to<Number>(query.point), convert_to<Number>(shape), segment, k, reach_of<Number>(query),
                     limits_of<Number>(query));
}

/// The retained impact of a query over all candidates, in one number type.
/// @throws Undecided where Number cannot tell
template <class Number>
Impact<Number> retained_in(const ContactQuery& query, const CandidateSegments& candidates) {
    return retained_impact<Number>(
        convert_to<Number>(query.point), candidates.ranks,
        [&](int segment) { return convert_to<Number>(candidates.shape_of(segment)); }, reach_of<Number>(query),
        limits_of<Number>(query), query.proximity_competes);
}

/// What is certain of the impact on one sub-triangle: its kind and side, and two doubles that enclose its kappa.
struct ImpactEnclosure {
    Kind kind = Kind::none;
    int segment = -1;
    int triangle = 0;
    int side = 0;
    double kappa_low = 0;         ///< [-]
    double kappa_high = 0;        ///< [-]
    bool double_will_do = false;  ///< the projection in double is near enough to the exact one (magnitudes.h)
};

template <class Number>
ImpactEnclosure enclosure_of(const Impact<Number>& impact, double kappa_low, double kappa_high) {
    return {impact.kind, impact.segment, impact.triangle, impact.side, kappa_low, kappa_high, false};
}

/// By doubles with a bound on their error (Formulation 10, step 3).
/// @return nothing where the bound cannot tell
std::optional<ImpactEnclosure> enclosed_by_bound(const ContactQuery& query, const SegmentShape<double>& shape,
                                                 int segment, int k);

/// By intervals of doubles (Formulation 10, step 4). In a file of its own, since it changes the rounding mode while it
/// computes and the compiler has to know.
/// @return nothing where the intervals overlap
std::optional<ImpactEnclosure> enclosed_by_interval(const ContactQuery& query, const SegmentShape<double>& shape,
                                                    int segment, int k);

}  // namespace type21::reference
