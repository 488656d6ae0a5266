/// @file Files of effects beside the histories: the skid line and the data for adaptive meshing.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "reference/host/march.h"
#include "verification/results/tables/csv_writer.h"

namespace type21 {

/// Files of one interface, each only when the scene asks for its effect:
///   skid_line_<id>.csv  time, node, largest skid ratio since the start [-], at the end of the run
///   adaptive_<id>.csv   one row when an element is first to be divided: time, element, radius, longest edge [length],
///                       cosine of the sharpest angle [-], penetration as a share of the gap [-]
class EffectFiles {
  public:
    EffectFiles(const HostScene& scene, int interface, const std::filesystem::path& folder);

    void observe(const CycleRecord& record);
    /// The files that are there.
    std::vector<CsvWriter*> files();
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(largest_skid_, divided_);
    }

  private:
    void write_skid_line(double time);
    void write_adaptive(const CycleRecord& record, const ContactStep& step);

    const Model& model_;
    int interface_;
    std::optional<CsvWriter> skid_;
    std::vector<double> largest_skid_;
    std::optional<CsvWriter> adaptive_;
    std::vector<char> divided_;
};

}  // namespace type21
