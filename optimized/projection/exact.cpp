#include "optimized/projection/exact.h"

#include <array>

#include "optimized/projection/dyadic.h"

namespace type21::optimized {

namespace {

using Integer = mpz_class;

struct IntegerVector {
    std::array<Integer, 3> v;
    Integer& operator[](size_t i) { return v[i]; }
    const Integer& operator[](size_t i) const { return v[i]; }
};

IntegerVector operator+(const IntegerVector& p, const IntegerVector& q) {
    return {{{p[0] + q[0], p[1] + q[1], p[2] + q[2]}}};
}
IntegerVector operator-(const IntegerVector& p, const IntegerVector& q) {
    return {{{p[0] - q[0], p[1] - q[1], p[2] - q[2]}}};
}
IntegerVector operator*(const Integer& f, const IntegerVector& p) {
    return {{{f * p[0], f * p[1], f * p[2]}}};
}
Integer dot(const IntegerVector& p, const IntegerVector& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}
/// One component of the cross product.
Integer cross_component(const IntegerVector& p, const IntegerVector& q, size_t i) {
    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
    return p[j] * q[k] - p[k] * q[j];
}
IntegerVector cross(const IntegerVector& p, const IntegerVector& q) {
    return {{{cross_component(p, q, 0), cross_component(p, q, 1), cross_component(p, q, 2)}}};
}

/// Sign of one * 2^a - other * 2^b.
int compare_scaled(const Integer& one, int a, const Integer& other, int b) {
    const int least = std::min(a, b);
    return cmp(shifted(one, a - least), shifted(other, b - least));
}

/// A sub-triangle in integers: lengths in units of 2^length_exponent, normals likewise. Everything is multiplied by
/// four, so that the means of four are integers.
struct IntegerSubTriangle {
    int length_exponent = 0, normal_exponent = 0;
    IntegerVector e1, e2, u;         ///< B - A, C - A, P - A
    std::array<IntegerVector, 3> n;  ///< n_A, n_B, n_C
};

IntegerSubTriangle integer_sub_triangle(const V3& p, const SegmentData& segment, int k, bool with_guard) {
    const size_t corners = segment.is_triangle ? 3 : 4;
    CommonExponent length, direction;
    length.see(p);
    for (size_t j = 0; j < corners; ++j) {
        length.see(segment.node[j]);
        direction.see(segment.normal[j]);
    }
    // A slope is 64 times its value in units of 2^(normal + 2 length). D35's guard must be an integer in these, too.
    if (with_guard) direction.at_most(dyadic(leaning_guard).exponent - 2 * length.value() + 6);
    const auto integers = [](const CommonExponent& unit, const V3& v) {
        return IntegerVector{{{unit.integer(v.x), unit.integer(v.y), unit.integer(v.z)}}};
    };
    std::array<IntegerVector, 4> x, n;
    for (size_t j = 0; j < corners; ++j) {
        x[j] = integers(length, segment.node[j]);
        n[j] = integers(direction, segment.normal[j]);
    }
    const Integer four = 4;
    const SubTriangleCorners corner = sub_triangle_corners(segment.is_triangle, k);
    const IntegerVector a = segment.is_triangle ? four * x[2] : x[0] + x[1] + x[2] + x[3];
    IntegerSubTriangle triangle;
    triangle.e1 = four * x[static_cast<size_t>(corner.b)] - a;
    triangle.e2 = four * x[static_cast<size_t>(corner.c)] - a;
    triangle.u = four * integers(length, p) - a;
    triangle.n[0] = segment.is_triangle ? four * n[2] : n[0] + n[1] + n[2] + n[3];
    triangle.n[1] = four * n[static_cast<size_t>(corner.b)];
    triangle.n[2] = four * n[static_cast<size_t>(corner.c)];
    triangle.length_exponent = length.value() - 2;
    triangle.normal_exponent = direction.value() - 2;
    return triangle;
}

/// Weights b / total, c / total with total > 0 against the limits, which are dyadic.
bool inside(const Integer& b, const Integer& c, const Integer& total, const ProjectionLimits& rules) {
    const auto less = [&](const Integer& weight, double limit) {  // weight < limit total
        const Dyadic d = dyadic(limit);
        const Integer bound = total * static_cast<long>(d.mantissa);
        return compare_scaled(weight, 0, bound, d.exponent) < 0;
    };
    if (less(b, rules.low) || less(c, rules.low)) return false;
    const Dyadic high = dyadic(rules.high);
    const Integer sum = b + c;
    const Integer bound = total * static_cast<long>(high.mantissa);
    return compare_scaled(sum, 0, bound, high.exponent) <= 0;
}

/// First-pass weights times a common positive factor, and that factor; false where the lifted triangle is turned over
/// or P is outside. Source: Formulation 3, step 1 and Formulation 3, step 2.
bool lifted_weights(const IntegerSubTriangle& t, const IntegerVector& area, size_t axis, const Integer& height,
                    const std::array<Integer, 3>& slope, const ProjectionLimits& rules, std::array<Integer, 3>& weight,
                    Integer& total) {
    std::array<Integer, 3> divisor{1, 1, 1};
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
            const Integer guard = shifted(Integer(static_cast<long>(d.mantissa)),
                                          d.exponent - (t.normal_exponent + 2 * t.length_exponent));
            for (Integer& s : divisor) {
                if (s >= guard) continue;
                s = guard;
                guarded = true;
            }
        }
    }
    // divisor_V (V' - P) = divisor_V (V - P) + n_V H
    const std::array<IntegerVector, 3> from_p{Integer(-1) * t.u, t.e1 - t.u, t.e2 - t.u};
    std::array<IntegerVector, 3> lifted;
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
    std::array<IntegerVector, 3> opposite;
    for (size_t i = 0; i < 3; ++i)
        opposite[i] = divisor[i] * cross(lifted[(i + 1) % 3], lifted[(i + 2) % 3]);
    const IntegerVector turned = opposite[0] + opposite[1] + opposite[2];  // M
    if (dot(turned, area) <= 0) return false;
    for (size_t i = 0; i < 3; ++i)
        weight[i] = dot(turned, opposite[i]);
    total = weight[0] + weight[1] + weight[2];
    return inside(weight[1], weight[2], total, rules);
}

