/// @file Neighbouring tool segments of opposite sense: one of the two cannot look at the blank.
#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/segment_edges.h"
#include "reference/host/warnings/warnings.h"
#include "reference/model/card_validator.h"

namespace type21 {
namespace {

/// Groups of segments that hang together, each segment with its sense relative to the first of its group.
class Senses {
  public:
    explicit Senses(std::size_t segments) : parent_(segments), turned_(segments, 0) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    /// Root of the group, and whether the segment is turned against it.
    std::pair<int, bool> root(int segment) {
        int top = segment;
        bool turned = false;
        while (parent_[at(top)] != top) {
            turned ^= turned_[at(top)] != 0;
            top = parent_[at(top)];
        }
        // The way up is shortened for the next one who asks.
        bool rest = turned;
        while (parent_[at(segment)] != segment && segment != top) {
            const bool own = turned_[at(segment)] != 0;
            const int above = std::exchange(parent_[at(segment)], top);
            turned_[at(segment)] = rest ? 1 : 0;
            rest ^= own;
            segment = above;
        }
        return {top, turned};
    }

    void join(int a, int b, bool opposite) {
        const auto [root_a, turned_a] = root(a);
        const auto [root_b, turned_b] = root(b);
        if (root_a == root_b) return;
        const int upper = std::min(root_a, root_b);
        const int lower = std::max(root_a, root_b);
        parent_[at(lower)] = upper;
        turned_[at(lower)] = (turned_a ^ turned_b ^ opposite) ? 1 : 0;
    }

  private:
    static std::size_t at(int index) { return static_cast<std::size_t>(index); }
    std::vector<int> parent_;
    std::vector<char> turned_;
};

/// Segments of opposite sense to most of those that they hang together with, ascending.
std::vector<int> turned_segments(const Surface& surface, int& edges_met) {
    const std::vector<SegmentEdge> edges = segment_edges(surface);
    Senses senses(surface.segments.size());
    for_each_edge(edges, [&](const SegmentEdge* first, const SegmentEdge* last) {
        // Where three or more meet, no two of them need to have the same sense.
        if (last - first != 2 || first[0].segment == first[1].segment) return;
        const bool opposite = first[0].forward == first[1].forward;
        if (opposite) ++edges_met;
        senses.join(first[0].segment, first[1].segment, opposite);
    });
    if (edges_met == 0) return {};
    const int count = static_cast<int>(surface.segments.size());
    std::vector<int> balance(surface.segments.size(), 0);  // of each root: those of its sense less the others
    for (int i = 0; i < count; ++i) {
        const auto [root, turned] = senses.root(i);
        balance[static_cast<std::size_t>(root)] += turned ? -1 : 1;
    }
    std::vector<int> found;
    for (int i = 0; i < count; ++i) {
        const auto [root, turned] = senses.root(i);
        if (turned == (balance[static_cast<std::size_t>(root)] >= 0)) found.push_back(i);
    }
    return found;
}

}  // namespace

void warn_of_turned_segments(const SurpriseCheck& check) {
    for (const Interface& interface : check.model.interfaces) {
        const Surface& surface = check.main_surface(interface);
        int edges = 0;
        const std::vector<int> turned = turned_segments(surface, edges);
        if (edges == 0) continue;
        std::string which = "a band of segments with one side only";
        if (!turned.empty()) {
            std::vector<Id> ranks;
            ranks.reserve(turned.size());
            for (const int segment : turned)
                ranks.push_back(segment + 1);
            which = fmt::format("{} of {} segments: no. {}; the first has the nodes {}", turned.size(),
                                surface.segments.size(), first_few(ranks),
                                check.nodes_of(surface.segments[static_cast<std::size_t>(turned.front())]));
        }
        check.at_interface(
            interface, "surf_IDm", which,
            fmt::format("run against their neighbours through {} shared edge{}: of two such segments one looks "
                        "away from the blank and gives no contact",
                        edges, edges == 1 ? "" : "s"),
            "Reverse the order of their nodes, or put them into a part of their own with a negative id in /SURF");
    }
}

}  // namespace type21
