/// @file One answer compared with independent ones.
#pragma once

#include <string>

#include "verification/decisions/queries/decide.h"

namespace type21 {

/// How much of an answer is checked.
enum class Scrutiny {
    decision,  ///< it agrees with the second opinion
    full  ///< also with rational numbers and with the candidates in reverse order; margin and magnitudes are finite
};

/// One answer and what is wrong with it.
struct Judgement {
    DecisionAnswer answer;    ///< of the method; none where it threw
    DecisionAnswer expected;  ///< the second opinion
    double margin = 0;        ///< with Scrutiny::full [length]
    std::string wrong;        ///< what is wrong, in words; empty: nothing
};

Judgement judge(const DecisionTool& tool, const ContactQuery& query, DecideWith method, Scrutiny scrutiny);

}  // namespace type21
