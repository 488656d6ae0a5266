/// @file The retained impact of a node on the whole tool: certificates first, then the tree. Complete by construction.
#pragma once

#include <atomic>
#include <memory>
#include <span>
#include <vector>

#include "optimized/projection/a_priori_bounds.h"
#include "optimized/projection/decide.h"
#include "optimized/projection/project_double_double.h"
#include "optimized/projection/sub_triangle_id.h"
#include "optimized/search/box_tree.h"
#include "optimized/search/capture_volume.h"
#include "optimized/search/gather.h"
#include "optimized/search/memory.h"
#include "optimized/search/path_tally.h"
#include "optimized/search/prefetcher.h"
#include "optimized/search/search_kind.h"
#include "optimized/search/weight_lipschitz.h"

namespace type21::optimized {

/// How a decision was reached.
enum class Path {
    exclusive_region,  ///< the sub-triangle of the last cycle: no other can take the node there
    ranking_safe,      ///< that sub-triangle: the node is within the ranking safe radius
    edge_neighbour,    ///< that sub-triangle or its neighbour over one side: no other can take the node there
    separated,         ///< nothing: the node has moved less than its distance to all capture volumes
    searched           ///< by a full search
};

/// Decides when exclusive regions are worth their set-up. Those of one segment cost about as much as ten searches. They
/// do not pay where radii last long, or where there are many sub-triangles and each meets few nodes. The criterion is
/// the share of nodes that are searched for or compared with a neighbour, averaged over about eight cycles and all
/// nodes, so that no count of a single thread enters. Once they pay, they are used for the rest of the run.
class ExclusiveRegionPolicy {
  public:
    void add(const PathTally& cycle, long nodes, long sub_triangles) {
        const double now =
            static_cast<double>(cycle.searched + cycle.edge_neighbour) / static_cast<double>(std::max(nodes, 1L));
        // The first cycle searches for all nodes and does not count.
        mean_ = mean_ < 0 ? 0 : mean_ + (now - mean_) / 8;
        pays_ = pays_ || (mean_ > 0.06 && sub_triangles < 4 * nodes);
    }
    bool pays() const { return pays_; }
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(mean_, pays_);
    }

  private:
    double mean_ = -1;
    bool pays_ = false;
};

/// D34: the box in which a node must lie before a segment competes at all.
struct ReachBoxRule {
    bool on = false;
    Mat3 axes = Mat3::Identity();
    double proximity = 0;  ///< [length]
    bool holds(const V3& y, const SegmentData& segment, const ContactReach& reach) const;
};

/// The retained impacts on one tool, for one set of limits. Any number of threads may call it at once. T is the
/// sub-triangle that a node remembers. README.md of optimized/ has the proofs.
///
/// Exclusive region. m(T) is the least margin such that no point that T takes with all weights of step 2 >= m(T) is
/// taken by another sub-triangle. A node that projects on T with weights >= m(T), at a height between -DEPTH and the
/// largest reach, is taken by T or by nothing. So its projection on T decides. m(T) depends on the tool and its limits
/// only. It is found when first needed, and is the same number whichever thread finds it.
///
/// Edge neighbour zone. E is the sub-triangle over one side of T. m2(T) is a margin such that no point that T takes
/// with both weights of that side >= m2(T) is taken by any sub-triangle but T and E. There these two are compared. Near
/// a side the 1 % by which sub-triangles overlap keeps nodes out of every exclusive region.
///
/// Corners. T leads at its corner V under three conditions: it has the lowest number of all sub-triangles with V; the
/// slope <n_V, N'> of each of these is proven not to be zero; no point that T takes with a weight of V >= lead_weight
/// is taken by a sub-triangle without V. Exactly above V, those with V are tied or do not take the node (tie.h). So if
/// T takes it, T is retained.
///
/// Ranking safe radius. T is retained, and within this radius of the node every sub-triangle that takes the node has a
/// larger kappa than T. So T is retained there as long as T takes the node in contact. The radius does not depend on
/// gaps and outlives their change.
///
/// Contact safe radius. Within it T takes the node in contact and on the same side. Inside both radii the decision is
/// known without a projection. Inside the ranking safe radius only, one projection decides and gives a new contact safe
/// radius.
///
/// Separated. Nothing takes the node. The least clearance over all capture volumes is how far the node may move before
/// anything can.
class Search {
  public:
    /// @param kind  sorted: there is neither a tree nor a certificate; only what is said to take lists may be called
    Search(const Tool& tool, const CaptureLimits& limits, const ReachBoxRule& reach_box,
           SearchKind kind = SearchKind::tree);

