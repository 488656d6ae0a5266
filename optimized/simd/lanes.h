/// @file Several doubles at once, one in each lane of a register.
#pragma once

#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// W doubles. Operators act lane by lane. A comparison is written inside the choice that it decides, p < q ? r : s. GCC
/// splits a comparison that is a variable, or that two choices share. Masks that are needed more than once are made of
/// bits.
template <int W>
struct LanesOf {
    typedef double Real __attribute__((vector_size(W * sizeof(double))));
    typedef long long Integer __attribute__((vector_size(W * sizeof(double))));
};
template <int W>
using Lanes = typename LanesOf<W>::Real;
/// As many integers of 64 bits.
template <class L>
using IntegerLanes = typename LanesOf<sizeof(L) / sizeof(double)>::Integer;

template <class L, class Number>
TYPE21_INLINE void load(const Number* from, L& to) {
    static_assert(sizeof(Number) == sizeof(double));
    __builtin_memcpy(&to, from, sizeof(to));
}
template <class L, class Number>
TYPE21_INLINE void store(const L& from, Number* to) {
    static_assert(sizeof(Number) == sizeof(double));
    __builtin_memcpy(to, &from, sizeof(from));
}
template <class L>
TYPE21_INLINE void root_of(const L& v, L& r) {
    constexpr int width = sizeof(L) / sizeof(double);
    double in[width], out[width];
    store(v, in);
    for (int j = 0; j < width; ++j)
        out[j] = __builtin_sqrt(in[j]);
    load(out, r);
}
template <class L>
TYPE21_INLINE void magnitude_of(const L& v, L& r) {
    r = (L)((IntegerLanes<L>)v & 0x7fffffffffffffff);
}
template <class L>
TYPE21_INLINE void least_of(const L& p, L& r) {
    r = p < r ? p : r;
}
template <class L>
TYPE21_INLINE void most_of(const L& p, L& r) {
    r = p > r ? p : r;
}

/// A vector in each lane. Results are last arguments, since a register wider than the baseline cannot be returned.
template <class L>
struct VectorLanes {
    L x, y, z;
};
template <class L>
TYPE21_INLINE void load(const double* x, const double* y, const double* z, VectorLanes<L>& to) {
    load(x, to.x);
    load(y, to.y);
    load(z, to.z);
}
template <class L>
TYPE21_INLINE void store(const VectorLanes<L>& from, double* x, double* y, double* z) {
    store(from.x, x);
    store(from.y, y);
    store(from.z, z);
}
template <class L>
TYPE21_INLINE void minus(const VectorLanes<L>& p, const VectorLanes<L>& q, VectorLanes<L>& r) {
    r.x = p.x - q.x;
    r.y = p.y - q.y;
    r.z = p.z - q.z;
}
template <class L>
TYPE21_INLINE void scale(VectorLanes<L>& p, const L& f) {
    p.x *= f;
    p.y *= f;
    p.z *= f;
}
template <class L>
TYPE21_INLINE void cross_of(const VectorLanes<L>& p, const VectorLanes<L>& q, VectorLanes<L>& r) {
    r.x = p.y * q.z - p.z * q.y;
    r.y = p.z * q.x - p.x * q.z;
    r.z = p.x * q.y - p.y * q.x;
}
template <class L>
TYPE21_INLINE void dot_of(const VectorLanes<L>& p, const VectorLanes<L>& q, L& r) {
    r = (p.x * q.x + p.y * q.y) + p.z * q.z;
}
/// mask ? p : r in bits; a mask is all ones or all zeros.
template <class I, class L>
TYPE21_INLINE void choose(const I& mask, const L& p, L& r) {
    r = (L)(((I)p & mask) | ((I)r & ~mask));
}
template <class I, class L>
TYPE21_INLINE void choose(const I& mask, const VectorLanes<L>& p, VectorLanes<L>& r) {
    choose(mask, p.x, r.x);
    choose(mask, p.y, r.y);
    choose(mask, p.z, r.z);
}

/// M v; M^T v with `transposed`.
template <bool transposed, class L>
TYPE21_INLINE void turn(const double (&m)[3][3], const VectorLanes<L>& v, VectorLanes<L>& r) {
    const auto entry = [&](int i, int j) __attribute__((always_inline)) {
        return transposed ? m[j][i] : m[i][j];
    };
    r.x = (entry(0, 0) * v.x + entry(0, 1) * v.y) + entry(0, 2) * v.z;
    r.y = (entry(1, 0) * v.x + entry(1, 1) * v.y) + entry(1, 2) * v.z;
    r.z = (entry(2, 0) * v.x + entry(2, 1) * v.y) + entry(2, 2) * v.z;
}

}  // namespace type21::optimized
