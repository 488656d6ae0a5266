/// @file A tree of boxes: which hold a point, meet a box, or are near.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "optimized/search/box.h"
#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// A tree with one box a leaf. A branch holds eight boxes of what is below it, rounded outward to float, and tests them
/// at once. All but the last branches above the leaves are full. Branches lie in depth-first order, so near ones share
/// memory pages.
class BoxTree {
  public:
    static constexpr int wide = 8;

    BoxTree() = default;
    explicit BoxTree(const std::vector<Box>& boxes, SimdWidth machine = this_machine());

    /// Calls found(rank) for each box that holds y (and for some that nearly do).
    template <class Found>
    void at(const V3& y, const Found& found) const {
        within(y, 0, [&](int rank, double) { found(rank); });
    }
    /// Calls found(rank) for each box that meets this one (and for some that nearly do).
    template <class Found>
    void meeting(const Box& box, const Found& found) const {
        visit(query_of(box, 0), [&](int rank, double) { found(rank); });
    }
    /// Calls found(rank, lower bound on its distance from y) for boxes that are at most this far.
    template <class Found>
    void within(const V3& y, double distance, const Found& found) const {
        visit(query_of({y, y}, distance), found);
    }
    /// The same for boxes nearer than limit(), which may shrink, nearer ones first.
    template <class Limit, class Found>
    void near(const V3& y, const Limit& limit, const Found& found) const;

    size_t bytes() const { return branch_.capacity() * sizeof(Branch); }

  private:
    struct alignas(32) Branch {
        float low[3][wide], high[3][wide];
        std::int32_t below[wide];  ///< a branch, or ~rank of a box, or nothing
    };
    /// A box rounded outward, and the square of the distance within which boxes are looked for, rounded up.
    struct Query {
        float low[3], high[3];
        float most;
    };
    /// A bit for each of the eight boxes that is not farther. @param distance2  filled with squares of lower bounds
    using Test = unsigned (*)(const Branch&, const Query&, float* distance2);

    static constexpr std::int32_t nothing = std::numeric_limits<std::int32_t>::min();
    /// At most seven wait at each level; a level divides by four or more.
    static constexpr int deepest = 7 * 16;

    static Query query_of(const Box& box, double distance);
    static void limit(Query& query, double distance);
    /// The relative error of a square of floats is 1e-6; of a tiny one the error is below this number.
    static constexpr float tiny = 1e-36F;
    static double distance(float square) {
        constexpr double farthest = 1.8e19;  // beyond that a square is infinite
        return square > tiny ? std::min(std::sqrt(double(square) - double(tiny)) * (1 - 1e-6), farthest) : 0.0;
    }
    static unsigned test_eight(const Branch& branch, const Query& query, float* distance2);
    static unsigned test_four(const Branch& branch, const Query& query, float* distance2);

    /// Roughly where a box is; only the shape of the tree depends on it.
    struct Leaf {
        float middle[3];
        std::int32_t rank;
    };
    Box build(const std::vector<Box>& boxes, Leaf* first, std::int32_t count, std::int32_t at);

    /// Prefetches a branch.
    void fetch(std::int32_t at) const {
        const char* bytes = reinterpret_cast<const char*>(&branch_[static_cast<size_t>(at)]);
        for (size_t line = 0; line < sizeof(Branch); line += 64)
            __builtin_prefetch(bytes + line);
    }
    template <class Found>
    void visit(const Query& query, const Found& found) const {
        if (branch_.empty()) return;
        std::int32_t open[deepest];
        alignas(32) float distance2[wide];
        int depth = 0;
        open[depth++] = 0;
        while (depth > 0) {
            const Branch& branch = branch_[static_cast<size_t>(open[--depth])];
            for (unsigned hit = test_(branch, query, distance2); hit != 0; hit &= hit - 1) {
                const int i = std::countr_zero(hit);
                if (branch.below[i] == nothing) continue;
                if (branch.below[i] < 0) {
                    found(static_cast<int>(~branch.below[i]), distance(distance2[i]));
                } else {
                    fetch(branch.below[i]);
                    open[depth++] = branch.below[i];
                }
            }
        }
    }

    Test test_ = nullptr;
    std::vector<Branch> branch_;
};

template <class Limit, class Found>
void BoxTree::near(const V3& y, const Limit& limit_now, const Found& found) const {
    if (branch_.empty()) return;
    struct Open {
        std::int32_t branch;
        float distance2;
    };
    Open open[deepest];
    alignas(32) float distance2[wide];
    int depth = 0;
    open[depth++] = {0, 0.0F};
    Query query = query_of({y, y}, 0);
    while (depth > 0) {
        const Open top = open[--depth];
        if (!(distance(top.distance2) < limit_now())) continue;
        const Branch& branch = branch_[static_cast<size_t>(top.branch)];
        limit(query, limit_now());
        const int start = depth;
        for (unsigned hit = test_(branch, query, distance2); hit != 0; hit &= hit - 1) {
            const int i = std::countr_zero(hit);
            if (branch.below[i] == nothing) continue;
            if (branch.below[i] < 0) {
                if (distance(distance2[i]) < limit_now())
                    found(static_cast<int>(~branch.below[i]), distance(distance2[i]));
                continue;
            }
            fetch(branch.below[i]);
            // The nearest is taken from the end first.
            int at = depth++;
            for (; at > start && open[at - 1].distance2 < distance2[i]; --at)
                open[at] = open[at - 1];
            open[at] = {branch.below[i], distance2[i]};
        }
    }
}

}  // namespace type21::optimized
