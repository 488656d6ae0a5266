#include "optimized/search/tool.h"

#include <algorithm>
#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "optimized/projection/local_segment.h"

namespace type21::optimized {

namespace {

V3 unit(const V3& v) {
    const double length = norm(v);
    return length > 0 ? V3{v.x / length, v.y / length, v.z / length} : V3{};
}

}  // namespace

std::vector<V3> nodal_normals(const std::vector<V3>& position, const std::vector<std::array<int, 4>>& corner) {
    std::vector<V3> normal(position.size());
    for (const auto& s : corner) {
        const auto x = [&](size_t j) -> const V3& { return position[static_cast<size_t>(s[j])]; };
        const auto gain = [&](size_t j, const V3& n) {
            V3& sum = normal[static_cast<size_t>(s[j])];
            sum = sum + n;
        };
        if (s[2] == s[3]) {
            const V3 n = unit(cross(x(0) - x(2), x(1) - x(2)));
            for (size_t j = 0; j < 3; ++j)
                gain(j, n);
            continue;
        }
        const V3 sum = ((x(0) + x(1)) + x(2)) + x(3);
        const V3 center{sum.x / 4, sum.y / 4, sum.z / 4};
        for (size_t k = 0; k < 4; ++k) {
            const size_t next = (k + 1) % 4;
            const V3 n = unit(cross(x(k) - center, x(next) - center));
            gain(k, n);
            gain(next, n);
        }
    }
    for (V3& n : normal)
        n = unit(n);
    return normal;
}

void Tool::find_extents() {
    extent_.resize(corner_.size());
    tbb::parallel_for(tbb::blocked_range<int>(0, size(), 4096), [&](const tbb::blocked_range<int>& range) {
        for (int s = range.begin(); s < range.end(); ++s)
            extent_[static_cast<size_t>(s)] =
                std::nextafter(static_cast<float>(local_segment(segment(s)).extent), HUGE_VALF);
    });
}

Tool::Tool(std::vector<V3> position, std::vector<V3> normal, std::vector<std::array<int, 4>> corner)
    : corner_(std::move(corner)) {
    vertex_.reserve(position.size());
    for (size_t i = 0; i < position.size(); ++i)
        vertex_.push_back({position[i], normal[i]});
    find_extents();
}

namespace {

/// The segments that count in the normals: each once.
std::vector<std::array<int, 4>> without_repeated(const Surface& surface,
                                                 const std::vector<std::array<int, 4>>& corner) {
    std::vector<std::array<int, 4>> counted;
    for (size_t rank = 0; rank < corner.size(); ++rank)
        if (!surface.is_repeated(static_cast<int>(rank))) counted.push_back(corner[rank]);
    return counted;
}

}  // namespace

Tool::Tool(const ContactModel& model, const Interface& interface) {
    const Vec3& center = model.rigid_bodies[static_cast<size_t>(interface.tool)].center;
    const auto& main = interface.main_nodes;
    std::vector<V3> position;
    position.reserve(main.size());
    for (const int node : main)
        position.push_back(from(model.nodes.position[static_cast<size_t>(node)] - center));
    std::vector<int> rank(static_cast<size_t>(model.nodes.size()), -1);
    for (size_t i = 0; i < main.size(); ++i)
        rank[static_cast<size_t>(main[i])] = static_cast<int>(i);
    const auto& segments = model.surfaces[static_cast<size_t>(interface.main_surface)].segments;
    corner_.reserve(segments.size());
    for (const Segment& segment : segments) {
        std::array<int, 4> corner{};
        for (size_t j = 0; j < 4; ++j)
            corner[j] = rank[static_cast<size_t>(segment.node[j])];
        corner_.push_back(corner);
    }
    const Surface& surface = model.surfaces[static_cast<size_t>(interface.main_surface)];
    const std::vector<V3> normal =
        nodal_normals(position, surface.repeated.empty() ? corner_ : without_repeated(surface, corner_));
    vertex_.reserve(position.size());
    for (size_t i = 0; i < position.size(); ++i)
        vertex_.push_back({position[i], normal[i]});
    find_extents();
}

}  // namespace type21::optimized
