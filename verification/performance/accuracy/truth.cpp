#include "verification/performance/accuracy/truth.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "reference/exact/impact_enclosure.h"
#include "verification/criteria/lockstep/ulp_tally.h"
#include "verification/decisions/fuzz/second_opinion.h"
#include "verification/decisions/queries/decide.h"
#include "verification/decisions/queries/question.h"

namespace type21::accuracy {

namespace {

using reference::Fraction;

constexpr double rounding_ulps = 16;  // as the law: geometric_penetration() of the reference

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

bool fits(const DecisionTool& tool, const DecisionQuery& query) {
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

Truth truth_of(const DecisionTool& tool, const DecisionQuery& query) {
    Truth truth;
    truth.answer = second_opinion(tool, query);
    if (truth.answer.kind != Kind::contact || !fits(tool, query)) return truth;
    const Question question(tool, query);
    const auto impact = reference::impact_in<Fraction>(question.input(), shape_of(tool, truth.answer.segment),
                                                       truth.answer.segment, truth.answer.triangle);
    const auto& projection = impact.projection;
    truth.force = exact_force(stiffness, query.gap, projection.height, projection.normal.dot(projection.normal),
                              projection.slope);
    double largest = std::max(query.gap, query.point.cwiseAbs().maxCoeff());
    for (const int corner : tool.segment[static_cast<size_t>(truth.answer.segment)])
        largest = std::max(largest, tool.node[static_cast<size_t>(corner)].cwiseAbs().maxCoeff());
    truth.scale = stiffness * largest;
    truth.forced = truth.force > rounding_ulps * ulp_of_one * truth.scale;
    return truth;
}

}  // namespace type21::accuracy
