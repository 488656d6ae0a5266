#include "optimized/search/segment_boxes.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

constexpr int group = 8;  ///< segments that are computed together

struct SegmentRows {
    alignas(64) double corner[4][3][group], normal[4][3][group], low[3][group], high[3][group];
};

template <class L>
struct BoxLanes {
    L low, high;
};

/// min and max over three corners, each drawn out by `share` of its distance to the others and taken at two heights.
template <class L>
TYPE21_INLINE void extend(const L (&x)[3], const L (&rise)[3], double share, double down, double up, BoxLanes<L>& box) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const L wide = x[i] + (x[i] * 2.0 - x[j] - x[k]) * share;
        const L wide_rise = rise[i] + (rise[i] * 2.0 - rise[j] - rise[k]) * share;
        const L bottom = wide - wide_rise * down, top = wide + wide_rise * up;
        least_of(bottom, box.low);
        least_of(top, box.low);
        most_of(bottom, box.high);
        most_of(top, box.high);
    }
}

/// All quads, or all triangles: the same steps as capture_volume() and CaptureVolume::box().
template <int W, bool triangles>
TYPE21_INLINE void boxes_in(SegmentRows& rows, int at, const CaptureLimits& limits) {
    using L = Lanes<W>;
    using V = VectorLanes<L>;
    V x[5], n[5], local[5];
    for (int j = 0; j < 4; ++j) {
        load(rows.corner[j][0] + at, rows.corner[j][1] + at, rows.corner[j][2] + at, x[j]);
        load(rows.normal[j][0] + at, rows.normal[j][1] + at, rows.normal[j][2] + at, n[j]);
        minus(x[j], x[0], local[j]);
    }
    const L zero = x[0].x - x[0].x;
    const auto mean = [](const V* v, V& m) __attribute__((always_inline)) {
        m.x = ((v[0].x + v[1].x) + (v[2].x + v[3].x)) * 0.25;
        m.y = ((v[0].y + v[1].y) + (v[2].y + v[3].y)) * 0.25;
        m.z = ((v[0].z + v[1].z) + (v[2].z + v[3].z)) * 0.25;
    };
    if constexpr (triangles) {
        x[4] = x[2];
        n[4] = n[2];
        local[4] = local[2];
    } else {
        mean(x, x[4]);
        mean(n, n[4]);
        mean(local, local[4]);
    }
    const double growth = std::max(limits.outward, limits.inward);
    L size = zero, far = zero, other;
    const auto largest = [&](const V& v, L& most) __attribute__((always_inline)) {
        magnitude_of(v.x, other);
        most_of(other, most);
        magnitude_of(v.y, other);
        most_of(other, most);
        magnitude_of(v.z, other);
        most_of(other, most);
    };
    for (int j = 0; j < 4; ++j) {
        V from_center;
        minus(local[j], local[4], from_center);
        largest(from_center, size);
        largest(x[j], far);
    }
    const L slack = 1e-7 * (size + growth) + 1e-13 * far;
    BoxLanes<L> all[3] = {
        {zero + HUGE_VAL, zero - HUGE_VAL}, {zero + HUGE_VAL, zero - HUGE_VAL}, {zero + HUGE_VAL, zero - HUGE_VAL}};
    for (int k = 0; k < (triangles ? 1 : 4); ++k) {
        const int b = k, c = (k + 1) % 4;
        V e1, e2, area;
        L square, length, slope[3], steep[3];
        minus(local[b], local[4], e1);
        minus(local[c], local[4], e2);
        cross_of(e1, e2, area);
        dot_of(area, area, square);
        root_of(square, length);
        scale(area, 1.0 / length);
        const V* const normal[3] = {&n[4], &n[b], &n[c]};
        L trusted = 64 * 0x1p-53 * size * size < 1e-11 * length ? zero + 1.0 : zero;
        for (int i = 0; i < 3; ++i) {
            dot_of(*normal[i], area, slope[i]);
            dot_of(*normal[i], *normal[i], square);
            root_of(square, steep[i]);
            trusted += slope[i] > 0.05 * steep[i] ? zero + 1.0 : zero;
        }
        const IntegerLanes<L> doubted = (IntegerLanes<L>)(trusted - 4.0) >> 63;
        // Leaning normals: the sub-triangle may take nodes in its plane only; the wider of capture_volume()'s answers
        // is good.
        const auto axis = [&](int a, const L& xa, const L& xb, const L& xc, const L& na, const L& nb, const L& nc)
            __attribute__((always_inline)) {
            const L corner[3] = {xa, xb, xc};
            const L rise[3] = {na / slope[0], nb / slope[1], nc / slope[2]};
            BoxLanes<L> plain = {xa, xa}, exact = {zero + HUGE_VAL, zero - HUGE_VAL};
            least_of(xb, plain.low);
            least_of(xc, plain.low);
            most_of(xb, plain.high);
            most_of(xc, plain.high);
            plain.low -= growth;
            plain.high += growth;
            extend(corner, rise, limits.margin, limits.inward, limits.outward, exact);
            most_of(plain.low, exact.low);
            least_of(plain.high, exact.high);
            choose(doubted, plain.low, exact.low);
            choose(doubted, plain.high, exact.high);
            least_of(exact.low, all[a].low);
            most_of(exact.high, all[a].high);
        };
        axis(0, x[4].x, x[b].x, x[c].x, n[4].x, n[b].x, n[c].x);
        axis(1, x[4].y, x[b].y, x[c].y, n[4].y, n[b].y, n[c].y);
        axis(2, x[4].z, x[b].z, x[c].z, n[4].z, n[b].z, n[c].z);
    }
    for (int a = 0; a < 3; ++a) {
        store(all[a].low - slack, rows.low[a] + at);
        store(all[a].high + slack, rows.high[a] + at);
    }
}

