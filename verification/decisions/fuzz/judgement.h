/// @file One answer, judged.
#pragma once

#include <string>

#include "verification/decisions/queries/decide.h"

namespace type21 {

/// How much is asked of an answer.
enum class Scrutiny {
    decision,  ///< the second opinion agrees
    full       ///< and so do rational numbers and the reverse order of candidates; margin and magnitudes are numbers
};

/// One answer and what is wrong with it.
struct Judgement {
    DecisionAnswer answer;    ///< of the method; none where it threw
    DecisionAnswer expected;  ///< the second opinion
    double margin = 0;        ///< with Scrutiny::full [length]
    std::string wrong;        ///< empty where all is well
};

Judgement judge(const DecisionTool& tool, const DecisionQuery& query, DecideWith method, Scrutiny scrutiny);

}  // namespace type21