    struct Found {
        Retained retained;
        Path path = Path::searched;
    };
    /// Nodes and their retained impacts, one row for each number. A batch is large so that the few nodes that need a
    /// certain treatment fill registers. It is worked on in parts that fit into the nearest cache.
    struct Batch {
        static constexpr int capacity = 256, part = ProjectionBatch::capacity;
        using Row = double[capacity + 8];  ///< rows that are a power of two apart would evict each other from the cache

        int count = 0;
        double depth = 0, proximity = 0;              ///< of all nodes [length]
        bool exclusive_regions = true;                ///< use them for all nodes; else for nodes with small radii only
        const Prefetcher* prefetcher = nullptr;       ///< what else the caller will read of the nodes
        const std::span<const int>* lists = nullptr;  ///< a list of candidates for each node, with the sorted search
        int first = 0;                                ///< rank of the first node, for the prefetcher and the lists
        Memory* memory = nullptr;  ///< of the nodes, one after the other; the sorted search needs none
        bool active[capacity];     ///< false: the node is left out

        alignas(64) Row y[3];  ///< in the tool frame [length]
        alignas(64) Row gap;   ///< that decides contact [length]

        SubTriangleId id[capacity];              ///< retained; without one, the rows below are not filled
        alignas(64) Row b, c, lift, n[3], x[3];  ///< as in ProjectionBatch
        Kind kind[capacity];
        signed char side[capacity];
        Settled settled[capacity];
        Path path[capacity];
        PathTally tally;  ///< of this batch

        Retained retained(int i) const;
        V3 point(int i) const { return {y[0][i], y[1][i], y[2][i]}; }
        std::span<const int> list(int i) const { return lists[first + i]; }

        // Working storage.
        struct NeighbourPair {
            int column;                ///< of the node
            SubTriangleId own, other;  ///< T and E
            int side;                  ///< of T, over which E lies: the side opposite to the corner with this number
            double kappa;              ///< of T
            double margin;             ///< of the weights along the side, over m2
        };
        struct Candidate {
            int column;  ///< of the node
            SubTriangleId id;
            double distance;  ///< of the node to the box of the segment, at least [length]
        };
        ProjectionBatch rows, others, partners;
        KappaRows kappa;
        NeighbourPair pairs[part], close[capacity];
        Candidate candidates[part];
        int pair_count = 0, close_count = 0, candidate_count = 0;
        static constexpr int most_close = 16;  ///< near-equal kappas; a node with more of them is decided alone
        Contender contenders[most_close];
        SegmentData segments[most_close];
    };
    /// @param reach  of this node; its gap and proximity at most CaptureLimits::outward, its depth at most inward
    Found find(const V3& y, const ContactReach& reach, const ProjectionLimits& rules, Memory& memory) const;
    /// Decides up to Batch::capacity nodes at once; the answers are those of find. Takes lists.
    void find(Batch& batch, const ProjectionLimits& rules) const {
        if (batch.lists != nullptr) return find_in_lists(batch, rules);
        decide(batch, rules, true);
    }
    /// The same, but b, c, lift, n, x are not filled for nodes within both radii. Gaps and depth must be no smaller
    /// than in the calls before.
    void select(Batch& batch, const ProjectionLimits& rules) const { decide(batch, rules, false); }
    struct NodeQuery {
        V3 y;
        ContactReach reach;
        Memory* memory = nullptr;  ///< nullptr: nothing is remembered
    };
    void find(const NodeQuery* query, int count, const ProjectionLimits& rules, Found* found) const;
    /// The same for all nodes of a batch, without memory: that of the batch is removed.
    void search(Batch& batch, const ProjectionLimits& rules) const;
    /// The same for one node.
    Retained search(const V3& y, const ContactReach& reach, const ProjectionLimits& rules,
                    bool reach_boxes = true) const;
    /// The same among the candidates of a list that covers the node.
    Retained search(std::span<const int> candidates, const V3& y, const ContactReach& reach,
                    const ProjectionLimits& rules, bool reach_boxes = true) const;
    /// Of the segments, for the lists of the sorted search; empty with the tree.
    const std::vector<Box>& boxes() const { return boxes_; }

    const CaptureLimits& limits() const { return limits_; }
    /// Number of sub-triangles; a triangle in a mixed tool counts four times.
    long slots() const { return static_cast<long>(margins_.size()); }
    size_t bytes() const;

