#include "optimized/search/memory.h"

#include "optimized/lanes.h"

namespace type21::optimized {

namespace {

static_assert(sizeof(Memory) == 4 * sizeof(double) && offsetof(Memory, from) == sizeof(double));

/// Four nodes: four memories, four numbers each, turned.
TYPE21_AVX2 void within_four(const Memory* memory, const std::array<const double*, 3>& y, int count,
                             long long* within) {
    using L = Lanes<4>;
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
        from.x = __builtin_shufflevector(odd, odd_too, 0, 1, 4, 5);
        from.y = __builtin_shufflevector(even, even_too, 2, 3, 6, 7);
        from.z = __builtin_shufflevector(odd, odd_too, 2, 3, 6, 7);
        const L radius{double(memory[j].radius), double(memory[j + 1].radius), double(memory[j + 2].radius),
                       double(memory[j + 3].radius)};
        load(y[0] + j, y[1] + j, y[2] + j, way);
        minus(way, from, way);
        L square;
        dot_of(way, way, square);
        const WholeLanes<L> holds = square * (1 + 1e-14) < radius * radius;
        store(holds, within + j);
    }
}

}  // namespace

void within_balls(const Memory* memory, const std::array<const double*, 3>& y, int count, long long* within,
                  Machine machine) {
    const int first = machine == Machine::two ? 0 : count / 4 * 4;
    if (first > 0) within_four(memory, y, count, within);
    for (int j = first; j < count; ++j)
        within[j] = -static_cast<long long>(memory[j].within({y[0][j], y[1][j], y[2][j]}));
}

}  // namespace type21::optimized
