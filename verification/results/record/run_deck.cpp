#include "verification/results/record/run_deck.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "verification/results/paraview/paraview_files.h"
#include "verification/results/record/checkpoint.h"
#include "verification/results/record/recorder.h"
#include "verification/results/record/result_folder.h"
#include "verification/results/record/run_id.h"
#include "verification/support/contact_choice.h"
#include "verification/support/io_error.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

using Clock = std::chrono::steady_clock;

std::vector<std::string> warnings_of(const Problems& problems) {
    std::vector<std::string> out;
    for (const Problem& problem : problems.list())
        if (problem.severity == Severity::warning) out.push_back(to_text(problem));
    return out;
}

/// One run: the observers, and how it begins, goes on and ends.
class Run {
  public:
    Run(const HostScene& scene, const Problems& problems, const fs::path& target, const RunFiles& files,
        const std::optional<Checkpoint>& restart, RunIdentity identity)
        : scene_(scene),
          target_(target),
          files_(files),
          identity_(std::move(identity)),
          warnings_(warnings_of(problems)),
          run_id_(new_run_id()),
          folder_(target, run_id_) {
        summary_.run_id = run_id_;
        summary_.notes = folder_.notes();
        if (restart) summary_.restarted_from = {restart->run_id, restart->cycle, restart->time};
        // Written first, so that the folder of a run that was killed says whose it is.
        write_summary();
        if (restart) copy_histories(files.restart, *restart, folder_.path());
        recorder_.emplace(scene, folder_.path());
        if (files.paraview) paraview_.emplace(scene, folder_.path(), xml_mark(run_id_));
        if (restart && paraview_) paraview_->take_over(files.restart.parent_path(), restart->paraview_times);
    }

    /// Reads what the observers remember; the rest of the state is the march's.
    void restore(StateReader& state) { observers(state); }

    RunSummary march(const MakeContact& make, MarchOptions options,
                     const std::function<void(const RunProgress&)>& progress) {
        options.between_cycles = [this](const BetweenCycles& at) { between_cycles(at); };
        options.warn = [this](const std::string& text) { summary_.warnings.push_back("warning: " + text); };
        try {
            march_to_end(make, options, progress);
        } catch (const IoError& error) {
            if (checkpoint_name_.empty() || !summary_.checkpoint.empty()) throw;
            folder_.keep();
            throw IoError(fmt::format("{}. The last checkpoint is {}", error.what(),
                                      (folder_.path() / checkpoint_name_).string()));
        }
        return summary_;
    }

  private:
    void march_to_end(const MakeContact& make, const MarchOptions& options,
                      const std::function<void(const RunProgress&)>& progress) {
        try {
            type21::march(
                scene_, make, [&](const CycleRecord& record) { observe(record, progress); }, options);
        } catch (const RunStopped& stop) {
            return end(state_of(stop.why), stop.what());
        } catch (const StateError& error) {
            throw CheckpointError(fmt::format("{}: is not one of this run: {}", files_.restart.string(), error.what()));
        } catch (const IoError&) {
            throw;
        } catch (const std::exception& error) {
            end(RunSummary::State::stopped, std::string("internal error: ") + error.what());
            throw;
        }
        end(RunSummary::State::completed, "");
    }

    static RunSummary::State state_of(RunStopped::Why why) {
        if (why == RunStopped::Why::diverged) return RunSummary::State::diverged;
        return why == RunStopped::Why::interrupted ? RunSummary::State::interrupted : RunSummary::State::stopped;
    }

    template <class Archive>
    void observers(Archive& archive) {
        archive(summary_, balance_, counter_, *recorder_, paraview_);
    }

    double seconds() const { return earlier_seconds_ + std::chrono::duration<double>(Clock::now() - start_).count(); }

