/// @file The candidates of every node, kept while no node has moved farther than a margin.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "optimized/search/box.h"

namespace type21::optimized {

/// For each node the segments that may take it wherever it goes within the margin. All is in the tool frame: there the
/// segments stand still, however the tool turns, and the way of a node holds that of the tool.
///
/// Complete. Let y0 be where a node was at the sort, y where it is now, m the margin. Its list has every segment whose
/// box, grown by m on each side, holds y0. Let a segment take the node at y: then its box holds y. While no coordinate
/// of y - y0 is larger than m, the grown box holds y0, so the segment is in the list. README.md of optimized/ has the
/// rounding.
class CandidateLists {
  public:
    /// @param boxes   of the segments, each with all places where its segment takes a node; they must outlive the lists
    /// @param margin  m [length]
    CandidateLists(const std::vector<Box>& boxes, double margin);

    /// Is the list of a node complete for this place? Any number of threads may ask.
    bool covers(size_t node, const V3& y) const {
        const V3& from = at_[node];
        if (std::abs(y.x - from.x) <= margin_ && std::abs(y.y - from.y) <= margin_ && std::abs(y.z - from.z) <= margin_)
            return true;
        // Nothing takes a node outside of all boxes, and one that is not finite is outside.
        return !whole_.holds(y);
    }
    /// Makes new lists. They are the same for any number of threads.
    /// @param y  of each node; one that is not finite gets an empty list [length]
    void sort(std::vector<V3> y);

    /// Ranks of segments, ascending.
    std::span<const int> of(size_t node) const { return list_[node]; }
    /// The list of each node, until the next sort.
    const std::span<const int>* all() const { return list_.data(); }

    double margin() const { return margin_; }
    long sorts() const { return sorts_; }
    /// Memory of the last sort [byte]
    size_t bytes() const { return bytes_; }

  private:
    using Ranks = std::vector<int>;
    using SharedRanks = std::shared_ptr<const Ranks>;
    /// Nodes that are near each other, and the memory of their lists.
    struct Group {
        Ranks own;           ///< the lists of its nodes, one after the other
        SharedRanks shared;  ///< the list of those that have none of their own
    };
    static constexpr size_t group_size = 16;

    void halve(std::span<int> nodes, size_t first, const SharedRanks& candidates);
    size_t count_bytes() const;
    void list_group(std::span<const int> nodes, Group& group, const SharedRanks& candidates);

    const std::vector<Box>& boxes_;
    double margin_;
    double reach_;  ///< the margin, and what rounding may take of it [length]
    Box whole_;     ///< holds all boxes
    SharedRanks all_;
    std::vector<V3> at_;  ///< of each node at the sort [length]
    std::vector<std::span<const int>> list_;
    std::vector<Group> groups_;
    long sorts_ = 0;
    size_t bytes_ = 0;
};

}  // namespace type21::optimized
