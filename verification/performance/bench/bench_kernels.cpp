// The small pieces by themselves, with Google Benchmark: bench_kernels [--benchmark_filter=...].
#include <random>

#include <benchmark/benchmark.h>

#include "optimized/projection/a_priori_bounds.h"
#include "optimized/projection/decide.h"
#include "optimized/projection/project_double.h"
#include "optimized/sums/step_sums.h"

namespace type21::optimized {
namespace {

/// A square of four with a little noise in its corners and normals, and nodes over it.
struct Patch {
    explicit Patch(double noise) {
        std::mt19937_64 random(3);
        std::uniform_real_distribution<double> unit(-1, 1);
        for (int j = 0; j < 3; ++j)
            for (int i = 0; i < 3; ++i) {
                node.push_back({i + noise * unit(random), j + noise * unit(random), noise * unit(random)});
                normal.push_back({noise * unit(random), noise * unit(random), 1});
            }
        for (int j = 0; j < 2; ++j) {
            for (int i = 0; i < 2; ++i) {
                SegmentData s;
                const int corner[4] = {3 * j + i, 3 * j + i + 1, 3 * j + i + 4, 3 * j + i + 3};
                for (size_t c = 0; c < 4; ++c) {
                    s.node[c] = node[static_cast<size_t>(corner[c])];
                    s.normal[c] = normal[static_cast<size_t>(corner[c])];
                }
                segment.push_back(s);
            }
        }
        for (int i = 0; i < 256; ++i)
            position.push_back({0.7 + 0.3 * unit(random), 0.7 + 0.3 * unit(random), 0.2 * unit(random)});
    }
    std::vector<V3> node, normal, position;
    std::vector<SegmentData> segment;
    ContactReach reach{0.25, 0.25, 0};
};

void one_filter(benchmark::State& state) {
    const Patch patch(0.05);
    const LocalSegment local = local_segment(patch.segment[0]);
    size_t i = 0;
    for (auto _ : state) {
        ++i;
        benchmark::DoNotOptimize(
            filter(patch.position[i % 256], patch.segment[0], local, 1 + static_cast<int>(i % 4), patch.reach, {}));
    }
}
BENCHMARK(one_filter)->Name("filter: double with bounds, one sub-triangle");

void one_double_double(benchmark::State& state) {
    const Patch patch(0.05);
    KappaDoubleDouble kappa;
    size_t i = 0;
    for (auto _ : state) {
        ++i;
        benchmark::DoNotOptimize(filter_double_double(patch.position[i % 256], patch.segment[0],
                                                      1 + static_cast<int>(i % 4), patch.reach, {}, kappa));
    }
}
BENCHMARK(one_double_double)->Name("double-double with bounds, one sub-triangle");

void one_in_integers(benchmark::State& state) {
    const Patch patch(0.05);
    size_t i = 0;
    for (auto _ : state) {
        ++i;
        benchmark::DoNotOptimize(
            project_exact(patch.position[i % 256], patch.segment[0], 1 + static_cast<int>(i % 4), patch.reach, {}));
    }
}
BENCHMARK(one_in_integers)->Name("integers, one sub-triangle");

void many_plain(benchmark::State& state) {
    const Patch patch(0.05);
    ProjectionBatch rows;
    for (size_t i = 0; i < ProjectionBatch::capacity; ++i) {
        const SegmentData& segment = patch.segment[i % 4];
        for (int a = 0; a < 3; ++a) {
            rows.y[a][i] = patch.position[i][a];
            for (size_t j = 0; j < 4; ++j) {
                rows.corner[j][a][i] = segment.node[j][a];
                rows.normal[j][a][i] = segment.normal[j][a];
            }
        }
        rows.code[i] = static_cast<long long>(i % 4);
        rows.exclusive_margin[i] = 0;
        rows.size[i] = a_priori_size(2, 0.25);
        rows.gap[i] = 0.25;
    }
    for (auto _ : state) {
        project_double(rows, 0, ProjectionBatch::capacity, {0.25, 0.25, 0.25, 0, true});
        benchmark::ClobberMemory();
    }
}
BENCHMARK(many_plain)->Name("plain projection, 64 nodes");

/// A decision among the four squares. @param state.range(0)  0: anywhere on a noisy patch; 1: over the corner that the
/// squares of a regular one share; 2: over the middle of an edge; 3: over a centre
void decide(benchmark::State& state) {
    const Patch patch(state.range(0) == 0 ? 0.05 : 0.0);
    const V3 tied[] = {{}, {1, 1, 0.125}, {1, 0.5, 0.125}, {0.5, 0.5, 0.125}};
    size_t i = 0;
    for (auto _ : state) {
        const V3 p = state.range(0) == 0 ? patch.position[i++ % 256] : tied[state.range(0)];
        Decider decider(p, patch.reach, {});
        for (int s = 0; s < 4; ++s)
            decider.add(s, patch.segment[static_cast<size_t>(s)]);
        benchmark::DoNotOptimize(decider.retained([&](int s) { return patch.segment[static_cast<size_t>(s)]; }));
    }
}
BENCHMARK(decide)->Name("decision of 16 sub-triangles: ordinary, corner tie, edge tie, centre tie")->DenseRange(0, 3);

void sum_block(benchmark::State& state) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> number;
    double values[TermBlock::capacity];
    for (double& v : values)
        v = number(random);
    ExactAccumulator sum;
    for (auto _ : state) {
        sum.add_block(values, TermBlock::capacity);
        benchmark::ClobberMemory();
    }
    state.SetItemsProcessed(state.iterations() * TermBlock::capacity);
}
BENCHMARK(sum_block)->Name("exact sum, a block of numbers");

}  // namespace
}  // namespace type21::optimized

BENCHMARK_MAIN();
