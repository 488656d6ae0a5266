#include "reference/contact/contact_geometry.h"

#include <cmath>
#include <limits>

namespace type21::reference {

Vec3 interpolated(const Vec3& a, const Vec3& b, const Vec3& c, const Barycentric<double>& w) {
    return b * w.b + c * w.c + a * (1.0 - w.b - w.c);
}

ContactGeometry contact_geometry(const SubTriangle<double>& triangle, const Projection<double>& projection) {
    ContactGeometry geometry;
    const double length = projection.normal.norm();
    geometry.point = interpolated(triangle.a, triangle.b, triangle.c, projection.weights);
    geometry.normal = projection.normal / length;
    geometry.distance = projection.height * length / projection.slope;
    return geometry;
}

ContactGeometry contact_geometry(const RetainedProjection& retained) {
    return contact_geometry(sub_triangle(retained.segment, retained.triangle), retained.projection);
}

double geometric_penetration(double gap, double distance, const Vec3& y) {
    const double penetration = gap - distance;
    const double largest = y.cwiseAbs().maxCoeff();
    const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
    return penetration > 16.0 * ulp ? penetration : 0.0;
}

}  // namespace type21::reference
