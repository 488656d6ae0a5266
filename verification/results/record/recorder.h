/// @file The observer that writes the histories during a run.
#pragma once

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

/// Writes interface_<id>.csv, nodes.csv (when /TH/NODE asks) and rbody.csv into a prepared folder. Every record is
/// flushed, so a run that stops keeps what it wrote.
class Recorder {
  public:
    Recorder(const HostScene& scene, const std::filesystem::path& folder);

    void observe(const CycleRecord& record);

  private:
    struct InterfaceFile {
        CsvWriter file;
        std::vector<InterfaceColumn> columns;
    };

    void write(const CycleRecord& record);
    void write_nodes(const CycleRecord& record);

    const Model& model_;
    OutputClock clock_;
    std::vector<InterfaceFile> interfaces_;
    NodeHistory node_history_;
    std::optional<CsvWriter> nodes_;
    RigidBodyHistory body_history_;
    std::optional<CsvWriter> bodies_;
    std::vector<EffectFiles> effects_;  ///< per interface
};

}  // namespace type21
