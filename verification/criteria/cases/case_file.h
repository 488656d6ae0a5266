/// @file case.toml: what a case runs and what must come out. The format is documented in cases/README.md.
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
enum class CheckKind { analytic, exact, external, cross, regression };

std::string_view name(CheckKind kind);

/// The families that the report shows first: "patch test", "sliding continuity", "friction law", "Pmax limit".
const std::vector<std::string>& case_families();

struct CaseRun {
    std::string name;
    std::string as_built;
    std::filesystem::path deck;
    std::filesystem::path thickness;  ///< CSV for --thickness, empty: none
};

/// Form 1: a whole history.
struct HistoryCheck {
    FileRule rule;
};

/// When a value is taken.
struct At {
    enum class Kind { end, largest, smallest, time };
    Kind kind = Kind::end;
    double time = 0;
};

/// Form 2: one value.
struct ValueCheck {
    std::string file, column;
    At at;
    std::optional<Id> object;
    double expected = 0;
    bool absolute = false;
};

/// Form 3: a residual of InterfaceBalance.
struct BalanceCheck {
    std::string quantity;
    std::optional<Id> interface;
};

/// Form 4: a deck that must be refused.
struct RefusalCheck {
    std::string message;  ///< regular expression
};

/// Form 5: a run that must stop.
struct StopCheck {
    std::string message;  ///< regular expression
};

/// Form 6: ours minus measured is a known amount.
struct DepartureCheck {
    std::string reference, file, column;
    At at;
    std::optional<Id> object;
    double by = 0;
    bool absolute = false;
};

struct CaseCheck {
    std::string id;
    size_t run = 0;  ///< index into Case::runs
    CheckKind kind = CheckKind::analytic;
    double tolerance = 0;
    std::string reason, equation, unit;
    std::string with;  ///< the only implementation that it is asked of, empty: all
    int line = 0;
    std::variant<HistoryCheck, ValueCheck, BalanceCheck, RefusalCheck, StopCheck, DepartureCheck> form;
};

struct Case {
    std::string name;  ///< of its folder
    std::filesystem::path folder;
    std::string statement, source;
    std::vector<std::string> features;
    std::string family;               ///< one of case_families(), empty: none
    std::vector<std::string> covers;  ///< rows of the traceability table that the case shows
    std::vector<CaseRun> runs;
    std::vector<CaseCheck> checks;
};

/// Reads folder/case.toml. Every problem is one line "file:line: what is wrong" in `problems`; the case is complete
/// only when none was added.
Case read_case(const std::filesystem::path& folder, std::vector<std::string>& problems);

/// What a case says about comparing a run with its measured files: the rules of the runs with this as-built set, or,
/// when no run has it, of any run. `foreign` is then true.
std::vector<FileRule> rules_of(const Case& a_case, const std::string& as_built_text, bool& foreign);

}  // namespace type21
