#include "optimized/machine.h"

namespace type21::optimized {

#if defined(__GNUC__) && defined(__x86_64__)
Machine this_machine() {
    static const Machine found = __builtin_cpu_supports("avx512f") ? Machine::eight
                                 : __builtin_cpu_supports("avx2")  ? Machine::four
                                                                   : Machine::two;
    return found;
}

bool has_fma() {
    static const bool found = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    return found;
}
#else
Machine this_machine() {
    return Machine::two;
}

bool has_fma() {
    return false;
}
#endif

}  // namespace type21::optimized
