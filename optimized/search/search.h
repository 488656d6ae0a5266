/// @file The retained impact of a node on the whole tool: certificates first, then the tree. Complete by construction.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "optimized/projection/a_priori_bounds.h"
#include "optimized/projection/decide.h"
#include "optimized/projection/project_double_double.h"
#include "optimized/search/box_tree.h"
#include "optimized/search/capture_volume.h"
#include "optimized/search/gather.h"
#include "optimized/search/memory.h"
#include "optimized/search/path_tally.h"
#include "optimized/search/prefetcher.h"
#include "optimized/search/weight_lipschitz.h"

namespace type21::optimized {

/// How a node's decision came about.
enum class Path {
    certified,  ///< the sub-triangle of the last cycle, and no other can take the node there
    steady,     ///< that sub-triangle, and the node has moved less than what that is proven for
    paired,     ///< that sub-triangle or its neighbour over one side, and no other can take the node there
    quiet,      ///< nothing takes it: it has moved less than its clearance
    searched    ///< all that may take it were asked
};

/// Are nodes asked again so often that cores pay? Finding those of a segment costs about as much as ten searches: where
/// balls hold for long, or sub-triangles are many and few nodes pass each, searching is cheaper. ImpactEnclosure by the
/// mean of about the last eight cycles, of all nodes, so that no thread's pace has a part in it; once they pay they are
/// asked for ever after.
class ExclusiveRegionPolicy {
  public:
    void add(const PathTally& cycle, long nodes, long places) {
        const double now =
            static_cast<double>(cycle.searched + cycle.paired) / static_cast<double>(std::max(nodes, 1L));
        // The first cycle searches for all.
        mean_ = mean_ < 0 ? 0 : mean_ + (now - mean_) / 8;
        often_ = often_ || (mean_ > 0.06 && places < 4 * nodes);
    }
    bool often() const { return often_; }

  private:
    double mean_ = -1;
    bool often_ = false;
};

/// D34: the box in which a node must lie before a segment competes at all.
struct ReachBoxRule {
    bool on = false;
    Mat3 axes = Mat3::Identity();
    double proximity = 0;  ///< [length]
    bool holds(const V3& y, const SegmentData& segment, const ContactReach& window) const;
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
/// Corners. T leads at its corner V when it has the lowest number of all that have V, the slope <n_V, N'> of each of
/// these is proven not to be zero, and no point that T takes with a weight of V >= lead_weight is taken by any that has
/// not V. Exactly above V all that have it are tied (tie.h) or do not take the node: if T takes it, T is retained.
///
/// Steady. Where T is retained, a ball around the node in which every sub-triangle that takes it has a larger kappa
/// than T: as long as T takes it as contact, T is retained. A sub-triangle that takes the node now, or is only too far
/// from it, keeps its distance in kappa for (kappa' - kappa) / (2 (rate + rate')), the rates being those of rates.h;
/// one whose weights are below the limit by w cannot take it within w / rate', and one out of whose box, or heights,
/// the node is needs that way. Both rates hold for rate_reach / rate. Near a side m2(T) leaves E alone to be asked,
/// within (w - m2) / rate. Gaps are not part of this: a ball outlives their change.
///
/// Held. Where T, foreseen, takes the node with weights w of step 2 and v of step 3 at a height h over its plane, it
/// does so as contact, on the same side, for every node within r of it if
///   r <= (w + 0.01) / rate, r <= v / rate: no weight leaves its limits, no point is clipped,
///   r < |h|, for a height changes no faster than the node moves,
///   r <= reach / l - |h|, l a bound on sqrt(1 + |s|^2): with Q = P - h (N^ + s) of rates.h that times |h| is the
///   distance.
/// Rates prove besides that <n, N> > 0 and W > 0 there. Where the steady ball holds the node, too, no projection is
/// needed to know who is retained; where only that does, a projection tells, and r anew.
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
    /// Nodes and what is found of them, a row a number: many, so that what few of them ask for fills registers. They
    /// are worked on in parts, which the nearest cache holds.
    struct Batch {
        static constexpr int room = 256, part = ProjectionBatch::room;
        using Row = double[room + 8];  ///< of rows that are a power of two apart, few fit into a cache

        int count = 0;
        double depth = 0, proximity = 0;    ///< of all [length]
        bool cores = true;                  ///< ask them; else for nodes with small balls only
        const Prefetcher* ahead = nullptr;  ///< what else is asked of nodes
        int first = 0;                      ///< rank of its first node, for that
        Memory* memory = nullptr;           ///< of the nodes, one after the other
        bool asked[room];                   ///< else nothing is found

        alignas(64) Row y[3];  ///< in the tool frame [length]
        alignas(64) Row gap;   ///< that decides contact [length]

        int place[room];                         ///< retained, -1: none; then the rest is not filled
        alignas(64) Row b, c, lift, n[3], x[3];  ///< as in ProjectionBatch
        Kind kind[room];
        signed char side[room];
        Settled settled[room];
        Path path[room];
        PathTally tally;  ///< of this batch

