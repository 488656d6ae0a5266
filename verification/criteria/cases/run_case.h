/// @file Runs one [[run]] of a case.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/criteria/cases/case_file.h"
#include "verification/results/record/run_deck.h"

namespace type21 {

struct CaseOutcome {
    std::vector<std::string> problems;  ///< of the deck, as text
    bool refused = false;               ///< the deck has errors: nothing was run
    std::string error;                  ///< an internal error or an unusable folder; empty otherwise
    RunSummary summary;
    std::vector<Id> interfaces;    ///< ids, like summary.balance
    std::filesystem::path folder;  ///< where the results are
    double seconds = 0;            ///< of wall time, deck included
};

/// Never throws: errors are in the outcome.
/// @param with  implementation of the contact, one of contact_choices()
CaseOutcome run_case(const CaseRun& run, const std::filesystem::path& folder, const std::string& with);

}  // namespace type21
