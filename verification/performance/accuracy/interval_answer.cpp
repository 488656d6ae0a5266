#include <cmath>

#include "reference/exact/interval.h"
#include "verification/performance/accuracy/number_answer.h"

namespace type21::accuracy {

Answer answer_by_interval(const BlockQuery& one) {
    using reference::Interval;
    const Interval::Upward upward;
    return answer_in<Interval>(one, [](const Interval& x) { return x.low() + 0.5 * (x.high() - x.low()); });
}

}  // namespace type21::accuracy
