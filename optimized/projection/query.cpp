#include "optimized/projection/query.h"

#include <stdexcept>
#include <string>

#include "optimized/projection/decide.h"

namespace type21::optimized {

namespace {

void require(bool holds, const char* what) {
    if (!holds) throw std::invalid_argument(what);
}
void require(bool holds, const char* of, size_t number, const char* what) {
    if (!holds) throw std::invalid_argument(std::string("decide: ") + of + " " + std::to_string(number) + what);
}

}  // namespace

void check_query(const std::vector<Vec3>& nodes, const std::vector<Vec3>& normals,
                 const std::vector<std::array<int, 4>>& segments, const Vec3& p, double gap, double depth,
                 double reach) {
    require(nodes.size() == normals.size(), "decide: as many normals as nodes are needed");
    require(p.allFinite(), "decide: the position of the node is not finite [length]");
    require(std::isfinite(gap) && std::isfinite(depth) && std::isfinite(reach),
            "decide: gap, depth and reach must be finite [length]");
    for (size_t i = 0; i < nodes.size(); ++i)
        require(nodes[i].allFinite(), "tool node", i + 1, ": a coordinate is not finite [length]; give finite ones");
    for (size_t i = 0; i < normals.size(); ++i)
        require(normals[i].allFinite(), "tool node", i + 1,
                ": a component of its normal is not finite [-]; give finite ones");
    for (size_t rank = 0; rank < segments.size(); ++rank)
        for (const int corner : segments[rank])
            require(corner >= 0 && static_cast<size_t>(corner) < nodes.size(), "segment", rank + 1,
                    " names a node that is not there; indices start at 0");
}

Decision decide_query(const std::vector<Vec3>& nodes, const std::vector<Vec3>& normals,
                      const std::vector<std::array<int, 4>>& segments, const Vec3& p, double gap, double depth,
                      double reach) {
    check_query(nodes, normals, segments, p, gap, depth, reach);
    const auto segment_of = [&](int rank) {
        const auto& corner = segments[static_cast<size_t>(rank)];
        SegmentData segment;
        segment.is_triangle = corner[2] == corner[3];
        for (size_t j = 0; j < 4; ++j) {
            segment.node[j] = from(nodes[static_cast<size_t>(corner[j])]);
            segment.normal[j] = from(normals[static_cast<size_t>(corner[j])]);
        }
        return segment;
    };
    Decider decider(from(p), {gap, depth, reach}, {});
    for (int rank = 0; rank < static_cast<int>(segments.size()); ++rank)
        decider.add(rank, segment_of(rank));
    const Retained retained = decider.retained(segment_of);
    if (!retained.exists()) return {};
    return decision_of(retained);
}

}  // namespace type21::optimized
