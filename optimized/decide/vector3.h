/// @file Three doubles, and nothing that a compiler could reorder.
#pragma once

#include <algorithm>
#include <cmath>

#include "reference/model/vector.h"

namespace type21::optimized {

/// A vector in the tool frame. Plain members keep each sum in the order in which it is written, on every compiler.
struct V3 {
    double x = 0, y = 0, z = 0;

    double operator[](int i) const { return i == 0 ? x : (i == 1 ? y : z); }
    friend V3 operator+(const V3& p, const V3& q) { return {p.x + q.x, p.y + q.y, p.z + q.z}; }
    friend V3 operator-(const V3& p, const V3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
    friend V3 operator*(const V3& p, double f) { return {p.x * f, p.y * f, p.z * f}; }
    friend V3 operator*(double f, const V3& p) { return p * f; }
};

inline double dot(const V3& p, const V3& q) {
    return (p.x * q.x + p.y * q.y) + p.z * q.z;
}
inline V3 cross(const V3& p, const V3& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
/// Largest component in magnitude.
inline double largest(const V3& p) {
    return std::max(std::abs(p.x), std::max(std::abs(p.y), std::abs(p.z)));
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
inline bool finite(const V3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

}  // namespace type21::optimized
