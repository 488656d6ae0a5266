#include "verification/performance/bench/plain_search.h"

#include <algorithm>
#include <cmath>

#include "optimized/projection/a_priori_bounds.h"
#include "optimized/search/segment_boxes.h"

namespace type21::bench {

using optimized::ProjectionBatch;
using optimized::V3;

PlainSearch::PlainSearch(const optimized::Tool& tool, const optimized::CaptureLimits& limits)
    : tool_(tool), limits_(limits), tree_(segment_boxes(tool, limits)) {}

void PlainSearch::at(std::span<const V3> y, std::span<const double> gap, double depth, std::span<Decision> found) {
    std::fill(found.begin(), found.end(), Decision{});
    kappa_.assign(found.size(), HUGE_VAL);
    for (size_t i = 0; i < y.size(); ++i) {
        tree_.at(y[i], [&](int s) {
            for (int k = 1; k <= (tool_.is_triangle(s) ? 1 : 4); ++k) {
                if (count_ == ProjectionBatch::capacity) decide(gap, depth, found);
                for (int a = 0; a < 3; ++a)
                    rows_.y[a][count_] = y[i][a];
                candidates_[count_++] = {static_cast<int>(i), {s, k}};
            }
        });
    }
    decide(gap, depth, found);
}

/// Chapters 3 and 4 of the formulation on the plain numbers.
void PlainSearch::decide(std::span<const double> gap, double depth, std::span<Decision> found) {
    if (count_ == 0) return;
    optimized::SubTriangleId id[ProjectionBatch::capacity];
    for (int c = 0; c < count_; ++c)
        id[c] = candidates_[c].id;
    gather(rows_, tool_, id, 0, count_, std::max(limits_.outward, limits_.inward));
    project_double(rows_, 0, count_, {limits_.outward, limits_.inward, depth, 0, false});
    for (int c = 0; c < count_; ++c) {
        const ProjectionBatch& r = rows_;
        constexpr double low = optimized::weight_limit;
        const double a = 1 - r.b[c] - r.c[c], b = r.b[c], q = r.c[c];
        const bool lands = r.total[c] > 0 && std::min({r.weight[0][c], r.weight[1][c], r.weight[2][c]}) >= low &&
                           std::min({a, b, q}) >= low;
        if (!lands) continue;
        const auto i = static_cast<size_t>(candidates_[c].node);
        const double kappa = optimized::kappa_of(b, q);
        const int segment = id[c].segment(), triangle = id[c].triangle();
        Decision& best = found[i];
        const bool lower = segment < best.segment || (segment == best.segment && triangle < best.triangle);
        if (kappa > kappa_[i] || (kappa == kappa_[i] && !lower)) continue;
        const V3 n{r.n[0][c], r.n[1][c], r.n[2][c]};
        double distance = std::abs(r.lift[c]) * norm(n);
        if (std::min({a, b, q}) < 0) {
            const double ca = std::clamp(a, 0.0, 1.0), cb = std::clamp(b, 0.0, 1.0), cc = std::clamp(q, 0.0, 1.0),
                         sum = ca + cb + cc;
            distance = norm(optimized::offset_from_point({r.y[0][c], r.y[1][c], r.y[2][c]}, tool_.segment(segment),
                                                         triangle, cb / sum, cc / sum));
        }
        const bool front = r.height[c] >= 0;
        if (!(distance < (front ? gap[i] : depth))) continue;
        best = {Kind::contact, segment, triangle, front ? 1 : -1, b, q, Stage::bounded};
        kappa_[i] = kappa;
    }
    count_ = 0;
}

}  // namespace type21::bench
