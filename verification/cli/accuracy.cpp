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
    CLI::App* verb = app.add_subcommand("accuracy",
                                        "Measure the time and the accuracy of number types, implementations, searches "
                                        "and effects on the same questions");
    const auto options = std::make_shared<AccuracyArguments>();
    verb->add_flag("--quick", options->measure.quick, "fewer decisions and repeats: about 20 s instead of 3 minutes");
    verb->add_option("--repeats", options->measure.repeats,
                     "number of repeats of each measurement (default: 41, with --quick 21)")
        ->check(CLI::Range(1, 100000));
    verb->add_option("--scene", options->measure.scenes,
                     "measure only this scene, and no effects; may be repeated (default: all scenes)")
        ->check(CLI::IsMember(scene_names()));
    verb->add_option("--seed", options->measure.seed, "seed of the random questions")->capture_default_str();
    verb->add_option("--json", options->json, "also write the output to this JSON file");
    verb->add_flag("--quiet", options->quiet, "print no progress");
    verb->add_flag("--list", options->list, "list the scenes; measure nothing");
    verb->footer(
        "Times are processor time of one thread; the methods are timed in turn in one process.\n"
        "Exit code 3 if a method that guarantees exact decisions is wrong. Times do not affect the exit\n"
        "code; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace type21::cli
