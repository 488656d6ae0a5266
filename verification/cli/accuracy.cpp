#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/performance/accuracy/accuracy_report.h"

namespace type21::cli {
namespace {

struct AccuracyArguments {
    accuracy::Options measure;
    std::string json;
    bool quiet = false, list = false;
};

std::vector<std::string> scene_names() {
    std::vector<std::string> names;
    for (const accuracy::SceneKind& kind : accuracy::scene_kinds())
        names.emplace_back(kind.name);
    return names;
}

int run(AccuracyArguments options) {
    if (options.list) {
        for (const accuracy::SceneKind& kind : accuracy::scene_kinds())
            fmt::print("{:<12} {:<12} {}\n", kind.name, kind.kind, kind.what);
        return exit_ok;
    }
    if (!options.quiet) options.measure.progress = [](const std::string& what) { fmt::print(stderr, "{}\n", what); };
    const accuracy::Result result = accuracy::measure(options.measure);
    fmt::print("{}", accuracy::to_text(result));
    if (!options.json.empty()) write_report(options.json, accuracy::to_json(result));
    return result.exact_ones_are_right() ? exit_ok : exit_mismatch;
}

}  // namespace

void add_accuracy(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "accuracy", "What accuracy costs in time: number types, implementations, searches and effects side by side");
    const auto options = std::make_shared<AccuracyArguments>();
    verb->add_flag("--quick", options->measure.quick, "fewer decisions and repeats, some 20 s; else some 3 minutes");
    verb->add_option("--repeats", options->measure.repeats, "of each time (default: 21 when quick, else 41)")
        ->check(CLI::Range(1, 100000));
    verb->add_option("--scene", options->measure.scenes, "only these scenes, without the effects (default: all)")
        ->check(CLI::IsMember(scene_names()));
    verb->add_option("--seed", options->measure.seed, "another seed asks other questions")->capture_default_str();
    verb->add_option("--json", options->json, "write the same as JSON to this file");
    verb->add_flag("--quiet", options->quiet, "no progress");
    verb->add_flag("--list", options->list, "list the scenes; measure nothing");
    verb->footer(
        "Times are processor time of one thread; all methods are timed in turn in one process. Exit code 3 when a\n"
        "method that promises exact decisions is wrong; times never decide.");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace type21::cli
