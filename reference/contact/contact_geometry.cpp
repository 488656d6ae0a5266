#include "reference/contact/contact_geometry.h"

#include <cmath>
#include <limits>

namespace type21::reference {

namespace {

Vec3 weighted(const Vec3& a, const Vec3& b, const Vec3& c, const Barycentric<double>& w) {
    return b * w.b + c * w.c + a * (1.0 - w.b - w.c);
}

}  // namespace

ContactGeometry contact_geometry(const SubTriangle<double>& triangle, const Projection<double>& projection) {
    ContactGeometry geometry;
    const double length = projection.normal.norm();
    geometry.point = weighted(triangle.a, triangle.b, triangle.c, projection.weights);
    geometry.normal = projection.normal / length;
    geometry.distance = projection.height * length / projection.slope;
    return geometry;
}

ContactGeometry contact_geometry_as_built(const Vec3& p, const SubTriangle<double>& triangle,
                                          const Barycentric<double>& weights) {
    ContactGeometry geometry;
    geometry.point = weighted(triangle.a, triangle.b, triangle.c, weights);
    const Vec3 normal = weighted(triangle.normal_a, triangle.normal_b, triangle.normal_c, weights);
    const Vec3 h = p - geometry.point;
    const double sign = h.dot(normal) < 0 ? -1.0 : 1.0;
    const double length = h.norm();
    geometry.distance = sign * length;
    if (length > 0) geometry.normal = h * (sign / length);
    return geometry;
}

double geometric_penetration(double gap, double distance, const Vec3& y) {
    const double penetration = gap - distance;
    const double largest = y.cwiseAbs().maxCoeff();
    const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
    return penetration > 16.0 * ulp ? penetration : 0.0;
}

}  // namespace type21::reference
