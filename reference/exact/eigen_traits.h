/// @file What Eigen needs to know about these number types: they are real, not integers, and need their constructor.
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
