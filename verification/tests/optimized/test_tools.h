// Small tools for the tests of the optimized implementation.
#pragma once

#include <functional>
#include <random>

#include "optimized/projection/decide.h"
#include "optimized/search/tool.h"

namespace type21::optimized::testing {

/// A grid of n x n quads (or 2 n^2 triangles) over [-1, 1]^2 at height z(x, y), each inner vertex moved by up to
/// `shake` of an edge.
inline Tool grid(int n, const std::function<double(double, double)>& z, bool triangles = false, double shake = 0,
                 unsigned seed = 1) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> move(-shake * 2 / n, shake * 2 / n);
    std::vector<V3> position;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double x = -1 + 2.0 * i / n + move(random), y = -1 + 2.0 * j / n + move(random);
            position.push_back({x, y, z(x, y)});
        }
    }
    std::vector<std::array<int, 4>> corner;
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            if (triangles) {
                corner.push_back({a, b, c, c});
                corner.push_back({a, c, d, d});
            } else {
                corner.push_back({a, b, c, d});
            }
        }
    }
    const std::vector<V3> normal = nodal_normals(position, corner);
    return {position, normal, corner};
}

/// Every sub-triangle of the tool in whole numbers, without filter and search.
inline Retained exhaustive(
    const Tool& tool, const V3& p, const ContactReach& window, const ProjectionLimits& rules,
    const std::function<bool(const SegmentData&)>& competes = [](const SegmentData&) { return true; }) {
    Retained best;
    ExactLanding least;
    for (int s = 0; s < tool.size(); ++s) {
        const SegmentData segment = tool.segment(s);
        if (!competes(segment)) continue;
        for (int k = 1; k <= segment.pieces(); ++k) {
            ExactLanding one = exact_landing(p, segment, k, window, rules);
            if (!one.taken) continue;
            const bool other_kind =
                best.segment >= 0 && one.landing.kind != least.landing.kind && !rules.proximity_competes;
            const bool first =
                best.segment < 0 || (other_kind ? one.landing.kind == Kind::contact : compare_kappa(one, least) < 0);
            if (!first) continue;
            best = {s, k, one.landing, Settled::whole};
            least = std::move(one);
        }
    }
    return best;
}

inline ::testing::AssertionResult same(const Retained& one, const Retained& other) {
    const bool equal =
        one.segment == other.segment && one.piece == other.piece &&
        (one.segment < 0 || (one.landing.kind == other.landing.kind && one.landing.side == other.landing.side));
    if (equal) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "segment " << one.segment << " piece " << one.piece << " side "
                                         << one.landing.side << ", and segment " << other.segment << " piece "
                                         << other.piece << " side " << other.landing.side;
}

}  // namespace type21::optimized::testing
