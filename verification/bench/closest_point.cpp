#include "verification/bench/closest_point.h"

#include <algorithm>
#include <limits>

#include <Eigen/Geometry>

namespace type21::bench {

std::vector<std::array<Vec3, 3>> SurfaceMesh::triangles() const {
    std::vector<std::array<Vec3, 3>> out;
    for (const auto& s : segment) {
        const auto x = [&](size_t j) -> const Vec3& { return node[static_cast<size_t>(s[j])]; };
        if (s[2] == s[3]) {
            out.push_back({x(0), x(1), x(2)});
            continue;
        }
        const Vec3 center = 0.25 * (x(0) + x(1) + x(2) + x(3));
        for (size_t k = 0; k < 4; ++k)
            out.push_back({center, x(k), x((k + 1) % 4)});
    }
    return out;
}

// Inside the triangle where both weights and their rest are positive, else the nearest of the three edges.
double distance2_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d11 = ab.dot(ab), d12 = ab.dot(ac), d22 = ac.dot(ac), d1 = ab.dot(ap), d2 = ac.dot(ap);
    const double v = d22 * d1 - d12 * d2, w = d11 * d2 - d12 * d1, whole = d11 * d22 - d12 * d12;
    if (v >= 0 && w >= 0 && v + w <= whole && whole > 0)
        return (ap - ab * (v / whole) - ac * (w / whole)).squaredNorm();
    const auto edge = [](const Vec3& from, const Vec3& way) {
        const double length2 = way.squaredNorm();
        const double t = length2 > 0 ? std::clamp(from.dot(way) / length2, 0.0, 1.0) : 0.0;
        return (from - way * t).squaredNorm();
    };
    return std::min({edge(ap, ab), edge(ap, ac), edge(p - b, c - b)});
}

namespace {

class ByForce final : public ClosestPoint {
  public:
    explicit ByForce(const SurfaceMesh& mesh) : triangle_(mesh.triangles()) {
        for (size_t s = 0; s < mesh.segment.size(); ++s)
            segment_.insert(segment_.end(), mesh.segment[s][2] == mesh.segment[s][3] ? 1 : 4, static_cast<int>(s));
    }
    Nearest at(const Vec3& p) const override {
        Nearest best{std::numeric_limits<double>::infinity(), -1};
        for (size_t t = 0; t < triangle_.size(); ++t) {
            const double d2 = distance2_to_triangle(p, triangle_[t][0], triangle_[t][1], triangle_[t][2]);
            if (d2 < best.distance2) best = {d2, segment_[t]};
        }
        return best;
    }
    size_t bytes() const override { return triangle_.size() * sizeof(triangle_[0]) + segment_.size() * sizeof(int); }

  private:
    std::vector<std::array<Vec3, 3>> triangle_;
    std::vector<int> segment_;
};

}  // namespace

std::unique_ptr<ClosestPoint> closest_by_force(const SurfaceMesh& mesh) {
    return std::make_unique<ByForce>(mesh);
}

}  // namespace type21::bench
