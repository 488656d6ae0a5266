/// @file A query against its tool, as the implementations are asked.
#pragma once

#include <vector>

#include "reference/exact/staged_impact.h"
#include "verification/decisions/queries/query.h"

namespace type21 {

/// A segment of a tool with its normals.
reference::SegmentShape<double> shape_of(const DecisionTool& tool, int segment);

/// Segments that a node may touch: nearer than the farthest reach, with room for the rounding of this test.
std::vector<int> segments_near(const DecisionTool& tool, const DecisionQuery& query);

/// Owns what a DecisionInput refers to. The tool must outlive it.
class Question {
  public:
    Question(const DecisionTool& tool, const DecisionQuery& query)
        : Question(tool, query, segments_near(tool, query)) {}
    /// @param segments  candidates in any order; none that may touch the node is missing
    Question(const DecisionTool& tool, const DecisionQuery& query, std::vector<int> segments)
        : segments_(std::move(segments)),
          shape_of_([&tool](int segment) { return type21::shape_of(tool, segment); }),
          input_{query.point, segments_, shape_of_, {query.gap, query.depth, query.reach}, {}, false} {}
    Question(const Question&) = delete;
    Question& operator=(const Question&) = delete;

    const reference::DecisionInput& input() const { return input_; }
    const std::vector<int>& segments() const { return segments_; }

  private:
    std::vector<int> segments_;
    reference::ShapeOf shape_of_;
    reference::DecisionInput input_;
};

}  // namespace type21
