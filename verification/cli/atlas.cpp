#include "verification/decisions/atlas/atlas.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/support/build_info.h"

namespace type21::cli {
namespace {

struct AtlasArguments {
    std::vector<std::string> names;
    std::string folder = "cases/atlas", with = "reference", json;
};

int show(const AtlasArguments& options) {
    std::vector<std::string> problems;
    const std::vector<AtlasEntry> entries = read_atlas(options.folder, options.names, problems);
    for (const std::string& problem : problems)
        fmt::print(stderr, "{}\n", problem);
    if (!problems.empty()) return exit_deck;

    nlohmann::ordered_json json;
    json["with"] = options.with;
    json["program"] = program_name();
    json["entries"] = nlohmann::ordered_json::array();
    size_t queries = 0;
    size_t wrong = 0;
    size_t double_wrong = 0;
    for (const AtlasEntry& entry : entries) {
        const std::vector<AtlasAnswer> answers = answers_of(entry, method_named(options.with));
        queries += answers.size();
        for (size_t q = 0; q < answers.size(); ++q) {
            if (!answers[q].ok) ++wrong;
            if (!answers[q].plain.same_decision(entry.block.answers[q])) ++double_wrong;
        }
        fmt::print("{}", to_text(entry, answers));
        json["entries"].push_back(to_json(entry, answers));
    }
    fmt::print("{} {}, {} decisions: {} differ from the exact answer; plain double is wrong in {}\n", entries.size(),
               entries.size() == 1 ? "entry" : "entries", queries, wrong, double_wrong);
    if (!options.json.empty()) write_report(options.json, json);
    return wrong == 0 ? exit_ok : exit_mismatch;
}

}  // namespace

void add_atlas(CLI::App& app, int& exit_code) {
    CLI::App* verb =
        app.add_subcommand("atlas", "Answer the atlas of hard geometric cases and compare with the exact answers");
    const auto options = std::make_shared<AtlasArguments>();
    verb->add_option("NAMES", options->names, "names of entries (default: all)");
    verb->add_option("--folder", options->folder, "folder of the entries")->capture_default_str();
    verb->add_option("--with", options->with,
                     "method that answers: reference, optimized, exact (rational numbers) or double")
        ->check(CLI::IsMember(method_names()))
        ->capture_default_str();
    verb->add_option("--json", options->json,
                     "also write the entries, with geometry and all answers, to this JSON file");
    verb->footer("Exit code 3 if an answer differs from the exact one; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = show(*options); });
}

}  // namespace type21::cli
