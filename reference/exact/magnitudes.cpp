#include "reference/exact/magnitudes.h"

#include <algorithm>
#include <cmath>

#include "reference/exact/impact_enclosure.h"

namespace type21::reference {

bool close_enough(const Projection<Bounded>& projection, double largest) {
    const auto& [b, c] = projection.weights;
    if (!(std::max(b.error(), c.error()) <= MagnitudeLimits::weights)) return false;
    Vec3 normal, error;
    for (int i = 0; i < 3; ++i) {
        normal[i] = projection.normal[i].value();
        error[i] = projection.normal[i].error();
    }
    const double length = normal.norm();
    const double turned = error.norm() / length;
    if (!(turned <= MagnitudeLimits::weights)) return false;
    const Bounded along = projection.height / projection.slope;  // delta / |n|; the slope is known to be positive
    const double distance = (along.error() + std::abs(along.value()) * turned) * length;
    return distance <= MagnitudeLimits::distance * largest;
}

bool close_enough(const ContactQuery& query, const SegmentShape<double>& shape, int k) {
    const ProjectionLimits<Bounded> no_limits{Bounded(-1e300), Bounded(1e300), query.lift_leaning};
    try {
        const auto projection =
            project(convert_to<Bounded>(query.point), sub_triangle(convert_to<Bounded>(shape), k), no_limits);
        return projection && close_enough(*projection, largest_length(query.point, shape));
    } catch (const Undecided&) {
        return false;
    }
}

double largest_length(const Vec3& point, const SegmentShape<double>& shape) {
    double largest = point.cwiseAbs().maxCoeff();
    for (const Vec3& node : shape.node)
        largest = std::max(largest, node.cwiseAbs().maxCoeff());
    return largest;
}

}  // namespace type21::reference
