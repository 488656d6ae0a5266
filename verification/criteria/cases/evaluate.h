/// @file Judges a check against what its run did.
#pragma once

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/cases/check_result.h"
#include "verification/criteria/cases/run_case.h"

namespace type21 {

/// Never throws: what cannot be evaluated has failed, and `detail` says why. A run that was refused or stopped fails
/// every check of that run unless a check expects just that.
CheckResult evaluate(const Case& a_case, const CaseCheck& check, const CaseOutcome& outcome);

}  // namespace type21
