#include "optimized/simd/simd_width.h"

#include <algorithm>
#include <atomic>

namespace type21::optimized {

namespace {

#if defined(__GNUC__) && defined(__x86_64__)
Machine widest() {
    if (__builtin_cpu_supports("avx512f")) return Machine::eight;
    return __builtin_cpu_supports("avx2") ? Machine::four : Machine::two;
}
bool fused() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#else
Machine widest() {
    return Machine::two;
}
bool fused() {
    return false;
}
#endif

std::atomic<Machine>& used() {
    static std::atomic<Machine> machine{widest()};
    return machine;
}

}  // namespace

Machine this_machine() {
    return used().load(std::memory_order_relaxed);
}

bool has_fma() {
    static const bool found = fused();
    return found && this_machine() != Machine::two;
}

Narrowed::Narrowed(Machine machine) {
    used() = std::min(machine, widest());
}

Narrowed::~Narrowed() {
    used() = widest();
}

}  // namespace type21::optimized
