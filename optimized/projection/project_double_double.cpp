#include "optimized/projection/project_double_double.h"

#include "optimized/simd/two_lanes.h"

namespace type21::optimized {

namespace {

template <class Real>
struct DoubleDoubleVector {
    Real x, y, z;
    friend TYPE21_INLINE DoubleDoubleVector operator+(const DoubleDoubleVector& p, const DoubleDoubleVector& q) {
        return {p.x + q.x, p.y + q.y, p.z + q.z};
    }
    friend TYPE21_INLINE DoubleDoubleVector operator-(const DoubleDoubleVector& p, const DoubleDoubleVector& q) {
        return {p.x - q.x, p.y - q.y, p.z - q.z};
    }
    friend TYPE21_INLINE DoubleDoubleVector operator*(const DoubleDoubleVector& p, const Real& f) {
        return {p.x * f, p.y * f, p.z * f};
    }
};
template <class Real>
TYPE21_INLINE Real dot(const DoubleDoubleVector<Real>& p, const DoubleDoubleVector<Real>& q) {
    return (p.x * q.x + p.y * q.y) + p.z * q.z;
}
template <class Real>
TYPE21_INLINE DoubleDoubleVector<Real> cross(const DoubleDoubleVector<Real>& p, const DoubleDoubleVector<Real>& q) {
    return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
template <class I, class Real>
TYPE21_INLINE void choose_vector(const I& mask, const DoubleDoubleVector<Real>& p, DoubleDoubleVector<Real>& r) {
    choose(mask, p.x.high, r.x.high);
    choose(mask, p.x.low, r.x.low);
    choose(mask, p.y.high, r.y.high);
    choose(mask, p.y.low, r.y.low);
    choose(mask, p.z.high, r.z.high);
    choose(mask, p.z.low, r.z.low);
}

template <int W, bool fused>
TYPE21_INLINE void project(const ProjectionBatch& rows, int at, KappaRows& kappa) {
    using L = Lanes<W>;
    using I = IntegerLanes<L>;
    using Real = TwoLanes<L, fused>;
    using V = DoubleDoubleVector<Real>;
    I code;
    load(rows.code + at, code);
    const I odd = -(code & 1), late = -((code >> 1) & 1), triangle = -((code >> 2) & 1);
    const L zero = (L)(code ^ code);
    const auto fetch = [&](const double(*row)[ProjectionBatch::capacity], V& v) __attribute__((always_inline)) {
        load(row[0] + at, v.x.high);
        load(row[1] + at, v.y.high);
        load(row[2] + at, v.z.high);
        v.x.low = v.y.low = v.z.low = zero;
    };
    Real one, quarter, third;
    one.high = zero + 1.0;
    one.low = zero;
    quarter.high = zero + 0.25;
    quarter.low = zero;
    third.high = zero + 0x1.5555555555555p-2;
    third.low = zero + 0x1.5555555555555p-56;
    V y, d0, d1, d2, d3, n0, n1, n2, n3;
    fetch(rows.y, y);
    fetch(rows.corner[0], d0);
    fetch(rows.corner[1], d1);
    fetch(rows.corner[2], d2);
    fetch(rows.corner[3], d3);
    fetch(rows.normal[0], n0);
    fetch(rows.normal[1], n1);
    fetch(rows.normal[2], n2);
    fetch(rows.normal[3], n3);

    // o, A - o, n_A: a triangle has its third corner for all of them.
    V o = d0, center, none, na;
    none.x.high = none.x.low = none.y.high = none.y.low = none.z.high = none.z.low = zero;
    choose_vector(triangle, d2, o);
    d0 = d0 - o;
    d1 = d1 - o;
    d2 = d2 - o;
    d3 = d3 - o;
    center = (d1 + d2 + d3) * quarter;
    choose_vector(triangle, none, center);
    na = ((n0 + n1) + (n2 + n3)) * quarter;
    choose_vector(triangle, n2, na);
    const V u = (y - o) - center;
    V b = d0, c = d1, nb = n0, nc = n1, b_late = d2, c_late = d3, nb_late = n2, nc_late = n3;
    choose_vector(odd, d1, b);
    choose_vector(odd, d2, c);
    choose_vector(odd, n1, nb);
    choose_vector(odd, n2, nc);
    choose_vector(odd, d3, b_late);
    choose_vector(odd, d0, c_late);
    choose_vector(odd, n3, nb_late);
    choose_vector(odd, n0, nc_late);
    choose_vector(late, b_late, b);
    choose_vector(late, c_late, c);
    choose_vector(late, nb_late, nb);
    choose_vector(late, nc_late, nc);

    const V e1 = b - center, e2 = c - center;
    const V area = cross(e1, e2);
    const Real of_square = one / dot(area, area);
    const V g1 = cross(e2, area) * of_square, g2 = cross(area, e1) * of_square;
    const Real height = dot(u, area);
    const Real sa = dot(na, area), sb = dot(nb, area), sc = dot(nc, area);
    const Real px = dot(u, g1), py = dot(u, g2);
    const Real xa = dot(na, g1), ya = dot(na, g2);
    const Real xb = dot(nb, g1), yb = dot(nb, g2);
    const Real xc = dot(nc, g1), yc = dot(nc, g2);
    const Real ra = height / sa, rb = height / sb, rc = height / sc;
    const Real ax = ra * xa - px, ay = ra * ya - py;
    const Real bx = (one + rb * xb) - px, by = rb * yb - py;
    const Real cx = rc * xc - px, cy = (one + rc * yc) - py;
    const Real wa = bx * cy - by * cx;
    const Real wb = cx * ay - cy * ax;
    const Real wc = ax * by - ay * bx;
    const Real inverse = one / (wa + wb + wc);
    const Real b1 = wb * inverse, c1 = wc * inverse, a1 = wa * inverse;
    const Real slope = a1 * sa + b1 * sb + c1 * sc;
    const Real lift = height / slope;
    const Real nx = a1 * xa + b1 * xb + c1 * xc;
    const Real ny = a1 * ya + b1 * yb + c1 * yc;
    const Real final_b = px - nx * lift, final_c = py - ny * lift;
    const Real result =
        magnitude(third - final_b) + magnitude(third - final_c) + magnitude(third + third - final_b - final_c);
    store(result.high, kappa.high + at);
    store(result.low, kappa.low + at);
}

TYPE21_AVX512 void project_eight(const ProjectionBatch& rows, int count, KappaRows& kappa) {
    for (int at = 0; at < count; at += 8)
        project<8, true>(rows, at, kappa);
}
TYPE21_FMA void project_four(const ProjectionBatch& rows, int count, KappaRows& kappa) {
    for (int at = 0; at < count; at += 4)
        project<4, true>(rows, at, kappa);
}
void project_two(const ProjectionBatch& rows, int count, KappaRows& kappa) {
    for (int at = 0; at < count; at += 2)
        project<2, false>(rows, at, kappa);
}

}  // namespace

void project_double_double(const ProjectionBatch& rows, int count, KappaRows& kappa, SimdWidth machine) {
    const auto four = has_fma() ? project_four : project_two;
    compiled_for(machine, project_eight, four, project_two)(rows, count, kappa);
}

}  // namespace type21::optimized
