#include "optimized/simd/simd_width.h"

#include <algorithm>
#include <atomic>

namespace type21::optimized {

namespace {

#if defined(__GNUC__) && defined(__x86_64__)
SimdWidth widest() {
    if (__builtin_cpu_supports("avx512f")) return SimdWidth::eight;
    return __builtin_cpu_supports("avx2") ? SimdWidth::four : SimdWidth::two;
}
bool fused() {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#else
SimdWidth widest() {
    return SimdWidth::two;
}
bool fused() {
    return false;
}
#endif

std::atomic<SimdWidth>& used() {
    static std::atomic<SimdWidth> machine{widest()};
    return machine;
}

}  // namespace

SimdWidth this_machine() {
    return used().load(std::memory_order_relaxed);
}

bool has_fma() {
    static const bool found = fused();
    return found && this_machine() != SimdWidth::two;
}

SimdWidthCap::SimdWidthCap(SimdWidth machine) {
    used() = std::min(machine, widest());
}

SimdWidthCap::~SimdWidthCap() {
    used() = widest();
}

}  // namespace type21::optimized
