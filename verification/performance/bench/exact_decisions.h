/// @file What the decisions of a cycle are in real arithmetic, by the reference.
#pragma once

#include <memory>
#include <vector>

#include "reference/contract/decision.h"
#include "verification/performance/bench/bench_scene.h"

namespace type21::bench {

/// Kind, segment, sub-triangle and side agree.
inline bool same(const Decision& one, const Decision& other) {
    if (one.kind != other.kind) return false;
    if (one.kind == Kind::none) return true;
    return one.segment == other.segment && one.triangle == other.triangle && one.side == other.side;
}
std::string in_words(const Decision& decision);

/// The exact decisions of a generated scene in any pose, as fast as the reference can.
class ExactDecisions {
  public:
    explicit ExactDecisions(const BenchScene& scene);
    ~ExactDecisions();
    /// One for each secondary node, or for the first of them.
    std::vector<Decision> at(const Motion& motion, size_t most = static_cast<size_t>(-1)) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace type21::bench
