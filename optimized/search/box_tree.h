/// @file Which boxes hold a point, meet a box, or are near: a tree of boxes, built once.
#pragma once

#include <cstdint>
#include <vector>

#include "optimized/search/box.h"

namespace type21::optimized {

/// A binary tree with one box a leaf. A branch holds the boxes of both that are below it, rounded outward to float: 64
/// bytes, one cache line. Branches lie in depth-first order, so near ones share memory pages.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Box>& boxes);

    /// Calls found(rank) for each box that holds y (and for some that nearly do).
    template <class Found>
    void at(const V3& y, const Found& found) const {
        visit([&](const Side& side) { return side.distance2(y) <= 0; }, found);
    }
    /// Calls found(rank) for each box that meets this one (and for some that nearly do).
    template <class Found>
    void meeting(const Box& box, const Found& found) const {
        visit([&](const Side& side) { return side.meets(box); }, found);
    }
    /// Calls found(rank, lower bound on its distance from y) for boxes nearer than limit(), which may shrink.
    template <class Limit, class Found>
    void near(const V3& y, const Limit& limit, const Found& found) const;

    size_t bytes() const { return branch_.capacity() * sizeof(Branch); }

  private:
    struct Side {
        float low[3], high[3];

        double distance2(const V3& y) const {
            const double dx = std::max(0.0, std::max(double(low[0]) - y.x, y.x - double(high[0])));
            const double dy = std::max(0.0, std::max(double(low[1]) - y.y, y.y - double(high[1])));
            const double dz = std::max(0.0, std::max(double(low[2]) - y.z, y.z - double(high[2])));
            return dx * dx + dy * dy + dz * dz;
        }
        bool meets(const Box& b) const {
            return b.low.x <= double(high[0]) && b.high.x >= double(low[0]) && b.low.y <= double(high[1]) &&
                   b.high.y >= double(low[1]) && b.low.z <= double(high[2]) && b.high.z >= double(low[2]);
        }
    };
    struct alignas(64) Branch {
        Side side[2];
        std::int32_t below[2];  ///< a branch, or ~rank of a box
    };
    static constexpr int deepest = 64;  ///< halves: 2^31 boxes need 31

    static Side rounded_outward(const Box& box);
    /// Where a box is, roughly: only the shape of the tree depends on it.
    struct Leaf {
        float middle[3];
        std::int32_t rank;
    };
    Box build(const std::vector<Box>& boxes, Leaf* first, std::int32_t count, std::int32_t at);

    template <class Holds, class Found>
    void visit(const Holds& holds, const Found& found) const {
        if (branch_.empty()) return;
        std::int32_t open[deepest];
        int depth = 0;
        open[depth++] = 0;
        while (depth > 0) {
            const Branch& branch = branch_[static_cast<size_t>(open[--depth])];
            for (int i = 1; i >= 0; --i) {
                if (branch.below[i] == nothing || !holds(branch.side[i])) continue;
                if (branch.below[i] < 0) {
                    found(static_cast<int>(~branch.below[i]));
                } else {
                    open[depth++] = branch.below[i];
                }
            }
        }
    }

    static constexpr std::int32_t nothing = std::numeric_limits<std::int32_t>::min();
    std::vector<Branch> branch_;
};

template <class Limit, class Found>
void BoxTree::near(const V3& y, const Limit& limit, const Found& found) const {
    if (branch_.empty()) return;
    struct Open {
        std::int32_t branch;
        double distance;
    };
    Open open[deepest];
    int depth = 0;
    open[depth++] = {0, 0.0};
    while (depth > 0) {
        const Open top = open[--depth];
        if (top.distance >= limit()) continue;
        const Branch& branch = branch_[static_cast<size_t>(top.branch)];
        double distance[2];
        for (int i = 0; i < 2; ++i)
            distance[i] = branch.below[i] == nothing ? std::numeric_limits<double>::infinity()
                                                     : std::sqrt(branch.side[i].distance2(y)) * (1 - 1e-12);
        const int nearer = distance[1] < distance[0] ? 1 : 0;
        // The farther one is put under the nearer.
        for (const int i : {1 - nearer, nearer}) {
            if (branch.below[i] >= 0 && distance[i] < limit()) open[depth++] = {branch.below[i], distance[i]};
        }
        for (const int i : {nearer, 1 - nearer}) {
            if (branch.below[i] < 0 && branch.below[i] != nothing && distance[i] < limit())
                found(static_cast<int>(~branch.below[i]), distance[i]);
        }
    }
}

}  // namespace type21::optimized