template <int W>
TYPE21_INLINE void boxes_all(SegmentRows& rows, const CaptureLimits& limits, bool triangles) {
    for (int at = 0; at < group; at += W)
        triangles ? boxes_in<W, true>(rows, at, limits) : boxes_in<W, false>(rows, at, limits);
}
TYPE21_AVX512 void boxes_eight(SegmentRows& rows, const CaptureLimits& limits, bool triangles) {
    boxes_all<8>(rows, limits, triangles);
}
TYPE21_AVX2 void boxes_four(SegmentRows& rows, const CaptureLimits& limits, bool triangles) {
    boxes_all<4>(rows, limits, triangles);
}
void boxes_two(SegmentRows& rows, const CaptureLimits& limits, bool triangles) {
    boxes_all<2>(rows, limits, triangles);
}

}  // namespace

std::vector<Box> segment_boxes(const Tool& tool, const CaptureLimits& limits, SimdWidth machine) {
    std::vector<Box> boxes(static_cast<size_t>(tool.size()));
    const auto compute = compiled_for(machine, boxes_eight, boxes_four, boxes_two);
    tbb::parallel_for(tbb::blocked_range<int>(0, tool.size(), 1024), [&](const tbb::blocked_range<int>& range) {
        SegmentRows rows;
        for (int first = range.begin(); first < range.end(); first += group) {
            bool triangles = true;
            for (int i = 0; i < group; ++i) {
                const int s = std::min(first + i, range.end() - 1);
                triangles = triangles && tool.is_triangle(s);
                for (int j = 0; j < 4; ++j) {
                    const V3 &x = tool.node(s, j), &n = tool.normal(s, j);
                    for (int a = 0; a < 3; ++a) {
                        rows.corner[j][a][i] = x[a];
                        rows.normal[j][a][i] = n[a];
                    }
                }
            }
            compute(rows, limits, triangles);
            for (int s = first; s < std::min(first + group, range.end()); ++s) {
                Box& box = boxes[static_cast<size_t>(s)];
                const int i = s - first;
                if (!triangles && tool.is_triangle(s)) {
                    box = capture_volume(tool.segment(s), 1, limits).box();
                } else {
                    box.low = {rows.low[0][i], rows.low[1][i], rows.low[2][i]};
                    box.high = {rows.high[0][i], rows.high[1][i], rows.high[2][i]};
                }
            }
        }
    });
    return boxes;
}

}  // namespace type21::optimized
