/// @file The full search in plain double: the same tree and the same formulas as the optimized search, without a single
/// error bound. What exactness costs is the difference, and what it is worth are the wrong answers.
#pragma once

#include "optimized/decide/segment.h"
#include "optimized/search/box_tree.h"
#include "optimized/search/prism.h"
#include "optimized/search/tool.h"
#include "reference/contact/decision.h"

namespace type21::bench {

class PlainSearch {
  public:
    PlainSearch(const optimized::Tool& tool, const optimized::Limits& limits);
    /// May be wrong within rounding.
    Decision at(const optimized::V3& y, const optimized::Window& window) const;

  private:
    const optimized::Tool& tool_;
    optimized::BoxTree tree_;
};

}  // namespace type21::bench
