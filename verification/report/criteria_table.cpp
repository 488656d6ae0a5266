#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "verification/report/criteria_report.h"

namespace type21 {
namespace {

std::string shortened(const std::string& text, size_t width) {
    return text.size() <= width ? text : text.substr(0, width - 3) + "...";
}

/// "1 run", "3 runs"
std::string counted(size_t count, const char* one, const char* many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

}  // namespace

std::string criteria_table(const std::vector<CriterionResult>& results) {
    size_t case_width = 4;
    size_t criterion_width = 9;
    for (const CriterionResult& result : results) {
        case_width = std::max(case_width, result.case_name.size());
        criterion_width = std::max(criterion_width, result.id.size());
    }
    const std::string line = "{:<{}}  {:<{}}  {:<10}  {:>18}  {:<18}  {:>10}  {:>9}  {}\n";
    std::string out = fmt::format(fmt::runtime(line), "case", case_width, "criterion", criterion_width, "kind", "got",
                                  "expected", "difference", "tolerance", "verdict");
    std::map<std::string, size_t> kinds;
    std::set<std::string> cases, runs, kept;
    size_t failed = 0;
    size_t skipped = 0;
    for (const CriterionResult& result : results) {
        out += fmt::format(fmt::runtime(line), result.case_name, case_width, result.id, criterion_width, result.kind,
                           shortened(result.got, 18), shortened(result.expected, 18),
                           fmt::format("{:.2e}", result.difference), fmt::format("{:.1e}", result.tolerance),
                           result.skipped ? "skipped" : (result.ok ? "ok" : "FAILED"));
        if (!result.ok) out += fmt::format("    run {}: {}\n", result.run, result.detail);
        ++kinds[result.kind];
        cases.insert(result.case_name);
        runs.insert(result.case_name + "/" + result.run);
        if (result.kept) kept.insert(result.case_name + "/" + result.run);
        failed += result.ok ? 0 : 1;
        skipped += result.skipped ? 1 : 0;
    }
    std::string by_kind;
    for (const auto& [kind, count] : kinds)
        by_kind += fmt::format("{}{} {}", by_kind.empty() ? "" : ", ", count, kind);
    const std::string left_out = skipped == 0 ? "" : fmt::format(", {} skipped", skipped);
    out += fmt::format("{} ({}) of {} in {}: {}{}\n", counted(results.size(), "criterion", "criteria"), by_kind,
                       counted(runs.size(), "run", "runs"), counted(cases.size(), "case", "cases"),
                       failed == 0 ? "all hold" : fmt::format("{} FAILED", failed), left_out);
    if (!kept.empty())
        out += fmt::format("{} not repeated: the case, the program and the results are unchanged\n",
                           counted(kept.size(), "run was", "runs were"));
    return out;
}

}  // namespace type21