Integer clip(const Integer& weight, const Integer& total) {
    if (weight < 0) return 0;
    return weight > total ? total : weight;
}

/// Steps 4 and 5: contact, proximity or nothing for weights b / total, c / total.
Kind reached(const IntegerSubTriangle& t, const Integer& b, const Integer& c, const Integer& total, int side,
             const ContactReach& reach) {
    const Integer a = total - b - c;
    const Integer bc = clip(b, total), cc = clip(c, total);
    const Integer sum = clip(a, total) + bc + cc;
    const IntegerVector offset = sum * t.u - (bc * t.e1 + cc * t.e2);
    const Integer distance2 = dot(offset, offset);
    const Integer sum2 = sum * sum;
    const auto nearer = [&](double limit_distance) {  // distance^2 < limit_distance^2
        const Dyadic d = dyadic(limit_distance);
        Integer limit = static_cast<long>(d.mantissa);
        limit = limit * limit * sum2;
        return compare_scaled(distance2, 2 * t.length_exponent, limit, 2 * d.exponent) < 0;
    };
    if (side > 0 && nearer(reach.gap)) return Kind::contact;
    if (side < 0 && nearer(reach.depth)) return Kind::contact;
    if (side > 0 && nearer(reach.proximity)) return Kind::proximity;
    return Kind::none;
}

}  // namespace

ExactProjection project_exact(const V3& p, const SegmentData& segment, int k, const ContactReach& reach,
                              const ProjectionLimits& rules) {
    ExactProjection result;
    const IntegerSubTriangle t = integer_sub_triangle(p, segment, k, rules.lift_leaning);
    const IntegerVector area = cross(t.e1, t.e2);
    size_t axis = 0;
    for (size_t i = 1; i < 3; ++i)
        if (mpz_cmpabs(area[i].get_mpz_t(), area[axis].get_mpz_t()) > 0) axis = i;
    const int facing = sgn(area[axis]);
    if (facing == 0) return result;  // N = 0 rejects at step 2
    const Integer height = dot(t.u, area);
    const std::array<Integer, 3> slopes{dot(t.n[0], area), dot(t.n[1], area), dot(t.n[2], area)};
    std::array<Integer, 3> weight;
    Integer first_total;
    if (!lifted_weights(t, area, axis, height, slopes, rules, weight, first_total)) return result;

    // Step 3, everything times first_total: n and <n, N>; then everything times <n, N>: Q - A.
    const IntegerVector normal = weight[0] * t.n[0] + weight[1] * t.n[1] + weight[2] * t.n[2];
    const Integer slope = dot(normal, area);
    if (slope <= 0) return result;
    const IntegerVector q = slope * t.u - height * normal;
    const Integer total = slope * abs(area[axis]);
    Integer b = cross_component(q, t.e2, axis);
    Integer c = cross_component(t.e1, q, axis);
    if (facing < 0) {
        b = -b;
        c = -c;
    }
    if (!inside(b, c, total, rules)) return result;

    // The clipped point lies in the plane: its side is that of P, <P - point, N> = H.
    const int side = height < 0 ? -1 : 1;
    const Kind kind = reached(t, b, c, total, side, reach);
    if (kind == Kind::none) return result;
    result.taken = true;
    const Integer third_b = total - 3 * b, third_c = total - 3 * c;
    result.kappa_over = abs(third_b) + abs(third_c) + abs(third_b + third_c);
    result.kappa_under = total;

    ProjectionResult& projection = result.projection;
    projection.kind = kind;
    projection.side = side;
    projection.b = quotient(b, total);
    projection.c = quotient(c, total);
    projection.kappa = quotient(result.kappa_over, 3 * total);
    projection.normal = {quotient(normal[0], first_total, t.normal_exponent),
                         quotient(normal[1], first_total, t.normal_exponent),
                         quotient(normal[2], first_total, t.normal_exponent)};
    projection.lift = quotient(height * first_total, slope, t.length_exponent - t.normal_exponent);
    projection.weight_bound = projection.kappa_bound = 0x1p-50;
    return result;
}

int compare_kappa(const ExactProjection& one, const ExactProjection& other) {
    return cmp(one.kappa_over * other.kappa_under, other.kappa_over * one.kappa_under);
}

}  // namespace type21::optimized
