#include "verification/performance/bench/full_search.h"

#include <algorithm>

namespace type21::bench {

void FullSearch::at(std::span<const optimized::V3> y, std::span<const double> gap, std::span<Decision> found) {
    constexpr size_t capacity = optimized::Search::Batch::capacity;
    optimized::Search::Batch& batch = *batch_;
    batch.depth = laws_.card->depth;
    batch.proximity = 0;
    for (size_t first = 0; first < y.size(); first += capacity) {
        const size_t count = std::min(capacity, y.size() - first);
        batch.count = static_cast<int>(count);
        for (size_t i = 0; i < count; ++i) {
            for (int a = 0; a < 3; ++a)
                batch.y[a][i] = y[first + i][a];
            batch.gap[i] = gap[first + i];
        }
        laws_.search->search(batch, laws_.rules);
        for (size_t i = 0; i < count; ++i) {
            Decision& one = found[first + i];
            one = {};
            ++settled_[static_cast<size_t>(batch.settled[i])];
            if (!batch.id[i].exists()) continue;
            one.kind = batch.kind[i];
            one.segment = batch.id[i].segment();
            one.triangle = batch.id[i].triangle();
            one.side = batch.side[i];
        }
    }
}

}  // namespace type21::bench
