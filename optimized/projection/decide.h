/// @file The single retained impact of a node among segments (formulation section 4), exact always.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "optimized/projection/exact.h"
#include "optimized/projection/filter.h"
#include "optimized/projection/tie.h"

namespace type21::optimized {

/// What settled a decision.
enum class Settled {
    filter,  ///< double with error bounds
    tie,     ///< the proof of a tie
    fine,    ///< 100 bits with error bounds
    whole    ///< whole numbers
};

/// The stage that a report names. 100 bits with a bound are what intervals of doubles are elsewhere.
inline Stage stage_of(Settled settled) {
    if (settled == Settled::whole) return Stage::exact;
    return settled == Settled::fine ? Stage::interval : Stage::bounded;
}

/// The retained impact with its magnitudes.
struct Retained {
    int segment = -1;  ///< -1: nothing takes the node
    int piece = 0;     ///< sub-triangle k
    ProjectionResult landing;
    Settled settled = Settled::filter;
};

/// Collects what may take one node, in any order, and names the one retained. Contenders that are proven to lose are
/// dropped on the way, so that what is left at the end are the retained one and those that only whole numbers can tell
/// from it.
class Decider {
  public:
    Decider(const V3& p, const ContactReach& window, const ProjectionLimits& rules)
        : p_(p), window_(window), rules_(rules) {}

    /// Lets every sub-triangle of a segment compete.
    void add(int rank, const SegmentData& segment) {
        const LocalSegment local = local_segment(segment);
        for (int k = 1; k <= segment.pieces(); ++k) {
            if (leader_.known && follows(rank, segment, local, k)) continue;
            const FilterResult result = filter(p_, segment, local, k, window_, rules_);
            if (result.verdict == Verdict::taken && result.landing.kind == Kind::contact && alone_on_corner(result) &&
                !rules_.lift_leaning)
                lead(rank, segment, k);
            add(rank, k, result);
        }
    }
    void add(int rank, int piece, const FilterResult& result);

    /// @param segment_of  rank -> SegmentData
    template <class SegmentOf>
    Retained retained(const SegmentOf& segment_of) const {
        if (count_ == 0 && more_.empty()) return {};
        if (count_ == 1 && more_.empty() && !list_[0].unsure && best_.side != 0 &&
            place(list_[0].segment, list_[0].piece) == best_place_) {
            return {list_[0].segment, list_[0].piece, best_, leader_.followed ? Settled::tie : Settled::filter};
        }
        if (more_.empty()) {
            std::array<SegmentData, room> segments;
            for (size_t i = 0; i < count_; ++i)
                segments[i] = segment_of(list_[i].segment);
            return settle({list_.data(), count_}, {segments.data(), count_});
        }
        std::vector<Contender> contenders;
        std::vector<SegmentData> segments;
        each([&](const Contender& one) {
            contenders.push_back(one);
            segments.push_back(segment_of(one.segment));
        });
        return settle(contenders, segments);
    }

  private:
    static constexpr size_t room = 16;

    template <class F>
    void each(const F& f) const {
        for (size_t i = 0; i < count_; ++i)
            f(list_[i]);
        for (const Contender& one : more_)
            f(one);
    }
    /// The lowest so far of those that take the node as contact from exactly above one corner V. Another sub-triangle
    /// with this corner and <n_V, N'> not zero is tied with it (tie.h) or does not take the node: where <n_V, N'> < 0
    /// it rejects the node, which is off its plane or is V. So those with a higher number need not be asked. Where
    /// <n_V, N'> = 0 the node may lie in the plane of N' and away from V: nothing is lifted, and kappa is any number.
    /// Not with D35, where one that leans takes the node elsewhere.
    struct Leader {
        bool known = false, followed = false;
        int segment = -1, piece = 0;
        TieCorner corner;
    };
    static std::int64_t place(int segment, int piece) { return std::int64_t{segment} * 4 + piece; }
    static bool alone_on_corner(const FilterResult& result) {
        return std::abs(result.landing.kappa - kappa_on_corner) <= result.landing.kappa_bound + 1e-15;
    }
    /// Has it a higher number than the leader and the leader's corner, where its slope is proven not to be zero?
    bool follows(int rank, const SegmentData& segment, const LocalSegment& local, int piece) {
        const bool lower = rank < leader_.segment || (rank == leader_.segment && piece < leader_.piece);
        if (lower) return false;
        const int corner = leader_.corner.index_in(rank, segment, piece);
        if (corner < 0 || !slope_is_not_zero(segment, local, piece, corner)) return false;
        leader_.followed = true;
        return true;
    }
    /// Makes it the leader if the node is exactly above one of its corners; the one before it is let go.
    void lead(int rank, const SegmentData& segment, int piece);

    /// Proven: one is retained rather than other.
    bool beats(const Contender& one, const Contender& other) const;
    /// More than the filter is needed: a proven tie, 100 bits, whole numbers, in this order.
    Retained settle(std::span<const Contender> contenders, std::span<const SegmentData> segments) const;

    V3 p_;
    ContactReach window_;
    ProjectionLimits rules_;
    size_t count_ = 0;
    std::array<Contender, room> list_;
    Leader leader_;
    std::vector<Contender> more_;  ///< beyond the room: so many are rare
    ProjectionResult best_;        ///< of the one at best_place_: the last that was alone, or a lower one after it
    std::int64_t best_place_ = -1;
};

}  // namespace type21::optimized
