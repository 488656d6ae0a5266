// The full search of many nodes: all sub-triangles that may take them are projected on side by side in the lanes of
// registers. It also finds the safe radii.
#include <algorithm>
#include <cmath>

#include "optimized/projection/local_segment.h"
#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

constexpr int most_segments = ProjectionBatch::capacity / 4;  ///< near a node; one with more is decided alone

struct Near {
    int segment;
    double distance;  ///< lower bound [length]
};

/// Largest |P - Q| / |h| of nodes with weights of step 2 >= -0.01: sqrt(1 + |s|^2) of weight_lipschitz.h.
double longest_lift(const SegmentData& segment, int triangle) {
    constexpr double q = -weight_limit;
    const SubTriangleCorners of = sub_triangle_corners(segment.is_triangle, triangle);
    const LocalSegment local = local_segment(segment);
    const V3 area = cross(local.corner[static_cast<size_t>(of.b)] - local.center,
                          local.corner[static_cast<size_t>(of.c)] - local.center);
    const double square = dot(area, area);
    double least = HUGE_VAL, most = 0, lean = 0;
    for (const V3& n :
         {local.center_normal, segment.normal[static_cast<size_t>(of.b)], segment.normal[static_cast<size_t>(of.c)]}) {
        const double slope = dot(n, area);
        least = std::min(least, slope);
        most = std::max(most, slope);
        lean = std::max(lean, dot(n, n) * square / (slope * slope) - 1);
    }
    const double share = (1 + 4 * q) * most / ((1 + 2 * q) * least - 2 * q * most);
    return std::sqrt(1 + share * share * lean) * (1 + 1e-5);
}

}  // namespace

double Search::rival_radius(const ProjectionBatch& rows, int i, State state, double bound, double least,
                            double own_bound) const {
    if (state == State::unknown) return 0;
    if (state != State::taken) {
        const double above =
            rows.distance_from_plane(i) * (1 - 1e-9) - (rows.height[i] > 0 ? limits_.outward : limits_.inward);
        if (above > 0) return above - 2 * a_priori_share * rows.size[i];
    }
    if (!(bound < no_lipschitz && own_bound < no_lipschitz)) return 0;
    const double cap = lipschitz_reach / bound;
    if (state != State::rejected)
        return std::min(cap, (kappa_of(rows.b[i], rows.c[i]) - least - decision_margin) / (2 * (bound + own_bound)));
    const double inner = rows.least_w(i), low = inner < weight_limit - decision_margin ? inner : rows.least_v(i);
    return std::min(cap, (weight_limit - decision_margin - low) / bound);
}

/// Which of these columns, all a priori bounded, has the least kappa in double-double; -1: that cannot tell.
int Search::least_kappa_double_double(Batch& batch, const int* columns, int count) const {
    ProjectionBatch& copy = batch.partners;
    const ProjectionBatch& rows = batch.others;
    for (int j = 0; j < count; ++j) {
        const int c = columns[j];
        for (int a = 0; a < 3; ++a) {
            copy.y[a][j] = rows.y[a][c];
            for (int k = 0; k < 4; ++k) {
                copy.corner[k][a][j] = rows.corner[k][a][c];
                copy.normal[k][a][j] = rows.normal[k][a][c];
            }
        }
        copy.code[j] = rows.code[c];
    }
    project_double_double(copy, count, batch.kappa);
    const auto kappa = [&](int j) { return TwoDoubles(batch.kappa.high[j], batch.kappa.low[j]); };
    int best = 0;
    for (int j = 1; j < count; ++j)
        if ((kappa(j) - kappa(best)).high < 0) best = j;
    const auto bound = [&](int j) { return double_double_bound(batch.candidates[columns[j]].id); };
    for (int j = 0; j < count; ++j)
        if (j != best && !((kappa(j) - kappa(best)).high > 1.001 * (bound(j) + bound(best)))) return -1;
    return best;
}

/// All of these take the node, and one of them is retained. In this order: proof of a tie, double-double, Decider.
Retained Search::decide_close_candidates(Batch& batch, int i, const int* columns, int count,
                                         const ProjectionLimits& rules) const {
    const V3 y = batch.point(i);
    const ContactReach reach{batch.gap[i], batch.depth, batch.proximity};
    Contender* const contenders = batch.contenders;
    SegmentData* const segments = batch.segments;
    for (int j = 0; j < count; ++j) {
        const int c = columns[j];
        const SubTriangleId id = batch.candidates[c].id;
        const double kappa = kappa_of(batch.others.b[c], batch.others.c[c]);
        contenders[j] = {id, Kind::contact, false, kappa - decision_margin, kappa + decision_margin};
        segments[j] = tool_.segment(id.segment());
    }
    Retained first;
    const auto n = static_cast<size_t>(count);
    if (tied(y, {contenders, n}, {segments, n}, reach, rules)) {
        first.id = contenders[0].id;
        for (int j = 1; j < count; ++j)
            first.id = std::min(first.id, contenders[j].id);
        first.settled = Settled::tie;
        return first;
    }
    if (const int best = least_kappa_double_double(batch, columns, count); best >= 0) {
        first.id = contenders[best].id;
        first.settled = Settled::double_double;
        return first;
    }
    Decider decider(y, reach, rules);
    for (size_t j = 0; j < n; ++j)
        decider.add(contenders[j].id,
                    filter(y, segments[j], local_segment(segments[j]), contenders[j].id.triangle(), reach, rules));
    return decider.retained([&](int s) { return tool_.segment(s); });
}

