#include "verification/decisions/question_families/tool_shapes.h"

#include <utility>

#include <Eigen/Geometry>

#include "verification/support/scene_builder.h"

namespace type21 {

DecisionTool sheet(int columns, int rows, const Place& place) {
    SurfaceMesh mesh = grid(columns, rows, place);
    DecisionTool tool{std::move(mesh.node), {}, std::move(mesh.segment)};
    tool.normal.assign(tool.node.size(), Vec3::Zero());
    return tool;
}

DecisionTool drawn_profile(int columns, int rows, double pitch, const std::function<Vec3(int)>& profile) {
    return sheet(columns, rows, [&](int i, int j) {
        const Vec3 p = profile(i);
        return Vec3(p.x(), pitch * j, p.z());
    });
}

void halve_quads(DecisionTool& tool, Draw& draw, double share) {
    std::vector<std::array<int, 4>> pieces;
    for (const auto& corner : tool.segment) {
        const bool quad = corner[2] != corner[3];
        if (!quad || !draw.chance(share)) {
            pieces.push_back(corner);
        } else if (draw.chance(0.5)) {
            pieces.push_back({corner[0], corner[1], corner[2], corner[2]});
            pieces.push_back({corner[0], corner[2], corner[3], corner[3]});
        } else {
            pieces.push_back({corner[0], corner[1], corner[3], corner[3]});
            pieces.push_back({corner[1], corner[2], corner[3], corner[3]});
        }
    }
    tool.segment = std::move(pieces);
}

void append(DecisionTool& tool, const DecisionTool& other) {
    const int first = static_cast<int>(tool.node.size());
    tool.node.insert(tool.node.end(), other.node.begin(), other.node.end());
    tool.normal.insert(tool.normal.end(), other.normal.begin(), other.normal.end());
    for (const auto& corner : other.segment)
        tool.segment.push_back({first + corner[0], first + corner[1], first + corner[2], first + corner[3]});
}

namespace {

/// Unit normal of (a, b, c), zero without area. The edges are scaled first: their product may overflow or vanish.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    return unit_vector(unit_vector(b - a).cross(unit_vector(c - a)));
}

}  // namespace

void set_normals(DecisionTool& tool) {
    tool.normal.assign(tool.node.size(), Vec3::Zero());
    for (const auto& corner : tool.segment) {
        const auto x = [&](size_t j) { return tool.node[static_cast<size_t>(corner[j])]; };
        const auto add = [&](size_t j, const Vec3& n) { tool.normal[static_cast<size_t>(corner[j])] += n; };
        if (corner[2] == corner[3]) {
            const Vec3 n = unit_normal(x(2), x(0), x(1));
            for (size_t j = 0; j < 3; ++j)
                add(j, n);
            continue;
        }
        const Vec3 centre = 0.25 * x(0) + 0.25 * x(1) + 0.25 * x(2) + 0.25 * x(3);
        for (size_t j = 0; j < 4; ++j) {
            const Vec3 n = unit_normal(centre, x(j), x((j + 1) % 4));
            add(j, n);
            add((j + 1) % 4, n);
        }
    }
    for (Vec3& n : tool.normal)
        n = unit_vector(n);
}

void place_at(DecisionTool& tool, double scale, const Vec3& offset) {
    for (Vec3& x : tool.node)
        x = offset + scale * x;
}

}  // namespace type21
