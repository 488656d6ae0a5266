// Nodes near a side: the two sub-triangles that can take them are compared in double, in double-double, exactly.
#include <algorithm>
#include <cmath>

#include "optimized/search/search.h"
#include "optimized/search/separating_lines.h"

namespace type21::optimized {

Search::State Search::state_in_rows(const ProjectionBatch& rows, int i, double depth, SubTriangleId id) const {
    if (rows.certain[i] > 0) return State::taken;
    return rows.rejected[i] > 0 ? State::rejected : state_of(rows, i, depth, id);
}

Search::State Search::state_of(const ProjectionBatch& rows, int i, double depth, SubTriangleId id) const {
    const double size = rows.size[i], height2 = rows.height[i] * rows.height[i];
    const double rounding = a_priori_share * size;
    if (!(rows.exclusive_margin[i] < double(not_a_priori_bounded) && rows.far[i] <= size)) return State::unknown;
    const bool front = rows.height[i] > 0;
    const double limit = front ? limits_.outward : limits_.inward;
    const double out = limit + 3 * rounding;
    if (height2 > out * out * (1 + 1e-9) * rows.square[i]) return State::rejected;
    if (!(std::abs(rows.p[i]) <= 4 && std::abs(rows.q[i]) <= 4 && rows.total[i] >= 0.5 &&
          height2 > 4 * rounding * rounding * rows.square[i] && height2 * (1 + 1e-9) < limit * limit * rows.square[i]))
        return State::unknown;
    constexpr double low = weight_limit;
    const double inner = rows.least_w(i);
    if (inner < low - decision_margin) return State::rejected;
    if (!(inner > low + decision_margin)) return State::unknown;
    const double least = rows.least_v(i);
    if (least < low - decision_margin) return State::rejected;
    if (!(least > low + decision_margin)) return State::unknown;
    const V3 n{rows.n[0][i], rows.n[1][i], rows.n[2][i]};
    // The error of a weight is below a_priori_share, that of a clipped and rescaled one below four times that, and an
    // edge is at most 2 sqrt(3) times the extent. Clipping twice as much moves the point by less than 15 times that
    // share.
    const double distance =
        least > -2 * a_priori_share ? std::abs(rows.lift[i]) * norm(n) : clipped_distance(rows, i, id);
    const double unsure = 4 * decision_margin * size, reach = front ? rows.gap[i] : depth;
    if (distance + unsure < reach) return State::taken;
    return distance - unsure > reach ? State::too_far : State::distance_unsure;
}

/// Formulation 3, step 4: distance of the node to the point with its weights clipped.
double Search::clipped_distance(const ProjectionBatch& rows, int i, SubTriangleId id) const {
    const double a = 1 - rows.b[i] - rows.c[i];
    const double clipped[3] = {std::clamp(a, 0.0, 1.0), std::clamp(rows.b[i], 0.0, 1.0),
                               std::clamp(rows.c[i], 0.0, 1.0)};
    const double sum = (clipped[0] + clipped[1]) + clipped[2];
    const SegmentData segment = tool_.segment(id.segment());
    return norm(offset_from_point({rows.y[0][i], rows.y[1][i], rows.y[2][i]}, segment, id.triangle(), clipped[1] / sum,
                                  clipped[2] / sum));
}

bool Search::above_leading_corner(Batch& batch, int i, int column) const {
    const ProjectionBatch& rows = batch.rows;
    // D35 lifts leaning normals: then a sub-triangle with this corner can take the node elsewhere.
    if (reach_box_.on || limits_.lift_leaning || rows.exclusive_margin[column] >= double(not_a_priori_bounded))
        return false;
    const double w[3] = {rows.weight[0][column], rows.weight[1][column], rows.weight[2][column]};
    const int corner = w[0] > w[1] ? (w[0] > w[2] ? 0 : 2) : (w[1] > w[2] ? 1 : 2);
    if (!(w[corner] >= 1 - decision_margin)) return false;
    const SubTriangleId own = batch.memory[i].last;
    const unsigned leads = leads_[static_cast<size_t>(own.code())].load(std::memory_order_relaxed);
    if ((leads >> corner & 1U) == 0 || state_of(rows, column, batch.depth, own) != State::taken) return false;
    if (!above_corner(batch.point(i), tool_.segment(own.segment()), own.triangle(), corner)) return false;
    batch.id[i] = own;
    batch.settled[i] = Settled::tie;
    ++batch.tally.exclusive_region;
    return true;
}

bool Search::add_neighbour_pair(Batch& batch, int i, int column) const {
    const ProjectionBatch& rows = batch.rows;
    if (reach_box_.on || rows.exclusive_margin[column] >= double(not_a_priori_bounded)) return false;
    const SubTriangleId own = batch.memory[i].last;
    const double w[3] = {rows.weight[0][column], rows.weight[1][column], rows.weight[2][column]};
    const int side = w[0] < w[1] ? (w[0] < w[2] ? 0 : 2) : (w[1] < w[2] ? 1 : 2);
    const double along = std::min(w[(side + 1) % 3], w[(side + 2) % 3]);
    const auto m2 = double(margins(own).neighbour.load(std::memory_order_relaxed));
    if (!(along >= m2 + decision_margin) || state_of(rows, column, batch.depth, own) != State::taken) return false;
    const SubTriangleId other = neighbour_over(own, side);
    if (!other.exists()) return false;
    put_query(batch.partners, batch.pair_count, other, batch.point(i), batch.gap[i]);
    batch.pairs[batch.pair_count++] = {
        i, own, other, side, kappa_of(rows.b[column], rows.c[column]), along - m2 - decision_margin};
    return true;
}

bool Search::over_shared_side(const Batch& batch, const Batch::NeighbourPair& pair) const {
    return over_side(batch.point(pair.column), tool_.segment(pair.own.segment()), pair.own.triangle(), pair.side);
}

void Search::decide_neighbour_pairs(Batch& batch, const ProjectionLimits& rules) const {
    const int count = batch.pair_count;
    batch.pair_count = 0;
    if (count == 0) return;
    batch.tally.edge_neighbour += count;
    const ProjectionBatch& rows = batch.partners;
    SubTriangleId others[ProjectionBatch::capacity];
    for (int j = 0; j < count; ++j)
        others[j] = batch.pairs[j].other;
    gather(batch.partners, tool_, others, 0, count, growth_);
    project_double(batch.partners, 0, count, batch_limits(batch.depth, batch.proximity));
    for (int j = 0; j < count; ++j) {
        const Batch::NeighbourPair& pair = batch.pairs[j];
        const int i = pair.column;
        batch.path[i] = Path::edge_neighbour;
        const State state = state_in_rows(rows, j, batch.depth, pair.other);
        const double excess = kappa_of(rows.b[j], rows.c[j]) - pair.kappa;
        const bool only_own = state == State::rejected || (state == State::too_far && batch.proximity == 0);
        const bool may_take = state == State::taken || state == State::distance_unsure;
        if (only_own || (may_take && excess > decision_margin)) {
            batch.id[i] = pair.own;
            const double own = lipschitz(pair.own);
            const double of_other = rival_radius(rows, j, state, lipschitz(pair.other), pair.kappa, own);
            batch.memory[i].keep_ranking_safe(pair.own, batch.point(i),
                                              std::min(std::min(pair.margin / own, lipschitz_reach_of(own)), of_other));
        } else if (state == State::taken && excess < -decision_margin) {
            take(batch, i, pair.other, rows, j);
        } else if (state == State::taken && over_shared_side(batch, pair)) {
            batch.settled[i] = Settled::tie;
            batch.id[i] = pair.own;
            if (pair.other < pair.own) take(batch, i, pair.other, rows, j);
        } else if (state == State::taken) {
            batch.close[batch.close_count++] = pair;
        } else {
            put_found(batch, i, decide_pair_alone(batch, pair, rules));
        }
    }
}

double Search::double_double_bound(SubTriangleId id) const {
    return std::ldexp(double_double_share, -int(kappa_bits_[static_cast<size_t>(id.segment())]));
}

void Search::decide_close_pairs(Batch& batch, const ProjectionLimits& rules) const {
    ProjectionBatch& rows = batch.others;
    KappaRows& kappa = batch.kappa;
    constexpr int part = ProjectionBatch::capacity / 2;
    for (int first = 0; first < batch.close_count; first += part) {
        const int count = std::min(part, batch.close_count - first);
        SubTriangleId id[ProjectionBatch::capacity] = {};
        for (int j = 0; j < count; ++j) {
            const Batch::NeighbourPair& pair = batch.close[first + j];
            for (const int which : {0, 1}) {
                id[2 * j + which] = which == 0 ? pair.own : pair.other;
                put_query(rows, 2 * j + which, id[2 * j + which], batch.point(pair.column), batch.gap[pair.column]);
            }
        }
        gather(rows, tool_, id, 0, 2 * count, growth_);
        project_double_double(rows, 2 * count, kappa);
        for (int j = 0; j < count; ++j) {
            const Batch::NeighbourPair& pair = batch.close[first + j];
            const int own = 2 * j, other = own + 1;
            const double excess =
                (TwoDoubles(kappa.high[other], kappa.low[other]) - TwoDoubles(kappa.high[own], kappa.low[own])).high;
            const double unsure = 1.001 * (double_double_bound(pair.own) + double_double_bound(pair.other));
            if (excess > unsure) {
                batch.id[pair.column] = pair.own;
            } else if (excess < -unsure) {
                ProjectionBatch& projected = batch.partners;
                put_query(projected, 0, pair.other, batch.point(pair.column), batch.gap[pair.column]);
                gather(projected, tool_, &pair.other, 0, 1, growth_);
                project_double(projected, 0, 1, batch_limits(batch.depth, batch.proximity));
                take(batch, pair.column, pair.other, projected, 0);
            } else {
                put_found(batch, pair.column, decide_pair_alone(batch, pair, rules));
                batch.path[pair.column] = Path::edge_neighbour;
                continue;
            }
            batch.settled[pair.column] = Settled::double_double;
            ++batch.tally.double_double;
        }
    }
}

/// Only these two can take the node. They are compared in the stages of Decider.
Search::Found Search::decide_pair_alone(const Batch& batch, const Batch::NeighbourPair& pair,
                                        const ProjectionLimits& rules) const {
    const int i = pair.column;
    const V3 y = batch.point(i);
    const ContactReach reach{batch.gap[i], batch.depth, batch.proximity};
    Decider decider(y, reach, rules);
    for (const SubTriangleId id : {pair.own, pair.other}) {
        const SegmentData segment = tool_.segment(id.segment());
        decider.add(id, filter(y, segment, local_segment(segment), id.triangle(), reach, rules));
    }
    Found found{decider.retained([&](int s) { return tool_.segment(s); }), Path::edge_neighbour};
    batch.memory[i].forget();
    use_double_magnitudes(y, reach, found.retained);
    if (found.retained.exists()) batch.memory[i].look_at(found.retained.id);
    return found;
}

}  // namespace type21::optimized
