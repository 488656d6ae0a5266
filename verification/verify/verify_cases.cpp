#include "verification/verify/verify_cases.h"

#include <algorithm>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "verification/verify/evaluate.h"
#include "verification/verify/in_parallel.h"
#include "verification/verify/run_case.h"

namespace type21 {
namespace fs = std::filesystem;

std::vector<Case> read_cases(const fs::path& root, const std::vector<std::string>& names,
                             std::vector<std::string>& problems) {
    std::set<std::string> chosen(names.begin(), names.end());
    for (const std::string& name : chosen)
        if (!fs::exists(root / name / "case.toml"))
            problems.push_back(fmt::format("{}: there is no such case", (root / name / "case.toml").string()));
    std::error_code error;
    if (chosen.empty())
        for (const fs::directory_entry& entry : fs::directory_iterator(root, error))
            if (fs::exists(entry.path() / "case.toml")) chosen.insert(entry.path().filename().string());
    if (error) problems.push_back(fmt::format("{}: {}", root.string(), error.message()));
    if (chosen.empty() && problems.empty())
        problems.push_back(fmt::format("{}: no folder with a case.toml", root.string()));
    std::vector<Case> cases;
    for (const std::string& name : chosen)
        if (fs::exists(root / name / "case.toml")) cases.push_back(read_case(root / name, problems));
    return cases;
}

std::vector<CheckResult> verify_cases(const std::vector<Case>& cases, const fs::path& scratch, int jobs,
                                      const std::function<void(const VerifyProgress&)>& progress,
                                      const std::string& with) {
    struct Task {
        size_t a_case = 0, run = 0;
    };
    std::vector<Task> tasks;
    std::vector<std::vector<CheckResult>> results(cases.size());
    for (size_t c = 0; c < cases.size(); ++c) {
        results[c].resize(cases[c].checks.size());
        for (size_t r = 0; r < cases[c].runs.size(); ++r)
            tasks.push_back({c, r});
    }

    std::mutex reporting;
    size_t done = 0;
    in_parallel(tasks.size(), jobs, [&](size_t t) {
        const Case& a_case = cases[tasks[t].a_case];
        const CaseRun& run = a_case.runs[tasks[t].run];
        const CaseOutcome outcome = run_case(run, scratch / a_case.name / run.name, with);
        VerifyProgress report{0, tasks.size(), a_case.name, run.name, outcome.seconds, 0};
        for (size_t i = 0; i < a_case.checks.size(); ++i) {
            if (a_case.checks[i].run != tasks[t].run) continue;
            // Each check belongs to one run: no two threads write the same entry.
            CheckResult& result = results[tasks[t].a_case][i];
            result = evaluate(a_case, a_case.checks[i], outcome);
            const std::string& only = a_case.checks[i].with;
            if (!only.empty() && only != with) {
                result.ok = result.skipped = true;
                result.detail = "asked of " + only + " only";
            }
            if (!result.ok) ++report.failed;
        }
        const std::lock_guard<std::mutex> lock(reporting);
        report.done = ++done;
        if (progress) progress(report);
    });

    std::vector<CheckResult> flat;
    for (std::vector<CheckResult>& of_case : results)
        for (CheckResult& result : of_case)
            flat.push_back(std::move(result));
    return flat;
}

}  // namespace type21
