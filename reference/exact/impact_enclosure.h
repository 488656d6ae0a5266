/// @file One sub-triangle judged in one arithmetic.
#pragma once

#include <optional>

#include "reference/exact/staged_impact.h"

namespace type21::reference {

template <class Number>
Vector<Number> exactly(const Vec3& v) {
    return Vector<Number>(Number(v.x()), Number(v.y()), Number(v.z()));
}

template <class Number>
SegmentShape<Number> exactly(const SegmentShape<double>& shape) {
    SegmentShape<Number> same;
    for (size_t j = 0; j < 4; ++j) {
        same.node[j] = exactly<Number>(shape.node[j]);
        same.normal[j] = exactly<Number>(shape.normal[j]);
    }
    same.triangle = shape.triangle;
    return same;
}

template <class Number>
Reach<Number> exactly(const Reach<double>& reach) {
    return {Number(reach.gap), Number(reach.depth), Number(reach.proximity)};
}

template <class Number>
ProjectionLimits<Number> exactly(const ProjectionLimits<double>& limits) {
    return {Number(limits.low), Number(limits.high), limits.lift_leaning};
}

/// @throws Undecided where Number cannot tell
template <class Number>
Impact<Number> impact_in(const DecisionInput& input, const SegmentShape<double>& shape, int segment, int k) {
    return impact_on(exactly<Number>(input.point), exactly<Number>(shape), segment, k, exactly<Number>(input.reach),
                     exactly<Number>(input.limits));
}

/// What is known of one sub-triangle's impact: kind and side for certain, kappa between two doubles.
struct Judged {
    Kind kind = Kind::none;
    int segment = -1;
    int triangle = 0;
    int side = 0;
    double kappa_low = 0;
    double kappa_high = 0;
    bool double_will_do = false;  ///< its magnitudes are known to be good in double (magnitudes.h)
};

template <class Number>
Judged judged(const Impact<Number>& impact, double kappa_low, double kappa_high) {
    return {impact.kind, impact.segment, impact.triangle, impact.side, kappa_low, kappa_high, false};
}

/// By doubles with a bound of their error. Nothing where the bound cannot tell.
std::optional<Judged> judged_by_bound(const DecisionInput& input, const SegmentShape<double>& shape, int segment,
                                      int k);

/// Nothing where the intervals overlap. Compiled on its own, since it changes the rounding mode while it computes.
std::optional<Judged> judged_by_interval(const DecisionInput& input, const SegmentShape<double>& shape, int segment,
                                         int k);

}  // namespace type21::reference
