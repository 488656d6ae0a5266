#include "verification/explain/law_points.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "optimized/kernel/friction_law.h"
#include "reference/as_built/reading_of.h"
#include "reference/contact/friction_law.h"

namespace type21 {

namespace {

constexpr int curve_points = 41;
constexpr size_t most_curves = 3;
constexpr double grid = 32;     // cells of the largest value along each axis
constexpr double above = 1.15;  // of the largest pressure, to which curves are drawn
constexpr size_t most_raw = 200000;
constexpr double rounding = 1e-9;  // of forces that are equal

/// One point of each cell of a grid over (x, y), in the order in which they came.
template <class Point, class X, class Y>
std::vector<Point> thinned(const std::vector<Point>& points, const X& x, const Y& y) {
    double wide = 0, high = 0;
    for (const Point& point : points) {
        wide = std::max(wide, std::abs(x(point)));
        high = std::max(high, std::abs(y(point)));
    }
    const auto cell = [](double value, double largest) {
        return largest > 0 ? std::lround(grid * value / largest) : 0L;
    };
    std::set<std::pair<long, long>> taken;
    std::vector<Point> kept;
    for (const Point& point : points)
        if (taken.emplace(cell(x(point), wide), cell(y(point), high)).second) kept.push_back(point);
    return kept;
}

/// All nodes count here: the points drawn are too few to say whether the limit acts.
void add_limited(const NodeContact& node, double area, double pmax, PressureLimit& limit) {
    const double pressure = node.elastic_force / area;
    ++limit.node_cycles;
    limit.largest = std::max(limit.largest, pressure);
    if (!(node.elastic_force < (1 - rounding) * node.stiffness * node.penetration)) return;
    ++limit.lowered;
    if (std::abs(pressure - pmax) > rounding * pmax) return;
    if (limit.plateau++ == 0) limit.first = limit.last = node.penetration;
    limit.first = std::min(limit.first, node.penetration);
    limit.last = std::max(limit.last, node.penetration);
}

/// `pmax` is 0 without a limit.
void add_node(const NodeContact& node, double conductance, double area, bool rubs, double pmax, InterfaceLaws& laws) {
    if (!(area > 0)) return;
    if (conductance > 0 && laws.heat.size() < most_raw) laws.heat.push_back({node.distance, conductance / area});
    if (node.status == Status::open) return;
    if (pmax > 0) {
        add_limited(node, area, pmax, laws.limit);
        if (laws.normal.size() < most_raw) laws.normal.push_back({node.penetration, node.elastic_force / area});
    }
    if (!rubs || node.status != Status::slip || !(node.normal_force > 0) || laws.friction.size() >= most_raw) return;
    const Vec3& v = node.relative_velocity;
    const double speed = (v - v.dot(node.normal) * node.normal).norm();
    laws.friction.push_back({node.normal_force / area, speed, node.friction.norm() / node.normal_force});
}

/// The smallest, a middle and the largest of the speeds of the points.
std::vector<double> speeds_of(const std::vector<FrictionPoint>& points) {
    std::vector<double> speeds;
    speeds.reserve(points.size());
    for (const FrictionPoint& point : points)
        speeds.push_back(point.speed);
    std::sort(speeds.begin(), speeds.end());
    std::vector<double> apart;
    for (const double speed : speeds)
        if (apart.empty() || speed > apart.back() + 0.02 * speeds.back()) apart.push_back(speed);
    if (apart.size() <= most_curves) return apart;
    return {apart.front(), apart[apart.size() / 2], apart.back()};
}

void add_curves(const Model& model, const Interface& card, InterfaceLaws& laws) {
    if (laws.friction.empty()) return;
    const FrictionCoefficients numbers = reference::friction_coefficients(model, card, -1, -1);
    const reference::ContactReading reading = reference::as_built::reading_of(model, card);
    const optimized::FrictionLaw law(card.ifric, model.as_built);
    double largest = 0;
    for (const FrictionPoint& point : laws.friction)
        largest = std::max(largest, point.pressure);
    for (int i = 0; i < curve_points; ++i)
        laws.pressures.push_back(above * largest * i / (curve_points - 1));
    for (const double speed : speeds_of(laws.friction)) {
        FrictionCurve& curve = laws.curves.emplace_back();
        curve.speed = speed;
        for (const double pressure : laws.pressures) {
            curve.mu.push_back(reading.friction_coefficient(card.ifric, numbers, pressure, speed));
            curve.mu_optimized.push_back(law.coefficient(numbers, pressure, speed, 1.0));
        }
    }
}

}  // namespace

std::vector<InterfaceLaws> law_points(const HostScene& scene, const MakeContact& make, const MarchOptions& options) {
    const Model& model = *scene.host;
    std::vector<InterfaceLaws> all(model.interfaces.size());
    std::vector<bool> rubs;
    std::vector<double> pmax;  // 0: no limit
    for (size_t i = 0; i < all.size(); ++i) {
        rubs.push_back(scene.has(static_cast<int>(i), Effect::friction));
        pmax.push_back(scene.has(static_cast<int>(i), Effect::pmax_limit) ? double(model.interfaces[i].pmax) : 0.0);
    }
    const auto observe = [&](const CycleRecord& cycle) {
        for (size_t i = 0; i < all.size(); ++i) {
            const ContactStep& step = (*cycle.contacts)[i];
            for (size_t n = 0; n < step.nodes.size(); ++n)
                add_node(step.nodes[n], step.heat.empty() ? 0.0 : step.heat[n].conductance,
                         model.interfaces[i].secondary.area[n], rubs[i], pmax[i], all[i]);
        }
    };
    try {
        march(scene, make, observe, options);
    } catch (const RunStopped&) {
        // What came about until then counts.
    }
    for (size_t i = 0; i < all.size(); ++i) {
        InterfaceLaws& laws = all[i];
        const Interface& card = model.interfaces[i];
        laws.id = card.id;
        laws.title = card.title;
        laws.ifric = card.ifric;
        laws.pmax = pmax[i];
        laws.several_mu = scene.has(static_cast<int>(i), Effect::friction_heat_factor) || pmax[i] > 0 ||
                          (card.friction_model >= 0 &&
                           !model.friction_models[static_cast<size_t>(card.friction_model)].pairs.empty());
        laws.friction = thinned(
            laws.friction, [](const FrictionPoint& p) { return p.pressure; },
            [](const FrictionPoint& p) { return p.speed; });
        laws.normal = thinned(
            laws.normal, [](const NormalPoint& p) { return p.penetration; },
            [](const NormalPoint& p) { return p.pressure; });
        laws.heat = thinned(
            laws.heat, [](const HeatPoint& p) { return p.distance; }, [](const HeatPoint& p) { return p.conductance; });
        add_curves(model, card, laws);
    }
    return all;
}

double largest_difference(const InterfaceLaws& laws) {
    double largest = 0;
    for (const FrictionCurve& curve : laws.curves)
        for (size_t i = 0; i < curve.mu.size(); ++i)
            largest = std::max(largest, std::abs(curve.mu_optimized[i] - curve.mu[i]) / std::abs(curve.mu[i]));
    return largest;
}

}  // namespace type21
