#include "verification/decisions/queries/decide.h"

#include <memory>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/support/build_info.h"

namespace type21::cli {
namespace {

struct DecideArguments {
    std::string file, out, with = "reference";
};

int decide_file(const DecideArguments& options) {
    std::vector<std::string> problems;
    DecisionFile file = read_decisions(options.file, problems);
    for (const std::string& problem : problems)
        fmt::print(stderr, "{}\n", problem);
    if (!problems.empty()) {
        fmt::print(stderr, "{} problems; no question was answered\n", problems.size());
        return exit_deck;
    }
    for (size_t i = 0; i < file.blocks.size(); ++i)
        for (const std::string& warning : warnings(file.blocks[i].tool))
            fmt::print(stderr, "{}: /blocks/{}: warning: {}\n", options.file, i, warning);

    const DecisionTally tally = answer_all(file, method_named(options.with));
    nlohmann::ordered_json json = to_json(file);
    json["with"] = options.with;
    json["program"] = program_name();
    json["stage_counts"] = to_json(tally.stage_counts);
    if (options.out.empty()) {
        fmt::print("{}\n", json.dump(1));
        fmt::print(stderr, "{}", to_text(tally));
    } else {
        write_report(options.out, json);
        fmt::print("{}", to_text(tally));
    }
    return tally.different.empty() ? exit_ok : exit_mismatch;
}

}  // namespace

void add_decide(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "decide", "Answer geometric questions: segment, side, contact or proximity, and the margin to another answer");
    const auto options = std::make_shared<DecideArguments>();
    verb->add_option("FILE", options->file, "JSON file with tools and nodes (format: verification/commands/decide.md)")
        ->required();
    verb->add_option(
            "--with", options->with,
            "method: reference (exact, in stages), optimized (exact), exact (only rational numbers) or double (may be "
            "wrong)")
        ->check(CLI::IsMember(method_names()))
        ->capture_default_str();
    verb->add_option("--out", options->out, "write questions and answers to this JSON file (default: standard output)");
    verb->footer(
        "If FILE has answers, they are compared. Exit code 3 if one differs; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = decide_file(*options); });
}

}  // namespace type21::cli
