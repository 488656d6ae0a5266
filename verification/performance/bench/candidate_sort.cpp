#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Geometry>

#include "verification/performance/bench/candidate_list.h"

namespace type21::bench {

SortSizes sort_sizes(double gap, double depth, double mean_edge, double bumult) {
    SortSizes sizes;
    sizes.gap = gap;
    sizes.depth = depth;
    const double size = std::max(mean_edge, 1.251 * depth);
    sizes.margin = bumult * size;
    sizes.reach = sizes.margin + std::max(gap, depth);
    sizes.smallest_box = 0.25 * (size + 2 * sizes.reach);
    return sizes;
}

namespace {

constexpr size_t group = 128;  ///< pairs that a vector group of the engine holds
constexpr int deepest = 1000;

struct SegmentBox {
    Vec3 low, high;
};

/// All that stays the same while boxes are halved.
struct Sort {
    const SurfaceMesh& tool;
    const std::vector<Vec3>& y;
    const SortSizes& sizes;
    std::vector<SegmentBox> boxes;
    std::vector<CandidatePair> found;

    double distance2(const Vec3& p, int segment) const {
        const auto& s = tool.segment[static_cast<size_t>(segment)];
        const auto x = [&](size_t j) -> const Vec3& { return tool.node[static_cast<size_t>(s[j])]; };
        if (s[2] == s[3]) return distance2_to_triangle(p, x(0), x(1), x(2));
        const Vec3 center = 0.25 * (x(0) + x(1) + x(2) + x(3));
        double least = distance2_to_triangle(p, center, x(0), x(1));
        for (size_t k = 1; k < 4; ++k)
            least = std::min(least, distance2_to_triangle(p, center, x(k), x((k + 1) % 4)));
        return least;
    }

    void meet(std::span<const int> nodes, std::span<const int> segments) {
        const double limit = std::max(sizes.gap, sizes.depth) + sizes.margin;
        for (const int s : segments) {
            const SegmentBox& box = boxes[static_cast<size_t>(s)];
            const Vec3 low = box.low.array() - sizes.reach, high = box.high.array() + sizes.reach;
            for (const int n : nodes) {
                const Vec3& p = y[static_cast<size_t>(n)];
                if (!((p.array() > low.array()).all() && (p.array() < high.array()).all())) continue;
                if (distance2(p, s) < limit * limit) found.push_back({n, s});
            }
        }
    }

    void halve(std::span<int> nodes, const std::vector<int>& segments, const Vec3& low, const Vec3& high, int depth) {
        if (nodes.empty() || segments.empty()) return;
        Eigen::Index axis = 0;
        const double side = (high - low).maxCoeff(&axis);
        const bool small = nodes.size() * segments.size() <= group && nodes.size() + segments.size() <= group;
        if (side < sizes.smallest_box || nodes.size() <= 1 || small || depth >= deepest) {
            meet(nodes, segments);
            return;
        }
        const double middle = 0.5 * (low[axis] + high[axis]);
        const auto upper =
            std::partition(nodes.begin(), nodes.end(), [&](int n) { return y[static_cast<size_t>(n)][axis] < middle; });
        std::vector<int> below, above;
        for (const int s : segments) {
            const SegmentBox& box = boxes[static_cast<size_t>(s)];
            if (box.low[axis] - sizes.reach < middle) below.push_back(s);
            if (box.high[axis] + sizes.reach >= middle) above.push_back(s);
        }
        Vec3 end = high, start = low;
        end[axis] = start[axis] = middle;
        halve({nodes.begin(), upper}, below, low, end, depth + 1);
        halve({upper, nodes.end()}, above, start, high, depth + 1);
    }
};

}  // namespace

std::vector<CandidatePair> sorted_pairs(const SurfaceMesh& tool, const std::vector<Vec3>& y, const SortSizes& sizes) {
    Sort sort{tool, y, sizes, {}, {}};
    Eigen::AlignedBox3d all;
    for (const Vec3& p : y)
        all.extend(p);
    Vec3 largest = Vec3::Zero();
    for (const auto& s : tool.segment) {
        SegmentBox box{tool.node[static_cast<size_t>(s[0])], tool.node[static_cast<size_t>(s[0])]};
        for (const int corner : s) {
            box.low = box.low.cwiseMin(tool.node[static_cast<size_t>(corner)]);
            box.high = box.high.cwiseMax(tool.node[static_cast<size_t>(corner)]);
        }
        largest = largest.cwiseMax(box.high - box.low);
        sort.boxes.push_back(box);
    }
    const Vec3 growth = largest.array() + sizes.reach;
    const Vec3 low = all.min() - growth, high = all.max() + growth;
    std::vector<int> nodes(y.size()), segments;
    for (size_t i = 0; i < nodes.size(); ++i)
        nodes[i] = static_cast<int>(i);
    for (size_t s = 0; s < tool.segment.size(); ++s) {
        for (const int corner : tool.segment[s]) {
            const Vec3& x = tool.node[static_cast<size_t>(corner)];
            if (!((x.array() >= low.array()).all() && (x.array() <= high.array()).all())) continue;
            segments.push_back(static_cast<int>(s));
            break;
        }
    }
    sort.halve(nodes, segments, low, high, 0);
    return std::move(sort.found);
}

}  // namespace type21::bench
