/// @file The full search of the optimized contact, for many nodes and without memory.
#pragma once

#include <array>
#include <memory>
#include <span>

#include "optimized/kernel/node_data.h"
#include "reference/contract/decision.h"

namespace type21::bench {

class FullSearch {
  public:
    explicit FullSearch(const optimized::Laws& laws) : laws_(laws) {}
    /// Nodes next to each other. @param gap  of each [length]
    void at(std::span<const optimized::V3> y, std::span<const double> gap, std::span<Decision> found);
    /// How many decisions so far were settled by what, an entry for each of optimized::Settled.
    const std::array<long, 4>& settled() const { return settled_; }

  private:
    const optimized::Laws& laws_;
    std::unique_ptr<optimized::Search::Batch> batch_ = std::make_unique<optimized::Search::Batch>();
    std::array<long, 4> settled_{};
};

}  // namespace type21::bench
