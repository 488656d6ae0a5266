/// @file The sampled test of main normals.
#include "reference/model/main_normals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <fmt/format.h>

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

struct Sample {
    size_t rank = 0;  ///< in the main surface, from 0
    Vec3 center = Vec3::Zero();
    Vec3 area = Vec3::Zero();  ///< area vector, along the normal [length^2]
    int nearest_node = -1;
};

size_t sample_count(size_t segments, size_t nodes) {
    constexpr size_t most_distances = 30'000'000;
    constexpr size_t fewest = 16;
    constexpr size_t most = 300;
    return std::min(segments, std::clamp(most_distances / nodes, fewest, most));
}

Sample examine(const CardValidator& validator, const Segment& segment, size_t rank) {
    const auto& x = validator.model.nodes.position;
    const auto& n = segment.node;
    Sample sample{rank};
    for (int corner = 0; corner < segment.corners(); ++corner)
        sample.center += x[at(n[at(corner)])] / segment.corners();
    sample.area = 0.5 * (x[at(n[2])] - x[at(n[0])]).cross(x[at(n[3])] - x[at(n[1])]);
    double nearest = std::numeric_limits<double>::infinity();
    for (const int node : validator.interface.secondary.node) {
        const double squared_distance = (x[at(node)] - sample.center).squaredNorm();
        if (squared_distance >= nearest) continue;
        nearest = squared_distance;
        sample.nearest_node = node;
    }
    return sample;
}

std::vector<Sample> examine_spread(const CardValidator& validator, const std::vector<Segment>& segments) {
    const size_t count = sample_count(segments.size(), validator.interface.secondary.node.size());
    std::vector<Sample> samples;
    for (size_t i = 0; i < count; ++i) {
        const size_t rank = i * segments.size() / count;
        samples.push_back(examine(validator, segments[rank], rank));
    }
    return samples;
}

/// A sample and the node that it is compared with.
using Pairs = std::map<const Sample*, int>;

/// Each node that is the nearest of some sample, with the sample nearest to it; by rank.
Pairs facing_pairs(const std::vector<Vec3>& x, const std::vector<Sample>& samples) {
    std::set<int> nodes;
    for (const Sample& sample : samples)
        nodes.insert(sample.nearest_node);
    Pairs pairs;
    for (const int node : nodes) {
        const auto distance = [&](const Sample& sample) { return (x[at(node)] - sample.center).squaredNorm(); };
        const auto nearest = std::min_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
            return distance(a) < distance(b);
        });
        pairs.emplace(&*nearest, node);
    }
    return pairs;
}

}  // namespace

/// @manual field Invn; comment 21
void check_main_normals(const CardValidator& validator) {
    constexpr double across = 0.02;
    const auto& segments = validator.model.surfaces[at(validator.interface.main_surface)].segments;
    const auto& x = validator.model.nodes.position;
    const std::vector<Sample> samples = examine_spread(validator, segments);
    double counted_area = 0;
    double away_area = 0;
    size_t counted = 0;
    std::vector<const Sample*> away;
    for (const auto& [sample, node_of_pair] : facing_pairs(x, samples)) {
        const Vec3 way = x[at(node_of_pair)] - sample->center;
        const double facing = sample->area.dot(way);
        if (std::abs(facing) <= across * sample->area.norm() * way.norm()) continue;
        ++counted;
        counted_area += sample->area.norm();
        if (facing > 0) continue;
        away_area += sample->area.norm();
        away.push_back(sample);
    }
    if (away_area <= 0.5 * counted_area) return;
    const auto& node = segments[away.front()->rank].node;
    const auto& id = validator.model.nodes.id;
    validator.warning_with(
        "surf_IDm",
        fmt::format("{} of {} examined segments that face the blank, the first is no. {} (nodes {}, {}, {}, {})",
                    away.size(), counted, away.front()->rank + 1, id[at(node[0])], id[at(node[1])], id[at(node[2])],
                    id[at(node[3])]),
        "the main normals face away from the blank; they must face the secondary surface",
        "Give the part or surface with a negative id in /SURF to reverse it, unless the blank really starts behind the "
        "tool");
}

}  // namespace type21
