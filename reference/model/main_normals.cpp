/// @file The sampled test of main normals.
#include "reference/model/main_normals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

struct Sample {
    size_t rank = 0;      ///< in the main surface, from 0
    double area = 0;      ///< [length^2]
    double distance = 0;  ///< |d|, centre to nearest secondary node [length]
    double cosine = 0;    ///< <n, d> / |d|, 0 where |d| = 0 [-]
};

size_t sample_count(size_t segments, size_t nodes) {
    constexpr size_t most_distances = 30'000'000;
    constexpr size_t fewest = 16;
    constexpr size_t most = 300;
    return std::min(segments, std::clamp(most_distances / nodes, fewest, most));
}

Sample examine(const InterfaceJudge& judge, const Segment& segment, size_t rank) {
    const auto& x = judge.model.nodes.position;
    const auto& n = segment.node;
    Vec3 center = Vec3::Zero();
    for (int corner = 0; corner < segment.corners(); ++corner)
        center += x[at(n[at(corner)])] / segment.corners();
    const Vec3 area = 0.5 * (x[at(n[2])] - x[at(n[0])]).cross(x[at(n[3])] - x[at(n[1])]);
    double nearest = std::numeric_limits<double>::infinity();
    Vec3 way = Vec3::Zero();
    for (const int node : judge.interface.secondary.node) {
        const Vec3 d = x[at(node)] - center;
        if (d.squaredNorm() >= nearest) continue;
        nearest = d.squaredNorm();
        way = d;
    }
    Sample sample{rank, area.norm(), std::sqrt(nearest), 0};
    if (sample.area > 0 && sample.distance > 0) sample.cosine = area.dot(way) / (sample.area * sample.distance);
    return sample;
}

std::vector<Sample> examine_spread(const InterfaceJudge& judge, const std::vector<Segment>& segments) {
    const size_t count = sample_count(segments.size(), judge.interface.secondary.node.size());
    std::vector<Sample> samples;
    for (size_t i = 0; i < count; ++i) {
        const size_t rank = i * segments.size() / count;
        samples.push_back(examine(judge, segments[rank], rank));
    }
    return samples;
}

/// Farthest distance that is still near: the blank may lie far above the whole tool.
double near_limit(const Interface& interface, const std::vector<Sample>& samples) {
    double nearest = std::numeric_limits<double>::infinity();
    double area = 0;
    for (const Sample& sample : samples) {
        nearest = std::min(nearest, sample.distance);
        area += sample.area;
    }
    const double size = std::sqrt(area / static_cast<double>(samples.size()));
    return nearest + interface.largest_gap + interface.depth + 3 * size;
}

}  // namespace

void check_main_normals(const InterfaceJudge& judge) {
    constexpr double across = 0.02;
    const auto& segments = judge.model.surfaces[at(judge.interface.main_surface)].segments;
    const std::vector<Sample> samples = examine_spread(judge, segments);
    const double limit = near_limit(judge.interface, samples);
    double judged_area = 0;
    double away_area = 0;
    size_t judged = 0;
    std::vector<const Sample*> away;
    for (const Sample& sample : samples) {
        if (sample.distance > limit || std::abs(sample.cosine) <= across) continue;
        ++judged;
        judged_area += sample.area;
        if (sample.cosine > 0) continue;
        away_area += sample.area;
        away.push_back(&sample);
    }
    if (away_area <= 0.5 * judged_area) return;
    const auto& node = segments[away.front()->rank].node;
    const auto& id = judge.model.nodes.id;
    judge.warning_with(
        "surf_IDm",
        fmt::format("{} of {} examined segments near the blank, the first is no. {} (nodes {}, {}, {}, {})",
                    away.size(), judged, away.front()->rank + 1, id[at(node[0])], id[at(node[1])], id[at(node[2])],
                    id[at(node[3])]),
        "the main normals look away from the blank; they must be oriented toward the secondary surface",
        "Give the part or surface with a negative id in /SURF to reverse it, unless the blank really starts behind the "
        "tool");
}

}  // namespace type21
