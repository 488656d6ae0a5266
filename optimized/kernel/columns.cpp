// Vectors are transposed in registers, as many at a time as a register has lanes. A row is written by full registers,
// which costs a third of writing its numbers one by one.
#include "optimized/kernel/columns.h"

#include <cstring>

#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

static_assert(sizeof(Vec3) == 3 * sizeof(double) && sizeof(V3) == sizeof(Vec3));

/// Three registers hold as many vectors as one has lanes: the numbers of one of these in p, q and r, in this order,
/// are x0 y0 z0 x1 y1 ...
TYPE21_INLINE void turn(const Lanes<2>& p, const Lanes<2>& q, const Lanes<2>& r, VectorLanes<Lanes<2>>& v) {
    v.x = __builtin_shufflevector(p, q, 0, 3);
    v.y = __builtin_shufflevector(p, r, 1, 2);
    v.z = __builtin_shufflevector(q, r, 0, 3);
}
TYPE21_INLINE void turn(const Lanes<4>& p, const Lanes<4>& q, const Lanes<4>& r, VectorLanes<Lanes<4>>& v) {
    v.x = __builtin_shufflevector(__builtin_shufflevector(p, q, 0, 3, 6, 6), r, 0, 1, 2, 5);
    v.y = __builtin_shufflevector(__builtin_shufflevector(p, q, 1, 4, 7, 7), r, 0, 1, 2, 6);
    v.z = __builtin_shufflevector(__builtin_shufflevector(p, q, 2, 5, 5, 5), r, 0, 1, 4, 7);
}
TYPE21_INLINE void turn(const Lanes<8>& p, const Lanes<8>& q, const Lanes<8>& r, VectorLanes<Lanes<8>>& v) {
    v.x = __builtin_shufflevector(__builtin_shufflevector(p, q, 0, 3, 6, 9, 12, 15, 0, 0), r, 0, 1, 2, 3, 4, 5, 10, 13);
    v.y = __builtin_shufflevector(__builtin_shufflevector(p, q, 1, 4, 7, 10, 13, 0, 0, 0), r, 0, 1, 2, 3, 4, 8, 11, 14);
    v.z = __builtin_shufflevector(__builtin_shufflevector(p, q, 2, 5, 8, 11, 14, 0, 0, 0), r, 0, 1, 2, 3, 4, 9, 12, 15);
}
/// Back.
TYPE21_INLINE void turn_back(const VectorLanes<Lanes<2>>& v, Lanes<2>& p, Lanes<2>& q, Lanes<2>& r) {
    p = __builtin_shufflevector(v.x, v.y, 0, 2);
    q = __builtin_shufflevector(v.z, v.x, 0, 3);
    r = __builtin_shufflevector(v.y, v.z, 1, 3);
}
TYPE21_INLINE void turn_back(const VectorLanes<Lanes<4>>& v, Lanes<4>& p, Lanes<4>& q, Lanes<4>& r) {
    p = __builtin_shufflevector(__builtin_shufflevector(v.x, v.y, 0, 4, 1, 1), v.z, 0, 1, 4, 2);
    q = __builtin_shufflevector(__builtin_shufflevector(v.y, v.x, 1, 2, 6, 6), v.z, 0, 5, 2, 1);
    r = __builtin_shufflevector(__builtin_shufflevector(v.x, v.y, 3, 7, 3, 3), v.z, 6, 0, 1, 7);
}
TYPE21_INLINE void turn_back(const VectorLanes<Lanes<8>>& v, Lanes<8>& p, Lanes<8>& q, Lanes<8>& r) {
    p = __builtin_shufflevector(__builtin_shufflevector(v.x, v.y, 0, 8, 0, 1, 9, 0, 2, 10), v.z, 0, 1, 8, 3, 4, 9, 6,
                                7);
    q = __builtin_shufflevector(__builtin_shufflevector(v.x, v.y, 0, 3, 11, 0, 4, 12, 0, 5), v.z, 10, 1, 2, 11, 4, 5,
                                12, 7);
    r = __builtin_shufflevector(__builtin_shufflevector(v.x, v.y, 13, 0, 6, 14, 0, 7, 15, 0), v.z, 0, 13, 2, 3, 14, 5,
                                6, 15);
}

