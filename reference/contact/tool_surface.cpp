#include "reference/contact/tool_surface.h"

#include <algorithm>

namespace type21::reference {

namespace {

Vec3 unit(const Vec3& v) {
    const double length = v.norm();
    return length > 0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

}  // namespace

std::vector<Vec3> nodal_normals(const std::vector<Vec3>& position, const std::vector<std::array<int, 4>>& segments) {
    std::vector<Vec3> sum(position.size(), Vec3::Zero());
    const auto at = [&](int node) -> const Vec3& { return position[static_cast<size_t>(node)]; };
    for (const auto& s : segments) {
        if (s[2] == s[3]) {
            const Vec3 m = unit((at(s[0]) - at(s[2])).cross(at(s[1]) - at(s[2])));
            for (int j = 0; j < 3; ++j)
                sum[static_cast<size_t>(s[static_cast<size_t>(j)])] += m;
            continue;
        }
        const Vec3 center = (at(s[0]) + at(s[1]) + at(s[2]) + at(s[3])) / 4.0;
        for (size_t k = 0; k < 4; ++k) {
            const int first = s[k];
            const int second = s[(k + 1) % 4];
            const Vec3 m = unit((at(first) - center).cross(at(second) - center));
            sum[static_cast<size_t>(first)] += m;
            sum[static_cast<size_t>(second)] += m;
        }
    }
    for (Vec3& n : sum)
        n = unit(n);
    return sum;
}

ToolSurface::ToolSurface(const ContactModel& model, const Interface& interface)
    : segments_(model.surfaces[static_cast<size_t>(interface.main_surface)].segments) {
    const Vec3 center = model.rigid_bodies[static_cast<size_t>(interface.tool)].center;
    const auto& main = interface.main_nodes;
    position_.reserve(main.size());
    for (const int node : main)
        position_.emplace_back(model.nodes.position[static_cast<size_t>(node)] - center);
    local_.reserve(segments_.size());
    for (const Segment& segment : segments_) {
        std::array<int, 4> local{};
        for (size_t j = 0; j < 4; ++j) {
            local[j] = static_cast<int>(std::lower_bound(main.begin(), main.end(), segment.node[j]) - main.begin());
        }
        local_.push_back(local);
    }
    // A segment that stands in the surface twice counts once in the normals. As built: D41, where none is noted.
    const Surface& surface = model.surfaces[static_cast<size_t>(interface.main_surface)];
    std::vector<std::array<int, 4>> counted;
    counted.reserve(local_.size());
    for (size_t rank = 0; rank < local_.size(); ++rank)
        if (!surface.is_repeated(static_cast<int>(rank))) counted.push_back(local_[rank]);
    normal_ = nodal_normals(position_, counted);
    for (const Vec3& y : position_) {
        if (y.squaredNorm() > farthest_.squaredNorm()) farthest_ = y;
    }
}

SegmentShape<double> ToolSurface::shape(int segment) const {
    const auto& local = local_[static_cast<size_t>(segment)];
    SegmentShape<double> shape;
    for (size_t j = 0; j < 4; ++j) {
        shape.node[j] = position_[static_cast<size_t>(local[j])];
        shape.normal[j] = normal_[static_cast<size_t>(local[j])];
    }
    shape.triangle = segments_[static_cast<size_t>(segment)].is_triangle();
    return shape;
}

}  // namespace type21::reference
