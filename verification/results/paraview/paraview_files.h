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
    /// @param mark  xml_mark() of the run
    /// @throws IoError when the folder cannot be written
    ParaviewFiles(const HostScene& scene, const std::filesystem::path& folder, const std::string& mark);

    /// @throws IoError
    void observe(const CycleRecord& record);

    /// Copies the files of the times so far from the folder of a run that is gone on with, and puts the mark of this
    /// one into them.
    /// @param times  of the files
    /// @throws IoError
    void take_over(const std::filesystem::path& folder, const std::vector<double>& times);
    /// Of the files so far [time].
    const std::vector<double>& times() const { return times_; }
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(clock_, grids_);
    }

  private:
    struct Series {
        std::string name;  ///< "blank_1"
        PvdFile list;
        std::string file(size_t number) const;
    };

    void add(Series& series, const VtuGrid& grid);

    std::filesystem::path folder_;
    std::string mark_;
    OutputClock clock_;
    std::vector<double> times_;
    std::vector<ContactGrid> grids_;      ///< per interface
    std::vector<Series> blanks_, tools_;  ///< likewise
};

}  // namespace type21
