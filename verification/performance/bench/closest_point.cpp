#include "verification/performance/bench/closest_point.h"

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

// By the region in which the foot of p lies: corner, edge or face (C. Ericson, Real-time collision detection, 5.1.5).
double distance2_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0 && d2 <= 0) return ap.squaredNorm();
    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0 && d4 <= d3) return bp.squaredNorm();
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - ab * (d1 / (d1 - d3))).squaredNorm();
    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0 && d5 <= d6) return cp.squaredNorm();
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - ac * (d2 / (d2 - d6))).squaredNorm();
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 >= d3 && d5 >= d6) return (bp - (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)))).squaredNorm();
    const double inverse = 1 / (va + vb + vc);
    return (ap - ab * (vb * inverse) - ac * (vc * inverse)).squaredNorm();
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
