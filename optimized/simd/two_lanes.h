/// @file TwoDoubles in each lane of a register; the operations and bounds are those of two_doubles.h.
#pragma once

#include "optimized/simd/lanes.h"

namespace type21::optimized {

template <class L>
TYPE21_INLINE void fused_of(const L& p, const L& q, const L& s, L& r) {
    constexpr int width = sizeof(L) / sizeof(double);
    double a[width], b[width], c[width], out[width];
    store(p, a);
    store(q, b);
    store(s, c);
    for (int j = 0; j < width; ++j)
        out[j] = __builtin_fma(a[j], b[j], c[j]);
    load(out, r);
}

template <class L, bool fused>
struct TwoLanes {
    L high, low;

    static TYPE21_INLINE TwoLanes quick_sum(const L& s, const L& t) {
        TwoLanes r;
        r.high = s + t;
        r.low = t - (r.high - s);
        return r;
    }
    static TYPE21_INLINE TwoLanes exact_sum(const L& s, const L& t) {
        TwoLanes r;
        r.high = s + t;
        const L of_t = r.high - s;
        r.low = (s - (r.high - of_t)) + (t - of_t);
        return r;
    }
    static TYPE21_INLINE TwoLanes exact_product(const L& s, const L& t) {
        TwoLanes r;
        r.high = s * t;
        if constexpr (fused) {
            fused_of(s, t, -r.high, r.low);
        } else {
            constexpr double splitter = 134217729;  // 2^27 + 1
            const L cs = splitter * s, ct = splitter * t;
            const L sh = cs - (cs - s), th = ct - (ct - t);
            const L sl = s - sh, tl = t - th;
            r.low = ((sh * th - r.high) + sh * tl + sl * th) + sl * tl;
        }
        return r;
    }
    friend TYPE21_INLINE TwoLanes operator+(const TwoLanes& x, const TwoLanes& y) {
        const TwoLanes s = exact_sum(x.high, y.high), t = exact_sum(x.low, y.low);
        const TwoLanes v = quick_sum(s.high, s.low + t.high);
        return quick_sum(v.high, t.low + v.low);
    }
    friend TYPE21_INLINE TwoLanes operator-(const TwoLanes& x) {
        TwoLanes r;
        r.high = -x.high;
        r.low = -x.low;
        return r;
    }
    friend TYPE21_INLINE TwoLanes operator-(const TwoLanes& x, const TwoLanes& y) { return x + -y; }
    friend TYPE21_INLINE TwoLanes operator*(const TwoLanes& x, const TwoLanes& y) {
        const TwoLanes p = exact_product(x.high, y.high);
        return quick_sum(p.high, p.low + (x.high * y.low + x.low * y.high));
    }
    friend TYPE21_INLINE TwoLanes operator/(const TwoLanes& x, const TwoLanes& y) {
        TwoLanes part;
        part.low = x.low - x.low;
        const L quotient = x.high / y.high;
        part.high = quotient;
        const TwoLanes left = x - y * part;
        const L more = left.high / y.high;
        part.high = more;
        const TwoLanes left2 = left - y * part;
        part.high = left2.high / y.high;
        return quick_sum(quotient, more) + part;
    }
};

template <class L, bool fused>
TYPE21_INLINE TwoLanes<L, fused> magnitude(const TwoLanes<L, fused>& v) {
    const auto below = (IntegerLanes<L>)v.high >> 63;
    TwoLanes<L, fused> r = v;
    choose(below, -v.high, r.high);
    choose(below, -v.low, r.low);
    return r;
}

}  // namespace type21::optimized
