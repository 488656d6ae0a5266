#include "optimized/decide/plain_landing.h"

#include "optimized/machine.h"

namespace type21::optimized {

namespace {

using Vector = Triple<Lanes>;

TYPE21_INLINE void load(const double* from, Lanes& to) {
    __builtin_memcpy(&to, from, sizeof(to));
}
TYPE21_INLINE void store(const Lanes& from, double* to) {
    __builtin_memcpy(to, &from, sizeof(from));
}
TYPE21_INLINE void load(const double (*from)[lanes], Vector& to) {
    load(from[0], to.x);
    load(from[1], to.y);
    load(from[2], to.z);
}
TYPE21_INLINE void minus(const Vector& p, const Vector& q, Vector& r) {
    r.x = p.x - q.x;
    r.y = p.y - q.y;
    r.z = p.z - q.z;
}
TYPE21_INLINE void scale(Vector& p, const Lanes& f) {
    p.x *= f;
    p.y *= f;
    p.z *= f;
}
TYPE21_INLINE void cross_of(const Vector& p, const Vector& q, Vector& r) {
    r.x = p.y * q.z - p.z * q.y;
    r.y = p.z * q.x - p.x * q.z;
    r.z = p.x * q.y - p.y * q.x;
}
TYPE21_INLINE void dot_of(const Vector& p, const Vector& q, Lanes& r) {
    r = (p.x * q.x + p.y * q.y) + p.z * q.z;
}
TYPE21_INLINE void least_of(const Lanes& p, Lanes& r) {
    r = p < r ? p : r;
}
TYPE21_INLINE void most_magnitude(const Lanes& p, Lanes& r) {
    const Lanes size = p < 0 ? -p : p;
    r = size > r ? size : r;
}

}  // namespace

TYPE21_FOR_EACH_MACHINE
void plain_landing(PlainRows& rows) {
    using R = PlainRows;
    Vector p, o, x1, x2, x3, b, c, l1, l2, l3, l4, na, nb, nc;
    load(rows.in + R::px, p);
    load(rows.in + R::ox, o);
    load(rows.in + R::x1, x1);
    load(rows.in + R::x2, x2);
    load(rows.in + R::x3, x3);
    load(rows.in + R::bx, b);
    load(rows.in + R::cx, c);
    load(rows.in + R::l1x, l1);
    load(rows.in + R::l2x, l2);
    load(rows.in + R::l3x, l3);
    load(rows.in + R::l4x, l4);
    load(rows.in + R::nbx, nb);
    load(rows.in + R::ncx, nc);
    Lanes quarter, normal_quarter;
    load(rows.in[R::quarter], quarter);
    load(rows.in[R::normal_quarter], normal_quarter);

    Vector center, e1, e2, u, far;
    minus(p, o, far);
    minus(x1, o, x1);
    minus(x2, o, x2);
    minus(x3, o, x3);
    center.x = (x1.x + x2.x) + x3.x;
    center.y = (x1.y + x2.y) + x3.y;
    center.z = (x1.z + x2.z) + x3.z;
    scale(center, quarter);
    na.x = (l1.x + l2.x) + (l3.x + l4.x);
    na.y = (l1.y + l2.y) + (l3.y + l4.y);
    na.z = (l1.z + l2.z) + (l3.z + l4.z);
    scale(na, normal_quarter);
    minus(b, o, b);
    minus(b, center, e1);
    minus(c, o, c);
    minus(c, center, e2);
    minus(far, center, u);

    Vector area, g1, g2;
    Lanes d2, height, sa, sb, sc;
    cross_of(e1, e2, area);
    dot_of(area, area, d2);
    const Lanes of_square = 1.0 / d2;
    cross_of(e2, area, g1);
    scale(g1, of_square);
    cross_of(area, e1, g2);
    scale(g2, of_square);
    dot_of(u, area, height);
    dot_of(na, area, sa);
    dot_of(nb, area, sb);
    dot_of(nc, area, sc);

    Lanes px, py, xa, ya, xb, yb, xc, yc;
    dot_of(u, g1, px);
    dot_of(u, g2, py);
    dot_of(na, g1, xa);
    dot_of(na, g2, ya);
    dot_of(nb, g1, xb);
    dot_of(nb, g2, yb);
    dot_of(nc, g1, xc);
    dot_of(nc, g2, yc);
    const Lanes ra = height / sa, rb = height / sb, rc = height / sc;
    const Lanes ax = ra * xa - px, ay = ra * ya - py;
    const Lanes bx = (1.0 + rb * xb) - px, by = rb * yb - py;
    const Lanes cx = rc * xc - px, cy = (1.0 + rc * yc) - py;
    const Lanes wa = bx * cy - by * cx;
    const Lanes wb = cx * ay - cy * ax;
    const Lanes wc = ax * by - ay * bx;
    const Lanes total = wa + wb + wc;
    const Lanes inverse = 1.0 / total;
    const Lanes b1 = wb * inverse, c1 = wc * inverse, a1 = wa * inverse;
    const Lanes slope = a1 * sa + b1 * sb + c1 * sc;
    const Lanes lift = height / slope;
    const Lanes nx = a1 * xa + b1 * xb + c1 * xc;
    const Lanes ny = a1 * ya + b1 * yb + c1 * yc;
    const Lanes shift_x = nx * lift, shift_y = ny * lift;
    const Lanes landed_b = px - shift_x, landed_c = py - shift_y;

    Lanes inner = a1, farthest = px - px;
    least_of(b1, inner);
    least_of(c1, inner);
    most_magnitude(far.x, farthest);
    most_magnitude(far.y, farthest);
    most_magnitude(far.z, farthest);
    store(landed_b, rows.out[R::rb]);
    store(landed_c, rows.out[R::rc]);
    store(lift, rows.out[R::rlift]);
    store((na.x * a1 + nb.x * b1) + nc.x * c1, rows.out[R::rnx]);
    store((na.y * a1 + nb.y * b1) + nc.y * c1, rows.out[R::rny]);
    store((na.z * a1 + nb.z * b1) + nc.z * c1, rows.out[R::rnz]);
    store(height, rows.out[R::rheight]);
    store(d2, rows.out[R::rsquare]);
    store(total, rows.out[R::rtotal]);
    store(inner, rows.out[R::rinner]);
    store(px, rows.out[R::rp]);
    store(py, rows.out[R::rq]);
    store(farthest, rows.out[R::rfar]);
}

}  // namespace type21::optimized
