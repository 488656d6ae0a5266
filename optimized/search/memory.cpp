#include "optimized/search/memory.h"

#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

static_assert(sizeof(Memory) == 5 * sizeof(double) && offsetof(Memory, from) == 0);

/// Four memories: the first four numbers of each, turned; the fourth is not used.
TYPE21_AVX2 void recall_four(const Memory* memory, const std::array<const double*, 3>& y, int count, float small,
                             Recalled& found) {
    using L = Lanes<4>;
    using I = WholeLanes<L>;
    using Four = int __attribute__((vector_size(16)));
    for (int j = 0; j + 4 <= count; j += 4) {
        L p, q, r, s;
        const auto* const numbers = reinterpret_cast<const char*>(memory + j);
        __builtin_memcpy(&p, numbers, sizeof(p));
        __builtin_memcpy(&q, numbers + sizeof(Memory), sizeof(q));
        __builtin_memcpy(&r, numbers + 2 * sizeof(Memory), sizeof(r));
        __builtin_memcpy(&s, numbers + 3 * sizeof(Memory), sizeof(s));
        const L even = __builtin_shufflevector(p, q, 0, 4, 2, 6), odd = __builtin_shufflevector(p, q, 1, 5, 3, 7);
        const L even_too = __builtin_shufflevector(r, s, 0, 4, 2, 6),
                odd_too = __builtin_shufflevector(r, s, 1, 5, 3, 7);
        VectorLanes<L> from, way;
        from.x = __builtin_shufflevector(even, even_too, 0, 1, 4, 5);
        from.y = __builtin_shufflevector(odd, odd_too, 0, 1, 4, 5);
        from.z = __builtin_shufflevector(even, even_too, 2, 3, 6, 7);
        const Memory* const m = memory + j;
        const L ball{double(m[0].radius), double(m[1].radius), double(m[2].radius), double(m[3].radius)};
        const L less{double(m[0].held), double(m[1].held), double(m[2].held), double(m[3].held)};
        const Four place{m[0].place, m[1].place, m[2].place, m[3].place};
        load(y[0] + j, y[1] + j, y[2] + j, way);
        minus(way, from, way);
        L square;
        dot_of(way, way, square);
        square *= 1 + 1e-14;
        const L zero = ball - ball;
        const I in_ball = square < ball * ball, in_less = square<less * less, outside = ball> zero;
        const I in_steady = in_ball & ~outside;
        const I near = -ball < zero + double(small);
        const I looks = ~outside & (near | in_steady) & (__builtin_convertvector(place, I) >= 0);
        // Each is one more than the one before it; -1 is true.
        const I what = (in_ball & outside & 1) - (looks + looks) - (looks & in_steady) - (looks & in_steady & in_less);
        const Four told = __builtin_convertvector(what, Four);
        __builtin_memcpy(found.what + j, &told, sizeof(told));
        __builtin_memcpy(found.place + j, &place, sizeof(place));
    }
}

}  // namespace

Recalled::What Recalled::of(const Memory& memory, const V3& y, float small) {
    const bool in = memory.within(y);
    if (memory.radius > 0) return in ? quiet : nothing;
    if (memory.place < 0 || !(in || -memory.radius < small)) return nothing;
    return !in ? core : (memory.within_held(y) ? held : steady);
}

void Recalled::find(const Memory* memory, const std::array<const double*, 3>& y, int count, float small,
                    SimdWidth machine) {
    const int first = machine == SimdWidth::two ? 0 : count / 4 * 4;
    if (first > 0) recall_four(memory, y, count, small, *this);
    for (int j = first; j < count; ++j) {
        what[j] = of(memory[j], {y[0][j], y[1][j], y[2][j]}, small);
        place[j] = memory[j].place;
    }
}

}  // namespace type21::optimized
