/// @file A method compared with the exact answers.
#pragma once

#include <span>
#include <vector>

#include "verification/performance/accuracy/exact_answer.h"
#include "verification/performance/accuracy/force_error.h"
#include "verification/performance/accuracy/method.h"

namespace type21::accuracy {

struct Score {
    size_t decisions = 0;  ///< compared
    size_t wrong = 0;      ///< another kind, segment, sub-triangle or side than the exact answer
    size_t undecided = 0;  ///< the arithmetic cannot tell: neither right nor wrong; its force is not compared
    ForceErrors force;
    std::vector<std::vector<size_t>> settled;  ///< ranks of the queries by stage, where the method has stages
    double seconds = 0;                        ///< of processor time
};

/// Answers the queries of `order` one after the other, until all are answered or `seconds` of processor time are over.
Score score(const Method& method, const std::vector<ExactAnswer>& exact, std::span<const size_t> order, double seconds);

}  // namespace type21::accuracy
