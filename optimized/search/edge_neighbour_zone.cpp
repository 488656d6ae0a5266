// Nodes near a side: the two sub-triangles that can take them, told apart in double, in 100 bits, exactly.
#include <algorithm>
#include <cmath>

#include "optimized/search/search.h"
#include "optimized/search/separating_lines.h"

namespace type21::optimized {

Search::Standing Search::standing_in_rows(const ProjectionBatch& rows, int i, double depth, int place) const {
    if (rows.certain[i] > 0) return Standing::taken;
    return rows.rejected[i] > 0 ? Standing::rejected : standing(rows, i, depth, place);
}

Search::Standing Search::standing(const ProjectionBatch& rows, int i, double depth, int place) const {
    const double size = rows.size[i], height2 = rows.height[i] * rows.height[i];
    const double rounding = foreseen_share * size;
    if (!(rows.core[i] < double(beyond_foreseen) && rows.far[i] <= size)) return Standing::unknown;
    const bool front = rows.height[i] > 0;
    const double limit = front ? limits_.outward : limits_.inward;
    const double out = limit + 3 * rounding;
    if (height2 > out * out * (1 + 1e-9) * rows.square[i]) return Standing::rejected;
    if (!(std::abs(rows.p[i]) <= 4 && std::abs(rows.q[i]) <= 4 && rows.total[i] >= 0.5 &&
          height2 > 4 * rounding * rounding * rows.square[i] && height2 * (1 + 1e-9) < limit * limit * rows.square[i]))
        return Standing::unknown;
    constexpr double low = weight_limit;
    const double inner = rows.innermost(i);
    if (inner < low - plain_share) return Standing::rejected;
    if (!(inner > low + plain_share)) return Standing::unknown;
    const double least = rows.least_landed(i);
    if (least < low - plain_share) return Standing::rejected;
    if (!(least > low + plain_share)) return Standing::unknown;
    const V3 n{rows.n[0][i], rows.n[1][i], rows.n[2][i]};
    // Weights are off by less than foreseen_share, clipped and rescaled ones by four times that, an edge is at most 2
    // sqrt(3) times the extent. Clipping twice as much moves the point by less than 15 times that share.
    const double distance =
        least > -2 * foreseen_share ? std::abs(rows.lift[i]) * norm(n) : clipped_distance(rows, i, place);
    const double unsure = 4 * plain_share * size, reach = front ? rows.gap[i] : depth;
    if (distance + unsure < reach) return Standing::taken;
    return distance - unsure > reach ? Standing::beyond : Standing::lands;
}

/// Step 4: of the node from the point with its weights clipped.
double Search::clipped_distance(const ProjectionBatch& rows, int i, int place) const {
    const double a = 1 - rows.b[i] - rows.c[i];
    const double clipped[3] = {std::clamp(a, 0.0, 1.0), std::clamp(rows.b[i], 0.0, 1.0),
                               std::clamp(rows.c[i], 0.0, 1.0)};
    const double sum = (clipped[0] + clipped[1]) + clipped[2];
    const SegmentData segment = tool_.segment(segment_of(place));
    return norm(offset_from_landing({rows.y[0][i], rows.y[1][i], rows.y[2][i]}, segment, piece_of(place),
                                    clipped[1] / sum, clipped[2] / sum));
}

bool Search::over_corner(Batch& batch, int at, int i) const {
    const ProjectionBatch& rows = batch.rows;
    // With D35 one that leans has the corner and takes the node elsewhere.
    if (reach_box_.on || limits_.lift_leaning || rows.core[i] >= double(beyond_foreseen)) return false;
    const double w[3] = {rows.weight[0][i], rows.weight[1][i], rows.weight[2][i]};
    const int corner = w[0] > w[1] ? (w[0] > w[2] ? 0 : 2) : (w[1] > w[2] ? 1 : 2);
    if (!(w[corner] >= 1 - plain_share)) return false;
    const int own = batch.memory[at].place;
    const unsigned leads = leads_[static_cast<size_t>(own)].load(std::memory_order_relaxed);
    if ((leads >> corner & 1U) == 0 || standing(rows, i, batch.depth, own) != Standing::taken) return false;
    const V3 y = batch.point(at);
    if (!above_corner(y, tool_.segment(segment_of(own)), piece_of(own), corner)) return false;
    batch.place[at] = own;
    batch.settled[at] = Settled::tie;
    ++batch.tally.certified;
    return true;
}

bool Search::pair_up(Batch& batch, int at, int i) const {
    const ProjectionBatch& rows = batch.rows;
    if (reach_box_.on || rows.core[i] >= double(beyond_foreseen)) return false;
    const int own = batch.memory[at].place;
    const double w[3] = {rows.weight[0][i], rows.weight[1][i], rows.weight[2][i]};
    const int side = w[0] < w[1] ? (w[0] < w[2] ? 0 : 2) : (w[1] < w[2] ? 1 : 2);
    const double along = std::min(w[(side + 1) % 3], w[(side + 2) % 3]);
    const float pair = margins(own).pair.load(std::memory_order_relaxed);
    if (!(along >= double(pair) + plain_share) || standing(rows, i, batch.depth, own) != Standing::taken) return false;
    const int other = partner(own, side);
    if (other < 0) return false;
    ask_at(batch.partners, batch.pair_count, other, batch.point(at), batch.gap[at]);
    batch.pairs[batch.pair_count++] = {
        at, own, other, side, kappa_of(rows.b[i], rows.c[i]), along - double(pair) - plain_share};
    return true;
}

bool Search::over_shared_side(const Batch& batch, const Batch::Pair& pair) const {
    const int i = pair.column;
    const V3 y = batch.point(i);
    return over_side(y, tool_.segment(segment_of(pair.own)), piece_of(pair.own), pair.side);
}

void Search::decide_pairs(Batch& batch, const ProjectionLimits& rules) const {
    const int count = batch.pair_count;
    batch.pair_count = 0;
    if (count == 0) return;
    batch.tally.paired += count;
    const ProjectionBatch& rows = batch.partners;
    int others[ProjectionBatch::room];
    for (int j = 0; j < count; ++j)
        others[j] = batch.pairs[j].other;
    gather(batch.partners, tool_, others, 0, count, growth_);
    project_double(batch.partners, 0, count, landing_limits(batch.depth, batch.proximity));
    for (int j = 0; j < count; ++j) {
        const Batch::Pair& pair = batch.pairs[j];
        batch.path[pair.column] = Path::paired;
        const Standing stands = standing_in_rows(rows, j, batch.depth, pair.other);
        const double apart = kappa_of(rows.b[j], rows.c[j]) - pair.kappa;
        const bool only = stands == Standing::rejected || (stands == Standing::beyond && batch.proximity == 0);
        const bool lands = stands == Standing::taken || stands == Standing::lands;
        if (only || (lands && apart > plain_share)) {
            batch.place[pair.column] = pair.own;
            const double own = rate(pair.own);
            const double alone = ball(rows, j, stands, rate(pair.other), pair.kappa, own);
            batch.memory[pair.column].keep_steady(pair.own, batch.point(pair.column),
                                                  std::min(std::min(pair.room / own, reach_of(own)), alone));
        } else if (stands == Standing::taken && apart < -plain_share) {
            take(batch, pair.column, pair.other, rows, j);
        } else if (stands == Standing::taken && over_shared_side(batch, pair)) {
            batch.settled[pair.column] = Settled::tie;
            batch.place[pair.column] = pair.own;
            if (pair.other < pair.own) take(batch, pair.column, pair.other, rows, j);
        } else if (stands == Standing::taken) {
            batch.close[batch.close_count++] = pair;
        } else {
            put(batch, pair.column, decide_pair(batch, pair, rules));
        }
    }
}

double Search::fine_bound(int place) const {
    return std::ldexp(fine_share, -int(kappa_bits_[static_cast<size_t>(segment_of(place))]));
}

void Search::decide_close(Batch& batch, const ProjectionLimits& rules) const {
    ProjectionBatch& rows = batch.others;
    FineKappaRows& fine = batch.fine;
    constexpr int part = ProjectionBatch::room / 2;
    for (int first = 0; first < batch.close_count; first += part) {
        const int count = std::min(part, batch.close_count - first);
        int place[ProjectionBatch::room] = {};
        for (int j = 0; j < count; ++j) {
            const Batch::Pair& pair = batch.close[first + j];
            for (const int which : {0, 1}) {
                place[2 * j + which] = which == 0 ? pair.own : pair.other;
                ask_at(rows, 2 * j + which, place[2 * j + which], batch.point(pair.column), batch.gap[pair.column]);
            }
        }
        gather(rows, tool_, place, 0, 2 * count, growth_);
        project_double_double(rows, 2 * count, fine);
        for (int j = 0; j < count; ++j) {
            const Batch::Pair& pair = batch.close[first + j];
            const int own = 2 * j, other = own + 1;
            const double apart =
                (TwoDoubles(fine.high[other], fine.low[other]) - TwoDoubles(fine.high[own], fine.low[own])).high;
            const double unsure = 1.001 * (fine_bound(pair.own) + fine_bound(pair.other));
            if (apart > unsure) {
                batch.place[pair.column] = pair.own;
            } else if (apart < -unsure) {
                ProjectionBatch& landed = batch.partners;
                ask_at(landed, 0, pair.other, batch.point(pair.column), batch.gap[pair.column]);
                gather(landed, tool_, &pair.other, 0, 1, growth_);
                project_double(landed, 0, 1, landing_limits(batch.depth, batch.proximity));
                take(batch, pair.column, pair.other, landed, 0);
            } else {
                put(batch, pair.column, decide_pair(batch, pair, rules));
                batch.path[pair.column] = Path::paired;
                continue;
            }
            batch.settled[pair.column] = Settled::fine;
            ++batch.tally.fine;
        }
    }
}

/// Only these two can take the node: the exact way of telling them apart.
Search::Found Search::decide_pair(const Batch& batch, const Batch::Pair& pair, const ProjectionLimits& rules) const {
    const int i = pair.column;
    const V3 y = batch.point(i);
    const ContactReach window{batch.gap[i], batch.depth, batch.proximity};
    Decider decider(y, window, rules);
    for (const int place : {pair.own, pair.other}) {
        const SegmentData segment = tool_.segment(segment_of(place));
        decider.add(segment_of(place), piece_of(place),
                    filter(y, segment, local_segment(segment), piece_of(place), window, rules));
    }
    Found found{decider.retained([&](int s) { return tool_.segment(s); }), Path::paired};
    batch.memory[i].forget();
    use_plain_magnitudes(y, window, found.retained);
    if (found.retained.segment >= 0) batch.memory[i].look_at(place_of(found.retained.segment, found.retained.piece));
    return found;
}

}  // namespace type21::optimized