  private:
    /// @param project_all  false: not for nodes within both radii
    void decide(Batch& batch, const ProjectionLimits& rules, bool project_all) const;
    /// What is known of one sub-triangle.
    struct Margins {
        std::atomic<float> exclusive;  ///< m(T), plus not_a_priori_bounded where projections have to be filtered
        std::atomic<float> neighbour;  ///< m2(T)
        float lipschitz;               ///< L of its weights; infinite: it is not a priori bounded
    };
    /// A tool of triangles only has one entry a segment.
    Margins& margins(SubTriangleId id) const { return margins_[static_cast<size_t>(id.code()) >> shift_]; }
    /// Decides by the exclusive region of the last sub-triangle: then `found` is filled, and true is returned.
    bool by_exclusive_region(const V3& y, const ContactReach& reach, const ProjectionLimits& rules, Memory& memory,
                             Found& found) const;
    float exclusive_margin(SubTriangleId id) const {
        const float margin = margins(id).exclusive.load(std::memory_order_acquire);
        return margin >= 0 ? margin : new_exclusive_margin(id);
    }
    float new_exclusive_margin(SubTriangleId id) const;
    float lipschitz(SubTriangleId id) const { return margins(id).lipschitz; }
    bool a_priori_bounded(SubTriangleId id) const { return std::isfinite(lipschitz(id)); }
    /// Is the last sub-triangle one whose projections have to be filtered?
    bool needs_filter(const Memory& memory) const { return memory.last.exists() && !a_priori_bounded(memory.last); }
    /// Distance within which the Lipschitz bound holds [length]
    static double lipschitz_reach_of(double bound) { return bound < no_lipschitz ? lipschitz_reach / bound : 0.0; }
    void find_exclusive_regions(int segment) const;
    /// E over the side opposite to corner `side` (0: A, 1: B, 2: C); none where there is none.
    SubTriangleId neighbour_over(SubTriangleId id, int side) const;
    int vertex_at(SubTriangleId id, int corner) const;
    /// Which corner of a sub-triangle a vertex is: 0: A, 1: B, 2: C, -1: none.
    int corner_at(SubTriangleId id, int vertex) const;
    bool is_lowest_at(SubTriangleId id, int corner, std::span<const int> segments) const;
    void search_tree(const V3& y, const ContactReach& reach, const ProjectionLimits& rules, Memory& memory,
                     Found& found) const;
    void keep_separated(const V3& y, Memory& memory) const;
    void keep_separated(const Batch& batch, int i, double radius) const;
    /// No larger radius is looked for. Near a side radii are small, and rivals far away need not be projected.
    double wanted_radius(const Memory& memory) const;
    /// For node i within the ranking safe radius, in this column of the rows.
    void keep_contact_safe(Batch& batch, int i, int column) const;
    /// Within this distance of the node the sub-triangle takes it in contact, on the same side; <= 0: not known.
    double contact_safe_radius(const ProjectionBatch& rows, int column, double depth, SubTriangleId id) const;
    void decide_alone(Batch& batch, int i, const ProjectionLimits& rules, bool remembers) const;
    /// Decides the active nodes, each among the candidates of its list.
    void find_in_lists(Batch& batch, const ProjectionLimits& rules) const;
    template <class EachSegment>
    Retained decide_among(const EachSegment& each, const V3& y, const ContactReach& reach,
                          const ProjectionLimits& rules, bool reach_boxes) const;
    BatchLimits batch_limits(double depth, double proximity) const;
    static void put_node(ProjectionBatch& rows, int column, const V3& y, double gap);
    /// A node, and whether the sub-triangle is a priori bounded.
    void put_query(ProjectionBatch& rows, int column, SubTriangleId id, const V3& y, double gap) const;
    void project_one(const V3& y, const ContactReach& reach, SubTriangleId id, ProjectionBatch& rows) const;
    void use_double_magnitudes(const V3& y, const ContactReach& reach, Retained& retained) const;
    /// Projects the nodes of the part that begins at `first` on their last sub-triangles.
    /// @param last  for each node of the part; none: it is not projected
    /// @param open  filled with the nodes that are left   @return how many are left
    int project_on_last(Batch& batch, int first, const SubTriangleId* last, const ProjectionLimits& rules, int* open,
                        bool project_all) const;
    /// All nodes of a part, each in the column of its number.
    void project_in_place(Batch& batch, int first, int count, const SubTriangleId* last) const;
    /// These nodes of a part, in columns one after the other.
    void project_gathered(Batch& batch, int first, const int* nodes, int count, const SubTriangleId* last) const;
    /// The least weight with which the projection on this sub-triangle decides.
    double deciding_weight(const Batch& batch, int i, SubTriangleId id) const;
    /// The impact of node i from this column.
    static void copy_result(Batch& batch, int i, const ProjectionBatch& rows, int column);
    /// The numbers of node i into this column of the rows, which hold the others of its projection.
    static void complete_rows(Batch& batch, int i, int column);
    /// Reads what nodes remember: separated ones are done, others have a sub-triangle to project on.
    /// @param last, open  likewise
    int recall(Batch& batch, int first, SubTriangleId* last, int* open, bool project_all) const;
    /// Is node i, in this column of the rows, exactly above a corner where its sub-triangle leads? Then it is decided.
    bool above_leading_corner(Batch& batch, int i, int column) const;
    /// Proven: the two of a pair, which both take the node, are tied.
    bool over_shared_side(const Batch& batch, const Batch::NeighbourPair& pair) const;
    /// Is node i, in this column of the rows, in an edge neighbour zone? Then it is added to the pairs.
    bool add_neighbour_pair(Batch& batch, int i, int column) const;
    /// Decides the pairs that kappa in double separates; the others become close pairs.
    void decide_neighbour_pairs(Batch& batch, const ProjectionLimits& rules) const;
    /// Double-double for close pairs.
    void decide_close_pairs(Batch& batch, const ProjectionLimits& rules) const;
    /// Does a sub-triangle take a node in contact? Known only within the a priori bounds, and away from every limit by
    /// more than the filter needs.
    enum class State {
        unknown,
        taken,
        distance_unsure,  ///< if it is near enough, which is not known
        too_far,          ///< it would if it were nearer
        rejected          ///< not here, at whatever distance
    };
    State state_of(const ProjectionBatch& rows, int column, double depth, SubTriangleId id) const;
    /// The same after put_query; mostly the marks of the rows suffice.
    State state_in_rows(const ProjectionBatch& rows, int column, double depth, SubTriangleId id) const;
    double clipped_distance(const ProjectionBatch& rows, int column, SubTriangleId id) const;
    /// The contribution of a rival to the ranking safe radius: within it the rival cannot take the node, or only with a
    /// larger kappa than `least`; <= 0: not known.
    /// @param bound, own_bound  L of the rival and of the retained one   @param least  kappa of the retained one
    double rival_radius(const ProjectionBatch& rows, int column, State state, double bound, double least,
                        double own_bound) const;
    /// Projects the nodes on all that may take them, side by side; nodes that are left are decided one by one.
    /// @param remembers  radii are needed
    void search_rows(Batch& batch, const int* open, int count, const ProjectionLimits& rules, bool remembers) const;
    /// Projects the candidates that were collected, and decides their nodes.
    void decide_candidates(Batch& batch, const ProjectionLimits& rules, bool remembers) const;
    bool decide_candidates(Batch& batch, int first, int last, const ProjectionLimits& rules, bool remembers) const;
    int least_kappa_double_double(Batch& batch, const int* columns, int count) const;
    /// Error bound of kappa of project_double_double on this sub-triangle, which is a priori bounded.
    double double_double_bound(SubTriangleId id) const;
    Retained decide_close_candidates(Batch& batch, int i, const int* columns, int count,
                                     const ProjectionLimits& rules) const;
    Found decide_pair_alone(const Batch& batch, const Batch::NeighbourPair& pair, const ProjectionLimits& rules) const;
    void take(Batch& batch, int i, SubTriangleId id, const ProjectionBatch& rows, int column) const;
    void put_found(Batch& batch, int i, const Found& found) const;
    double clearance(const V3& y) const;

    const Tool& tool_;
    CaptureLimits limits_;
    double growth_;  ///< max(outward, inward) [length]
    ReachBoxRule reach_box_;
    BoxTree tree_;            ///< empty with the sorted search
    std::vector<Box> boxes_;  ///< of the segments, for the sorted search
    double usual_clearance_;  ///< no larger clearance is looked for [length]
    double usual_radius_;     ///< no larger ranking safe radius is looked for [length]
    double small_radius_;     ///< nodes with smaller ones use exclusive regions and neighbour zones [length]
    int shift_ = 0;           ///< 2 where there are triangles only, with one entry a segment
    mutable std::vector<Margins> margins_;  ///< of sub-triangles; exclusive < 0: not known yet
    std::vector<std::uint8_t> kappa_bits_;  ///< @see LipschitzBounds
    /// Four a segment, relaxed but published by Margins::exclusive. Quad: over the side of sub-triangle k that is a
    /// side of the segment; triangle: over the sides opposite to A, B, C.
    mutable std::vector<std::atomic<SubTriangleId>> neighbour_;
    /// Four a segment, likewise: bit i where the sub-triangle leads at corner i.
    mutable std::vector<std::atomic<unsigned char>> leads_;
};

}  // namespace type21::optimized
