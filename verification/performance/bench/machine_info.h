/// @file What the machine can do at most: bandwidth of memory, rate of arithmetic.
#pragma once

#include <string>
#include <vector>

namespace type21::bench {

struct Bandwidth {
    int threads = 1;
    double copy = 0;   ///< a = b: bytes read and written [GB/s]
    double triad = 0;  ///< a = b + s c [GB/s]
};

struct MachineInfo {
    std::string cpu;
    int processors = 0;
    std::string simd;  ///< widest that the product's kernels use here: "avx512f", "avx2", "sse2"
    std::vector<Bandwidth> bandwidth;
    double fma = 0;           ///< multiply-adds count twice, one thread [Gflop/s]
    double load_average = 0;  ///< of the last minute, before the bench: others on the machine [-]
};

/// @param megabytes  of each array; several times the last cache
MachineInfo measure_machine(const std::vector<int>& threads, int megabytes, int repeats);

}  // namespace type21::bench
