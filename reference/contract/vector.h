/// @file Vectors of three components over any number type: double in a run, exact where a decision is made.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace type21 {

template <class Number>
using Vector = Eigen::Matrix<Number, 3, 1>;

using Vec3 = Vector<double>;
using Mat3 = Eigen::Matrix<double, 3, 3>;

}  // namespace type21
