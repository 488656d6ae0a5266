#include "verification/explain/candidate_account.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace type21 {

using reference::Barycentric;
using reference::Impact;
using reference::ProjectionLimits;
using reference::ProjectionStep;

void ProjectionRecord::operator()(ProjectionStep at, double value) {
    if (at == ProjectionStep::height) {
        step = 1;
        height = value;
    } else if (at == ProjectionStep::turn) {
        step = 2;
        turn = value;
    } else {
        step = 3;
        slope = value;
    }
}

void ProjectionRecord::operator()(ProjectionStep at, double first, double second) {
    if (at == ProjectionStep::lifted_weights) {
        lifted = {first, second};
    } else {
        weights = {first, second};
    }
}

void ProjectionRecord::operator()(ProjectionStep, double first, double second, double third) {
    corner_slopes = {first, second, third};
}

namespace {

/// The limit that weights break: "b' = -0.51 < -0.01".
std::string outside_text(const Barycentric<double>& w, const ProjectionLimits<double>& limits, std::string_view mark) {
    if (w.b < limits.low) return fmt::format("b{} = {:.4g} < {}", mark, w.b, limits.low);
    if (w.c < limits.low) return fmt::format("c{} = {:.4g} < {}", mark, w.c, limits.low);
    return fmt::format("b{0}+c{0} = {1:.4g} > {2}", mark, w.b + w.c, limits.high);
}

/// The last number that was computed is the one that led to the rejection.
std::string rejection_text(const ProjectionRecord& r, const ProjectionLimits<double>& limits) {
    if (r.weights) return outside_text(*r.weights, limits, "");
    if (r.slope) return fmt::format("<n,N> = {:.4g} <= 0", *r.slope);
    if (r.lifted) return outside_text(*r.lifted, limits, "'");
    if (r.turn) return fmt::format("<M,N> = {:.4g} <= 0", *r.turn);
    return fmt::format("<n_V,N> = {:.4g} <= 0",
                       std::min({(*r.corner_slopes)[0], (*r.corner_slopes)[1], (*r.corner_slopes)[2]}));
}

/// Step 5 in words: the distance against what decided.
std::string distance_text(const SubTriangleAccount& t, const reference::ContactReach<double>& reach) {
    const char* const sign = t.kind == Kind::none ? ">=" : "<";
    if (t.side < 0) return fmt::format("behind, d = {:.6g} {} DEPTH = {:.6g}", t.distance, sign, reach.depth);
    if (t.kind == Kind::proximity)
        return fmt::format("d = {:.6g} < reach of heat exchange = {:.6g}", t.distance, reach.proximity);
    if (t.kind == Kind::none && reach.proximity > reach.gap)
        return fmt::format("d = {:.6g} >= reach of heat exchange = {:.6g}", t.distance, reach.proximity);
    return fmt::format("d = {:.6g} {} g = {:.6g}", t.distance, sign, reach.gap);
}

/// How the retained impact beats the best of the others.
std::string why_retained(const Impact<double>& best, const std::vector<Impact<double>>& taken,
                         bool proximity_competes) {
    if (taken.empty()) return "";
    if (taken.size() == 1) return "the only sub-triangle that accepts the node";
    Impact<double> other;
    for (const Impact<double>& impact : taken) {
        if (impact.segment == best.segment && impact.triangle == best.triangle) continue;
        if (precedes(impact, other, proximity_competes)) other = impact;
    }
    const std::string name = fmt::format("segment {}, k = {}", other.segment + 1, other.triangle);
    if (other.kind != best.kind && !proximity_competes)
        return fmt::format("contact takes precedence over proximity ({})", name);
    if (best.kappa < other.kappa)
        return fmt::format("smallest kappa of {}: {:.9g}; the next is {:.9g} of {}", taken.size(), best.kappa,
                           other.kappa, name);
    if (best.segment != other.segment)
        return fmt::format("kappa {:.9g} is equal to that of {}; the lower segment number is retained", best.kappa,
                           name);
    return fmt::format("kappa {:.9g} is equal to that of {}; the lower k is retained", best.kappa, name);
}

}  // namespace

CandidateAccount account_candidates(const reference::Inspect& inspect, int i, const Vec3& y) {
    CandidateAccount account;
    const auto limits = inspect.limits();
    const auto reach = inspect.reach(i);
    std::vector<Impact<double>> taken;
    for (const int segment : inspect.candidates(i, y)) {
        SegmentAccount of_segment;
        of_segment.segment = segment;
        const auto shape = inspect.shape(segment);
        for (int k = 1; k <= shape.sub_triangles(); ++k) {
            const auto t = sub_triangle(shape, k);
            SubTriangleAccount one;
            one.triangle = k;
            const auto projection = project<double>(y, t, limits, one.numbers);
            if (projection) {
                const auto near = approach(y, t, projection->weights);
                one.side = near.side;
                one.distance = std::sqrt(near.squared_distance);
                one.kind = classify(near, reach);
                one.kappa = centrality(projection->weights);
                one.step = one.kind == Kind::none ? 5 : 0;
                one.reason = distance_text(one, reach);
            } else {
                one.step = one.numbers.step;
                one.reason = rejection_text(one.numbers, limits);
            }
            if (one.kind != Kind::none) {
                const Impact<double> impact{one.kind, segment, k, one.side, *projection, one.kappa};
                taken.push_back(impact);
                if (precedes(impact, account.retained, inspect.proximity_competes())) account.retained = impact;
            }
            of_segment.triangles.push_back(std::move(one));
        }
        account.rejected += static_cast<int>(std::count_if(of_segment.triangles.begin(), of_segment.triangles.end(),
                                                           [](const auto& t) { return t.kind == Kind::none; }));
        account.segments.push_back(std::move(of_segment));
    }
    account.taken = static_cast<int>(taken.size());
    account.why = why_retained(account.retained, taken, inspect.proximity_competes());
    return account;
}

}  // namespace type21
