#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "reference/host/prepare_deck.h"
#include "verification/cli/exit_code.h"
#include "verification/cli/interruption.h"
#include "verification/cli/progress.h"
#include "verification/cli/run_output.h"
#include "verification/cli/verbs.h"
#include "verification/results/record/checkpoint.h"
#include "verification/results/record/run_deck.h"
#include "verification/support/contact_choice.h"

namespace type21::cli {
namespace {

struct RunArguments {
    std::string deck, out, as_built, thickness, restart, with = "reference", search;
    bool quiet = false, paraview = false, keep_checkpoints = false;
    long checkpoint_every = 0;
};

int run(const RunArguments& options) {
    const MakeContact make = chosen_contact(options.with, options.search);
    const PreparedDeck prepared = prepare_deck(options.deck, options.as_built, true, options.thickness);
    print_problems(prepared.problems);
    if (!prepared.scene) return exit_deck;
    const HostScene& scene = *prepared.scene;
    Progress progress(scene.host->units.name(dim::time));
    std::function<void(const RunProgress&)> report;
    if (!options.quiet) report = [&progress](const RunProgress& p) { progress(p); };
    RunFiles files;
    files.paraview = options.paraview;
    files.checkpoint_every = options.checkpoint_every;
    files.keep_checkpoints = options.keep_checkpoints;
    files.restart = options.restart;
    files.inputs = prepared.files;
    files.with = options.search.empty() ? options.with : fmt::format("{}, search {}", options.with, options.search);
    files.durable = true;
    const Interruption interruption;
    files.interrupted = Interruption::asked;
    RunSummary summary;
    try {
        summary = run_scene(scene, prepared.problems, options.out, report, prepared.options(), make, files);
    } catch (const CheckpointError& error) {
        fmt::print(stderr, "{}\n", error.what());
        return exit_deck;
    } catch (...) {
        progress.finish();
        throw;
    }
    progress.finish();
    for (const std::string& note : summary.notes)
        fmt::print(stderr, "note: {}\n", note);
    for (const std::string& warning : summary.warnings)
        fmt::print(stderr, "{}\n", warning);
    if (!options.quiet) fmt::print("{}", run_text(summary, scene, options.out));
    if (summary.state == RunSummary::State::completed) return exit_ok;
    if (summary.state == RunSummary::State::interrupted) {
        fmt::print(stderr, "type21: the run was interrupted ({}): {}. The results until then are in {}\n",
                   Interruption::signal_name(), summary.reason, options.out);
        if (!summary.checkpoint.empty()) fmt::print(stderr, "type21: go on with --restart {}\n", summary.checkpoint);
        return exit_interrupted;
    }
    fmt::print(stderr, "type21: the run {}: {}. The results until then are in {}\n", name(summary.state),
               summary.reason, options.out);
    return exit_stopped;
}

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand("run", "Run a deck and write its histories");
    const auto options = std::make_shared<RunArguments>();
    verb->add_option("DECK", options->deck,
                     "starter deck NAME_0000.rad; the engine deck NAME_0001.rad must be in the same folder")
        ->required();
    verb->add_option("--out", options->out,
                     "folder for the results; it takes the place of an earlier result at the end of the run")
        ->required();
    add_as_built(*verb, options->as_built);
    verb->add_option(
        "--thickness", options->thickness,
        "CSV of the thickness of the shells: time and one column for each element id, with the value at the end of "
        "the cycle at that time; 0 deletes the element (for Igap 2 and Idel)");
    verb->add_option("--with", options->with, "implementation of the contact")
        ->check(CLI::IsMember(contact_choices()))
        ->capture_default_str();
    add_search(*verb, options->search, "; only with --with optimized (default: tree)");
    verb->add_flag(
        "--paraview", options->paraview,
        "also write blank and tool of each interface as time series for ParaView, in the subfolder paraview");
    CLI::Option* checkpoint =
        verb->add_option("--checkpoint", options->checkpoint_every,
                         "write a checkpoint every so many cycles, in the folder of the results: checkpoint.t21")
            ->check(CLI::PositiveNumber);
    verb->add_flag("--keep-checkpoints", options->keep_checkpoints,
                   "keep every checkpoint, not only the last: checkpoint_<cycle>.t21")
        ->needs(checkpoint);
    verb->add_option("--restart", options->restart,
                     "checkpoint to go on from; the results are those of a run without interruption");
    verb->add_flag("--quiet", options->quiet, "print no progress and no summary");
    verb->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace type21::cli
