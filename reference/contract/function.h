/// @file Functions of one variable (/FUNCT).
#pragma once

#include <string>
#include <vector>

#include "mesh.h"

namespace type21 {

/// Piecewise linear, extrapolated linearly beyond both ends; one point is a constant.
struct Function {
    Id id = 0;
    std::string title;
    std::vector<double> x;  ///< ascending
    std::vector<double> y;

    /// @return the ordinate; 0 for a function without points.  Formulation 9, step 1.
    double operator()(double abscissa) const;
};

}  // namespace type21
