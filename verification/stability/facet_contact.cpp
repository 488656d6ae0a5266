#include "verification/stability/facet_contact.h"

#include <algorithm>
#include <limits>

#include "verification/stability/long_run_scene.h"

namespace type21::stability {
namespace {

Vec3 nearest_on_edge(const Vec3& p, const Vec3& from, const Vec3& to) {
    const Vec3 edge = to - from;
    return from + std::clamp((p - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0) * edge;
}

}  // namespace

/// The foot of the perpendicular if it lies inside, else the nearest point of the three edges.
Vec3 nearest_point(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = (b - a).cross(c - a);
    const Vec3 foot = p - normal * ((p - a).dot(normal) / normal.squaredNorm());
    const auto left_of = [&](const Vec3& from, const Vec3& to) {
        return (to - from).cross(foot - from).dot(normal) >= 0;
    };
    if (left_of(a, b) && left_of(b, c) && left_of(c, a)) return foot;
    Vec3 nearest = nearest_on_edge(p, a, b);
    for (const Vec3& other : {nearest_on_edge(p, b, c), nearest_on_edge(p, c, a)}) {
        if ((other - p).squaredNorm() < (nearest - p).squaredNorm()) nearest = other;
    }
    return nearest;
}

FacetContact::FacetContact(const SurfaceMesh& tool) {
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        facets_.push_back({a, b, c, (b - a).cross(c - a).normalized()});
    };
    for (const auto& s : tool.segment) {
        const auto at = [&](size_t j) -> const Vec3& { return tool.node[static_cast<size_t>(s[j])]; };
        if (s[2] == s[3]) {
            add(at(0), at(1), at(2));
            continue;
        }
        const Vec3 middle = (at(0) + at(1) + at(2) + at(3)) / 4.0;
        for (size_t k = 0; k < 4; ++k)
            add(middle, at(k), at((k + 1) % 4));
    }
}

FacetForce FacetContact::at(const Vec3& x, const Vec3& travel, double friction) const {
    double least = std::numeric_limits<double>::infinity();
    FacetForce force;
    for (const Facet& facet : facets_) {
        const Vec3 offset = x - nearest_point(x, facet.a, facet.b, facet.c);
        if (offset.squaredNorm() >= least) continue;
        least = offset.squaredNorm();
        const double penetration = std::max(0.0, gap - offset.dot(facet.normal));
        const Vec3 along = travel - facet.normal * travel.dot(facet.normal);
        force.normal = stiffness * penetration * facet.normal;
        force.friction =
            along.norm() > 0 ? Vec3(friction * stiffness * penetration * along.normalized()) : Vec3(Vec3::Zero());
    }
    return force;
}

}  // namespace type21::stability
