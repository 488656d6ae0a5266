/// @file A segment that a card gives by its nodes (/SURF/SEG, /SET with SEG).
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "reference/model/card_reader.h"
#include "reference/model/model.h"

namespace type21 {

/// Finds the shell that a segment lies on: it has all nodes of the segment; of several the thickest, then the stiffest.
class ShellFinder {
  public:
    explicit ShellFinder(const Model& model);

    /// Index of the shell, -1 if the segment lies on none.
    int find(const Segment& segment) const;

  private:
    bool holds(int shell, const Segment& segment) const;
    std::pair<double, double> rank(int index) const;

    const Model& model_;
    std::vector<size_t> begin_;  ///< of each node in at_node_, and the end of the last
    std::vector<int> at_node_;   ///< shells, node by node
};

/// The segment with these nodes; the fourth id is 0 or repeats the third for a triangle. None and an error when a node
/// does not exist, or when the nodes do not make a segment.
std::optional<Segment> read_segment(const Model& model, CardReader& reader, size_t line, std::array<Id, 4> ids,
                                    const ShellFinder& finder);

}  // namespace type21