        Retained retained(int i) const;
        V3 point(int i) const { return {y[0][i], y[1][i], y[2][i]}; }

        // Where it works.
        struct Pair {
            int column, own, other;  ///< node, and places
            int side;                ///< of own, to which the other lies over: that opposite to this weight
            double kappa;            ///< of own
            double room;             ///< of its weights along the side, over m2
        };
        struct Candidate {
            int column, place;  ///< node, and what may take it
            double apart;       ///< of the node from the box of its segment, at least [length]
        };
        ProjectionBatch rows, others, partners;
        FineKappaRows fine;
        Pair pairs[part], close[room];
        Candidate candidates[part];
        int pair_count = 0, close_count = 0, candidate_count = 0;
        static constexpr int most_close =
            16;  ///< that plain numbers do not tell apart; a node with more is asked alone
        Contender contenders[most_close];
        SegmentData segments[most_close];
    };
    /// @param window  of this node; its gap and proximity at most Limits::outward, its depth at most Limits::inward
    Found find(const V3& y, const ContactReach& window, const ProjectionLimits& rules, Memory& memory) const;
    /// Asks for up to Batch::room nodes at once; the answers are those of find.
    void find(Batch& batch, const ProjectionLimits& rules) const { decide(batch, rules, true); }
    /// The same, but without numbers for nodes that are held: of these b, c, lift, n, x are not filled. Gaps and depth
    /// must be no smaller than in the calls before.
    void select(Batch& batch, const ProjectionLimits& rules) const { decide(batch, rules, false); }
    struct Asked {
        V3 y;
        ContactReach window;
        Memory* memory = nullptr;  ///< nullptr: nothing is remembered
    };
    void find(const Asked* asked, int count, const ProjectionLimits& rules, Found* found) const;
    /// The same of all nodes of a batch, without what they remember: the memory is taken away from them.
    void search(Batch& batch, const ProjectionLimits& rules) const;
    /// The same of one node.
    Retained search(const V3& y, const ContactReach& window, const ProjectionLimits& rules,
                    bool reach_boxes = true) const;

    const Limits& limits() const { return limits_; }
    /// Sub-triangles, those of triangles in a mixed tool four times.
    long places() const { return static_cast<long>(margins_.size()); }
    size_t bytes() const;

