#include "verification/decisions/queries/decide.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "optimized/projection/query.h"
#include "optimized/search/sorted/query_by_search.h"
#include "reference/exact/fraction.h"
#include "reference/exact/impact_enclosure.h"
#include "verification/decisions/queries/tool_candidates.h"

namespace type21 {

namespace {

using Box = Eigen::AlignedBox3d;

constexpr std::array methods{DecideWith::reference, DecideWith::optimized, DecideWith::exact, DecideWith::plain};
constexpr std::array methods_of_search{DecideWith::by_tree, DecideWith::by_sorting};

/// Exact: the answers are, and a tool must not be called flat that takes a node, nor the other way round.
bool has_area(const reference::SegmentShape<double>& shape) {
    using Number = reference::Fraction;
    for (int k = 1; k <= shape.sub_triangles(); ++k) {
        const reference::SubTriangle<double> rounded = reference::sub_triangle(shape, k);
        const double size =
            std::max((rounded.b - rounded.a).cwiseAbs().maxCoeff(), (rounded.c - rounded.a).cwiseAbs().maxCoeff());
        const double place = std::max(
            {rounded.a.cwiseAbs().maxCoeff(), rounded.b.cwiseAbs().maxCoeff(), rounded.c.cwiseAbs().maxCoeff()});
        // Beyond what rounding makes of the corners and of the product, and far from where squares underflow.
        const double area = rounded.area.cwiseAbs().maxCoeff();
        if (std::isfinite(area) && size > 1e-140 && area > 1e-12 * size * std::max(size, place)) return true;
        if (reference::sub_triangle(reference::convert_to<Number>(shape), k).area != Vector<Number>::Zero())
            return true;
    }
    return false;
}

double farthest_reach(const ContactQuery& query) {
    return std::max({query.gap, query.depth, query.proximity_reach});
}

/// Distance from a point to the box of a segment [length].
double distance_to_box(const DecisionTool& tool, int segment, const Vec3& point) {
    Box box;
    for (const int corner : tool.segment[static_cast<size_t>(segment)])
        box.extend(tool.node[static_cast<size_t>(corner)]);
    const Vec3 outside = (box.min() - point).cwiseMax(point - box.max()).cwiseMax(0.0);
    return outside.stableNorm();
}

}  // namespace

reference::SegmentShape<double> shape_of(const DecisionTool& tool, int segment) {
    const auto& corner = tool.segment[static_cast<size_t>(segment)];
    reference::SegmentShape<double> shape;
    for (size_t j = 0; j < 4; ++j) {
        shape.node[j] = tool.node[static_cast<size_t>(corner[j])];
        shape.normal[j] = tool.normal[static_cast<size_t>(corner[j])];
    }
    shape.triangle = corner[2] == corner[3];
    return shape;
}

std::vector<int> segments_near(const DecisionTool& tool, const ContactQuery& query) {
    constexpr double rounding = 1e-9;
    std::vector<int> found;
    for (int s = 0; s < static_cast<int>(tool.segment.size()); ++s) {
        const double reach = farthest_reach(query);
        const double size = query.point.cwiseAbs().maxCoeff();
        if (!(distance_to_box(tool, s, query.point) > reach + rounding * (reach + size))) found.push_back(s);
    }
    return found;
}

std::string_view name(DecideWith method) {
    switch (method) {
        case DecideWith::reference:
            return "reference";
        case DecideWith::optimized:
            return "optimized";
        case DecideWith::by_tree:
            return "optimized-tree";
        case DecideWith::by_sorting:
            return "optimized-sorted";
        case DecideWith::exact:
            return "exact";
        case DecideWith::plain:
            break;
    }
    return "double";
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const DecideWith method : methods)
        names.emplace_back(name(method));
    return names;
}

DecideWith method_named(std::string_view word) {
    for (const DecideWith method : methods)
        if (name(method) == word) return method;
    for (const DecideWith method : methods_of_search)
        if (name(method) == word) return method;
    throw std::invalid_argument(fmt::format("there is no way '{}' to decide", word));
}

DecisionAnswer decide(const DecisionTool& tool, const ContactQuery& query, DecideWith method,
                      DecisionStageCounts* counts) {
    if (method == DecideWith::optimized || method == DecideWith::by_tree || method == DecideWith::by_sorting) {
        if (!query.as_documented())
            throw std::invalid_argument("the optimized implementation answers queries with the documented limits only");
        const auto answer = [&](auto... search) {
            return optimized::decide_query(tool.node, tool.normal, tool.segment, query.point, query.gap, query.depth,
                                           query.proximity_reach, search...);
        };
        using optimized::SearchKind;
        const Decision decision = method == DecideWith::optimized ? answer()
                                  : method == DecideWith::by_tree ? answer(SearchKind::tree)
                                                                  : answer(SearchKind::sorted);
        return {decision.kind, decision.segment, decision.triangle, decision.side, decision.stage, 0, 0};
    }
    const ToolCandidates candidates(tool, query);
    reference::StagedImpact impact;
    switch (method) {
        case DecideWith::reference:
            impact = staged_impact(query, candidates.segments(), counts);
            break;
        case DecideWith::optimized:
        case DecideWith::by_tree:
        case DecideWith::by_sorting:
            break;
        case DecideWith::exact:
            impact = exact_impact(query, candidates.segments());
            break;
        case DecideWith::plain:
            impact = double_impact(query, candidates.segments());
            break;
    }
    return {impact.kind, impact.segment, impact.triangle, impact.side, impact.stage, 0, 0};
}

double margin(const DecisionTool& tool, const ContactQuery& query) {
    const ToolCandidates candidates(tool, query);
    const std::vector<int>& segments = candidates.ranks();
    double margin = decision_margin(query, candidates.segments());
    // A segment that is too far away cannot matter before its box is in reach.
    for (int s = 0; s < static_cast<int>(tool.segment.size()); ++s)
        if (!std::binary_search(segments.begin(), segments.end(), s))
            margin = std::min(margin, distance_to_box(tool, s, query.point) - farthest_reach(query));
    return margin;
}

double in_ulps(double length, const Vec3& point) {
    const double largest = point.cwiseAbs().maxCoeff();
    return length / (std::nextafter(largest, std::numeric_limits<double>::infinity()) - largest);
}

std::vector<std::string> warnings(const DecisionTool& tool) {
    size_t flat = 0;
    for (int s = 0; s < static_cast<int>(tool.segment.size()); ++s)
        if (!has_area(shape_of(tool, s))) ++flat;
    // Normals of a Radioss run are unit to rounding; others are taken as given, as the limits are defined with them.
    const auto odd = std::count_if(tool.normal.begin(), tool.normal.end(),
                                   [](const Vec3& n) { return std::abs(n.stableNorm() - 1.0) > 1e-6; });
    std::vector<std::string> found;
    if (flat > 0) found.push_back(fmt::format("{} segments have no area: nothing touches them", flat));
    if (odd > 0) found.push_back(fmt::format("{} normals are not of unit length; taken as given", odd));
    return found;
}

}  // namespace type21
