/// @file Tool nodes that lie on each other without being one: a seam that looks closed and is a border.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/segment_edges.h"
#include "reference/host/warnings/warnings.h"

namespace type21 {
namespace {

/// Two nodes nearer than this part of the shortest border edge were meant to be one.
constexpr double same_place = 1e-3;

struct Border {
    std::vector<int> nodes;  ///< ascending
    double shortest = 0;     ///< shortest edge of the border [length]
};

Border border_of(const Surface& surface, const std::vector<Vec3>& x) {
    Border border;
    double shortest = std::numeric_limits<double>::infinity();
    for_each_edge(segment_edges(surface), [&](const SegmentEdge* first, const SegmentEdge* last) {
        if (last - first != 1) return;
        border.nodes.insert(border.nodes.end(), {first->low, first->high});
        const double length = (x[static_cast<size_t>(first->low)] - x[static_cast<size_t>(first->high)]).norm();
        if (length > 0) shortest = std::min(shortest, length);
    });
    std::sort(border.nodes.begin(), border.nodes.end());
    border.nodes.erase(std::unique(border.nodes.begin(), border.nodes.end()), border.nodes.end());
    border.shortest = shortest;
    return border;
}

/// Points by the cell of a grid that they lie in; points nearer than an edge of it are in the same or the next cell.
class Grid {
  public:
    Grid(const std::vector<Vec3>& x, double edge) : x_(x), edge_(edge) {}

    void add(int node) { cells_[key(cell(node), {0, 0, 0})].push_back(node); }

    /// A point added before that is no farther than the edge of the grid; -1 if there is none.
    int near(int node) const {
        const auto middle = cell(node);
        for (std::int64_t i = -1; i <= 1; ++i)
            for (std::int64_t j = -1; j <= 1; ++j)
                for (std::int64_t k = -1; k <= 1; ++k) {
                    const auto found = cells_.find(key(middle, {i, j, k}));
                    if (found == cells_.end()) continue;
                    for (const int other : found->second)
                        if ((x_[static_cast<size_t>(other)] - x_[static_cast<size_t>(node)]).norm() <= edge_)
                            return other;
                }
        return -1;
    }

  private:
    using Cell = std::array<std::int64_t, 3>;

    Cell cell(int node) const {
        Cell of{};
        for (int d = 0; d < 3; ++d) {
            // Far from the origin a cell may be finer than what an integer can count: then all share one.
            const double at = std::floor(x_[static_cast<size_t>(node)][d] / edge_);
            of[static_cast<size_t>(d)] = std::abs(at) < 9e15 ? static_cast<std::int64_t>(at) : 0;
        }
        return of;
    }

    /// Points of several cells may share a key; their distance decides.
    static std::uint64_t key(const Cell& cell, const Cell& step) {
        std::uint64_t mixed = 0;
        for (size_t d = 0; d < 3; ++d)
            mixed = (mixed ^ static_cast<std::uint64_t>(cell[d] + step[d])) * 0x9e3779b97f4a7c15U + (mixed >> 29U);
        return mixed;
    }

    const std::vector<Vec3>& x_;
    double edge_;
    std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

}  // namespace

void warn_of_open_seams(const SurpriseCheck& check) {
    const auto& x = check.model.nodes.position;
    const auto& id = check.model.nodes.id;
    for (const Interface& interface : check.model.interfaces) {
        const Border border = border_of(check.main_surface(interface), x);
        if (border.nodes.empty() || !std::isfinite(border.shortest)) continue;
        Grid grid(x, same_place * border.shortest);
        std::array<int, 2> first{-1, -1};
        int count = 0;
        for (const int node : border.nodes) {
            const int other = grid.near(node);
            grid.add(node);
            if (other < 0) continue;
            if (count++ == 0) first = {other, node};
        }
        if (count == 0) continue;
        check.at_interface(
            interface, "surf_IDm",
            fmt::format("{} pair{} of nodes, the first {} and {}", count, count == 1 ? "" : "s",
                        id[static_cast<size_t>(first[0])], id[static_cast<size_t>(first[1])]),
            fmt::format("two nodes on the border of the tool lie within {} of each other and are not the same: the "
                        "seam is a border, without a common normal and without contact past it",
                        check.quantity(same_place * border.shortest, dim::length)),
            "Merge the nodes, unless the tool really ends there");
    }
}

}  // namespace type21
