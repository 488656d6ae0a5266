#include "optimized/projection/exact.h"

#include <array>

#include "optimized/projection/dyadic.h"

namespace type21::optimized {

namespace {

using Whole = mpz_class;

struct WholeVector {
    std::array<Whole, 3> v;
    Whole& operator[](size_t i) { return v[i]; }
    const Whole& operator[](size_t i) const { return v[i]; }
};

WholeVector operator+(const WholeVector& p, const WholeVector& q) {
    return {{{p[0] + q[0], p[1] + q[1], p[2] + q[2]}}};
}
WholeVector operator-(const WholeVector& p, const WholeVector& q) {
    return {{{p[0] - q[0], p[1] - q[1], p[2] - q[2]}}};
}
WholeVector operator*(const Whole& f, const WholeVector& p) {
    return {{{f * p[0], f * p[1], f * p[2]}}};
}
Whole dot(const WholeVector& p, const WholeVector& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
/// One component of the cross product.
Whole cross_component(const WholeVector& p, const WholeVector& q, size_t i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return p[j] * q[k] - p[k] * q[j];
}
WholeVector cross(const WholeVector& p, const WholeVector& q) {
    return {{{cross_component(p, q, 0), cross_component(p, q, 1), cross_component(p, q, 2)}}};
}

/// Sign of one * 2^a - other * 2^b.
int compare_scaled(const Whole& one, int a, const Whole& other, int b) {
    const int least = std::min(a, b);
    return cmp(shifted(one, a - least), shifted(other, b - least));
}

/// A sub-triangle in whole numbers: lengths in units of 2^length_exponent, normals likewise. Everything is taken four
/// times, so that the means of four are whole.
struct WholePiece {
    int length_exponent = 0, normal_exponent = 0;
    WholeVector e1, e2, u;         ///< B - A, C - A, P - A
    std::array<WholeVector, 3> n;  ///< n_A, n_B, n_C
};

WholePiece whole_piece(const V3& p, const SegmentData& segment, int k, bool room_for_guard) {
    const size_t corners = segment.triangle ? 3 : 4;
    CommonExponent length, direction;
    length.see(p);
    for (size_t j = 0; j < corners; ++j) {
        length.see(segment.node[j]);
        direction.see(segment.normal[j]);
    }
    // A slope is 64 times its worth in units of 2^(normal + 2 length); D35's guard must be whole in it, too.
    if (room_for_guard) direction.at_most(dyadic(leaning_guard).exponent - 2 * length.value() + 6);
    const auto whole = [](const CommonExponent& unit, const V3& v) {
        return WholeVector{{{unit.whole(v.x), unit.whole(v.y), unit.whole(v.z)}}};
    };
    std::array<WholeVector, 4> x, n;
    for (size_t j = 0; j < corners; ++j) {
        x[j] = whole(length, segment.node[j]);
        n[j] = whole(direction, segment.normal[j]);
    }
    const Whole four = 4;
    const PieceCorners corner = piece_corners(segment.triangle, k);
    const WholeVector a = segment.triangle ? four * x[2] : x[0] + x[1] + x[2] + x[3];
    WholePiece piece;
    piece.e1 = four * x[static_cast<size_t>(corner.b)] - a;
    piece.e2 = four * x[static_cast<size_t>(corner.c)] - a;
    piece.u = four * whole(length, p) - a;
    piece.n[0] = segment.triangle ? four * n[2] : n[0] + n[1] + n[2] + n[3];
    piece.n[1] = four * n[static_cast<size_t>(corner.b)];
    piece.n[2] = four * n[static_cast<size_t>(corner.c)];
    piece.length_exponent = length.value() - 2;
    piece.normal_exponent = direction.value() - 2;
    return piece;
}

/// Weights b / total, c / total with total > 0 against the limits, which are dyadic.
bool inside(const Whole& b, const Whole& c, const Whole& total, const ProjectionLimits& rules) {
    const auto less = [&](const Whole& weight, double limit) {  // weight < limit total
        const Dyadic d = dyadic(limit);
        const Whole bound = total * static_cast<long>(d.mantissa);
        return compare_scaled(weight, 0, bound, d.exponent) < 0;
    };
    if (less(b, rules.low) || less(c, rules.low)) return false;
    const Dyadic high = dyadic(rules.high);
    const Whole sum = b + c;
    const Whole bound = total * static_cast<long>(high.mantissa);
    return compare_scaled(sum, 0, bound, high.exponent) <= 0;
}

/// First-pass weights times a common positive factor, and that factor; false where the lifted triangle is turned over
/// or P is outside. Source: formulation section 3, steps 1 and 2.
bool lifted_weights(const WholePiece& t, const WholeVector& area, size_t axis, const Whole& height,
                    const std::array<Whole, 3>& slope, const ProjectionLimits& rules, std::array<Whole, 3>& weight,
                    Whole& total) {
    std::array<Whole, 3> divisor{1, 1, 1};
    bool guarded = false;
    if (height != 0) {
        bool leaning = false;
        for (size_t i = 0; i < 3; ++i) {
            divisor[i] = slope[i];
            leaning = leaning || slope[i] <= 0;
        }
        if (leaning) {
            if (!rules.lift_leaning) return false;
            const Dyadic d = dyadic(leaning_guard);
            const Whole guard =
                shifted(Whole(static_cast<long>(d.mantissa)), d.exponent - (t.normal_exponent + 2 * t.length_exponent));
            for (Whole& s : divisor) {
                if (s >= guard) continue;
                s = guard;
                guarded = true;
            }
        }
    }
    // divisor_V (V' - P) = divisor_V (V - P) + n_V H
    const std::array<WholeVector, 3> from_p{Whole(-1) * t.u, t.e1 - t.u, t.e2 - t.u};
    std::array<WholeVector, 3> lifted;
    for (size_t i = 0; i < 3; ++i) {
        lifted[i] = divisor[i] * from_p[i];
        if (height != 0) lifted[i] = lifted[i] + height * t.n[i];
    }
    if (!guarded) {
        // All three lie in the plane through P normal to N: one component of each cross product says all of it.
        const int facing = sgn(area[axis]);
        for (size_t i = 0; i < 3; ++i) {
            weight[i] = divisor[i] * cross_component(lifted[(i + 1) % 3], lifted[(i + 2) % 3], axis);
            if (facing < 0) weight[i] = -weight[i];
        }
        total = weight[0] + weight[1] + weight[2];
        return total > 0 && inside(weight[1], weight[2], total, rules);
    }
    std::array<WholeVector, 3> opposite;
    for (size_t i = 0; i < 3; ++i)
        opposite[i] = divisor[i] * cross(lifted[(i + 1) % 3], lifted[(i + 2) % 3]);
    const WholeVector turned = opposite[0] + opposite[1] + opposite[2];  // M
    if (dot(turned, area) <= 0) return false;
    for (size_t i = 0; i < 3; ++i)
        weight[i] = dot(turned, opposite[i]);
    total = weight[0] + weight[1] + weight[2];
    return inside(weight[1], weight[2], total, rules);
}

Whole clip(const Whole& weight, const Whole& total) {
    if (weight < 0) return 0;
    return weight > total ? total : weight;
}

/// Steps 4 and 5: contact, proximity or nothing for weights b / total, c / total.
Kind reached(const WholePiece& t, const Whole& b, const Whole& c, const Whole& total, int side,
             const ContactReach& window) {
    const Whole a = total - b - c;
    const Whole bc = clip(b, total), cc = clip(c, total);
    const Whole sum = clip(a, total) + bc + cc;
    const WholeVector offset = sum * t.u - (bc * t.e1 + cc * t.e2);
    const Whole distance2 = dot(offset, offset);
    const Whole sum2 = sum * sum;
    const auto nearer = [&](double reach) {  // distance^2 < reach^2
        const Dyadic d = dyadic(reach);
        Whole limit = static_cast<long>(d.mantissa);
        limit = limit * limit * sum2;
        return compare_scaled(distance2, 2 * t.length_exponent, limit, 2 * d.exponent) < 0;
    };
    if (side > 0 && nearer(window.gap)) return Kind::contact;
    if (side < 0 && nearer(window.depth)) return Kind::contact;
    if (side > 0 && nearer(window.proximity)) return Kind::proximity;
    return Kind::none;
}

}  // namespace

ExactLanding exact_landing(const V3& p, const SegmentData& segment, int k, const ContactReach& window,
                           const ProjectionLimits& rules) {
    ExactLanding result;
    const WholePiece t = whole_piece(p, segment, k, rules.lift_leaning);
    const WholeVector area = cross(t.e1, t.e2);
    size_t axis = 0;
    for (size_t i = 1; i < 3; ++i)
        if (mpz_cmpabs(area[i].get_mpz_t(), area[axis].get_mpz_t()) > 0) axis = i;
    const int facing = sgn(area[axis]);
    if (facing == 0) return result;  // N = 0 rejects at step 2
    const Whole height = dot(t.u, area);
    const std::array<Whole, 3> slopes{dot(t.n[0], area), dot(t.n[1], area), dot(t.n[2], area)};
    std::array<Whole, 3> weight;
    Whole first_total;
    if (!lifted_weights(t, area, axis, height, slopes, rules, weight, first_total)) return result;

    // Step 3, everything times first_total: n and <n, N>; then everything times <n, N>: Q - A.
    const WholeVector normal = weight[0] * t.n[0] + weight[1] * t.n[1] + weight[2] * t.n[2];
    const Whole slope = dot(normal, area);
    if (slope <= 0) return result;
    const WholeVector q = slope * t.u - height * normal;
    const Whole total = slope * abs(area[axis]);
    Whole b = cross_component(q, t.e2, axis);
    Whole c = cross_component(t.e1, q, axis);
    if (facing < 0) {
        b = -b;
        c = -c;
    }
    if (!inside(b, c, total, rules)) return result;

    // The clipped point lies in the plane: its side is that of P, <P - point, N> = H.
    const int side = height < 0 ? -1 : 1;
    const Kind kind = reached(t, b, c, total, side, window);
    if (kind == Kind::none) return result;
    result.taken = true;
    const Whole third_b = total - 3 * b, third_c = total - 3 * c;
    result.kappa_over = abs(third_b) + abs(third_c) + abs(third_b + third_c);
    result.kappa_under = total;

    ProjectionResult& landing = result.landing;
    landing.kind = kind;
    landing.side = side;
    landing.b = quotient(b, total);
    landing.c = quotient(c, total);
    landing.kappa = quotient(result.kappa_over, 3 * total);
    landing.normal = {quotient(normal[0], first_total, t.normal_exponent),
                      quotient(normal[1], first_total, t.normal_exponent),
                      quotient(normal[2], first_total, t.normal_exponent)};
    landing.lift = quotient(height * first_total, slope, t.length_exponent - t.normal_exponent);
    landing.weight_bound = landing.kappa_bound = 0x1p-50;
    return result;
}

int compare_kappa(const ExactLanding& one, const ExactLanding& other) {
    return cmp(one.kappa_over * other.kappa_under, other.kappa_over * one.kappa_under);
}

}  // namespace type21::optimized
