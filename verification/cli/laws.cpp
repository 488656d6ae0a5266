#include <memory>
#include <string>

#include <fmt/format.h>

#include "reference/host/prepare_deck.h"
#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/explain/law_report.h"
#include "verification/support/contact_choice.h"

namespace type21::cli {
namespace {

struct LawsArguments {
    std::string deck, as_built, thickness, with = "reference", json;
};

int run(const LawsArguments& options) {
    const PreparedDeck prepared = prepare_deck(options.deck, options.as_built, true, options.thickness);
    print_problems(prepared.problems);
    if (!prepared.scene) return exit_deck;
    const UnitSystem& units = prepared.scene->host->units;
    const auto laws = law_points(*prepared.scene, contact_maker(options.with), prepared.options());
    fmt::print("{}", to_text(laws, units));
    if (!options.json.empty()) write_report(options.json, to_json(laws, units));
    return exit_ok;
}

}  // namespace

void add_laws(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "laws", "Run a deck and print the range of its friction, pressure and heat laws that its nodes covered");
    const auto options = std::make_shared<LawsArguments>();
    verb->add_option("DECK", options->deck, "starter deck NAME_0000.rad")->required();
    add_as_built(*verb, options->as_built);
    verb->add_option("--thickness", options->thickness,
                     "CSV of the thickness of the shells over time (see 'type21 run --help')");
    verb->add_option("--with", options->with, "implementation of the contact")
        ->check(CLI::IsMember(contact_choices()))
        ->capture_default_str();
    verb->add_option("--json", options->json, "also write points and curves to this JSON file");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace type21::cli
