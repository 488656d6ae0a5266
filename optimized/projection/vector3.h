/// @file Three doubles, and nothing that a compiler could reorder.
#pragma once

#include <algorithm>
#include <cmath>

#include "optimized/projection/two_doubles.h"
#include "reference/contract/vector.h"

namespace type21::optimized {

/// A vector in the tool frame. Plain members keep each sum in the order in which it is written, on every compiler.
template <class Real>
struct Triple {
    Real x{0}, y{0}, z{0};

    const Real& operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
    friend TYPE21_INLINE Triple operator+(const Triple& p, const Triple& q) {
        return {p.x + q.x, p.y + q.y, p.z + q.z};
    }
    friend TYPE21_INLINE Triple operator-(const Triple& p, const Triple& q) {
        return {p.x - q.x, p.y - q.y, p.z - q.z};
    }
    friend TYPE21_INLINE Triple operator*(const Triple& p, const Real& f) { return {p.x * f, p.y * f, p.z * f}; }
    friend TYPE21_INLINE Triple operator*(const Real& f, const Triple& p) { return p * f; }
};

using V3 = Triple<double>;

template <class Real>
TYPE21_INLINE Real dot(const Triple<Real>& p, const Triple<Real>& q) {
    return (p.x * q.x + p.y * q.y) + p.z * q.z;
}
template <class Real>
TYPE21_INLINE Triple<Real> cross(const Triple<Real>& p, const Triple<Real>& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
/// Largest component in magnitude.
template <class Real>
TYPE21_INLINE double largest(const Triple<Real>& p) {
    return std::max(std::abs(leading(p.x)), std::max(std::abs(leading(p.y)), std::abs(leading(p.z))));
}
inline double norm(const V3& p) {
    return std::sqrt(dot(p, p));
}
inline V3 from(const Vec3& v) {
    return {v[0], v[1], v[2]};
}
inline Vec3 to_vec3(const V3& v) {
    return {v.x, v.y, v.z};
}
}  // namespace type21::optimized
