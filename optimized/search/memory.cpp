#include "optimized/search/memory.h"

#include "optimized/simd/lanes.h"

namespace type21::optimized {

namespace {

static_assert(sizeof(Memory) == 5 * sizeof(double) && offsetof(Memory, center) == 0);

/// Four memories at a time. The first four numbers of each are transposed; the fourth is not used.
TYPE21_AVX2 void recall_four(const Memory* memory, const std::array<const double*, 3>& y, int count, float small,
                             Recalled& found) {
    using L = Lanes<4>;
    using I = IntegerLanes<L>;
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
        VectorLanes<L> center, way;
        center.x = __builtin_shufflevector(even, even_too, 0, 1, 4, 5);
        center.y = __builtin_shufflevector(odd, odd_too, 0, 1, 4, 5);
        center.z = __builtin_shufflevector(even, even_too, 2, 3, 6, 7);
        const Memory* const m = memory + j;
        const L radius{double(m[0].radius), double(m[1].radius), double(m[2].radius), double(m[3].radius)};
        const L contact{double(m[0].contact_safe), double(m[1].contact_safe), double(m[2].contact_safe),
                        double(m[3].contact_safe)};
        const Four last{m[0].last.code(), m[1].last.code(), m[2].last.code(), m[3].last.code()};
        load(y[0] + j, y[1] + j, y[2] + j, way);
        minus(way, center, way);
        L square;
        dot_of(way, way, square);
        square *= 1 + 1e-14;
        const L zero = radius - radius;
        const I in_radius = square < radius * radius, in_contact = square<contact * contact, separates = radius> zero;
        const I safe = in_radius & ~separates;
        const I near = -radius < zero + double(small);
        const I looks = ~separates & (near | safe) & (__builtin_convertvector(last, I) >= 0);
        // The enumerators are numbered so that each condition adds one; -1 is true.
        const I what = (in_radius & separates & 1) - (looks + looks) - (looks & safe) - (looks & safe & in_contact);
        const Four found_what = __builtin_convertvector(what, Four);
        __builtin_memcpy(found.what + j, &found_what, sizeof(found_what));
        __builtin_memcpy(static_cast<void*>(found.last + j), &last, sizeof(last));
    }
}

}  // namespace

Recalled::What Recalled::of(const Memory& memory, const V3& y, float small) {
    const bool in = memory.within(y);
    if (memory.radius > 0) return in ? separated : nothing;
    if (!memory.last.exists() || !(in || -memory.radius < small)) return nothing;
    if (!in) return project;
    return memory.within_contact_safe(y) ? contact_safe : ranking_safe;
}

void Recalled::find(const Memory* memory, const std::array<const double*, 3>& y, int count, float small,
                    SimdWidth machine) {
    const int first = machine == SimdWidth::two ? 0 : count / 4 * 4;
    if (first > 0) recall_four(memory, y, count, small, *this);
    for (int j = first; j < count; ++j) {
        what[j] = of(memory[j], {y[0][j], y[1][j], y[2][j]}, small);
        last[j] = memory[j].last;
    }
}

}  // namespace type21::optimized
