#include "verification/criteria/lockstep/lockstep.h"

#include <algorithm>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/criteria/lockstep/lockstep_report.h"
#include "verification/support/contact_choice.h"

namespace type21::cli {
namespace {

struct LockstepArguments {
    std::vector<std::string> names;
    std::string cases = "cases", as_built, json, free_runs, search;
    bool as_built_given = false, quiet = false;
    int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

int run(const LockstepArguments& options) {
    std::vector<std::string> case_names, problems;
    std::vector<LockstepTarget> targets;
    for (const std::string& name : options.names) {
        if (name.ends_with(".rad"))
            targets.push_back({name, {name, options.as_built, name, {}}});
        else
            case_names.push_back(name);
    }
    if (!case_names.empty() || targets.empty()) {
        const std::vector<Case> cases = read_cases(options.cases, case_names, problems);
        for (const std::string& problem : problems)
            fmt::print(stderr, "{}\n", problem);
        if (!problems.empty()) return exit_deck;
        std::optional<std::string> as_built;
        if (options.as_built_given) as_built = options.as_built;
        for (const LockstepTarget& target : lockstep_targets(cases, as_built))
            targets.push_back(target);
    }
    size_t done = 0;
    LockstepOptions how{options.jobs, options.free_runs, {}, options.search};
    if (!options.quiet)
        how.progress = [&](const LockstepRecord& record) {
            fmt::print(stderr, "[{:>3}/{}] {} {:.2f} s{}\n", ++done, targets.size(), record.target.name, record.seconds,
                       record.ok() ? "" : ", DIFFERS");
        };
    const std::vector<LockstepRecord> records = lockstep_decks(targets, how);
    fmt::print("{}", to_text(records));
    if (!options.json.empty()) {
        nlohmann::ordered_json json = to_json(records);
        json["search"] = options.search.empty() ? search_choices().front() : options.search;
        write_report(options.json, json);
    }
    for (const LockstepRecord& record : records) {
        // A deck named by the user must run; some cases have decks that must be refused.
        if (record.refused && record.target.name.ends_with(".rad")) return exit_deck;
        if (!record.ok()) return exit_mismatch;
    }
    return exit_ok;
}

}  // namespace

void add_lockstep(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand("lockstep",
                                        "Step the reference and the optimized contact side by side and compare every "
                                        "decision and force of every cycle");
    const auto options = std::make_shared<LockstepArguments>();
    verb->add_option("NAMES", options->names, "names of cases, or starter decks NAME_0000.rad (default: all cases)");
    verb->add_option("--cases", options->cases, "folder of the cases")->capture_default_str();
    add_as_built(*verb, options->as_built);
    verb->add_option("--free-runs", options->free_runs,
                     "also run both separately, into this folder, and print the largest difference of their histories");
    add_search(*verb, options->search, " (default: tree)");
    verb->add_option("--json", options->json, "also write the output to this JSON file");
    verb->add_option("--jobs", options->jobs, "number of runs at a time (default: number of processors)")
        ->check(CLI::PositiveNumber);
    verb->add_flag("--quiet", options->quiet, "print no progress");
    verb->footer(
        "Cases are run with the departures of their case.toml, or with those of --as-built ('none' for none).\n"
        "Exit code 3 if a decision differs, or a number by more than 4 ulps of the magnitudes that enter it;\n"
        "'type21 --help' lists the others.");
    verb->callback([options, verb, &exit_code] {
        options->as_built_given = verb->count("--as-built") > 0;
        exit_code = run(*options);
    });
}

}  // namespace type21::cli
