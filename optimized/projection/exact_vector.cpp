#include "optimized/projection/exact_vector.h"

namespace type21::optimized {

ExactVector exact(const V3& v) {
    ExactVector e;
    for (size_t i = 0; i < 3; ++i)
        e.put(i, v[static_cast<int>(i)]);
    return e;
}

ExactVector way(const V3& p, const V3& q) {
    ExactVector e;
    for (int i = 0; i < 3; ++i)
        e.put(static_cast<size_t>(i), TwoDoubles::exact_sum(q[i], -p[i]));
    return e;
}

ExactVector sum_of(const std::array<V3, 4>& x) {
    ExactVector e;
    for (int i = 0; i < 3; ++i) {
        const TwoDoubles one = TwoDoubles::exact_sum(x[0][i], x[2][i]);
        const TwoDoubles other = TwoDoubles::exact_sum(x[1][i], x[3][i]);
        TwoDoubles high = TwoDoubles::exact_sum(one.high, other.high);
        if (one.low != 0 || other.low != 0) {
            const TwoDoubles low = TwoDoubles::exact_sum(one.low, other.low);
            e.known = e.known && high.low == 0 && low.low == 0;
            high.low = low.high;
        }
        e.put(static_cast<size_t>(i), high);
    }
    return e;
}

ExactVector way_from_sum(const ExactVector& sum, const V3& p) {
    ExactVector e;
    for (size_t i = 0; i < 3; ++i) {
        TwoDoubles d = TwoDoubles::exact_sum(4 * p[static_cast<int>(i)], -sum.high[i]);
        if (sum.low[i] != 0) {
            e.known = e.known && d.low == 0;
            d.low = -sum.low[i];
        }
        e.put(i, d);
    }
    e.known = e.known && sum.known;
    return e;
}

namespace {

/// x = 0 is not excluded by the rounding of its terms, whose sizes sum up to `size`.
bool may_be_zero(double x, double size) {
    return std::abs(x) <= 1e-14 * size;
}

}  // namespace

bool parallel(const ExactVector& p, const ExactVector& q) {
    if (!p.known || !q.known) return false;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        const double one = p.high[i] * q.high[j], other = p.high[j] * q.high[i];
        if (!may_be_zero(one - other, std::abs(one) + std::abs(other))) return false;
    }
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3;
        ZeroSum sum;
        for (const auto& pi : {p.high, p.low}) {
            for (const auto& qi : {q.high, q.low}) {
                sum.add(pi[i], qi[j]);
                sum.add(-pi[j], qi[i]);
            }
        }
        if (!sum.zero()) return false;
    }
    return true;
}

bool in_one_plane(const ExactVector& p, const ExactVector& q, const ExactVector& r) {
    if (!p.known || !q.known || !r.known) return false;
    double value = 0, size = 0;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        const double one = p.high[i] * q.high[j] * r.high[k], other = p.high[i] * q.high[k] * r.high[j];
        value += one - other;
        size += std::abs(one) + std::abs(other);
    }
    if (!may_be_zero(value, size)) return false;
    ZeroSum sum;
    for (const auto& pi : {p.high, p.low}) {
        for (const auto& qi : {q.high, q.low}) {
            for (const auto& ri : {r.high, r.low}) {
                for (size_t i = 0; i < 3; ++i) {
                    const size_t j = (i + 1) % 3, k = (i + 2) % 3;
                    sum.add(pi[i], qi[j], ri[k]);
                    sum.add(-pi[i], qi[k], ri[j]);
                }
            }
        }
    }
    return sum.zero();
}

}  // namespace type21::optimized
