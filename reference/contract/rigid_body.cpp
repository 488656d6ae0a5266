#include "rigid_body.h"

#include <Eigen/Eigenvalues>

namespace type21 {

double smallest_inertia(const Mat3& inertia) {
    return Eigen::SelfAdjointEigenSolver<Mat3>(inertia, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

double inertia_about(const Mat3& inertia, const Vec3& axis) {
    const double length = axis.stableNorm();
    if (!(length > 0)) return 0;
    const Vec3 unit = axis / length;
    return unit.dot(inertia * unit);
}

}  // namespace type21
