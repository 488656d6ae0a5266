/// @file All cases: each (case, run) once, then its checks.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/cases/check_result.h"

namespace type21 {

/// The folders below `root` that hold a case.toml, by name; only the named ones when names are given.
/// A name without a case.toml, or no case at all, is a problem.
std::vector<Case> read_cases(const std::filesystem::path& root, const std::vector<std::string>& names,
                             std::vector<std::string>& problems);

struct VerifyProgress {
    size_t done = 0, of = 0;  ///< runs
    std::string case_name, run;
    double seconds = 0;
    size_t failed = 0;  ///< checks of this run
    bool kept = false;  ///< not run again
};

/// Runs everything in scratch/<case>/<run>, `jobs` runs at a time.
/// @param with      who computes the contact, one of contact_choices()
/// @param keep      a run whose checks held and whose case, program and results are the same as then is not run again
/// @param progress  called after each run, never twice at the same time
/// @return the results in the order of the cases and their checks, whatever the number of jobs
std::vector<CheckResult> verify_cases(const std::vector<Case>& cases, const std::filesystem::path& scratch, int jobs,
                                      const std::function<void(const VerifyProgress&)>& progress,
                                      const std::string& with = "reference", bool keep = false);

}  // namespace type21
