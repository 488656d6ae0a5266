/// @file The full search in plain double, without a bound: what exactness is measured against.
#pragma once

#include <memory>
#include <span>

#include "optimized/projection/segment.h"
#include "optimized/search/box_tree.h"
#include "optimized/search/capture_volume.h"
#include "optimized/search/gather.h"
#include "reference/contract/decision.h"

namespace type21::bench {

/// The same tree over the same boxes, the same rows of projections, and the order of the plain numbers as they come.
class PlainSearch {
  public:
    PlainSearch(const optimized::Tool& tool, const optimized::CaptureLimits& limits);
    /// Nodes next to each other. @param gap  of each [length]
    void at(std::span<const optimized::V3> y, std::span<const double> gap, double depth, std::span<Decision> found);

  private:
    struct Candidate {
        int node;
        optimized::SubTriangleId id;
    };
    void decide(std::span<const double> gap, double depth, std::span<Decision> found);

    const optimized::Tool& tool_;
    optimized::CaptureLimits limits_;
    optimized::BoxTree tree_;
    optimized::ProjectionBatch rows_;
    Candidate candidates_[optimized::ProjectionBatch::capacity];
    int count_ = 0;
    std::vector<double> kappa_;  ///< of what is found [-]
};

}  // namespace type21::bench
