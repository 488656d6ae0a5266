// Segments into rows. What is far in memory is prefetched, and four columns are filled at a time.
#include "optimized/search/gather.h"

#include <algorithm>

#include "optimized/projection/a_priori_bounds.h"
#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

constexpr int group = 4;

/// Position and normal of a corner, six numbers in a row, of four columns.
using Corners = std::array<const double*, group>;

using Segments = std::array<int, group>;
TYPE21_INLINE Corners corners(const Tool& tool, const Segments& segment, int j) {
    return {tool.numbers(segment[0], j), tool.numbers(segment[1], j), tool.numbers(segment[2], j),
            tool.numbers(segment[3], j)};
}

void gather_one_by_one(const Tool& tool, const Segments& segment, int at, ProjectionBatch& rows) {
    for (int j = 0; j < 4; ++j) {
        const Corners from = corners(tool, segment, j);
        for (int i = 0; i < group; ++i) {
            const double* v = from[static_cast<size_t>(i)];
            for (int a = 0; a < 3; ++a) {
                rows.corner[j][a][at + i] = v[a];
                rows.normal[j][a][at + i] = v[3 + a];
            }
        }
    }
}

using Four = Lanes<group>;

/// Four rows of four numbers are transposed into columns; the first two columns only with `all`.
template <bool all>
TYPE21_INLINE void turn(const Corners& from, int offset, double* x, double* y, double* z, double* w) {
    // Four names, since GCC would put an array of registers into memory.
    Four p, q, r, s;
    load(from[0] + offset, p);
    load(from[1] + offset, q);
    load(from[2] + offset, r);
    load(from[3] + offset, s);
    const Four even = __builtin_shufflevector(p, q, 0, 4, 2, 6), odd = __builtin_shufflevector(p, q, 1, 5, 3, 7);
    const Four even_too = __builtin_shufflevector(r, s, 0, 4, 2, 6),
               odd_too = __builtin_shufflevector(r, s, 1, 5, 3, 7);
    if constexpr (all) {
        store(__builtin_shufflevector(even, even_too, 0, 1, 4, 5), x);
        store(__builtin_shufflevector(odd, odd_too, 0, 1, 4, 5), y);
    }
    store(__builtin_shufflevector(even, even_too, 2, 3, 6, 7), z);
    store(__builtin_shufflevector(odd, odd_too, 2, 3, 6, 7), w);
}

TYPE21_AVX2 void gather_four(const Tool& tool, const Segments& segment, int at, ProjectionBatch& rows) {
    for (int j = 0; j < 4; ++j) {
        const Corners from = corners(tool, segment, j);
        turn<true>(from, 0, rows.corner[j][0] + at, rows.corner[j][1] + at, rows.corner[j][2] + at,
                   rows.normal[j][0] + at);
        turn<false>(from, 2, nullptr, nullptr, rows.normal[j][1] + at, rows.normal[j][2] + at);
    }
}

}  // namespace

void gather(ProjectionBatch& rows, const Tool& tool, const SubTriangleId* id, int first, int count, double growth,
            SimdWidth machine) {
    for (int c = 0; c < count; ++c)
        tool.prefetch_corners(id[c].segment());
    gather_prefetched(rows, tool, id, first, count, growth, machine);
}

void gather_prefetched(ProjectionBatch& rows, const Tool& tool, const SubTriangleId* id, int first, int count,
                       double growth, SimdWidth machine) {
    const auto gather_group = machine == SimdWidth::two ? gather_one_by_one : gather_four;
    for (int c = 0; c < count; c += group) {
        Segments segment;
        const int at = first + c;
        for (int i = 0; i < group; ++i) {
            // Columns beyond the last repeat it.
            const SubTriangleId one = id[std::min(c + i, count - 1)];
            const int s = one.segment();
            segment[static_cast<size_t>(i)] = s;
            rows.code[at + i] = tool.is_triangle(s) ? 4 : one.triangle() - 1;
            rows.size[at + i] = a_priori_size(tool.extent(s), growth);
        }
        gather_group(tool, segment, at, rows);
    }
}

}  // namespace type21::optimized
