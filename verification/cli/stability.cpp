#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/stability/long_runs.h"
#include "verification/stability/stability_report.h"
#include "verification/support/build_info.h"
#include "verification/support/contact_choice.h"

namespace type21::cli {
namespace {

constexpr const char* sliding = "sliding";

struct StabilityArguments {
    std::vector<std::string> names;
    std::string json, with = "reference";
    long cycles = 0;
};

std::vector<std::string> all_names() {
    std::vector<std::string> names;
    for (const stability::LongRunKind& kind : stability::long_runs())
        names.emplace_back(kind.name);
    names.emplace_back(sliding);
    return names;
}

int run(const StabilityArguments& options) {
    const auto wanted = [&](std::string_view name) {
        return options.names.empty() ||
               std::find(options.names.begin(), options.names.end(), name) != options.names.end();
    };
    const MakeContact make = contact_maker(options.with);
    const BuildInfo& build = build_info();
    nlohmann::ordered_json out{{"program", {{"version", build.version}, {"commit", build.commit}}},
                               {"contact", options.with}};
    bool all_hold = true;
    for (const stability::LongRunKind& kind : stability::long_runs()) {
        if (!wanted(kind.name)) continue;
        const stability::LongRun result = kind.run(make, options.cycles > 0 ? options.cycles : kind.cycles);
        fmt::print("{}\n", stability::to_text(result));
        out["long_runs"].push_back(stability::to_json(result));
        all_hold = all_hold && result.holds();
    }
    if (wanted(sliding)) {
        const std::vector<stability::SlidingRow> rows = stability::slide_over_all(make);
        fmt::print("{}\n", stability::to_text(rows));
        out["sliding"] = stability::to_json(rows);
        for (const stability::SlidingRow& row : rows)
            all_hold = all_hold && stability::holds(row);
    }
    fmt::print("{}\n", all_hold ? "everything holds" : "something DOES NOT HOLD");
    out["holds"] = all_hold;
    if (!options.json.empty()) write_report(options.json, out);
    return all_hold ? exit_ok : exit_mismatch;
}

}  // namespace

void add_stability(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "stability", "Measure drift over long runs, and jumps of the force of a node that slides over a tool");
    const auto options = std::make_shared<StabilityArguments>();
    verb->add_option("NAMES", options->names, "names of long runs, or sliding (default: all)")
        ->check(CLI::IsMember(all_names()));
    verb->add_option("--cycles", options->cycles, "number of cycles of each long run (default: 1e5 or 1e6, by run)")
        ->check(CLI::Range(10000L, 1000000000L));
    verb->add_option("--with", options->with, "implementation of the contact")
        ->check(CLI::IsMember(contact_choices()))
        ->capture_default_str();
    verb->add_option("--json", options->json, "also write the output to this JSON file");
    verb->footer("Exit code 3 if a number exceeds its bound; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace type21::cli
