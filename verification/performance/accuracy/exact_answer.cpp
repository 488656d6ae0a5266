#include "verification/performance/accuracy/exact_answer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/impact_enclosure.h"
#include "verification/criteria/lockstep/ulp_tally.h"
#include "verification/decisions/fuzz/second_opinion.h"
#include "verification/decisions/queries/decide.h"
#include "verification/decisions/queries/tool_candidates.h"

namespace type21::accuracy {

namespace {

using reference::Fraction;

constexpr double rounding_ulps = 16;  // as in the law: geometric_penetration() of the reference

double nearest(const Fraction& exact) {
    const auto [low, high] = exact.enclosure();
    double best = low;
    const double last = std::nextafter(high, std::numeric_limits<double>::infinity());
    const auto away = [&](double value) { return magnitude(exact - Fraction(value)); };
    for (double one = low; one != last && std::isfinite(one);
         one = std::nextafter(one, std::numeric_limits<double>::infinity()))
        if (away(one) < away(best)) best = one;
    return best;
}

bool fits(const DecisionTool& tool, const ContactQuery& query) {
    const auto of_size = [](const Vec3& x) {
        return x.cwiseAbs().maxCoeff() < 1e60 && (x.array() == 0 || x.array().abs() > 1e-60).all();
    };
    for (const Vec3& x : tool.node)
        if (!of_size(x)) return false;
    return of_size(query.point);
}

}  // namespace

double exact_force(double k, double gap, const Fraction& height, const Fraction& normal_squared,
                   const Fraction& slope) {
    const Fraction squared = height * height * normal_squared / (slope * slope);
    Fraction distance(0);
    if (squared.sign() != 0) {
        distance = Fraction(std::sqrt(squared.to_double()));
        for (int i = 0; i < 2; ++i) {
            const double correction = (squared - distance * distance).to_double() / (2 * distance.to_double());
            distance += Fraction(correction);
        }
    }
    if (height.sign() < 0) distance = -distance;
    return nearest((Fraction(gap) - distance) * Fraction(k));
}

ExactAnswer exact_answer_of(const DecisionTool& tool, const ContactQuery& query) {
    ExactAnswer exact;
    exact.answer = second_opinion(tool, query);
    if (exact.answer.kind != Kind::contact || !fits(tool, query)) return exact;
    const auto impact = reference::impact_in<Fraction>(query, shape_of(tool, exact.answer.segment),
                                                       exact.answer.segment, exact.answer.triangle);
    const auto& projection = impact.projection;
    exact.force = exact_force(stiffness, query.gap, projection.height, projection.normal.dot(projection.normal),
                              projection.slope);
    double largest = std::max(query.gap, query.point.cwiseAbs().maxCoeff());
    for (const int corner : tool.segment[static_cast<size_t>(exact.answer.segment)])
        largest = std::max(largest, tool.node[static_cast<size_t>(corner)].cwiseAbs().maxCoeff());
    exact.scale = stiffness * largest;
    exact.forced = exact.force > rounding_ulps * ulp_of_one * exact.scale;
    return exact;
}

}  // namespace type21::accuracy
