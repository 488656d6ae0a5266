#include <memory>

#include <fmt/format.h>

#include "reference/host/prepare_deck.h"
#include "verification/cli/check_output.h"
#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"

namespace type21::cli {
namespace {

struct CheckArguments {
    std::string deck, as_built, json;
    bool geometry = false;
};

int check(const CheckArguments& options) {
    const PreparedDeck prepared = prepare_deck(options.deck, options.as_built, false);
    print_problems(prepared.problems);
    if (!prepared.scene) {
        if (!options.json.empty()) write_report(options.json, refused_json(options.deck, prepared.problems));
        return exit_deck;
    }
    const HostScene& scene = *prepared.scene;
    std::vector<TimeZero> zero;
    for (size_t i = 0; i < scene.model->interfaces.size(); ++i)
        zero.push_back(time_zero(scene, static_cast<int>(i)));
    fmt::print("{}", check_text(scene, zero));
    if (!options.json.empty()) {
        nlohmann::ordered_json json = check_json(scene, zero, prepared.problems);
        if (options.geometry) json["geometry"] = geometry_json(scene);
        write_report(options.json, json);
    }
    return exit_ok;
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "check", "Read a deck and print what would be computed, with every value and its origin; nothing is run");
    const auto options = std::make_shared<CheckArguments>();
    verb->add_option("DECK", options->deck, "starter deck NAME_0000.rad")->required();
    add_as_built(*verb, options->as_built);
    CLI::Option* json = verb->add_option("--json", options->json, "also write the output to this JSON file");
    verb->add_flag("--geometry", options->geometry, "add nodes and segments to the JSON file")->needs(json);
    verb->callback([options, &exit_code] { exit_code = check(*options); });
}

}  // namespace type21::cli
