#include "verification/performance/bench/machine_info.h"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <thread>

#include "verification/performance/bench/timing.h"
#include "verification/support/build_info.h"

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define TYPE21_WIDEST __attribute__((target_clones("default", "arch=haswell", "avx512f")))
#else
#define TYPE21_WIDEST
#endif

namespace type21::bench {

namespace {

/// Runs f(first, last) on so many threads, each with its own part.
template <class F>
void in_parts(int threads, size_t count, const F& f) {
    tbb::task_arena arena(threads);
    arena.execute([&] {
        tbb::parallel_for(
            tbb::blocked_range<int>(0, threads, 1),
            [&](const tbb::blocked_range<int>& range) {
                for (int t = range.begin(); t < range.end(); ++t) {
                    const auto part = [&](int i) {
                        return count * static_cast<size_t>(i) / static_cast<size_t>(threads);
                    };
                    f(part(t), part(t + 1));
                }
            },
            tbb::static_partitioner());
    });
}

Bandwidth bandwidth(int threads, size_t count, int repeats) {
    const std::unique_ptr<double[]> a(new double[count]), b(new double[count]), c(new double[count]);
    double *pa = a.get(), *pb = b.get(), *pc = c.get();
    in_parts(threads, count, [&](size_t first, size_t last) {
        std::fill(pa + first, pa + last, 0.0);
        std::fill(pb + first, pb + last, 1.0);
        std::fill(pc + first, pc + last, 2.0);
    });
    Bandwidth best{threads, 0, 0};
    const double bytes = static_cast<double>(count * sizeof(double));
    for (int r = 0; r < repeats; ++r) {
        const Watch copying(false);
        in_parts(threads, count, [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i)
                pa[i] = pb[i];
            keep(pa[first]);
        });
        best.copy = std::max(best.copy, 2 * bytes / copying.nanoseconds());
        const Watch adding(false);
        in_parts(threads, count, [&](size_t first, size_t last) {
            for (size_t i = first; i < last; ++i)
                pa[i] = pb[i] + 3.0 * pc[i];
            keep(pa[first]);
        });
        best.triad = std::max(best.triad, 3 * bytes / adding.nanoseconds());
    }
    return best;
}

constexpr int lanes = 8, chains = 12;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

/// `chains` sums that do not wait for each other. This file alone is compiled with contraction.
TYPE21_WIDEST
double multiply_add(long steps, double factor) {
    Lanes sum[chains];
    for (int i = 0; i < chains; ++i)
        sum[i] = Lanes{} + double(i);
    const Lanes f = Lanes{} + factor, g = Lanes{} + 1e-3;
    for (long s = 0; s < steps; ++s) {
        for (int i = 0; i < chains; ++i)
            sum[i] = sum[i] * f + g;
    }
    double out = 0;
    for (int i = 0; i < chains; ++i)
        for (int j = 0; j < lanes; ++j)
            out += sum[i][j];
    return out;
}

double fma_rate(int repeats) {
    constexpr long steps = 1000000;
    double best = 0;
    for (int r = 0; r < repeats; ++r) {
        const Watch watch(true);
        keep(multiply_add(steps, 0.999 + 1e-9 * r));
        best = std::max(best, 2.0 * lanes * chains * static_cast<double>(steps) / watch.nanoseconds());
    }
    return best;
}

std::string widest() {
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
    if (__builtin_cpu_supports("avx512f")) return "avx512f";
    if (__builtin_cpu_supports("avx2")) return "avx2";
    return "sse2";
#else
    return "baseline";
#endif
}

}  // namespace

MachineInfo measure_machine(const std::vector<int>& threads, int megabytes, int repeats) {
    MachineInfo machine;
    machine.cpu = build_info().cpu;
    machine.processors = static_cast<int>(std::thread::hardware_concurrency());
    machine.simd = widest();
    double load[1] = {0};
    if (getloadavg(load, 1) == 1) machine.load_average = load[0];
    for (const int t : threads)
        machine.bandwidth.push_back(bandwidth(t, static_cast<size_t>(megabytes) * (1 << 17), repeats));
    machine.fma = fma_rate(std::max(repeats, 3));
    return machine;
}

}  // namespace type21::bench
