/// @file Evaluates a criterion on the results of its run.
#pragma once

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/cases/criterion_result.h"
#include "verification/criteria/cases/run_case.h"

namespace type21 {

/// Never throws: a criterion that cannot be evaluated fails, and `detail` says why. If the run was refused or stopped,
/// all its criteria fail, unless one of them expects that.
CriterionResult evaluate(const Case& a_case, const Criterion& criterion, const CaseOutcome& outcome);

}  // namespace type21
