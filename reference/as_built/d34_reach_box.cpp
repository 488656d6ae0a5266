#include "reference/as_built/d34_reach_box.h"

#include <Eigen/Eigenvalues>

namespace type21::reference::as_built {

bool in_reach_box(const Vec3& y, const SegmentShape<double>& segment, const Mat3& axes, double reach, double depth) {
    Eigen::AlignedBox3d box;
    for (size_t j = 0; j < 4; ++j) {
        const Vec3 corner = axes.transpose() * segment.node[j];
        const Vec3 normal = axes.transpose() * segment.normal[j];
        box.extend(Vec3(corner + reach * normal));
        box.extend(Vec3(corner - depth * normal));
    }
    const Vec3 growth = 0.01 * box.sizes();
    box.min() -= growth;
    box.max() += growth;
    return box.contains(Vec3(axes.transpose() * y));
}

Mat3 reach_box_axes(const RigidBody& tool, bool tool_rotates) {
    if (!tool_rotates) return Mat3::Identity();
    return Eigen::SelfAdjointEigenSolver<Mat3>(tool.inertia).eigenvectors();
}

}  // namespace type21::reference::as_built
