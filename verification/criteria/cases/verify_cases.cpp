#include "verification/criteria/cases/verify_cases.h"

#include <algorithm>
#include <mutex>
#include <set>

#include <fmt/format.h>

#include "verification/criteria/cases/digest.h"
#include "verification/criteria/cases/evaluate.h"
#include "verification/criteria/cases/kept_results.h"
#include "verification/criteria/cases/run_case.h"
#include "verification/support/in_parallel.h"

namespace type21 {
namespace fs = std::filesystem;

namespace {

/// A key of each case: the program, the implementation and the files of the case. The name of the run is added later.
std::vector<std::string> keys_of(const std::vector<Case>& cases, const std::string& with) {
    const std::string program = digest_of("/proc/self/exe");
    std::vector<std::string> keys;
    for (const Case& a_case : cases)
        keys.push_back(fmt::format("{} {} {}", program, with, digest_of(a_case.folder)));
    return keys;
}

std::vector<CriterionResult> results_of(const Case& a_case, size_t run, const CaseOutcome& outcome,
                                        const std::string& with) {
    std::vector<CriterionResult> results;
    for (const Criterion& criterion : a_case.criteria) {
        if (criterion.run != run) continue;
        CriterionResult result = evaluate(a_case, criterion, outcome);
        if (!criterion.with.empty() && criterion.with != with) {
            result.ok = result.skipped = true;
            result.detail = "applies to " + criterion.with + " only";
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

std::vector<CriterionResult> verify_cases(const std::vector<Case>& cases, const fs::path& scratch, int jobs,
                                          const std::function<void(const VerifyProgress&)>& progress,
                                          const std::string& with, bool keep) {
    struct Task {
        size_t a_case = 0, run = 0;
    };
    std::vector<Task> tasks;
    std::vector<std::vector<CriterionResult>> results(cases.size());
    for (size_t c = 0; c < cases.size(); ++c) {
        results[c].resize(cases[c].criteria.size());
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
        std::optional<std::vector<CriterionResult>> of_run = keep ? kept_results(folder, key) : std::nullopt;
        VerifyProgress report{0, tasks.size(), a_case.name, run.name, 0, 0, of_run.has_value()};
        if (!of_run) {
            const CaseOutcome outcome = run_case(run, folder, with);
            report.seconds = outcome.seconds;
            of_run = results_of(a_case, tasks[t].run, outcome, with);
            if (keep) keep_results(folder, key, *of_run);
        }
        size_t next = 0;
        for (size_t i = 0; i < a_case.criteria.size(); ++i) {
            if (a_case.criteria[i].run != tasks[t].run) continue;
            // Each criterion belongs to one run: no two threads write the same entry.
            CriterionResult& result = results[tasks[t].a_case][i];
            result = std::move(of_run->at(next++));
            if (!result.ok) ++report.failed;
        }
        const std::lock_guard<std::mutex> lock(reporting);
        report.done = ++done;
        if (progress) progress(report);
    });

    std::vector<CriterionResult> flat;
    for (std::vector<CriterionResult>& of_case : results)
        for (CriterionResult& result : of_case)
            flat.push_back(std::move(result));
    return flat;
}

}  // namespace type21
