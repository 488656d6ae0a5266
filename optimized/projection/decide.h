/// @file The retained impact of a node among segments (Formulation 4, steps 1 to 5), always exact.
#pragma once

#include <array>
#include <vector>

#include "optimized/projection/exact.h"
#include "optimized/projection/filter.h"
#include "optimized/projection/sub_triangle_id.h"
#include "optimized/projection/tie.h"

namespace type21::optimized {

/// The arithmetic that settled a decision.
enum class Settled {
    filter,         ///< double with error bounds
    tie,            ///< the proof of a tie
    double_double,  ///< 100 bits with error bounds
    integer         ///< integers
};

/// The stage that a report names. Other implementations have intervals of doubles where this one has double-double.
inline Stage stage_of(Settled settled) {
    if (settled == Settled::integer) return Stage::exact;
    return settled == Settled::double_double ? Stage::interval : Stage::bounded;
}

/// The retained impact with its magnitudes.
struct Retained {
    SubTriangleId id = SubTriangleId::none();  ///< none: nothing takes the node
    ProjectionResult projection;
    Settled settled = Settled::filter;

    bool exists() const { return id.exists(); }
};

inline Decision decision_of(const Retained& r) {
    Decision d;
    d.kind = r.projection.kind;
    d.segment = r.id.segment();
    d.triangle = r.id.triangle();
    d.side = r.projection.side;
    d.b = r.projection.b;
    d.c = r.projection.c;
    d.stage = stage_of(r.settled);
    return d;
}

/// Collects the sub-triangles that may take one node, in any order, and names the retained one. A contender that is
/// proven to lose is dropped at once. At the end the retained one is left, with those that the filter cannot tell from
/// it.
class Decider {
  public:
    Decider(const V3& p, const ContactReach& reach, const ProjectionLimits& rules)
        : p_(p), reach_(reach), rules_(rules) {}

    /// Lets every sub-triangle of a segment compete.
    void add(int rank, const SegmentData& segment) {
        const LocalSegment local = local_segment(segment);
        for (int k = 1; k <= segment.sub_triangles(); ++k) {
            const SubTriangleId id(rank, k);
            if (leader_.id.exists() && follows(id, segment, local)) continue;
            const FilterResult result = filter(p_, segment, local, k, reach_, rules_);
            if (result.verdict == Verdict::taken && result.projection.kind == Kind::contact &&
                may_be_above_corner(result) && !rules_.lift_leaning)
                lead(id, segment);
            add(id, result);
        }
    }
    void add(SubTriangleId id, const FilterResult& result);

    /// @param segment_data  rank -> SegmentData
    template <class SegmentDataOf>
    Retained retained(const SegmentDataOf& segment_data) const {
        if (count_ == 0 && more_.empty()) return {};
        if (count_ == 1 && more_.empty() && !list_[0].unsure && best_.side != 0 && list_[0].id == best_id_)
            return {best_id_, best_, leader_.followed ? Settled::tie : Settled::filter};
        if (more_.empty()) {
            std::array<SegmentData, capacity> segments;
            for (size_t i = 0; i < count_; ++i)
                segments[i] = segment_data(list_[i].id.segment());
            return settle({list_.data(), count_}, {segments.data(), count_});
        }
        std::vector<Contender> contenders;
        std::vector<SegmentData> segments;
        each([&](const Contender& one) {
            contenders.push_back(one);
            segments.push_back(segment_data(one.id.segment()));
        });
        return settle(contenders, segments);
    }

  private:
    static constexpr size_t capacity = 16;

    template <class F>
    void each(const F& f) const {
        for (size_t i = 0; i < count_; ++i)
            f(list_[i]);
        for (const Contender& one : more_)
            f(one);
    }
    /// The lowest so far of the sub-triangles that take the node in contact from exactly above one corner V.
    ///
    /// Another sub-triangle T' with this corner and <n_V, N'> != 0 is tied with it or does not take the node (tie.h),
    /// so one with a higher number need not be projected. The condition on the slope is needed: where <n_V, N'> = 0 the
    /// node lies in the plane of T', nothing is lifted, and kappa of T' can be any number. Not used with D35, which
    /// lifts leaning normals.
    struct Leader {
        SubTriangleId id = SubTriangleId::none();
        bool followed = false;
        TieCorner corner;
    };
    static bool may_be_above_corner(const FilterResult& result) {
        return std::abs(result.projection.kappa - kappa_above_corner) <= result.projection.kappa_bound + 1e-15;
    }
    /// Does this sub-triangle come after the leader, and have the leader's corner with a slope that is proven not to be
    /// zero?
    bool follows(SubTriangleId id, const SegmentData& segment, const LocalSegment& local) {
        if (id < leader_.id) return false;
        const int corner = leader_.corner.index_in(id, segment);
        if (corner < 0 || !slope_is_not_zero(segment, local, id.triangle(), corner)) return false;
        leader_.followed = true;
        return true;
    }
    /// Makes it the leader if the node is exactly above one of its corners; the leader before it is dropped.
    void lead(SubTriangleId id, const SegmentData& segment);

    /// Proven: `one` is retained rather than `other`.
    bool beats(const Contender& one, const Contender& other) const;
    /// Where the filter does not suffice. In this order: proof of a tie, double-double, integers.
    Retained settle(std::span<const Contender> contenders, std::span<const SegmentData> segments) const;

    V3 p_;
    ContactReach reach_;
    ProjectionLimits rules_;
    size_t count_ = 0;
    std::array<Contender, capacity> list_;
    Leader leader_;
    std::vector<Contender> more_;  ///< those that do not fit into the list, which is rare
    ProjectionResult best_;        ///< of best_id_: the last that was the only one, or a lower one after it
    SubTriangleId best_id_ = SubTriangleId::none();
};

}  // namespace type21::optimized