    void observe(const CycleRecord& record, const std::function<void(const RunProgress&)>& progress) {
        if (first_) earlier_seconds_ = summary_.wall_seconds;
        first_ = false;
        summary_.observe(record);
        balance_.observe(record);
        counter_.observe(record);
        recorder_->observe(record);
        if (paraview_) paraview_->observe(record);
        if (!progress) return;
        const double end_time = scene_.host->engine.end_time;
        const double fraction = record.last ? 1.0 : (end_time > 0 ? std::min(record.time / end_time, 1.0) : 1.0);
        const double left = fraction > 0 ? seconds() * (1 - fraction) / fraction : 0;
        progress({fraction, record.cycle, record.time, left, record.last});
    }

    void between_cycles(const BetweenCycles& at) {
        const bool interrupted = files_.interrupted && files_.interrupted();
        const long every = files_.checkpoint_every;
        if (every > 0 && (interrupted || at.next_cycle % every == 0)) write_checkpoint(at);
        if (interrupted)
            throw RunStopped(RunStopped::Why::interrupted,
                             fmt::format("told to stop before cycle {} at t = {:.9g} {}", at.next_cycle, at.time,
                                         scene_.host->units.name(dim::time)));
    }

    void write_checkpoint(const BetweenCycles& at) {
        summary_.wall_seconds = seconds();
        StateWriter state;
        observers(state);
        at.save(state);
        recorder_->flush();
        Checkpoint checkpoint{run_id_, at.next_cycle, at.time, identity_, recorder_->written(), {}, state.bytes()};
        if (paraview_) checkpoint.paraview_times = paraview_->times();
        const std::string name =
            files_.keep_checkpoints ? fmt::format("checkpoint_{:08}.t21", at.next_cycle) : "checkpoint.t21";
        type21::write_checkpoint(folder_.path() / name, checkpoint);
        checkpoint_name_ = name;
    }

    void end(RunSummary::State state, const std::string& reason) {
        summary_.state = state;
        summary_.reason = reason;
        summary_.wall_seconds = seconds();
        summary_.balance = balance_.result();
        summary_.contact = counter_.result();
        recorder_->close(run_id_);
        write_summary();
        folder_.publish(files_.durable);
        if (!checkpoint_name_.empty()) summary_.checkpoint = (target_ / checkpoint_name_).string();
    }

    void write_summary() const { write_json(folder_.path() / "run.json", to_json(summary_, scene_, warnings_)); }

    const HostScene& scene_;
    fs::path target_;
    const RunFiles& files_;
    RunIdentity identity_;
    std::vector<std::string> warnings_;
    std::string run_id_;
    ResultFolder folder_;
    RunSummary summary_;
    std::optional<Recorder> recorder_;
    std::optional<ParaviewFiles> paraview_;
    BalanceObserver balance_{scene_};
    ContactCounter counter_{scene_};
    Clock::time_point start_ = Clock::now();
    double earlier_seconds_ = 0;  ///< of the runs that this one goes on with [s]
    bool first_ = true;
    std::string checkpoint_name_;
};

}  // namespace

RunSummary run_scene(const HostScene& scene, const Problems& problems, const fs::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options,
                     const MakeContact& make, const RunFiles& files) {
    RunIdentity identity;
    if (files.checkpoint_every > 0 || !files.restart.empty())
        identity = identity_of(files.inputs, scene.host->as_built.text(), files.with, files.paraview);
    std::optional<Checkpoint> restart;
    if (!files.restart.empty()) {
        restart = read_checkpoint(files.restart);
        require_same(files.restart, restart->identity, identity);
    }
    Run run(scene, problems, folder, files, restart, identity);
    MarchOptions march_options = options;
    StateReader state(restart ? std::string_view(restart->state) : std::string_view());
    if (restart) {
        try {
            run.restore(state);
        } catch (const StateError& error) {
            throw CheckpointError(fmt::format("{}: is not one of this run: {}", files.restart.string(), error.what()));
        }
        march_options.restart = &state;
    }
    return run.march(make, march_options, progress);
}

RunSummary run_scene(const HostScene& scene, const Problems& problems, const fs::path& folder,
                     const std::function<void(const RunProgress&)>& progress, const MarchOptions& options,
                     const std::string& with, RunFiles files) {
    files.with = with;
    return run_scene(scene, problems, folder, progress, options, contact_maker(with), files);
}

}  // namespace type21