/// Decides the node that these candidates belong to. @return false where plain projections do not suffice
bool Search::decide_candidates(Batch& batch, int first, int last, const ProjectionLimits& rules, bool remembers) const {
    const ProjectionBatch& rows = batch.others;
    const int i = batch.candidates[first].column;
    const double wanted = remembers ? wanted_radius(batch.memory[i]) : 0;  // before the memory is overwritten
    int best = -1;
    double least = HUGE_VAL, next = HUGE_VAL;  // kappas of those that take it
    double least_unsure = HUGE_VAL;            // kappa of those whose distance is unsure
    bool too_far = false;
    State states[ProjectionBatch::capacity];
    for (int c = first; c < last; ++c) {
        const Batch::Candidate& one = batch.candidates[c];
        const State state = states[c] = state_in_rows(rows, c, batch.depth, one.id);
        if (state == State::unknown && !(one.distance > 0)) return false;
        too_far |= state == State::too_far;
        if (state != State::taken && state != State::distance_unsure) continue;
        const double kappa = kappa_of(rows.b[c], rows.c[c]);
        if (state == State::distance_unsure) {
            least_unsure = std::min(least_unsure, kappa);
            continue;
        }
        if (kappa < least) {
            next = least;
            least = kappa;
            best = c;
        } else {
            next = std::min(next, kappa);
        }
    }
    // Within this distance of the node no rival takes it, or only with a larger kappa.
    const auto radius = [&] {
        const double own = best < 0 ? 0.0 : double(lipschitz(batch.candidates[best].id));
        double all = wanted;
        for (int c = first; c < last; ++c) {
            if (c == best) continue;
            const Batch::Candidate& one = batch.candidates[c];
            all =
                std::min(all, std::max(one.distance, rival_radius(rows, c, states[c], lipschitz(one.id), least, own)));
        }
        return all;
    };
    batch.path[i] = Path::searched;
    if (best < 0) {
        if (least_unsure < HUGE_VAL || (too_far && batch.proximity > 0)) return false;
        ++batch.tally.searched;
        batch.id[i] = SubTriangleId::none();
        if (remembers) keep_separated(batch, i, radius());
        return true;
    }
    if (!(least_unsure - least > decision_margin)) return false;
    if (!(next - least > decision_margin)) {
        // Those that plain double does not separate. All others have lost.
        int close[ProjectionBatch::capacity], count = 0;
        for (int c = first; c < last; ++c)
            if (states[c] == State::taken && !(kappa_of(rows.b[c], rows.c[c]) - least > decision_margin))
                close[count++] = c;
        if (count > Batch::most_close) return false;
        const Retained retained = decide_close_candidates(batch, i, close, count, rules);
        for (int c = 0; c < count; ++c)
            if (batch.candidates[close[c]].id == retained.id) best = close[c];
        batch.settled[i] = retained.settled;
        batch.tally.double_double += retained.settled == Settled::double_double;
        batch.tally.integer += retained.settled == Settled::integer;
        least = HUGE_VAL;  // no radius
    }
    ++batch.tally.searched;
    const SubTriangleId id = batch.candidates[best].id;
    take(batch, i, id, rows, best);
    if (remembers)
        batch.memory[i].keep_ranking_safe(id, batch.point(i), std::min(radius(), lipschitz_reach_of(lipschitz(id))));
    return true;
}

/// @param radius  within which nothing takes the node; where it is not known, or nothing is near, the clearance of all
/// capture volumes counts
void Search::keep_separated(const Batch& batch, int i, double radius) const {
    Memory& memory = batch.memory[i];
    if (!(radius > 0) || radius >= wanted_radius(memory)) return keep_separated(batch.point(i), memory);
    memory.keep_separated(batch.point(i), radius);
}

double Search::wanted_radius(const Memory& memory) const {
    if (!memory.last.exists() || !(memory.radius < 0)) return usual_radius_;
    return std::clamp(-8 * double(memory.radius), small_radius_, usual_radius_);
}

double Search::contact_safe_radius(const ProjectionBatch& rows, int i, double depth, SubTriangleId id) const {
    const double own = lipschitz(id), size = rows.size[i], rounding = 3 * a_priori_share * size;
    if (!(own < no_lipschitz)) return 0;
    const double in_weights = (std::min(rows.least_v(i), rows.least_w(i) - weight_limit) - decision_margin) / own;
    const double height = rows.distance_from_plane(i);
    const double reach = rows.height[i] > 0 ? rows.gap[i] : depth;
    const double in_reach = reach / longest_lift(tool_.segment(id.segment()), id.triangle()) - height;
    return std::min(std::min(in_weights, lipschitz_reach_of(own)), std::min(height, in_reach) * (1 - 1e-9) - rounding);
}

