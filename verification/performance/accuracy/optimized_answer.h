/// @file A query in the types of the optimized implementation, and its answer.
#pragma once

#include <vector>

#include "optimized/projection/decide.h"
#include "verification/performance/accuracy/method.h"

namespace type21::accuracy {

inline Answer answer_of(const optimized::Retained& retained, double gap) {
    Answer answer;
    answer.stage = static_cast<int>(retained.settled);
    if (!retained.exists()) return answer;
    const optimized::ProjectionResult& projection = retained.projection;
    answer.kind = projection.kind;
    answer.segment = retained.id.segment();
    answer.triangle = retained.id.triangle();
    answer.side = projection.side;
    if (projection.kind == Kind::contact)
        answer.penetration = gap - projection.lift * optimized::norm(projection.normal);
    return answer;
}

inline optimized::SegmentData segment_data(const DecisionTool& tool, int rank) {
    const auto& corner = tool.segment[static_cast<size_t>(rank)];
    optimized::SegmentData segment;
    segment.is_triangle = corner[2] == corner[3];
    for (size_t j = 0; j < 4; ++j) {
        segment.node[j] = optimized::from(tool.node[static_cast<size_t>(corner[j])]);
        segment.normal[j] = optimized::from(tool.normal[static_cast<size_t>(corner[j])]);
    }
    return segment;
}

/// Tool and query must outlive it. The limits of the query are the documented ones.
class OptimizedQuery {
  public:
    OptimizedQuery(const DecisionTool& tool, const ContactQuery& query) : tool_(tool), query_(query) {}

    optimized::V3 point() const { return optimized::from(query_.point); }
    optimized::ContactReach reach() const { return {query_.gap, query_.depth, query_.proximity_reach}; }

    /// The decision among some segments. @param segments  a range of ranks
    template <class Segments>
    Answer among(const Segments& segments) const {
        optimized::Decider decider(point(), reach(), {});
        for (const int rank : segments)
            decider.add(rank, segment_data(tool_, rank));
        return answer_of(decider.retained([&](int rank) { return segment_data(tool_, rank); }), query_.gap);
    }

  private:
    const DecisionTool& tool_;
    const ContactQuery& query_;
};

}  // namespace type21::accuracy
