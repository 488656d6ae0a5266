#include "optimized/projection/project_double.h"

#include "optimized/projection/a_priori_bounds.h"
#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

/// The columns from `at` on.
template <int W>
TYPE21_INLINE void project(ProjectionBatch& rows, const ProjectionRows& to, int at, const BatchLimits& limits) {
    using L = Lanes<W>;
    using I = IntegerLanes<L>;
    using V = VectorLanes<L>;
    V y, d0, d1, d2, d3, n0, n1, n2, n3;
    I code;
    load(to.y[0] + at, to.y[1] + at, to.y[2] + at, y);
    load(rows.corner[0][0] + at, rows.corner[0][1] + at, rows.corner[0][2] + at, d0);
    load(rows.corner[1][0] + at, rows.corner[1][1] + at, rows.corner[1][2] + at, d1);
    load(rows.corner[2][0] + at, rows.corner[2][1] + at, rows.corner[2][2] + at, d2);
    load(rows.corner[3][0] + at, rows.corner[3][1] + at, rows.corner[3][2] + at, d3);
    load(rows.normal[0][0] + at, rows.normal[0][1] + at, rows.normal[0][2] + at, n0);
    load(rows.normal[1][0] + at, rows.normal[1][1] + at, rows.normal[1][2] + at, n1);
    load(rows.normal[2][0] + at, rows.normal[2][1] + at, rows.normal[2][2] + at, n2);
    load(rows.normal[3][0] + at, rows.normal[3][1] + at, rows.normal[3][2] + at, n3);
    load(rows.code + at, code);
    const I odd = -(code & 1), late = -((code >> 1) & 1), triangle = -((code >> 2) & 1);
    const L zero = (L)(code ^ code);

    // o, A - o, n_A: a triangle has its third corner for all of them.
    V o = d0, center, na, far, u;
    choose(triangle, d2, o);
    minus(d0, o, d0);
    minus(d1, o, d1);
    minus(d2, o, d2);
    minus(d3, o, d3);
    L quarter = zero + 0.25;
    choose(triangle, zero, quarter);
    center.x = ((d1.x + d2.x) + d3.x) * quarter;
    center.y = ((d1.y + d2.y) + d3.y) * quarter;
    center.z = ((d1.z + d2.z) + d3.z) * quarter;
    na.x = ((n0.x + n1.x) + (n2.x + n3.x)) * 0.25;
    na.y = ((n0.y + n1.y) + (n2.y + n3.y)) * 0.25;
    na.z = ((n0.z + n1.z) + (n2.z + n3.z)) * 0.25;
    choose(triangle, n2, na);
    minus(y, o, far);
    minus(far, center, u);

    // B and C of sub-triangle k are corners k and k + 1.
    V b = d0, c = d1, nb = n0, nc = n1, b_late = d2, c_late = d3, nb_late = n2, nc_late = n3;
    choose(odd, d1, b);
    choose(odd, d2, c);
    choose(odd, n1, nb);
    choose(odd, n2, nc);
    choose(odd, d3, b_late);
    choose(odd, d0, c_late);
    choose(odd, n3, nb_late);
    choose(odd, n0, nc_late);
    choose(late, b_late, b);
    choose(late, c_late, c);
    choose(late, nb_late, nb);
    choose(late, nc_late, nc);

    V e1, e2, area, g1, g2;
    L square, height, sa, sb, sc;
    minus(b, center, e1);
    minus(c, center, e2);
    cross_of(e1, e2, area);
    dot_of(area, area, square);
    const L of_square = 1.0 / square;
    cross_of(e2, area, g1);
    scale(g1, of_square);
    cross_of(area, e1, g2);
    scale(g2, of_square);
    dot_of(u, area, height);
    dot_of(na, area, sa);
    dot_of(nb, area, sb);
    dot_of(nc, area, sc);

    L px, py, xa, ya, xb, yb, xc, yc;
    dot_of(u, g1, px);
    dot_of(u, g2, py);
    dot_of(na, g1, xa);
    dot_of(na, g2, ya);
    dot_of(nb, g1, xb);
    dot_of(nb, g2, yb);
    dot_of(nc, g1, xc);
    dot_of(nc, g2, yc);
    const L ra = height / sa, rb = height / sb, rc = height / sc;
    const L ax = ra * xa - px, ay = ra * ya - py;
    const L bx = (1.0 + rb * xb) - px, by = rb * yb - py;
    const L cx = rc * xc - px, cy = (1.0 + rc * yc) - py;
    const L wa = bx * cy - by * cx;
    const L wb = cx * ay - cy * ax;
    const L wc = ax * by - ay * bx;
    const L total = wa + wb + wc;
    const L inverse = 1.0 / total;
    const L b1 = wb * inverse, c1 = wc * inverse, a1 = wa * inverse;
    const L slope = a1 * sa + b1 * sb + c1 * sc;
    const L lift = height / slope;
    const L nx = a1 * xa + b1 * xb + c1 * xc;
    const L ny = a1 * ya + b1 * yb + c1 * yc;
    const L shift_x = nx * lift, shift_y = ny * lift;
    const L final_b = px - shift_x, final_c = py - shift_y;
    V n, x;
    n.x = (na.x * a1 + nb.x * b1) + nc.x * c1;
    n.y = (na.y * a1 + nb.y * b1) + nc.y * c1;
    n.z = (na.z * a1 + nb.z * b1) + nc.z * c1;
    x.x = o.x + (center.x + (e1.x * final_b + e2.x * final_c));
    x.y = o.y + (center.y + (e1.y * final_b + e2.y * final_c));
    x.z = o.z + (center.z + (e1.z * final_b + e2.z * final_c));

    store(final_b, to.b + at);
    store(final_c, to.c + at);
    store(lift, to.lift + at);
    store(n, to.n[0] + at, to.n[1] + at, to.n[2] + at);
    store(x, to.x[0] + at, to.x[1] + at, to.x[2] + at);
    store(a1, rows.weight[0] + at);
    store(b1, rows.weight[1] + at);
    store(c1, rows.weight[2] + at);
    store(total, rows.total + at);
    store(height, rows.height + at);
    store(square, rows.square + at);
    store(px, rows.p + at);
    store(py, rows.q + at);
    L farthest, other;
    magnitude_of(far.x, farthest);
    magnitude_of(far.y, other);
    most_of(other, farthest);
    magnitude_of(far.z, other);
    most_of(other, farthest);
    store(farthest, rows.far + at);

    // Does this projection alone decide? NaN compares false everywhere.
    L margin, size, gap, p_size, q_size, normal_square;
    load(rows.exclusive_margin + at, margin);
    load(rows.size + at, size);
    load(to.gap + at, gap);
    magnitude_of(px, p_size);
    magnitude_of(py, q_size);
    dot_of(n, n, normal_square);
    L inner = a1, least = (1.0 - final_b) - final_c;
    least_of(b1, inner);
    least_of(c1, inner);
    least_of(final_b, least);
    least_of(final_c, least);
    const L rounding = a_priori_share * size;
    const L height2 = height * height, enlarged = height2 * (1 + 1e-9);
    const I behind = (I)height >> 63;
    L limit = zero + limits.outward, reach = gap;
    choose(behind, zero + limits.inward, limit);
    choose(behind, zero + limits.depth, reach);
    const L distance2 = lift * lift * normal_square;
    // Clipping weights >= -w, w <= 0.01, moves the point by at most half of the weights' change, 4.04 w, times an edge;
    // an edge is at most 2 sqrt(3) times the extent, which is less than the size.
    L clipped = 2.0 * decision_margin - least;
    most_of(zero, clipped);
    const L unsure = 2.0 * rounding + 7.1 * clipped * size;
    const L nearer = reach - unsure, farther = reach + unsure;
    // Conditions are counted: GCC takes apart what joins several comparisons.
    const L one = zero + 1.0;
    L sure = farthest <= size ? one : zero;
    sure += p_size <= 4.0 ? one : zero;
    sure += q_size <= 4.0 ? one : zero;
    sure += total >= 0.5 ? one : zero;
    sure += height2 > 4.0 * rounding * rounding * square ? one : zero;
    sure += enlarged < limit * limit * square ? one : zero;
    L met = sure;
    met += inner >= margin + a_priori_share ? one : zero;
    met += least >= sure_weight ? one : zero;
    // Without step 3 where step 2 rejects.
    const L lowest = inner < sure_weight ? inner : least;
    L rejected = sure;
    rejected += lowest < weight_limit - decision_margin ? one : zero;
    rejected += margin < double(not_a_priori_bounded) ? one : zero;
    store(rejected == 8.0 ? one : zero, rows.rejected + at);
    L touched = distance2 < nearer * nearer ? one : zero;
    touched += nearer > 0.0 ? one : zero;
    L certain = touched + met == 10.0 ? one : zero;
    L beyond = zero + limits.proximity;
    choose(behind, zero, beyond);
    beyond += unsure;
    most_of(farther, beyond);
    const L missed = distance2 > beyond * beyond ? zero + 10.0 : zero;
    certain -= missed + met == 18.0 ? one : zero;
    store(limits.decide ? certain : zero, rows.certain + at);
}

