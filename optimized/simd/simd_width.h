/// @file Code for the registers of several machines. The choice is made when the program runs.
#pragma once

namespace type21::optimized {

#define TYPE21_INLINE inline __attribute__((always_inline))
#if defined(__GNUC__) && defined(__x86_64__)
#define TYPE21_AVX2 __attribute__((target("avx2")))
#define TYPE21_AVX512 __attribute__((target("avx512f")))
#define TYPE21_FMA __attribute__((target("avx2,fma")))
#else
#define TYPE21_AVX2
#define TYPE21_AVX512
#define TYPE21_FMA
#endif

/// How many doubles a register holds. Loops for each machine are one template, compiled with 2, 4 or 8 lanes; every
/// operation is that of one double and nothing is contracted: each gives the same bits.
enum class SimdWidth { two = 2, four = 4, eight = 8 };

/// The widest that this processor has, or less while a SimdWidthCap exists.
SimdWidth this_machine();
/// Does the processor have a fused multiply-add? It is used for exact products only, which are the same without it.
bool has_fma();

/// Of a loop that was compiled for each width, the one for this machine.
template <class Function>
Function* compiled_for(SimdWidth machine, Function* eight, Function* four, Function* two) {
    return machine == SimdWidth::eight ? eight : (machine == SimdWidth::four ? four : two);
}

/// Caps the width, so that one processor can show what others compute. Not to be used while other threads compute.
class SimdWidthCap {
  public:
    explicit SimdWidthCap(SimdWidth machine);
    ~SimdWidthCap();
    SimdWidthCap(const SimdWidthCap&) = delete;
    SimdWidthCap& operator=(const SimdWidthCap&) = delete;
};

}  // namespace type21::optimized
