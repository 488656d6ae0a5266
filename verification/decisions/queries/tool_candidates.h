/// @file The segments of a small tool that may take a node, as the reference wants them.
#pragma once

#include <utility>
#include <vector>

#include "reference/exact/staged_impact.h"
#include "verification/decisions/queries/decision_block.h"

namespace type21 {

/// A segment of a tool with its normals.
/// @param segment  index into DecisionTool::segment
reference::SegmentShape<double> shape_of(const DecisionTool& tool, int segment);

/// Segments that the node of a query may touch: nearer than the farthest reach, with an allowance for the rounding of
/// this test. Ascending.
std::vector<int> segments_near(const DecisionTool& tool, const ContactQuery& query);

/// Owns what reference::CandidateSegments refers to. The tool must outlive it.
class ToolCandidates {
  public:
    ToolCandidates(const DecisionTool& tool, const ContactQuery& query)
        : ToolCandidates(tool, segments_near(tool, query)) {}
    /// @param ranks  candidates in any order; no segment that may take the node is missing
    ToolCandidates(const DecisionTool& tool, std::vector<int> ranks)
        : ranks_(std::move(ranks)), shape_of_([&tool](int segment) { return type21::shape_of(tool, segment); }) {}
    ToolCandidates(const ToolCandidates&) = delete;
    ToolCandidates& operator=(const ToolCandidates&) = delete;

    /// Valid as long as this object.
    reference::CandidateSegments segments() const { return {ranks_, shape_of_}; }
    const std::vector<int>& ranks() const { return ranks_; }

  private:
    std::vector<int> ranks_;
    reference::ShapeOf shape_of_;
};

}  // namespace type21
