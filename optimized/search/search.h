/// @file The retained impact of a node on the whole tool: certificates first, then the tree. Complete by construction.
#pragma once

#include <atomic>
#include <memory>
#include <vector>

#include "optimized/decide/decide.h"
#include "optimized/decide/plain_landing.h"
#include "optimized/search/box_tree.h"
#include "optimized/search/prism.h"
#include "optimized/search/tool.h"

namespace type21::optimized {

/// What a node remembers to be quick. It never changes an answer: it only says where to look first, and everything that
/// is concluded from it is proven for the place where the node is now.
struct Memory {
    int segment = -1;  ///< retained last
    int piece = 0;
    float quiet = 0;  ///< no sub-triangle takes the node within this of `from` [length]; 0: not known
    V3 from;          ///< [length]
};

/// How a node's decision came about.
enum class Path {
    certified,  ///< the sub-triangle of the last cycle, and no other can take the node there
    quiet,      ///< nothing takes it: it has moved less than its clearance
    searched    ///< all that may take it were asked
};

/// D34: the box in which a node must lie before a segment competes at all.
struct ReachBoxRule {
    bool on = false;
    Mat3 axes = Mat3::Identity();
    double proximity = 0;  ///< [length]
    bool holds(const V3& y, const SegmentData& segment, const Window& window) const;
};

/// Answers for one tool and one set of limits. Any number of threads may ask at once.
///
/// Cores. Let m(T) be the smallest weight such that no point that T takes with all weights of step 2 >= m(T) is taken
/// by any other sub-triangle (margin_apart over all T' whose boxes meet that of T's segment; boxes that do not meet are
/// apart). A node that projects on T with weights >= m(T), at a height between -DEPTH and the largest reach, is taken
/// by T or by nothing: its projection on T alone decides. m depends on the tool and its limits only; it is found when
/// first needed, and is the same number whoever finds it.
///
/// Quiet. Where nothing takes a node, the smallest clearance over all prisms is how far it may move before anything
/// can.
class Search {
  public:
    Search(const Tool& tool, const Limits& limits, const ReachBoxRule& reach_box);

    struct Found {
        Retained retained;
        Path path = Path::searched;
    };
    /// @param window  of this node; its gap and proximity at most Limits::outward, its depth at most Limits::inward
    Found find(const V3& y, const Window& window, const Rules& rules, Memory& memory) const;
    /// Asks for up to `lanes` nodes at once; the answers are those of find.
    struct Asked {
        V3 y;
        Window window;
        Memory* memory = nullptr;
    };
    void find(const Asked* asked, int count, const Rules& rules, Found* found) const;
    /// The same without memory and certificates.
    Retained search(const V3& y, const Window& window, const Rules& rules, bool reach_boxes = true) const;

    const Limits& limits() const { return limits_; }
    size_t bytes() const;

  private:
    /// Certified by T's core: found is filled, and true is returned.
    bool certified(const V3& y, const Window& window, const Rules& rules, Memory& memory, Found& found) const;
    /// The answer for a node in the core of the sub-triangle of its memory, where the bounds of a plain projection are
    /// foreseen. @param lane  of rows.out
    bool certified_plainly(const Asked& asked, const PlainRows& rows, int lane, float core, Found& found) const;
    /// m(T), and beyond_foreseen more where a plain projection has to be filtered.
    float core(int segment, int piece) const;
    void find_cores(int segment) const;
    void ask_all(const V3& y, const Window& window, const Rules& rules, Memory& memory, Found& found) const;
    void fill_lane(const Asked& asked, int lane, PlainRows& rows) const;
    double clearance(const V3& y) const;

    const Tool& tool_;
    Limits limits_;
    ReachBoxRule reach_box_;
    BoxTree tree_;
    double usual_clearance_;                        ///< clearances are not looked for beyond it [length]
    mutable std::vector<std::atomic<float>> core_;  ///< four for a segment; negative: not known yet
};

}  // namespace type21::optimized
