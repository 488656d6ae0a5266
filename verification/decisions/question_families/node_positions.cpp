#include "verification/decisions/question_families/node_positions.h"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace type21 {

namespace {

struct Weights {
    double b, c;
};

/// Places in a triangle where a comparison changes its outcome, and others.
Weights weights(Draw& draw) {
    constexpr double low = -0.01;  // Formulation 3, step 2
    constexpr double high = 1.01;
    const double t = draw.one_of({draw.unit(), draw.unit(), 0.25, 0.5});
    switch (draw.below(12)) {
        case 0:
            return {1.0 / 3.0, 1.0 / 3.0};
        case 1:
            return {t, 0};
        case 2:
            return {0, t};
        case 3:
            return {t, 1 - t};
        case 4:
            return {0.5 * t, 0.5 * t};
        case 5:
            return draw.one_of<Weights>({{0, 0}, {1, 0}, {0, 1}});
        case 6:
            return {low, t};
        case 7:
            return {t, low};
        case 8:
            return {t, high - t};
        case 9:
            return {draw.between(-0.02, 0.02), t};
        default:
            return {t, (1 - t) * draw.unit()};
    }
}

double height(Draw& draw, const QueryReach& reach) {
    switch (draw.below(8)) {
        case 0:
            return 0;
        case 1:
            return reach.gap;
        case 2:
            return -reach.depth;
        case 3:
            return reach.proximity;
        case 4:
            return draw.between(-1.2, 0) * reach.depth;
        case 5:
            return draw.between(0, 1.2) * reach.proximity;
        default:
            return draw.between(0, 1.2) * reach.gap;
    }
}

}  // namespace

QueryReach reach_for(Draw& draw, double size) {
    QueryReach reach;
    const double power = draw.power_of_two(-6, -1);
    reach.gap = size * power * draw.one_of({1.0, 0.8, draw.between(0.5, 1)});
    reach.depth = draw.one_of({reach.gap, 2 * reach.gap, size * draw.unit()});
    reach.proximity = draw.chance(0.5) ? 0 : reach.gap * draw.one_of({1.0, 2.0, draw.between(1, 3)});
    return reach;
}

Vec3 nudged(Draw& draw, const Vec3& point) {
    Vec3 moved_point = point;
    const double largest = point.cwiseAbs().maxCoeff();
    const double ulp = std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest;
    for (int i = 0; i < 3; ++i) {
        if (draw.chance(0.5)) continue;
        moved_point[i] = draw.chance(0.5) ? moved(point[i], draw.below(5) - 2) : point[i] + ulp * (draw.below(5) - 2);
    }
    return moved_point;
}

ContactQuery query_near(Draw& draw, const DecisionTool& tool, const QueryReach& reach) {
    const auto& corner = tool.segment[static_cast<size_t>(draw.below(static_cast<int>(tool.segment.size())))];
    const auto rank = [&](size_t j) { return static_cast<size_t>(corner[j]); };
    const bool triangle = corner[2] == corner[3];
    const size_t k = static_cast<size_t>(draw.below(4));
    const size_t first = triangle ? 0 : k;
    const size_t second = triangle ? 1 : (k + 1) % 4;
    const auto centre = [&](const std::vector<Vec3>& of) -> Vec3 {
        if (triangle) return of[rank(2)];
        return 0.25 * of[rank(0)] + 0.25 * of[rank(1)] + 0.25 * of[rank(2)] + 0.25 * of[rank(3)];
    };
    const Weights w = weights(draw);
    const auto mixed = [&](const std::vector<Vec3>& of) -> Vec3 {
        return (1 - w.b - w.c) * centre(of) + w.b * of[rank(first)] + w.c * of[rank(second)];
    };
    const Vec3 direction = unit_vector(mixed(tool.normal));
    ContactQuery query = query_at(mixed(tool.node), reach);
    const double h = height(draw, reach);
    if (h != 0) query.point += h * direction;
    if (draw.chance(0.5)) query.point = nudged(draw, query.point);
    return query;
}

void add_queries(Draw& draw, DecisionBlock& block, double size, int count) {
    for (int i = 0; i < count; ++i) {
        const QueryReach reach = reach_for(draw, size);
        block.queries.push_back(query_near(draw, block.tool, reach));
    }
}

}  // namespace type21
