/// @file A query answered in one number type.
#pragma once

#include <cmath>

#include "reference/exact/impact_enclosure.h"
#include "reference/exact/undecided.h"
#include "verification/performance/accuracy/method.h"

namespace type21::accuracy {

/// @param real  Number -> the floating-point number in which the penetration is computed
template <class Number, class Real>
Answer answer_in(const BlockQuery& one, const Real& real) {
    using namespace reference;
    Impact<Number> best;
    try {
        best = retained_in<Number>(one.query(), one.candidates->segments());
    } catch (const Undecided&) {
        Answer answer;
        answer.undecided = true;
        return answer;
    }
    Answer answer{best.kind, best.segment, best.triangle, best.side};
    if (best.kind != Kind::contact) return answer;
    const auto& projection = best.projection;
    const auto x = real(projection.normal[0]), y = real(projection.normal[1]), z = real(projection.normal[2]);
    const auto distance = real(projection.height) * std::sqrt(x * x + y * y + z * z) / real(projection.slope);
    answer.penetration = static_cast<double>(real(Number(one.query().gap)) - distance);
    return answer;
}

}  // namespace type21::accuracy
