/// @file The observer that writes the histories during a run.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "reference/host/march.h"
#include "verification/results/record/effect_files.h"
#include "verification/results/record/interface_columns.h"
#include "verification/results/record/node_columns.h"
#include "verification/results/record/rigid_body_history.h"
#include "verification/results/tables/csv_writer.h"
#include "verification/results/tables/output_clock.h"

namespace type21 {

/// Writes interface_<id>.csv, nodes.csv (when /TH/NODE asks), rbody.csv and the files of effects into the folder of a
/// run. Rows reach the disk once a second, and all of them before a checkpoint and at the end.
class Recorder {
  public:
    /// Goes on with the files that are there already, those of a run that is gone on with.
    Recorder(const HostScene& scene, const std::filesystem::path& folder);

    /// @throws std::logic_error naming the column of a value that is not finite, IoError
    void observe(const CycleRecord& record);
    /// Everything to the disk. @throws IoError
    void flush();
    /// What is in the files so far; flush() first.
    std::vector<WrittenFile> written();
    /// Marks every file with the run and closes it. @throws IoError
    void close(std::string_view run_id);

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(clock_, body_history_, effects_);
    }

  private:
    struct InterfaceFile {
        CsvWriter file;
        std::vector<InterfaceColumn> columns;
    };

    using Clock = std::chrono::steady_clock;

    void write(const CycleRecord& record);
    void write_nodes(const CycleRecord& record, const std::string& time);
    std::vector<CsvWriter*> files();

    const Model& model_;
    OutputClock clock_;
    std::vector<InterfaceFile> interfaces_;
    NodeHistory node_history_;
    std::optional<CsvWriter> nodes_;
    RigidBodyHistory body_history_;
    std::optional<CsvWriter> bodies_;
    std::vector<EffectFiles> effects_;  ///< per interface
    Clock::time_point flushed_ = Clock::now();
};

}  // namespace type21
