#include "verification/results/record/run_deck.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "verification/results/paraview/paraview_files.h"
#include "verification/results/record/recorder.h"
#include "verification/results/record/result_folder.h"
#include "verification/support/contact_choice.h"

namespace type21 {
namespace {

std::vector<std::string> warnings_of(const Problems& problems) {
    std::vector<std::string> out;
    for (const Problem& problem : problems.list())
        if (problem.severity == Severity::warning) out.push_back(to_text(problem));
    return out;
}

}  // namespace

RunSummary run_scene(const HostScene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options,
                     const std::string& with, const RunFiles& files) {
    return run_scene(scene, problems, folder, progress, options, contact_maker(with), files);
}

RunSummary run_scene(const HostScene& scene, const Problems& problems, const std::filesystem::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options,
                     const MakeContact& make, const RunFiles& files) {
    prepare_folder(folder);
    const std::vector<std::string> warnings = warnings_of(problems);
    const std::filesystem::path json = folder / "run.json";
    RunSummary summary;
    // Written first, so that the folder of a run that was killed says whose it is.
    write_json(json, to_json(summary, scene, warnings));

    Recorder recorder(scene, folder);
    std::optional<ParaviewFiles> paraview;
    if (files.paraview) paraview.emplace(scene, folder);
    BalanceObserver balance(scene);
    ContactCounter counter(scene);
    const auto start = std::chrono::steady_clock::now();
    const auto seconds = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const double end_time = scene.host->engine.end_time;

    const auto observe = [&](const CycleRecord& record) {
        summary.observe(record);
        balance.observe(record);
        counter.observe(record);
        recorder.observe(record);
        if (paraview) paraview->observe(record);
        if (!progress) return;
        const double fraction = record.last ? 1.0 : (end_time > 0 ? std::min(record.time / end_time, 1.0) : 1.0);
        const double left = fraction > 0 ? seconds() * (1 - fraction) / fraction : 0;
        progress({fraction, record.cycle, record.time, left, record.last});
    };
    const auto finish = [&](RunSummary::State state, const std::string& reason) {
        summary.state = state;
        summary.reason = reason;
        summary.wall_seconds = seconds();
        summary.balance = balance.result();
        summary.contact = counter.result();
        write_json(json, to_json(summary, scene, warnings));
    };
    MarchOptions march_options = options;
    march_options.warn = [&](const std::string& text) { summary.warnings.push_back("warning: " + text); };
    try {
        march(scene, make, observe, march_options);
    } catch (const RunStopped& stop) {
        const bool diverged = stop.why == RunStopped::Why::diverged;
        finish(diverged ? RunSummary::State::diverged : RunSummary::State::stopped, stop.what());
        return summary;
    } catch (const std::exception& error) {
        finish(RunSummary::State::stopped, std::string("internal error: ") + error.what());
        throw;
    }
    finish(RunSummary::State::completed, "");
    return summary;
}

}  // namespace type21
