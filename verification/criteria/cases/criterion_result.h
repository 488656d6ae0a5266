/// @file The result of one criterion.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "verification/results/compare/compare_tables.h"

namespace type21 {

struct CriterionResult {
    std::string id, case_name, run, kind, equation;
    std::string expected;  ///< as text: a number, a file, a message
    std::string got;
    std::optional<double> expected_number, got_number;  ///< where they are finite numbers
    double difference = 0;  ///< in the measure of the tolerance (relative, scaled or absolute)
    double tolerance = 0;
    std::string unit, reason;
    bool ok = false;
    bool skipped = false;               ///< does not apply to the implementation that ran; ok is true; counted apart
    bool kept = false;                  ///< taken from an earlier run: nothing that it depends on has changed
    double seconds = 0;                 ///< of the run
    std::string detail;                 ///< where the largest difference is, or what went wrong
    std::vector<ColumnResult> columns;  ///< form 1: each column of the history
};

}  // namespace type21
