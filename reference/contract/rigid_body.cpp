#include "rigid_body.h"

#include <Eigen/Eigenvalues>

namespace type21 {

double smallest_inertia(const Mat3& inertia) {
    return Eigen::SelfAdjointEigenSolver<Mat3>(inertia, Eigen::EigenvaluesOnly).eigenvalues().minCoeff();
}

}  // namespace type21
