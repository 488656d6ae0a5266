// All that may take a node, side by side in the lanes of registers, for many nodes; and how long what is found holds.
#include <algorithm>
#include <cmath>

#include "optimized/projection/local_segment.h"
#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

constexpr int most_segments = ProjectionBatch::room / 4;  ///< around a node; with more it is asked alone

struct Near {
    int segment;
    double apart;
};

/// Largest distance of a landing over its height, of nodes whose weights of step 2 are >= -0.01: sqrt(1 + |s|^2) of
/// rates.h.
double longest_lift(const SegmentData& segment, int piece) {
    constexpr double q = -weight_limit;
    const PieceCorners of = piece_corners(segment.triangle, piece);
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

double Search::ball(const ProjectionBatch& rows, int i, Standing standing, double rate, double least,
                    double least_rate) const {
    if (standing == Standing::unknown) return 0;
    if (standing != Standing::taken) {
        const double above =
            rows.distance_from_plane(i) * (1 - 1e-9) - (rows.height[i] > 0 ? limits_.outward : limits_.inward);
        if (above > 0) return above - 2 * foreseen_share * rows.size[i];
    }
    if (!(rate < no_rate && least_rate < no_rate)) return 0;
    const double cap = rate_reach / rate;
    if (standing != Standing::rejected)
        return std::min(cap, (kappa_of(rows.b[i], rows.c[i]) - least - plain_share) / (2 * (rate + least_rate)));
    const double inner = rows.innermost(i), low = inner < weight_limit - plain_share ? inner : rows.least_landed(i);
    return std::min(cap, (weight_limit - plain_share - low) / rate);
}

/// Which of these foreseen columns has the least kappa in 100 bits, -1: that does not tell.
int Search::least_fine_kappa(Batch& batch, const int* columns, int count) const {
    ProjectionBatch& told = batch.partners;
    const ProjectionBatch& rows = batch.others;
    for (int j = 0; j < count; ++j) {
        const int c = columns[j];
        for (int a = 0; a < 3; ++a) {
            told.y[a][j] = rows.y[a][c];
            for (int k = 0; k < 4; ++k) {
                told.corner[k][a][j] = rows.corner[k][a][c];
                told.normal[k][a][j] = rows.normal[k][a][c];
            }
        }
        told.code[j] = rows.code[c];
    }
    project_double_double(told, count, batch.fine);
    const auto kappa = [&](int j) { return TwoDoubles(batch.fine.high[j], batch.fine.low[j]); };
    int best = 0;
    for (int j = 1; j < count; ++j)
        if ((kappa(j) - kappa(best)).high < 0) best = j;
    const auto bound = [&](int j) { return fine_bound(batch.candidates[columns[j]].place); };
    for (int j = 0; j < count; ++j)
        if (j != best && !((kappa(j) - kappa(best)).high > 1.001 * (bound(j) + bound(best)))) return -1;
    return best;
}

/// One of these is retained, all of which take the node: a tie, or what it takes.
Retained Search::tell_apart(Batch& batch, int i, const int* columns, int count, const ProjectionLimits& rules) const {
    const V3 y = batch.point(i);
    const ContactReach window{batch.gap[i], batch.depth, batch.proximity};
    Contender* const contenders = batch.contenders;
    SegmentData* const segments = batch.segments;
    for (int j = 0; j < count; ++j) {
        const int c = columns[j], place = batch.candidates[c].place;
        const double kappa = kappa_of(batch.others.b[c], batch.others.c[c]);
        contenders[j] = {segment_of(place),   piece_of(place),    Kind::contact, false,
                         kappa - plain_share, kappa + plain_share};
        segments[j] = tool_.segment(segment_of(place));
    }
    const auto n = static_cast<size_t>(count);
    if (tied(y, {contenders, n}, {segments, n}, window, rules)) {
        int lowest = batch.candidates[columns[0]].place;
        for (int j = 1; j < count; ++j)
            lowest = std::min(lowest, batch.candidates[columns[j]].place);
        Retained first;
        first.segment = segment_of(lowest);
        first.piece = piece_of(lowest);
        first.settled = Settled::tie;
        return first;
    }
    if (const int best = least_fine_kappa(batch, columns, count); best >= 0) {
        Retained first;
        first.segment = contenders[best].segment;
        first.piece = contenders[best].piece;
        first.settled = Settled::fine;
        return first;
    }
    Decider decider(y, window, rules);
    for (size_t j = 0; j < n; ++j)
        decider.add(contenders[j].segment, contenders[j].piece,
                    filter(y, segments[j], local_segment(segments[j]), contenders[j].piece, window, rules));
    return decider.retained([&](int s) { return tool_.segment(s); });
}

/// The node whose candidates these are. @return false where that takes more than a plain projection
bool Search::decide_candidates(Batch& batch, int first, int last, const ProjectionLimits& rules, bool remembers) const {
    const ProjectionBatch& rows = batch.others;
    const int i = batch.candidates[first].column;
    const double wanted = remembers ? ball_wanted(batch.memory[i]) : 0;  // before the node remembers something else
    int best = -1;
    double least = HUGE_VAL, next = HUGE_VAL;
    double lands = HUGE_VAL;  ///< smallest kappa of those that may take it
    bool beyond = false;
    Standing standings[ProjectionBatch::room];
    for (int c = first; c < last; ++c) {
        const Batch::Candidate& one = batch.candidates[c];
        const Standing stands = standings[c] = standing_in_rows(rows, c, batch.depth, one.place);
        if (stands == Standing::unknown && !(one.apart > 0)) return false;
        beyond |= stands == Standing::beyond;
        if (stands != Standing::taken && stands != Standing::lands) continue;
        const double kappa = kappa_of(rows.b[c], rows.c[c]);
        if (stands == Standing::lands) {
            lands = std::min(lands, kappa);
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
    // Within this of the node none of the others takes it, or only with a larger kappa.
    const auto radius = [&] {
        const double own = best < 0 ? 0.0 : double(rate(batch.candidates[best].place));
        double all = wanted;
        for (int c = first; c < last; ++c) {
            if (c == best) continue;
            const Batch::Candidate& one = batch.candidates[c];
            all = std::min(all, std::max(one.apart, ball(rows, c, standings[c], rate(one.place), least, own)));
        }
        return all;
    };
    batch.path[i] = Path::searched;
    if (best < 0) {
        if (lands < HUGE_VAL || (beyond && batch.proximity > 0)) return false;
        ++batch.tally.searched;
        batch.place[i] = -1;
        if (remembers) keep_quiet(batch, i, radius());
        return true;
    }
    if (!(lands - least > plain_share)) return false;
    if (!(next - least > plain_share)) {
        // Those that plain numbers do not tell apart; all others have lost.
        int close[ProjectionBatch::room], count = 0;
        for (int c = first; c < last; ++c)
            if (standings[c] == Standing::taken && !(kappa_of(rows.b[c], rows.c[c]) - least > plain_share))
                close[count++] = c;
        if (count > Batch::most_close) return false;
        const Retained told = tell_apart(batch, i, close, count, rules);
        for (int c = 0; c < count; ++c)
            if (batch.candidates[close[c]].place == place_of(told.segment, told.piece)) best = close[c];
        batch.settled[i] = told.settled;
        batch.tally.fine += told.settled == Settled::fine;
        batch.tally.whole += told.settled == Settled::whole;
        least = HUGE_VAL;  // no ball
    }
    ++batch.tally.searched;
    const int place = batch.candidates[best].place;
    take(batch, i, place, rows, best);
    if (remembers) batch.memory[i].keep_steady(place, batch.point(i), std::min(radius(), reach_of(rate(place))));
    return true;
}

/// @param radius  within which nothing takes the node; where nothing is nearer than usual, or no radius is known, all
/// prisms are asked
void Search::keep_quiet(const Batch& batch, int i, double radius) const {
    Memory& memory = batch.memory[i];
    if (!(radius > 0) || radius >= ball_wanted(memory)) return keep_quiet(batch.point(i), memory);
    memory.keep_quiet(batch.point(i), radius);
}

double Search::ball_wanted(const Memory& memory) const {
    if (memory.place < 0 || !(memory.radius < 0)) return usual_ball_;
    return std::clamp(-8 * double(memory.radius), small_ball_, usual_ball_);
}

double Search::holding_ball(const ProjectionBatch& rows, int i, double depth, int place) const {
    const double own = rate(place), size = rows.size[i], rounding = 3 * foreseen_share * size;
    if (!(own < no_rate)) return 0;
    const double in_weights = (std::min(rows.least_landed(i), rows.innermost(i) - weight_limit) - plain_share) / own;
    const double height = rows.distance_from_plane(i);
    const double reach = rows.height[i] > 0 ? rows.gap[i] : depth;
    const double in_reach = reach / longest_lift(tool_.segment(segment_of(place)), piece_of(place)) - height;
    return std::min(std::min(in_weights, reach_of(own)), std::min(height, in_reach) * (1 - 1e-9) - rounding);
}

void Search::decide_candidates(Batch& batch, const ProjectionLimits& rules, bool remembers) const {
    const int count = batch.candidate_count;
    batch.candidate_count = 0;
    if (count == 0) return;
    int place[ProjectionBatch::room] = {};
    for (int c = 0; c < count; ++c) {
        const Batch::Candidate& one = batch.candidates[c];
        place[c] = one.place;
        ask_at(batch.others, c, one.place, batch.point(one.column), batch.gap[one.column]);
    }
    gather(batch.others, tool_, place, 0, count, growth_);
    project_double(batch.others, 0, count, landing_limits(batch.depth, batch.proximity));
    for (int first = 0; first < count;) {
        const int i = batch.candidates[first].column;
        int last = first + 1;
        while (last < count && batch.candidates[last].column == i)
            ++last;
        if (!decide_candidates(batch, first, last, rules, remembers)) ask_alone(batch, i, rules, remembers);
        first = last;
    }
}

void Search::ask_alone(Batch& batch, int i, const ProjectionLimits& rules, bool remembers) const {
    const V3 y = batch.point(i);
    const ContactReach window{batch.gap[i], batch.depth, batch.proximity};
    put(batch, i, remembers ? find(y, window, rules, batch.memory[i]) : Found{search(y, window, rules)});
}

void Search::ask_rows(Batch& batch, const int* open, int count, const ProjectionLimits& rules, bool remembers) const {
    // D34 asks for boxes, D35 lifts what leans, D11 lets contact and proximity compete: one node after the other.
    const bool plain = !reach_box_.on && !limits_.lift_leaning && !(rules.proximity_competes && batch.proximity > 0);
    for (int j = 0; j < count; ++j) {
        const int i = open[j];
        const V3 y = batch.point(i);
        const double around = remembers ? ball_wanted(batch.memory[i]) : 0;
        Near near[most_segments];
        int segments = 0;
        if (plain)
            tree_.within(y, around, [&](int s, double apart) {
                if (segments < most_segments) near[segments] = {s, apart};
                tool_.prefetch_segment(s);
                __builtin_prefetch(&margins(place_of(s, 1)));
                ++segments;
            });
        if (!plain || segments > most_segments || (remembers && filtered(batch.memory[i]))) {
            ask_alone(batch, i, rules, remembers);
            continue;
        }
        if (segments == 0) {
            batch.path[i] = Path::searched;
            ++batch.tally.searched;
            batch.place[i] = -1;
            if (remembers) keep_quiet(batch, i, usual_ball_);
            continue;
        }
        int columns = 0;
        for (int s = 0; s < segments; ++s)
            columns += tool_.is_triangle(near[s].segment) ? 1 : 4;
        if (batch.candidate_count + columns > ProjectionBatch::room) decide_candidates(batch, rules, remembers);
        for (int s = 0; s < segments; ++s) {
            const int pieces = tool_.is_triangle(near[s].segment) ? 1 : 4;
            for (int k = 1; k <= pieces; ++k) {
                batch.candidates[batch.candidate_count++] = {i, place_of(near[s].segment, k), near[s].apart};
            }
        }
    }
    decide_candidates(batch, rules, remembers);
}

void Search::search(Batch& batch, const ProjectionLimits& rules) const {
    int all[Batch::room];
    batch.pair_count = batch.close_count = batch.candidate_count = 0;
    batch.tally = {};
    std::fill_n(batch.settled, batch.count, Settled::filter);
    std::fill_n(batch.kind, batch.count, Kind::contact);
    batch.memory = nullptr;
    for (int i = 0; i < batch.count; ++i)
        all[i] = i;
    ask_rows(batch, all, batch.count, rules, false);
}

}  // namespace type21::optimized