template <int W>
TYPE21_INLINE void rows_of(const double* from, const Components& to, int j) {
    Lanes<W> p, q, r;
    VectorLanes<Lanes<W>> v;
    load(from, p);
    load(from + W, q);
    load(from + 2 * W, r);
    turn(p, q, r, v);
    store(v, to[0] + j, to[1] + j, to[2] + j);
}

template <int W>
TYPE21_INLINE void all_into_rows(const double* from, int count, const Components& to) {
    int j = 0;
    for (; j + W <= count; j += W)
        rows_of<W>(from + 3 * j, to, j);
    for (; j < count; ++j)
        for (size_t a = 0; a < 3; ++a)
            to[a][j] = from[3 * static_cast<size_t>(j) + a];
}

template <int W>
TYPE21_INLINE void chosen_into_rows(const double* from, const int* index, int count, const Components& to) {
    int j = 0;
    for (; j + W <= count; j += W) {
        int gaps = 0;
        for (int i = 1; i < W; ++i)
            gaps |= index[j + i] - index[j] - i;
        if (gaps == 0) {
            rows_of<W>(from + 3 * static_cast<size_t>(index[j]), to, j);
            continue;
        }
        for (int i = j; i < j + W; ++i)
            for (size_t a = 0; a < 3; ++a)
                to[a][i] = from[3 * static_cast<size_t>(index[i]) + a];
    }
    for (; j < count; ++j)
        for (size_t a = 0; a < 3; ++a)
            to[a][j] = from[3 * static_cast<size_t>(index[j]) + a];
}

template <int W>
TYPE21_INLINE void all_from_rows(const ConstComponents& from, int count, double* to) {
    int j = 0;
    for (; j + W <= count; j += W) {
        Lanes<W> p, q, r;
        VectorLanes<Lanes<W>> v;
        load(from[0] + j, from[1] + j, from[2] + j, v);
        turn_back(v, p, q, r);
        store(p, to + 3 * j);
        store(q, to + 3 * j + W);
        store(r, to + 3 * j + 2 * W);
    }
    for (; j < count; ++j)
        for (size_t a = 0; a < 3; ++a)
            to[3 * static_cast<size_t>(j) + a] = from[a][j];
}

TYPE21_AVX512 void all_into_rows_eight(const double* from, int count, const Components& to) {
    all_into_rows<8>(from, count, to);
}
TYPE21_AVX2 void all_into_rows_four(const double* from, int count, const Components& to) {
    all_into_rows<4>(from, count, to);
}
void all_into_rows_two(const double* from, int count, const Components& to) {
    all_into_rows<2>(from, count, to);
}
TYPE21_AVX512 void chosen_into_rows_eight(const double* from, const int* index, int count, const Components& to) {
    chosen_into_rows<8>(from, index, count, to);
}
TYPE21_AVX2 void chosen_into_rows_four(const double* from, const int* index, int count, const Components& to) {
    chosen_into_rows<4>(from, index, count, to);
}
void chosen_into_rows_two(const double* from, const int* index, int count, const Components& to) {
    chosen_into_rows<2>(from, index, count, to);
}
TYPE21_AVX512 void all_from_rows_eight(const ConstComponents& from, int count, double* to) {
    all_from_rows<8>(from, count, to);
}
TYPE21_AVX2 void all_from_rows_four(const ConstComponents& from, int count, double* to) {
    all_from_rows<4>(from, count, to);
}
void all_from_rows_two(const ConstComponents& from, int count, double* to) {
    all_from_rows<2>(from, count, to);
}

void write_rows(const ConstComponents& from, int count, double* to, SimdWidth machine) {
    compiled_for(machine, all_from_rows_eight, all_from_rows_four, all_from_rows_two)(from, count, to);
}

}  // namespace

void into_rows(const V3* from, int count, const Components& to, SimdWidth machine) {
    compiled_for(machine, all_into_rows_eight, all_into_rows_four, all_into_rows_two)(&from->x, count, to);
}

void into_rows(std::span<const Vec3> from, const int* index, int count, const Components& to, SimdWidth machine) {
    compiled_for(machine, chosen_into_rows_eight, chosen_into_rows_four, chosen_into_rows_two)(from.data()->data(),
                                                                                               index, count, to);
}

void from_rows(const ConstComponents& from, int count, V3* to, SimdWidth machine) {
    write_rows(from, count, &to->x, machine);
}

void from_rows(const ConstComponents& from, int count, Vec3* to, SimdWidth machine) {
    write_rows(from, count, to->data(), machine);
}

}  // namespace type21::optimized
