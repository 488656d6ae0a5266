/// @file A method against what is right.
#pragma once

#include <span>
#include <vector>

#include "verification/performance/accuracy/force_error.h"
#include "verification/performance/accuracy/method.h"
#include "verification/performance/accuracy/truth.h"

namespace type21::accuracy {

struct Score {
    size_t decisions = 0;  ///< judged
    size_t wrong = 0;      ///< another kind, segment, sub-triangle or side than the exact ones
    size_t undecided = 0;  ///< the arithmetic cannot tell: not wrong, and no answer; its force is not judged
    ForceErrors force;
    std::vector<std::vector<size_t>> settled;  ///< questions by stage, where the method has stages
    double seconds = 0;                        ///< of processor time
};

/// Asks the questions of `order` one after the other until they are through or `seconds` of processor time are over.
Score score(const Method& method, const std::vector<Truth>& truths, std::span<const size_t> order, double seconds);

}  // namespace type21::accuracy