void Search::decide_candidates(Batch& batch, const ProjectionLimits& rules, bool remembers) const {
    const int count = batch.candidate_count;
    batch.candidate_count = 0;
    if (count == 0) return;
    SubTriangleId id[ProjectionBatch::capacity] = {};
    for (int c = 0; c < count; ++c) {
        const Batch::Candidate& one = batch.candidates[c];
        id[c] = one.id;
        put_query(batch.others, c, one.id, batch.point(one.column), batch.gap[one.column]);
    }
    gather(batch.others, tool_, id, 0, count, growth_);
    project_double(batch.others, 0, count, batch_limits(batch.depth, batch.proximity));
    for (int first = 0; first < count;) {
        const int i = batch.candidates[first].column;
        int last = first + 1;
        while (last < count && batch.candidates[last].column == i)
            ++last;
        if (!decide_candidates(batch, first, last, rules, remembers)) decide_alone(batch, i, rules, remembers);
        first = last;
    }
}

void Search::decide_alone(Batch& batch, int i, const ProjectionLimits& rules, bool remembers) const {
    const V3 y = batch.point(i);
    const ContactReach reach{batch.gap[i], batch.depth, batch.proximity};
    if (batch.lists != nullptr) {
        Found found{search(batch.list(i), y, reach, rules)};
        use_double_magnitudes(y, reach, found.retained);
        return put_found(batch, i, found);
    }
    put_found(batch, i, remembers ? find(y, reach, rules, batch.memory[i]) : Found{search(y, reach, rules)});
}

void Search::find_in_lists(Batch& batch, const ProjectionLimits& rules) const {
    int open[Batch::capacity], count = 0;
    batch.pair_count = batch.close_count = batch.candidate_count = 0;
    batch.tally = {};
    batch.memory = nullptr;
    std::fill_n(batch.settled, batch.count, Settled::filter);
    std::fill_n(batch.kind, batch.count, Kind::contact);
    std::fill_n(batch.path, batch.count, Path::searched);
    std::fill_n(batch.id, batch.count, SubTriangleId::none());
    for (int i = 0; i < batch.count; ++i) {
        if (batch.prefetcher != nullptr && i % Prefetcher::group == 0) batch.prefetcher->prefetch(batch.first + i);
        if (!batch.active[i]) continue;
        batch.tally.candidates += static_cast<long>(batch.list(i).size());
        open[count++] = i;
    }
    search_rows(batch, open, count, rules, false);
}

void Search::search_rows(Batch& batch, const int* open, int count, const ProjectionLimits& rules,
                         bool remembers) const {
    // With D34, with D35, and with D11 where there is proximity, nodes are decided one by one.
    const bool plain = !reach_box_.on && !limits_.lift_leaning && !(rules.proximity_competes && batch.proximity > 0);
    for (int j = 0; j < count; ++j) {
        const int i = open[j];
        const V3 y = batch.point(i);
        const double around = remembers ? wanted_radius(batch.memory[i]) : 0;
        Near near[most_segments];
        int segments = 0;
        const auto found = [&](int s, double distance) {
            if (segments < most_segments) near[segments] = {s, distance};
            tool_.prefetch_segment(s);
            __builtin_prefetch(&margins({s, 1}));
            ++segments;
        };
        if (batch.lists != nullptr) {
            for (const int s : batch.list(i))
                if (boxes_[static_cast<size_t>(s)].holds(y)) found(s, 0);
            batch.tally.near += segments;
        } else if (plain) {
            tree_.within(y, around, found);
        }
        if (!plain || segments > most_segments || (remembers && needs_filter(batch.memory[i]))) {
            decide_alone(batch, i, rules, remembers);
            continue;
        }
        if (segments == 0) {
            batch.path[i] = Path::searched;
            ++batch.tally.searched;
            batch.id[i] = SubTriangleId::none();
            if (remembers) keep_separated(batch, i, usual_radius_);
            continue;
        }
        int columns = 0;
        for (int s = 0; s < segments; ++s)
            columns += tool_.is_triangle(near[s].segment) ? 1 : 4;
        if (batch.candidate_count + columns > ProjectionBatch::capacity) decide_candidates(batch, rules, remembers);
        for (int s = 0; s < segments; ++s) {
            const int sub_triangles = tool_.is_triangle(near[s].segment) ? 1 : 4;
            for (int k = 1; k <= sub_triangles; ++k) {
                batch.candidates[batch.candidate_count++] = {i, {near[s].segment, k}, near[s].distance};
            }
        }
    }
    decide_candidates(batch, rules, remembers);
}

void Search::search(Batch& batch, const ProjectionLimits& rules) const {
    int all[Batch::capacity];
    batch.pair_count = batch.close_count = batch.candidate_count = 0;
    batch.tally = {};
    std::fill_n(batch.settled, batch.count, Settled::filter);
    std::fill_n(batch.kind, batch.count, Kind::contact);
    batch.memory = nullptr;
    for (int i = 0; i < batch.count; ++i)
        all[i] = i;
    search_rows(batch, all, batch.count, rules, false);
}

}  // namespace type21::optimized
