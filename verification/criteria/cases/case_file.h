/// @file case.toml: the runs of a case and its criteria. cases/README.md documents the format.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "verification/results/compare/compare_folders.h"

namespace type21 {

/// Where the expected value comes from.
enum class CriterionKind { analytic, exact, external, cross, regression };

std::string_view name(CriterionKind kind);

/// The case families that the report shows first: "patch test", "sliding continuity", "friction law", "Pmax limit".
const std::vector<std::string>& case_families();

struct CaseRun {
    std::string name;
    std::string as_built;
    std::filesystem::path deck;
    std::filesystem::path thickness;  ///< CSV for --thickness, empty: none
};

/// Form 1: a whole history.
struct HistoryCriterion {
    FileRule rule;
};

/// When a value is taken.
struct At {
    enum class Kind { end, largest, smallest, time };
    Kind kind = Kind::end;
    double time = 0;
};

/// Form 2: one value.
struct ValueCriterion {
    std::string file, column;
    At at;
    std::optional<Id> object;
    double expected = 0;
    bool absolute = false;
};

/// Form 3: a residual of InterfaceBalance.
struct BalanceCriterion {
    std::string quantity;
    std::optional<Id> interface;
};

/// Form 4: a deck that must be refused.
struct RefusalCriterion {
    std::string message;  ///< regular expression
};

/// Form 5: a run that must stop.
struct StopCriterion {
    std::string message;  ///< regular expression
};

/// Form 6: ours minus measured is a known amount.
struct DepartureCriterion {
    std::string reference, file, column;
    At at;
    std::optional<Id> object;
    double by = 0;
    bool absolute = false;
};

/// What a run must fulfil.
struct Criterion {
    std::string id;
    size_t run = 0;  ///< index into Case::runs
    CriterionKind kind = CriterionKind::analytic;
    double tolerance = 0;
    std::string reason, equation, unit;
    std::string with;  ///< the only implementation that it applies to; empty: all
    int line = 0;
    std::variant<HistoryCriterion, ValueCriterion, BalanceCriterion, RefusalCriterion, StopCriterion,
                 DepartureCriterion>
        form;
};

struct Case {
    std::string name;  ///< of its folder
    std::filesystem::path folder;
    std::string statement, source;
    std::vector<std::string> features;
    std::string family;               ///< one of case_families(), empty: none
    std::vector<std::string> covers;  ///< rows of the traceability table that the case shows
    std::vector<CaseRun> runs;
    std::vector<Criterion> criteria;
};

/// Reads folder/case.toml. Every problem is one line "file:line: what is wrong" in `problems`; the case is complete
/// only when none was added.
Case read_case(const std::filesystem::path& folder, std::vector<std::string>& problems);

/// The rules of a case for comparing a run with its measured files: those of the runs with this as-built set or, if no
/// run has it, of all runs; `foreign` is then true.
std::vector<FileRule> rules_of(const Case& a_case, const std::string& as_built_text, bool& foreign);

}  // namespace type21
