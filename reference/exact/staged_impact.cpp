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

/// The stages of one decision. Exact impacts are computed once and kept until the node is decided.
class Stages {
  public:
    Stages(const ContactQuery& query, const CandidateSegments& candidates, DecisionStageCounts* counts)
        : query_(query), candidates_(candidates), counts_(counts) {}

    /// By the first stage that can tell.
    ImpactEnclosure enclose(const SegmentShape<double>& shape, int segment, int k) {
        if (const auto answer = enclosed_by_bound(query_, shape, segment, k)) return *answer;
        if (const auto answer = by_interval(shape, segment, k)) return *answer;
        const auto& impact = exact(segment, k);
        const auto [low, high] = impact.kappa.enclosure();
        return enclosure_of(impact, low, high);
    }

    /// True when `one` is retained rather than `other`.
    bool precedes(const ImpactEnclosure& one, const ImpactEnclosure& other) {
        const int kinds = order_of_kinds(one.kind, other.kind, query_.proximity_competes);
        if (kinds != 0) return kinds < 0;
        if (one.kind == Kind::none || one.kappa_low > other.kappa_high) return false;
        if (one.kappa_high < other.kappa_low) return true;
        return reference::precedes(exact(one.segment, one.triangle), exact(other.segment, other.triangle),
                                   query_.proximity_competes);
    }

    const Impact<Fraction>& exact(int segment, int k) {
        stage_ = Stage::exact;
        const auto known = exact_.find({segment, k});
        if (known != exact_.end()) return known->second;
        const auto start = Clock::now();
        const auto& impact =
            exact_
                .emplace(std::pair{segment, k}, impact_in<Fraction>(query_, candidates_.shape_of(segment), segment, k))
                .first->second;
        add_time(Stage::exact, start);
        return impact;
    }

    Stage stage() const { return stage_; }

  private:
    std::optional<ImpactEnclosure> by_interval(const SegmentShape<double>& shape, int segment, int k) {
        stage_ = std::max(stage_, Stage::interval);
        const auto start = Clock::now();
        const auto answer = enclosed_by_interval(query_, shape, segment, k);
        add_time(Stage::interval, start);
        return answer;
    }

    void add_time(Stage stage, Clock::time_point start) const {
        if (counts_ != nullptr) counts_->seconds[static_cast<size_t>(stage)] += seconds_since(start);
    }

    const ContactQuery& query_;
    const CandidateSegments& candidates_;
    DecisionStageCounts* counts_;
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

/// The numbers of the retained projection: those of double arithmetic. Where double arithmetic rejects the node, or its
/// error bounds are too large, the exact ones are rounded instead. Formulation 10, step 7.
Projection<double> magnitudes(const ContactQuery& query, const CandidateSegments& candidates,
                              const ImpactEnclosure& best, Stages& stages) {
    if (best.kind == Kind::none) return {};
    const SegmentShape<double> shape = candidates.shape_of(best.segment);
    if (best.double_will_do || close_enough(query, shape, best.triangle)) {
        const auto projection = project(query.point, sub_triangle(shape, best.triangle), limits_of<double>(query));
        if (projection) return *projection;
    }
    return rounded(stages.exact(best.segment, best.triangle).projection);
}

bool same(const StagedImpact& one, const StagedImpact& other) {
    return one.kind == other.kind && one.segment == other.segment && one.triangle == other.triangle &&
           one.side == other.side;
}

}  // namespace

std::optional<ImpactEnclosure> enclosed_by_bound(const ContactQuery& query, const SegmentShape<double>& shape,
                                                 int segment, int k) {
    try {
        const auto impact = impact_in<Bounded>(query, shape, segment, k);
        const Bounded& kappa = impact.kappa;
        // Twice the bound: the two ends are rounded.
        ImpactEnclosure answer =
            enclosure_of(impact, kappa.value() - 2 * kappa.error(), kappa.value() + 2 * kappa.error());
        if (answer.kind != Kind::none)
            answer.double_will_do = close_enough(impact.projection, largest_length(query.point, shape));
        return answer;
    } catch (const Undecided&) {
        return std::nullopt;
    }
}

StagedImpact staged_impact(const ContactQuery& query, const CandidateSegments& candidates,
                           DecisionStageCounts* counts) {
    if (candidates.ranks.empty()) {
        if (counts != nullptr) ++counts->nothing_near;
        return {};
    }
    const auto start = Clock::now();
    const double later = counts == nullptr ? 0 : counts->seconds[1] + counts->seconds[2];
    Stages stages(query, candidates, counts);
    ImpactEnclosure best;
    for (const int segment : candidates.ranks) {
        const SegmentShape<double> shape = candidates.shape_of(segment);
        for (int k = 1; k <= shape.sub_triangles(); ++k) {
            const ImpactEnclosure one = stages.enclose(shape, segment, k);
            if (stages.precedes(one, best)) best = one;
        }
    }
    const Stage stage = stages.stage();
    StagedImpact decided = result(best, stage, magnitudes(query, candidates, best, stages));
    if (counts != nullptr) {
        ++counts->settled[static_cast<size_t>(stage)];
        counts->seconds[0] += seconds_since(start) - (counts->seconds[1] + counts->seconds[2] - later);
        // What the error bound settles, plain double decides in the same way.
        if (stage != Stage::bounded && !same(decided, double_impact(query, candidates))) ++counts->double_wrong;
    }
    return decided;
}

StagedImpact exact_impact(const ContactQuery& query, const CandidateSegments& candidates) {
    const auto best = retained_in<Fraction>(query, candidates);
    StagedImpact decided{best.kind, best.segment, best.triangle, best.side, Stage::exact, {}};
    if (best.kind != Kind::none) decided.projection = rounded(best.projection);
    return decided;
}

StagedImpact double_impact(const ContactQuery& query, const CandidateSegments& candidates) {
    const auto best = retained_in<double>(query, candidates);
    return {best.kind, best.segment, best.triangle, best.side, Stage::bounded, best.projection};
}

}  // namespace type21::reference
