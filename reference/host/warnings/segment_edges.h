/// @file The edges of a surface, with the segments on their two sides.
#pragma once

#include <vector>

#include "reference/contract/mesh.h"

namespace type21 {

/// One side of one segment.
struct SegmentEdge {
    int low = 0;   ///< index of the node with the lower index
    int high = 0;  ///< of the other
    int segment = 0;
    bool forward = true;  ///< the segment runs from low to high
};

/// The sides of all segments, those between the same two nodes next to each other.
std::vector<SegmentEdge> segment_edges(const Surface& surface);

/// Calls visit(first, last) for each edge: the range of its sides.
template <class Visit>
void for_each_edge(const std::vector<SegmentEdge>& edges, Visit visit) {
    for (std::size_t first = 0; first < edges.size();) {
        std::size_t last = first + 1;
        while (last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high)
            ++last;
        visit(edges.data() + first, edges.data() + last);
        first = last;
    }
}

}  // namespace type21
