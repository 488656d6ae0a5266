/// @file Runs the cases: each run of a case once, then its criteria.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "verification/criteria/cases/case_file.h"
#include "verification/criteria/cases/criterion_result.h"

namespace type21 {

/// The folders below `root` that hold a case.toml, by name; only the named ones when names are given.
/// A name without a case.toml is a problem, and so is a root without any case.
std::vector<Case> read_cases(const std::filesystem::path& root, const std::vector<std::string>& names,
                             std::vector<std::string>& problems);

struct VerifyProgress {
    size_t done = 0, of = 0;  ///< runs
    std::string case_name, run;
    double seconds = 0;
    size_t failed = 0;  ///< criteria of this run
    bool kept = false;  ///< not run again
};

/// Runs everything in scratch/<case>/<run>, `jobs` runs at a time.
/// @param with      implementation of the contact, one of contact_choices()
/// @param keep      do not repeat a run whose criteria held, if the case, the program and the results are unchanged
/// @param progress  called after each run, never twice at the same time
/// @return the results in the order of the cases and their criteria, whatever the number of jobs
std::vector<CriterionResult> verify_cases(const std::vector<Case>& cases, const std::filesystem::path& scratch,
                                          int jobs, const std::function<void(const VerifyProgress&)>& progress,
                                          const std::string& with = "reference", bool keep = false);

}  // namespace type21
