// The projection is written for any number; its constants are doubles, which float rounds. That is meant here.
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wfloat-conversion"

#include <cmath>

#include "verification/performance/accuracy/number_answer.h"

namespace type21::accuracy {

Answer answer_by_float(const BlockQuery& one) {
    return answer_in<float>(one, [](float x) { return x; });
}

}  // namespace type21::accuracy
