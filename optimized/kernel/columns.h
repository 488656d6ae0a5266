/// @file Numbers of nodes between arrays and rows: vectors stand in arrays one after the other, and in rows by
/// components.
#pragma once

#include <array>
#include <span>

#include "optimized/projection/vector3.h"
#include "optimized/simd/simd_width.h"
#include "reference/contract/vector.h"

namespace type21::optimized {

/// The components of several vectors.
using Components = std::array<double*, 3>;
using ConstComponents = std::array<const double*, 3>;

/// from[0], from[1], ... into rows.
void into_rows(const V3* from, int count, const Components& to, SimdWidth machine = this_machine());
/// from[index[0]], from[index[1]], ... into rows; indices are mostly consecutive.
void into_rows(std::span<const Vec3> from, const int* index, int count, const Components& to,
               SimdWidth machine = this_machine());
/// The other way.
void from_rows(const ConstComponents& from, int count, V3* to, SimdWidth machine = this_machine());
void from_rows(const ConstComponents& from, int count, Vec3* to, SimdWidth machine = this_machine());

template <size_t capacity>
void into_rows(const V3* from, int count, double (&to)[3][capacity]) {
    into_rows(from, count, Components{to[0], to[1], to[2]});
}
template <size_t capacity>
void into_rows(std::span<const Vec3> from, const int* index, int count, double (&to)[3][capacity]) {
    into_rows(from, index, count, Components{to[0], to[1], to[2]});
}
template <class Vector, size_t capacity>
void from_rows(const double (&from)[3][capacity], int count, Vector* to) {
    from_rows(ConstComponents{from[0], from[1], from[2]}, count, to);
}

}  // namespace type21::optimized
