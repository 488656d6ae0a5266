/// @file What Eigen has to know of our number types: real, not integers, made by a constructor.
#pragma once

#include <Eigen/Core>

namespace type21::reference {

template <class Number>
struct FieldTraits : Eigen::GenericNumTraits<Number> {
    using Real = Number;
    using NonInteger = Number;
    using Nested = Number;
    using Literal = double;
    enum {
        IsInteger = 0,
        IsSigned = 1,
        IsComplex = 0,
        RequireInitialization = 1,
        ReadCost = 2,
        AddCost = 8,
        MulCost = 16
    };
};

}  // namespace type21::reference
