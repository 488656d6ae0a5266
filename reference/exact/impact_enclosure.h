/// @file One sub-triangle judged in one arithmetic.
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

template <class Number>
ContactReach<Number> convert_to(const ContactReach<double>& reach) {
    return {Number(reach.gap), Number(reach.depth), Number(reach.proximity)};
}

template <class Number>
ProjectionLimits<Number> convert_to(const ProjectionLimits<double>& limits) {
    return {Number(limits.low), Number(limits.high), limits.lift_leaning};
}

/// @throws Undecided where Number cannot tell
template <class Number>
Impact<Number> impact_in(const DecisionInput& input, const SegmentShape<double>& shape, int segment, int k) {
    return impact_on(convert_to<Number>(input.point), convert_to<Number>(shape), segment, k,
                     convert_to<Number>(input.reach), convert_to<Number>(input.limits));
}

/// What is known of one sub-triangle's impact: kind and side for certain, kappa between two doubles.
struct ImpactEnclosure {
    Kind kind = Kind::none;
    int segment = -1;
    int triangle = 0;
    int side = 0;
    double kappa_low = 0;
    double kappa_high = 0;
    bool double_will_do = false;  ///< its magnitudes are known to be good in double (magnitudes.h)
};

template <class Number>
ImpactEnclosure judged(const Impact<Number>& impact, double kappa_low, double kappa_high) {
    return {impact.kind, impact.segment, impact.triangle, impact.side, kappa_low, kappa_high, false};
}

/// By doubles with a bound of their error. Nothing where the bound cannot tell.
std::optional<ImpactEnclosure> judged_by_bound(const DecisionInput& input, const SegmentShape<double>& shape,
                                               int segment, int k);

/// Nothing where the intervals overlap. Compiled on its own, since it changes the rounding mode while it computes.
std::optional<ImpactEnclosure> judged_by_interval(const DecisionInput& input, const SegmentShape<double>& shape,
                                                  int segment, int k);

}  // namespace type21::reference
