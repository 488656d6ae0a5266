#include "reference/exact/staged_impact.h"

#include <algorithm>
#include <chrono>
#include <map>

#include "reference/exact/bounded.h"
#include "reference/exact/fraction.h"
#include "reference/exact/impact_enclosure.h"
#include "reference/exact/magnitudes.h"

namespace type21::reference {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The stages of one node: exact impacts are kept until the race is over.
class Stages {
  public:
    Stages(const DecisionInput& input, DecisionStageCounts* stage_counts)
        : input_(input), stage_counts_(stage_counts) {}

    ImpactEnclosure judge(const SegmentShape<double>& shape, int segment, int k) {
        if (const auto answer = judged_by_bound(input_, shape, segment, k)) return *answer;
        if (const auto answer = judge_by_interval(shape, segment, k)) return *answer;
        const auto& impact = exact(segment, k);
        const auto [low, high] = impact.kappa.enclosure();
        return judged(impact, low, high);
    }

    /// True when one is retained rather than other.
    bool precedes(const ImpactEnclosure& one, const ImpactEnclosure& other) {
        const int kinds = order_of_kinds(one.kind, other.kind, input_.proximity_competes);
        if (kinds != 0) return kinds < 0;
        if (one.kind == Kind::none || one.kappa_low > other.kappa_high) return false;
        if (one.kappa_high < other.kappa_low) return true;
        return reference::precedes(exact(one.segment, one.triangle), exact(other.segment, other.triangle),
                                   input_.proximity_competes);
    }

    const Impact<Fraction>& exact(int segment, int k) {
        stage_ = Stage::exact;
        const auto known = exact_.find({segment, k});
        if (known != exact_.end()) return known->second;
        const auto start = Clock::now();
        const auto& impact =
            exact_.emplace(std::pair{segment, k}, impact_in<Fraction>(input_, input_.shape_of(segment), segment, k))
                .first->second;
        add_time(Stage::exact, start);
        return impact;
    }

    Stage stage() const { return stage_; }

  private:
    std::optional<ImpactEnclosure> judge_by_interval(const SegmentShape<double>& shape, int segment, int k) {
        stage_ = std::max(stage_, Stage::interval);
        const auto start = Clock::now();
        const auto answer = judged_by_interval(input_, shape, segment, k);
        add_time(Stage::interval, start);
        return answer;
    }

    void add_time(Stage stage, Clock::time_point start) const {
        if (stage_counts_ != nullptr) stage_counts_->seconds[static_cast<size_t>(stage)] += seconds_since(start);
    }

    const DecisionInput& input_;
    DecisionStageCounts* stage_counts_;
    Stage stage_ = Stage::bounded;
    std::map<std::pair<int, int>, Impact<Fraction>> exact_;
};

Projection<double> rounded(const Projection<Fraction>& exact) {
    Projection<double> projection;
    projection.weights = {exact.weights.b.to_double(), exact.weights.c.to_double()};
    for (int i = 0; i < 3; ++i)
        projection.normal[i] = exact.normal[i].to_double();
    projection.height = exact.height.to_double();
    projection.slope = exact.slope.to_double();
    return projection;
}

StagedImpact result(const ImpactEnclosure& best, Stage stage, const Projection<double>& projection) {
    return {best.kind, best.segment, best.triangle, best.side, stage, projection};
}

/// Magnitudes are those of double arithmetic; where it rejects or the bounds of its errors are too wide, the exact ones
/// are rounded.
Projection<double> magnitudes(const DecisionInput& input, const ImpactEnclosure& best, Stages& stages) {
    if (best.kind == Kind::none) return {};
    const SegmentShape<double> shape = input.shape_of(best.segment);
    if (best.double_will_do || close_enough(input, shape, best.triangle)) {
        const auto projection = project(input.point, sub_triangle(shape, best.triangle), input.limits);
        if (projection) return *projection;
    }
    return rounded(stages.exact(best.segment, best.triangle).projection);
}

template <class Number>
Impact<Number> in_one_arithmetic(const DecisionInput& input) {
    return retained_impact<Number>(
        convert_to<Number>(input.point), input.segments,
        [&](int segment) { return convert_to<Number>(input.shape_of(segment)); }, convert_to<Number>(input.reach),
        convert_to<Number>(input.limits), input.proximity_competes);
}

bool same(const StagedImpact& one, const StagedImpact& other) {
    return one.kind == other.kind && one.segment == other.segment && one.triangle == other.triangle &&
           one.side == other.side;
}

}  // namespace

std::optional<ImpactEnclosure> judged_by_bound(const DecisionInput& input, const SegmentShape<double>& shape,
                                               int segment, int k) {
    try {
        const auto impact = impact_in<Bounded>(input, shape, segment, k);
        const Bounded& kappa = impact.kappa;
        ImpactEnclosure answer = judged(impact, kappa.value() - 2 * kappa.error(), kappa.value() + 2 * kappa.error());
        if (answer.kind != Kind::none)
            answer.double_will_do = close_enough(impact.projection, largest_length(input.point, shape));
        return answer;
    } catch (const Undecided&) {
        return std::nullopt;
    }
}

StagedImpact staged_impact(const DecisionInput& input, DecisionStageCounts* stage_counts) {
    if (input.segments.empty()) {
        if (stage_counts != nullptr) ++stage_counts->nothing_near;
        return {};
    }
    const auto start = Clock::now();
    const double later = stage_counts == nullptr ? 0 : stage_counts->seconds[1] + stage_counts->seconds[2];
    Stages stages(input, stage_counts);
    ImpactEnclosure best;
    for (const int segment : input.segments) {
        const SegmentShape<double> shape = input.shape_of(segment);
        for (int k = 1; k <= shape.sub_triangles(); ++k) {
            const ImpactEnclosure one = stages.judge(shape, segment, k);
            if (stages.precedes(one, best)) best = one;
        }
    }
    const Stage stage = stages.stage();
    StagedImpact decided = result(best, stage, magnitudes(input, best, stages));
    if (stage_counts != nullptr) {
        ++stage_counts->settled[static_cast<size_t>(stage)];
        stage_counts->seconds[0] +=
            seconds_since(start) - (stage_counts->seconds[1] + stage_counts->seconds[2] - later);
        if (stage != Stage::bounded && !same(decided, double_impact(input))) ++stage_counts->double_wrong;
    }
    return decided;
}

StagedImpact exact_impact(const DecisionInput& input) {
    const auto best = in_one_arithmetic<Fraction>(input);
    StagedImpact decided{best.kind, best.segment, best.triangle, best.side, Stage::exact, {}};
    if (best.kind != Kind::none) decided.projection = rounded(best.projection);
    return decided;
}

StagedImpact double_impact(const DecisionInput& input) {
    const auto best = in_one_arithmetic<double>(input);
    return {best.kind, best.segment, best.triangle, best.side, Stage::bounded, best.projection};
}

}  // namespace type21::reference
