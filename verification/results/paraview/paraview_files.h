/// @file The observer that writes a run for ParaView while it goes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "verification/results/paraview/contact_grid.h"
#include "verification/results/paraview/pvd_file.h"
#include "verification/results/tables/output_clock.h"

namespace type21 {

/// Writes into <folder>/paraview, for each interface, the time series blank_<id>.pvd and tool_<id>.pvd and one .vtu for
/// each of their times, which are those of the histories (/TFILE). Each time is whole on the disk before the next
/// begins, and nothing of it is kept in memory.
class ParaviewFiles {
  public:
    /// @throws std::runtime_error when the folder cannot be written
    ParaviewFiles(const HostScene& scene, const std::filesystem::path& folder);

    void observe(const CycleRecord& record);

  private:
    struct Series {
        std::string name;  ///< "blank_1"
        PvdFile list;
        void add(const std::filesystem::path& folder, long number, const VtuGrid& grid);
    };

    std::filesystem::path folder_;
    OutputClock clock_;
    long written_ = 0;
    std::vector<ContactGrid> grids_;      ///< per interface
    std::vector<Series> blanks_, tools_;  ///< likewise
};

/// The files of an earlier run in its folder, to be removed before another one.
std::vector<std::filesystem::path> old_paraview_files(const std::filesystem::path& folder);

}  // namespace type21
