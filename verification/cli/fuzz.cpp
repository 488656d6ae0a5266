#include "verification/decisions/fuzz/fuzz.h"

#include <chrono>
#include <cstdio>
#include <memory>
#include <thread>
#include <unistd.h>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/decisions/fuzz/failure_file.h"
#include "verification/decisions/fuzz/fuzz_text.h"
#include "verification/support/build_info.h"

namespace type21::cli {
namespace {

struct FuzzArguments {
    std::vector<std::string> families;
    std::string with = "reference", search, json, failures = "fuzz_failures";
    FuzzOptions fuzz;
    bool list = false;
};

/// On a terminal one line that is overwritten; elsewhere a line every 30 s.
std::function<void(double)> progress_of(const std::string& family) {
    using Clock = std::chrono::steady_clock;
    return [family, terminal = isatty(STDERR_FILENO) == 1,
            next = Clock::now() + std::chrono::seconds(1)](double share) mutable {
        const auto now = Clock::now();
        if (now < next) return;
        next = now + (terminal ? std::chrono::milliseconds(200) : std::chrono::seconds(30));
        fmt::print(stderr, "{}{:<16} {:5.1f} %{}", terminal ? "\r" : "", family, 100 * share, terminal ? "\r" : "\n");
        std::fflush(stderr);
    };
}

std::vector<const QuestionFamily*> chosen(const std::vector<std::string>& names) {
    std::vector<const QuestionFamily*> found;
    for (const std::string& name : names) {
        const QuestionFamily* family = question_family_named(name);
        if (family == nullptr)
            throw UsageError(fmt::format("there is no question family '{}'; 'type21 fuzz --list' lists them", name));
        found.push_back(family);
    }
    if (names.empty())
        for (const QuestionFamily& family : question_families())
            found.push_back(&family);
    return found;
}

int run_fuzz(FuzzArguments options) {
    if (options.list) {
        for (const QuestionFamily& family : question_families())
            fmt::print("{:<16} {}\n", family.name, family.what);
        return exit_ok;
    }
    if (!options.search.empty() && options.with != name(DecideWith::optimized))
        throw UsageError(fmt::format("--search {}: only --with optimized has a choice of search", options.search));
    options.fuzz.method = method_named(options.with + (options.search.empty() ? "" : "-" + options.search));
    std::vector<FuzzTally> tallies;
    long different = 0;
    for (const QuestionFamily* family : chosen(options.families)) {
        const FuzzTally& tally =
            tallies.emplace_back(fuzz(*family, options.fuzz, progress_of(std::string(family->name))));
        different += tally.different;
        for (const FuzzFailure& failure : tally.failures) {
            const std::filesystem::path file =
                std::filesystem::path(options.failures) /
                fmt::format("{}_{}_{}_{}.json", tally.family, options.fuzz.seed, failure.block, failure.number);
            write_report(file, failure_json(failure, tally.family, options.fuzz));
            fmt::print(stderr, "{}: {}\n", file.string(), failure.what);
        }
    }
    fmt::print("{}", to_text(tallies, options.fuzz));
    if (!options.json.empty()) {
        nlohmann::ordered_json json = to_json(tallies, options.fuzz);
        json["program"] = program_name();
        write_report(options.json, json);
    }
    if (different == 0) return exit_ok;
    fmt::print(stderr, "{} answers are wrong; 'type21 replay FILE' shows one of the files in {}\n", different,
               options.failures);
    return exit_mismatch;
}

}  // namespace

void add_fuzz(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "fuzz", "Ask random and adversarial geometric questions and compare the answers with exact ones");
    const auto options = std::make_shared<FuzzArguments>();
    options->fuzz.jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    verb->add_option("--family", options->families, "question family; may be repeated (default: all)");
    verb->add_option("--count", options->fuzz.count, "number of questions for each family")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    verb->add_option("--seed", options->fuzz.seed, "seed of the random questions")->capture_default_str();
    verb->add_option("--with", options->with,
                     "method under test: reference, optimized, exact (rational numbers) or double")
        ->check(CLI::IsMember(method_names()))
        ->capture_default_str();
    add_search(*verb, options->search, "; only with --with optimized (default: none, every segment competes)");
    verb->add_option("--jobs", options->fuzz.jobs, "number of threads (default: number of processors)")
        ->check(CLI::PositiveNumber);
    verb->add_option("--failures", options->failures, "folder for the files of wrong answers")->capture_default_str();
    verb->add_option("--json", options->json, "also write the counts to this JSON file");
    verb->add_flag("--list", options->list, "list the question families and exit");
    verb->footer(
        "The first 10 wrong answers of a family are reduced and written to files.\n"
        "Exit code 3 if an answer is wrong; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = run_fuzz(*options); });
}

}  // namespace type21::cli
