/// @file The retained impact of a node on the whole tool: certificates first, then the tree. Complete by construction.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "optimized/decide/decide.h"
#include "optimized/decide/fine_landing.h"
#include "optimized/search/box_tree.h"
#include "optimized/search/prism.h"
#include "optimized/search/tool.h"

namespace type21::optimized {

/// What a node remembers to be quick. It never changes an answer: it only says where to look first, and everything that
/// is concluded from it is proven for the place where the node is now.
struct Memory {
    int place = -1;   ///< sub-triangle retained last, as place_of gives it
    float quiet = 0;  ///< no sub-triangle takes the node within this of `from` [length]; 0: not known
    V3 from;          ///< [length]
};

/// Sub-triangle k of a segment as one number, and back.
inline int place_of(int segment, int piece) {
    return 4 * segment + piece - 1;
}
inline int segment_of(int place) {
    return place >> 2;
}
inline int piece_of(int place) {
    return (place & 3) + 1;
}

/// How a node's decision came about.
enum class Path {
    certified,  ///< the sub-triangle of the last cycle, and no other can take the node there
    paired,     ///< that sub-triangle or its neighbour over one side, and no other can take the node there
    quiet,      ///< nothing takes it: it has moved less than its clearance
    searched    ///< all that may take it were asked
};

/// How many decisions came about how.
struct PathTally {
    long certified = 0, paired = 0, quiet = 0, searched = 0, fine = 0, whole = 0;
    void add(const PathTally& other);
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
/// Pairs. Let E be the sub-triangle over one side of T, and m2(T) such that no point that T takes with both weights of
/// that side >= m2(T) is taken by any sub-triangle but T and E. There the two decide between them: near a side, where
/// the 1 % by which sub-triangles overlap keeps nodes out of every core.
///
/// Corners. T leads at its corner V when it has the lowest number of all that have V, and no point that T takes with a
/// weight of V >= lead_weight is taken by any that has not. Exactly above V all that have it are tied (tie.h): if T
/// takes the node, it is retained.
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
    /// Nodes and what is found of them, a row a number.
    struct Batch {
        static constexpr int room = 256;
        using Row = double[room];

        int count = 0;
        double depth = 0, proximity = 0;  ///< of all [length]
        Memory* memory[room];             ///< nullptr: not asked
        alignas(64) Row y[3];             ///< in the tool frame [length]
        alignas(64) Row gap;              ///< that decides contact [length]

        int place[room];                         ///< retained, -1: none; then the rest is not filled
        alignas(64) Row b, c, lift, n[3], x[3];  ///< as in LandingRows
        Kind kind[room];
        signed char side[room];
        Settled settled[room];
        Path path[room];
        PathTally tally;  ///< of this batch

        Retained retained(int i) const;

        // Where it works: a part of the nodes, and pairs of all of them.
        struct Pair {
            int column, own, other;  ///< node, and places
            int side;                ///< of own, to which the other lies over: that opposite to this weight
            double kappa;            ///< of own
        };
        LandingRows rows, partners;
        FineKappaRows fine;
        Pair pairs[LandingRows::room], close[room];
        int pair_count = 0, close_count = 0;
    };
    /// @param window  of this node; its gap and proximity at most Limits::outward, its depth at most Limits::inward
    Found find(const V3& y, const Window& window, const Rules& rules, Memory& memory) const;
    /// Asks for up to Batch::room nodes at once; the answers are those of find.
    void find(Batch& batch, const Rules& rules) const;
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
    /// What is known of one sub-triangle.
    struct Margins {
        std::atomic<float> alone;  ///< m(T), and beyond_foreseen more where a plain projection has to be filtered
        std::atomic<float> pair;   ///< m2(T)
    };
    /// Certified by T's core: found is filled, and true is returned.
    bool certified(const V3& y, const Window& window, const Rules& rules, Memory& memory, Found& found) const;
    float core(int place) const {
        const float margin = margins_[static_cast<size_t>(place)].alone.load(std::memory_order_acquire);
        return margin >= 0 ? margin : new_core(place);
    }
    float new_core(int place) const;
    void find_cores(int segment) const;
    /// E over the side opposite to weight `side` (0: of A, 1: of B, 2: of C), -1: none.
    int partner(int place, int side) const;
    int vertex_at(int place, int i) const;
    bool has_corner(int place, int vertex) const;
    bool first_at(int place, int i, std::span<const int> segments) const;
    void ask_all(const V3& y, const Window& window, const Rules& rules, Memory& memory, Found& found) const;
    LandingLimits landing_limits(double depth, double proximity) const;
    void fill(LandingRows& rows, int column, int place) const;
    void fill(LandingRows& rows, int column, int place, const Batch& batch, int i) const;
    /// Nodes first to first + count of the batch. @param open  filled with those that are left
    /// @return how many are left
    int find_part(Batch& batch, int first, int count, const Rules& rules, int* open) const;
    /// Does the node in column i of the rows lie exactly above a corner where its place leads? Then it is decided.
    bool over_corner(Batch& batch, int first, int i) const;
    /// Proven: the two of a pair that both take the node are tied.
    bool over_shared_side(const Batch& batch, const Batch::Pair& pair) const;
    /// Is the node in column i of the rows one of a pair? Then it is put among them.
    bool pair_up(Batch& batch, int first, int i) const;
    /// Decides the pairs that kappa in double tells apart; the others are put among the close ones.
    void decide_pairs(Batch& batch, const Rules& rules) const;
    /// 100 bits for them.
    void decide_close(Batch& batch, const Rules& rules) const;
    enum class Standing { unknown, taken, rejected };
    Standing standing(const LandingRows& rows, int column, double depth, int place) const;
    Found decide_pair(const Batch& batch, const Batch::Pair& pair, const Rules& rules) const;
    void take(Batch& batch, int i, int place, const LandingRows& rows, int column) const;
    void put(Batch& batch, int i, const Found& found) const;
    double clearance(const V3& y) const;

    const Tool& tool_;
    Limits limits_;
    ReachBoxRule reach_box_;
    BoxTree tree_;
    double usual_clearance_;                ///< clearances are not looked for beyond it [length]
    mutable std::vector<Margins> margins_;  ///< four for a segment; alone < 0: not known yet
    /// Four for a segment, relaxed but published by Margins::alone. Quad: over the side of sub-triangle k that is a
    /// side of the segment; triangle: over the sides opposite to A, B, C.
    mutable std::vector<std::atomic<int>> over_;
    /// Four for a segment, likewise: bit i where the sub-triangle leads at the corner of weight i.
    mutable std::vector<std::atomic<unsigned char>> leads_;
};

}  // namespace type21::optimized
