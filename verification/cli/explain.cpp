#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reference/host/prepare_deck.h"
#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/explain/account_json.h"
#include "verification/explain/field_help.h"
#include "verification/explain/glossary.h"

namespace type21::cli {
namespace {

struct ExplainArguments {
    std::string what, as_built, thickness, json, cases = "cases";
    std::optional<Id> node, interface;
    std::optional<double> time;
};

int explain_node(const ExplainArguments& options) {
    if (!options.node || !options.time)
        throw UsageError("a deck needs --node and --time: one node at one time is explained");
    const PreparedDeck prepared = prepare_deck(options.what, options.as_built, true, options.thickness);
    print_problems(prepared.problems);
    if (!prepared.scene) return exit_deck;
    const Model& model = *prepared.scene->host;
    try {
        const DeckAccount account =
            explain_deck(*prepared.scene, {*options.node, *options.time, options.interface}, prepared.options());
        fmt::print("{}", account_text(account, model));
        if (!options.json.empty()) write_report(options.json, account_json(account, model));
    } catch (const ExplainError& error) {
        fmt::print(stderr, "type21: {}\n", error.what());
        return exit_deck;
    } catch (const RunStopped& stopped) {
        fmt::print(stderr, "type21: the run stopped before that time: {}\n", stopped.what());
        return exit_stopped;
    }
    return exit_ok;
}

/// What the cases of the folder cover; empty if there is no such folder.
std::vector<CaseCover> covers_of(const std::string& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error)) return {};
    std::vector<std::string> problems;
    std::vector<CaseCover> covers;
    for (const Case& a_case : read_cases(folder, {}, problems))
        covers.push_back({a_case.name, a_case.covers});
    return covers;
}

/// A field of the card, a departure or a term of the formulation; nothing where the word is none of them.
std::optional<std::string> word_text(const ExplainArguments& options) {
    const GlossaryEntry* term = find_term(options.what);
    if (const FieldHelp* help = find_field_help(options.what))
        return field_text(*help, covers_of(options.cases)) + (term == nullptr ? "" : "\n" + term_text(*term));
    std::string word = options.what;
    if (!word.empty()) word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
    for (const DepartureRow& row : departures())
        if (name(row.id) == word) return departure_text(row, covers_of(options.cases));
    if (term != nullptr) return term_text(*term);
    return std::nullopt;
}

std::string known_words() {
    std::string out;
    for (const FieldHelp& help : field_help())
        out += fmt::format("{} ", help.name);
    out += "D01 to D44";
    for (const GlossaryEntry& entry : glossary())
        out += fmt::format(", {}", entry.term);
    return out;
}

int explain(const ExplainArguments& options) {
    if (options.node || options.time) return explain_node(options);
    if (const auto text = word_text(options)) {
        fmt::print("{}", *text);
        return exit_ok;
    }
    std::error_code error;
    if (std::filesystem::exists(options.what, error)) return explain_node(options);
    const std::vector<std::string> near = near_terms(options.what);
    fmt::print(stderr,
               "type21: '{}' is no field of /INTER/TYPE21, no departure, no term of the formulation and no file; {}: "
               "{}\n",
               options.what, near.empty() ? "there are" : "near it are",
               near.empty() ? known_words() : fmt::format("{}", fmt::join(near, ", ")));
    return exit_deck;
}

}  // namespace

void add_explain(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "explain",
        "Explain the force on one node of a deck at one time, a field of the card (DEPTH), a departure (D03), or "
        "a term of the formulation (kappa)");
    const auto options = std::make_shared<ExplainArguments>();
    verb->add_option("WHAT", options->what,
                     "starter deck NAME_0000.rad with --node and --time, or a field, a departure or a term")
        ->required();
    verb->add_option("--node", options->node, "id of a secondary node");
    verb->add_option("--time", options->time, "time in the deck's unit; the last cycle at or before it is explained");
    verb->add_option("--interface", options->interface, "id of an interface (default: all with this node)");
    add_as_built(*verb, options->as_built);
    verb->add_option("--thickness", options->thickness,
                     "CSV of the thickness of the shells over time (see 'type21 run --help')");
    verb->add_option("--json", options->json, "also write the output to this JSON file");
    verb->add_option("--cases", options->cases,
                     "folder of the cases; those that cover a field or a departure are listed")
        ->capture_default_str();
    verb->callback([options, &exit_code] { exit_code = explain(*options); });
}

}  // namespace type21::cli
