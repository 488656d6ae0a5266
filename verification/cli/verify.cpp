#include <cstdio>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/criteria/lockstep/lockstep_report.h"
#include "verification/report/criteria_report.h"
#include "verification/support/contact_choice.h"

namespace type21::cli {
namespace {

struct VerifyArguments {
    std::vector<std::string> names;
    std::string cases = "cases", scratch = "build/verify", json, junit, with = "reference";
    bool list = false, lockstep = false, keep = false;
    int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

void print_list(const std::vector<Case>& cases) {
    for (const Case& a_case : cases) {
        fmt::print("{}: {}\n", a_case.name, a_case.statement);
        for (const Criterion& criterion : a_case.criteria)
            fmt::print("  {:<24} {:<10} run {}\n", criterion.id, name(criterion.kind), a_case.runs[criterion.run].name);
    }
}

/// Steps reference and optimized side by side: one criterion for each run whose deck is not refused.
void add_lockstep_criteria(const std::vector<Case>& cases, int jobs, std::vector<CriterionResult>& results) {
    for (const LockstepRecord& record : lockstep_decks(lockstep_targets(cases, {}), {jobs, {}, {}})) {
        if (record.refused) continue;
        const size_t slash = record.target.name.find('/');
        results.push_back(
            lockstep_criterion(record, record.target.name.substr(0, slash), record.target.name.substr(slash + 1)));
    }
}

int verify(const VerifyArguments& options) {
    std::vector<std::string> problems;
    const std::vector<Case> cases = read_cases(options.cases, options.names, problems);
    for (const std::string& problem : problems)
        fmt::print(stderr, "{}\n", problem);
    if (!problems.empty()) return exit_deck;
    if (options.list) {
        print_list(cases);
        return exit_ok;
    }
    const auto progress = [](const VerifyProgress& p) {
        if (p.kept) return;  // the summary gives their number
        fmt::print(stderr, "[{:>3}/{}] {}/{} {:.2f} s{}\n", p.done, p.of, p.case_name, p.run, p.seconds,
                   p.failed == 0 ? "" : fmt::format(", {} criteria FAILED", p.failed));
    };
    std::vector<CriterionResult> results =
        verify_cases(cases, options.scratch, options.jobs, progress, options.with, options.keep);
    if (options.lockstep) add_lockstep_criteria(cases, options.jobs, results);
    fmt::print("{}", criteria_table(results));
    if (!options.json.empty()) write_report(options.json, criteria_json(results));
    if (!options.junit.empty()) write_report(options.junit, criteria_junit(results));
    for (const CriterionResult& result : results)
        if (!result.ok) return exit_mismatch;
    return exit_ok;
}

}  // namespace

void add_verify(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand("verify", "Run cases and check their criteria");
    const auto options = std::make_shared<VerifyArguments>();
    verb->add_option("NAMES", options->names, "names of cases (default: all)");
    verb->add_option("--cases", options->cases, "folder of the cases")->capture_default_str();
    verb->add_option("--scratch", options->scratch, "folder for the results of the runs")->capture_default_str();
    verb->add_option("--json", options->json, "also write one record for each criterion to this JSON file");
    verb->add_option("--junit", options->junit, "also write JUnit XML to this file");
    verb->add_option("--jobs", options->jobs, "number of runs at a time (default: number of processors)")
        ->check(CLI::PositiveNumber);
    verb->add_option("--with", options->with, "implementation of the contact")
        ->check(CLI::IsMember(contact_choices()))
        ->capture_default_str();
    verb->add_flag("--keep", options->keep,
                   "do not repeat runs whose criteria held, if the case, the program and the results are unchanged");
    verb->add_flag("--lockstep", options->lockstep,
                   "also step the reference and the optimized contact side by side: one more criterion for each run");
    verb->add_flag("--list", options->list, "list the cases and their criteria, and exit");
    verb->footer("Exit code 3 if a criterion fails; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = verify(*options); });
}

}  // namespace type21::cli
