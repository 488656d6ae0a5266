#include "reference/host/warnings/segment_edges.h"

#include <algorithm>
#include <tuple>

namespace type21 {

std::vector<SegmentEdge> segment_edges(const Surface& surface) {
    std::vector<SegmentEdge> edges;
    edges.reserve(4 * surface.segments.size());
    for (std::size_t i = 0; i < surface.segments.size(); ++i) {
        const auto& node = surface.segments[i].node;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const int a = node[corner];
            const int b = node[(corner + 1) % 4];
            if (a != b) edges.push_back({std::min(a, b), std::max(a, b), static_cast<int>(i), a < b});
        }
    }
    std::sort(edges.begin(), edges.end(), [](const SegmentEdge& a, const SegmentEdge& b) {
        return std::tie(a.low, a.high, a.segment) < std::tie(b.low, b.high, b.segment);
    });
    return edges;
}

}  // namespace type21
