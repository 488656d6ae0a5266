#include <algorithm>
#include <memory>
#include <thread>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/criteria/mutation/score.h"
#include "verification/support/contact_choice.h"

namespace type21::cli {
namespace {

struct MutateArguments {
    std::vector<std::string> names;
    std::string cases = "cases", scratch = "build/mutate", json, with = "reference";
    bool list = false, quiet = false;
    int jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
};

std::vector<Mutation> chosen_mutations(const std::vector<std::string>& names) {
    if (names.empty()) return mutations();
    std::vector<Mutation> some;
    for (const std::string& name : names) {
        const auto found = std::find_if(mutations().begin(), mutations().end(),
                                        [&](const Mutation& mutation) { return mutation.name == name; });
        if (found == mutations().end())
            throw UsageError(fmt::format("there is no mutation '{}'; 'type21 mutate --list' lists them", name));
        some.push_back(*found);
    }
    return some;
}

int mutate(const MutateArguments& options) {
    const std::vector<Mutation> some = chosen_mutations(options.names);
    if (options.list) {
        for (const Mutation& mutation : some)
            fmt::print("{:<28} {:<34} {}\n", mutation.name, mutation.effect, mutation.broken);
        return exit_ok;
    }
    std::vector<std::string> problems;
    const std::vector<Case> cases = read_cases(options.cases, {}, problems);
    for (const std::string& problem : problems)
        fmt::print(stderr, "{}\n", problem);
    if (!problems.empty()) return exit_deck;
    ScoreOptions how;
    how.decisions = std::filesystem::path(options.cases) / "decisions";
    how.scratch = options.scratch;
    how.with = options.with;
    how.jobs = options.jobs;
    size_t done = 0;
    if (!options.quiet)
        how.progress = [&](const MutationVerdict& v) {
            fmt::print(stderr, "[{:>3}/{}] {} {:.2f} s{}\n", ++done, some.size(), v.mutation.name, v.seconds,
                       v.red ? "" : ", SURVIVES");
        };
    const std::vector<MutationVerdict> verdicts = score(some, cases, how);
    fmt::print("{}", to_text(verdicts));
    if (!options.json.empty()) write_report(options.json, to_json(verdicts));
    const bool all = std::all_of(verdicts.begin(), verdicts.end(), [](const MutationVerdict& v) { return v.red; });
    return all ? exit_ok : exit_mismatch;
}

}  // namespace

void add_mutate(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "mutate", "Break one effect of the contact at a time, on purpose, and check that a criterion fails");
    const auto options = std::make_shared<MutateArguments>();
    verb->add_option("NAMES", options->names, "names of mutations (default: all)");
    verb->add_option("--cases", options->cases, "folder of the cases")->capture_default_str();
    verb->add_option("--scratch", options->scratch, "folder for the runs; their results are removed")
        ->capture_default_str();
    verb->add_option("--with", options->with,
                     "implementation that is broken; mutations of decisions always break the reference")
        ->check(CLI::IsMember(contact_choices()))
        ->capture_default_str();
    verb->add_option("--json", options->json, "also write one record for each mutation to this JSON file");
    verb->add_option("--jobs", options->jobs, "number of mutations at a time (default: number of processors)")
        ->check(CLI::PositiveNumber);
    verb->add_flag("--list", options->list, "list the mutations and exit");
    verb->add_flag("--quiet", options->quiet, "print no progress");
    verb->footer("Exit code 3 if no criterion fails for a mutation; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = mutate(*options); });
}

}  // namespace type21::cli