template <int W>
TYPE21_INLINE void project_all(ProjectionBatch& rows, const ProjectionRows& to, int first, int last,
                               const BatchLimits& limits) {
    for (int at = first; at < last; at += W)
        project<W>(rows, to, at, limits);
}

TYPE21_AVX512 void project_eight(ProjectionBatch& rows, const ProjectionRows& to, int first, int last,
                                 const BatchLimits& limits) {
    project_all<8>(rows, to, first, last, limits);
}
TYPE21_AVX2 void project_four(ProjectionBatch& rows, const ProjectionRows& to, int first, int last,
                              const BatchLimits& limits) {
    project_all<4>(rows, to, first, last, limits);
}
void project_two(ProjectionBatch& rows, const ProjectionRows& to, int first, int last, const BatchLimits& limits) {
    project_all<2>(rows, to, first, last, limits);
}

}  // namespace

void project_double(ProjectionBatch& rows, int first, int last, const BatchLimits& limits, SimdWidth machine) {
    project_double(rows, rows_from(rows, 0), first, last, limits, machine);
}

void project_double(ProjectionBatch& rows, const ProjectionRows& to, int first, int last, const BatchLimits& limits,
                    SimdWidth machine) {
    compiled_for(machine, project_eight, project_four, project_two)(rows, to, first, last, limits);
}

namespace {

/// Q relative to o.
V3 local_point_at(const SegmentData& segment, int triangle, double b, double c) {
    const V3& o = segment.node[segment.is_triangle ? 2 : 0];
    const SubTriangleCorners corner = sub_triangle_corners(segment.is_triangle, triangle);
    std::array<V3, 4> local;
    for (size_t j = 0; j < 4; ++j)
        local[j] = segment.node[j] - o;
    const V3 center = ((local[1] + local[2]) + local[3]) * (segment.is_triangle ? 0.0 : 0.25);
    const V3 e1 = local[static_cast<size_t>(corner.b)] - center, e2 = local[static_cast<size_t>(corner.c)] - center;
    return center + (e1 * b + e2 * c);
}

}  // namespace

V3 point_at(const SegmentData& segment, int triangle, double b, double c) {
    return segment.node[segment.is_triangle ? 2 : 0] + local_point_at(segment, triangle, b, c);
}

V3 offset_from_point(const V3& y, const SegmentData& segment, int triangle, double b, double c) {
    return (y - segment.node[segment.is_triangle ? 2 : 0]) - local_point_at(segment, triangle, b, c);
}

}  // namespace type21::optimized
