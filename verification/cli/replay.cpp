#include <memory>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/decisions/fuzz/failure_file.h"
#include "verification/decisions/fuzz/judgement.h"
#include "verification/decisions/queries/decision_json.h"
#include "verification/decisions/queries/decision_text.h"
#include "verification/support/shown_text.h"

namespace type21::cli {
namespace {

struct ReplayArguments {
    std::string file, with;
};

/// @return true if the answer is wrong
bool replay_query(const DecisionBlock& block, size_t q, DecideWith method) {
    const ContactQuery& query = block.queries[q];
    fmt::print("{}", every_answer(block.tool, query));
    const Judgement judgement = judge(block.tool, query, method, Scrutiny::full);
    std::string wrong = judgement.wrong;
    if (!block.answers.empty()) {
        fmt::print("  {:<20} {}\n", "the file", in_words(block.answers[q]));
        if (wrong.empty() && !judgement.answer.same_decision(block.answers[q])) wrong = "the file has another answer";
    }
    fmt::print("  {} is {}\n", name(method), wrong.empty() ? "right" : "WRONG: " + wrong);
    return !wrong.empty();
}

int replay(const ReplayArguments& options) {
    std::vector<std::string> problems;
    const DecisionFile file = read_decisions(options.file, problems);
    for (const std::string& problem : problems)
        fmt::print(stderr, "{}\n", problem);
    if (!problems.empty()) return exit_deck;
    const std::string with = options.with.empty() ? file.with : options.with;
    DecideWith method = DecideWith::reference;
    try {
        if (!with.empty()) method = method_named(with);
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "{}: /with: {}\n", options.file, shown(error.what(), 160));
        return exit_deck;
    }
    bool wrong = false;
    for (size_t b = 0; b < file.blocks.size(); ++b)
        for (size_t q = 0; q < file.blocks[b].queries.size(); ++q) {
            fmt::print("block {}, query {}\n", b, q);
            wrong |= replay_query(file.blocks[b], q, method);
        }
    return wrong ? exit_mismatch : exit_ok;
}

}  // namespace

void add_replay(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand("replay", "Answer a question that failed once more, with every method");
    const auto options = std::make_shared<ReplayArguments>();
    verb->add_option("FILE", options->file, "file written by 'type21 fuzz', or any file for 'type21 decide'")
        ->required();
    verb->add_option("--with", options->with, "method to judge (default: the one that FILE names, otherwise reference)")
        ->check(CLI::IsMember(method_names()));
    verb->footer("Exit code 3 if the answer of the method is wrong; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = replay(*options); });
}

}  // namespace type21::cli