  private:
    void decide(Batch& batch, const ProjectionLimits& rules, bool projects) const;
    /// What is known of one sub-triangle.
    struct Margins {
        std::atomic<float> alone;  ///< m(T), and beyond_foreseen more where a plain projection has to be filtered
        std::atomic<float> pair;   ///< m2(T)
        float rate;                ///< of its weights; infinite: it is not foreseen
    };
    /// Of a tool of triangles those of segments stand side by side.
    Margins& margins(int place) const { return margins_[static_cast<size_t>(place) >> shift_]; }
    /// Certified by T's core: found is filled, and true is returned.
    bool certified(const V3& y, const ContactReach& window, const ProjectionLimits& rules, Memory& memory,
                   Found& found) const;
    float core(int place) const {
        const float margin = margins(place).alone.load(std::memory_order_acquire);
        return margin >= 0 ? margin : new_core(place);
    }
    float new_core(int place) const;
    float rate(int place) const { return margins(place).rate; }
    bool a_priori_bounded(int place) const { return std::isfinite(rate(place)); }
    /// Known to be one whose projections have to be filtered.
    bool filtered(const Memory& memory) const { return memory.place >= 0 && !a_priori_bounded(memory.place); }
    /// How far the rate itself holds [length]
    static double reach_of(double rate) { return rate < no_rate ? rate_reach / rate : 0.0; }
    void find_cores(int segment) const;
    /// E over the side opposite to weight `side` (0: of A, 1: of B, 2: of C), -1: none.
    int partner(int place, int side) const;
    int vertex_at(int place, int i) const;
    /// Which corner of a sub-triangle a vertex is: 0: A, 1: B, 2: C, -1: none.
    int corner_at(int place, int vertex) const;
    bool first_at(int place, int i, std::span<const int> segments) const;
    void ask_all(const V3& y, const ContactReach& window, const ProjectionLimits& rules, Memory& memory,
                 Found& found) const;
    void keep_quiet(const V3& y, Memory& memory) const;
    void keep_quiet(const Batch& batch, int i, double radius) const;
    /// No larger one is looked for: near a side balls are small, and what is far from there need not be asked.
    double ball_wanted(const Memory& memory) const;
    /// Node i, steady in its place, in this column of the rows.
    void keep_held(Batch& batch, int i, int column) const;
    /// Within this of the node the place takes it as contact, on the same side; <= 0: not known.
    double holding_ball(const ProjectionBatch& rows, int column, double depth, int place) const;
    void ask_alone(Batch& batch, int i, const ProjectionLimits& rules, bool remembers) const;
    LandingLimits landing_limits(double depth, double proximity) const;
    static void stand_at(ProjectionBatch& rows, int column, const V3& y, double gap);
    /// Where a node is, and whether the place is foreseen.
    void ask_at(ProjectionBatch& rows, int column, int place, const V3& y, double gap) const;
    void land_one(const V3& y, const ContactReach& window, int place, ProjectionBatch& rows) const;
    void use_plain_magnitudes(const V3& y, const ContactReach& window, Retained& retained) const;
    /// Nodes of the part that begins at `first` where they were last. @param last  place for each node of the part; -1:
    /// it does not look   @param open  filled with those that are left   @return how many are left
    int look_again(Batch& batch, int first, const int* last, const ProjectionLimits& rules, int* open,
                   bool projects) const;
    /// All of a part, each in the column of its number.
    void land_in_place(Batch& batch, int first, int count, const int* last) const;
    /// These of a part, one column after the other.
    void land_apart(Batch& batch, int first, const int* nodes, int count, const int* last) const;
    /// With what weights a place decides alone.
    double least_weight(const Batch& batch, int i, int place) const;
    /// The impact of node i from this column.
    static void fill(Batch& batch, int i, const ProjectionBatch& rows, int column);
    /// The numbers of node i into this column of the rows, which hold the others of its projection.
    static void complete(Batch& batch, int i, int column);
    /// What nodes remember: those that are quiet are, and others have a place to look. @param last, open  likewise
    int recall(Batch& batch, int first, int* last, int* open, bool projects) const;
    /// Does node i, in this column of the rows, lie exactly above a corner where its place leads? Then it is decided.
    bool over_corner(Batch& batch, int i, int column) const;
    /// Proven: the two of a pair that both take the node are tied.
    bool over_shared_side(const Batch& batch, const Batch::Pair& pair) const;
    /// Is node i, in this column of the rows, one of a pair? Then it is put among them.
    bool pair_up(Batch& batch, int i, int column) const;
    /// Decides the pairs that kappa in double tells apart; the others are put among the close ones.
    void decide_pairs(Batch& batch, const ProjectionLimits& rules) const;
    /// 100 bits for them.
    void decide_close(Batch& batch, const ProjectionLimits& rules) const;
    /// Does a sub-triangle take a node as contact? Known only where the bounds are foreseen, and away from every limit
    /// by more than the filter needs.
    enum class Standing {
        unknown,
        taken,
        lands,    ///< if it is near enough, which is not known
        beyond,   ///< it would if it were nearer
        rejected  ///< not here, however near
    };
    Standing standing(const ProjectionBatch& rows, int column, double depth, int place) const;
    /// The same for a place that ask_at put there, which mostly the rows tell.
    Standing standing_in_rows(const ProjectionBatch& rows, int column, double depth, int place) const;
    double clipped_distance(const ProjectionBatch& rows, int column, int place) const;
    /// Within this of the node the sub-triangle, whose rate is given, cannot take it, or only with a larger kappa than
    /// `least`, whose rate is `least_rate`; <= 0: not known.
    double ball(const ProjectionBatch& rows, int column, Standing standing, double rate, double least,
                double least_rate) const;
    /// Asks all that may take the nodes side by side; those that are left are asked one after the other.
    /// @param remembers  balls are wanted
    void ask_rows(Batch& batch, const int* open, int count, const ProjectionLimits& rules, bool remembers) const;
    /// Lands what candidates there are, and decides the nodes whose candidates are there.
    void decide_candidates(Batch& batch, const ProjectionLimits& rules, bool remembers) const;
    bool decide_candidates(Batch& batch, int first, int last, const ProjectionLimits& rules, bool remembers) const;
    int least_fine_kappa(Batch& batch, const int* columns, int count) const;
    /// What kappa of project_double_double may be off by on this place, which is foreseen.
    double fine_bound(int place) const;
    Retained tell_apart(Batch& batch, int i, const int* columns, int count, const ProjectionLimits& rules) const;
    Found decide_pair(const Batch& batch, const Batch::Pair& pair, const ProjectionLimits& rules) const;
    void take(Batch& batch, int i, int place, const ProjectionBatch& rows, int column) const;
    void put(Batch& batch, int i, const Found& found) const;
    double clearance(const V3& y) const;

    const Tool& tool_;
    Limits limits_;
    double growth_;  ///< max(outward, inward) [length]
    ReachBoxRule reach_box_;
    BoxTree tree_;
    double usual_clearance_;                ///< clearances are not looked for beyond it [length]
    double usual_ball_;                     ///< balls of steady nodes likewise [length]
    double small_ball_;                     ///< nodes with smaller ones ask for cores and pairs [length]
    int shift_ = 0;                         ///< 2 where there are triangles only, and one place for a segment
    mutable std::vector<Margins> margins_;  ///< of places; alone < 0: not known yet
    std::vector<std::uint8_t> kappa_bits_;  ///< @see LipschitzBounds
    /// Four for a segment, relaxed but published by Margins::alone. Quad: over the side of sub-triangle k that is a
    /// side of the segment; triangle: over the sides opposite to A, B, C.
    mutable std::vector<std::atomic<int>> over_;
    /// Four for a segment, likewise: bit i where the sub-triangle leads at the corner of weight i.
    mutable std::vector<std::atomic<unsigned char>> leads_;
};

}  // namespace type21::optimized
