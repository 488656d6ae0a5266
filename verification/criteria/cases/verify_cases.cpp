#include "verification/criteria/cases/verify_cases.h"

#include <algorithm>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "verification/criteria/cases/digest.h"
#include "verification/criteria/cases/evaluate.h"
#include "verification/criteria/cases/kept_checks.h"
#include "verification/criteria/cases/run_case.h"
#include "verification/support/in_parallel.h"

namespace type21 {
namespace fs = std::filesystem;

namespace {

/// Of all that the checks of each case depend on, but for the name of the run: the program, who computes, the files.
std::vector<std::string> keys_of(const std::vector<Case>& cases, const std::string& with) {
    const std::string program = digest_of("/proc/self/exe");
    std::vector<std::string> keys;
    for (const Case& a_case : cases)
        keys.push_back(fmt::format("{} {} {}", program, with, digest_of(a_case.folder)));
    return keys;
}

std::vector<CheckResult> checks_of(const Case& a_case, size_t run, const CaseOutcome& outcome,
                                   const std::string& with) {
    std::vector<CheckResult> results;
    for (const CaseCheck& check : a_case.checks) {
        if (check.run != run) continue;
        CheckResult result = evaluate(a_case, check, outcome);
        if (!check.with.empty() && check.with != with) {
            result.ok = result.skipped = true;
            result.detail = "asked of " + check.with + " only";
        }
        results.push_back(std::move(result));
    }
    return results;
}

}  // namespace

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
                                      const std::string& with, bool keep) {
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

    keep = keep && has_digest();
    std::mutex reporting;
    size_t done = 0;
    const std::vector<std::string> keys = keep ? keys_of(cases, with) : std::vector<std::string>(cases.size());
    in_parallel(tasks.size(), jobs, [&](size_t t) {
        const Case& a_case = cases[tasks[t].a_case];
        const CaseRun& run = a_case.runs[tasks[t].run];
        const fs::path folder = scratch / a_case.name / run.name;
        const std::string key = digest_of_text(keys[tasks[t].a_case] + " " + run.name);
        std::optional<std::vector<CheckResult>> checks = keep ? kept_checks(folder, key) : std::nullopt;
        VerifyProgress report{0, tasks.size(), a_case.name, run.name, 0, 0, checks.has_value()};
        if (!checks) {
            const CaseOutcome outcome = run_case(run, folder, with);
            report.seconds = outcome.seconds;
            checks = checks_of(a_case, tasks[t].run, outcome, with);
            if (keep) keep_checks(folder, key, *checks);
        }
        size_t next = 0;
        for (size_t i = 0; i < a_case.checks.size(); ++i) {
            if (a_case.checks[i].run != tasks[t].run) continue;
            // Each check belongs to one run: no two threads write the same entry.
            CheckResult& result = results[tasks[t].a_case][i];
            result = std::move(checks->at(next++));
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
