// Nodes near a side: the two sub-triangles that can take them, told apart in double, in 100 bits, exactly.
#include <cmath>

#include "optimized/decide/foreseen_bounds.h"
#include "optimized/search/margins.h"
#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

/// What a pair's weights and kappa must be away from what decides: ten times what foreseen() allows them to be off.
constexpr double pair_share = 1e-5;

double kappa(double b, double c) {
    return std::abs(1.0 / 3 - b) + std::abs(1.0 / 3 - c) + std::abs(2.0 / 3 - b - c);
}

}  // namespace

/// Does the sub-triangle take the node as contact? Known only where the bounds are foreseen, and away from every limit
/// by more than the filter needs.
Search::Standing Search::standing(const LandingRows& rows, int i, double depth, int place) const {
    const double size = rows.size[i], height2 = rows.height[i] * rows.height[i];
    const double rounding = foreseen_share * size;
    if (!(rows.core[i] < double(beyond_foreseen) && rows.far[i] <= size && std::abs(rows.p[i]) <= 4 &&
          std::abs(rows.q[i]) <= 4 && rows.total[i] >= 0.5 && height2 > 4 * rounding * rounding * rows.square[i]))
        return Standing::unknown;
    const bool front = rows.height[i] > 0;
    const double limit = front ? limits_.outward : limits_.inward;
    if (!(height2 * (1 + 1e-9) < limit * limit * rows.square[i])) return Standing::unknown;
    constexpr double low = -0.01;
    const double inner = std::min(rows.weight[0][i], std::min(rows.weight[1][i], rows.weight[2][i]));
    if (inner < low - pair_share) return Standing::rejected;
    if (!(inner > low + pair_share)) return Standing::unknown;
    const double least = std::min(1 - rows.b[i] - rows.c[i], std::min(rows.b[i], rows.c[i]));
    if (least < low - pair_share) return Standing::rejected;
    if (!(least > low + pair_share)) return Standing::unknown;
    // Clipping weights >= -w, w <= 0.01, moves the point by at most half of the weights' change, 4.04 w, times an edge;
    // an edge is at most 2 sqrt(3) times the extent.
    const double below = std::max(0.0, -least) + pair_share;
    const double moved = least > pair_share ? 0.0 : 7.1 * below * tool_.extent(segment_of(place));
    const V3 n{rows.n[0][i], rows.n[1][i], rows.n[2][i]};
    const double farthest = std::abs(rows.lift[i]) * norm(n) + moved + 2 * pair_share * size;
    return farthest < (front ? rows.gap[i] : depth) ? Standing::taken : Standing::unknown;
}

bool Search::over_corner(Batch& batch, int first, int i) const {
    const LandingRows& rows = batch.rows;
    // With D35 one that leans has the corner and takes the node elsewhere.
    if (reach_box_.on || limits_.lift_leaning || rows.core[i] >= double(beyond_foreseen)) return false;
    const double w[3] = {rows.weight[0][i], rows.weight[1][i], rows.weight[2][i]};
    const int corner = w[0] > w[1] ? (w[0] > w[2] ? 0 : 2) : (w[1] > w[2] ? 1 : 2);
    if (!(w[corner] >= 1 - pair_share)) return false;
    const int at = first + i, own = batch.memory[at]->place;
    const unsigned leads = leads_[static_cast<size_t>(own)].load(std::memory_order_relaxed);
    if ((leads >> corner & 1U) == 0 || standing(rows, i, batch.depth, own) != Standing::taken) return false;
    const V3 y{batch.y[0][at], batch.y[1][at], batch.y[2][at]};
    if (!above_corner(y, tool_.segment(segment_of(own)), piece_of(own), corner)) return false;
    batch.place[at] = own;
    batch.settled[at] = Settled::tie;
    ++batch.tally.certified;
    return true;
}

bool Search::pair_up(Batch& batch, int first, int i) const {
    const LandingRows& rows = batch.rows;
    // No place to look at is one of these, too.
    if (reach_box_.on || rows.core[i] >= double(beyond_foreseen)) return false;
    const int own = batch.memory[first + i]->place;
    const double w[3] = {rows.weight[0][i], rows.weight[1][i], rows.weight[2][i]};
    const int side = w[0] < w[1] ? (w[0] < w[2] ? 0 : 2) : (w[1] < w[2] ? 1 : 2);
    const double along = std::min(w[(side + 1) % 3], w[(side + 2) % 3]);
    const float pair = margins_[static_cast<size_t>(own)].pair.load(std::memory_order_relaxed);
    if (!(along >= double(pair) + pair_share) || standing(rows, i, batch.depth, own) != Standing::taken) return false;
    const int other = partner(own, side);
    if (other < 0) return false;
    fill(batch.partners, batch.pair_count, other, batch, first + i);
    batch.pairs[batch.pair_count++] = {first + i, own, other, side, kappa(rows.b[i], rows.c[i])};
    return true;
}

bool Search::over_shared_side(const Batch& batch, const Batch::Pair& pair) const {
    const int i = pair.column;
    const V3 y{batch.y[0][i], batch.y[1][i], batch.y[2][i]};
    return over_side(y, tool_.segment(segment_of(pair.own)), piece_of(pair.own), pair.side);
}

void Search::decide_pairs(Batch& batch, const Rules& rules) const {
    const int count = batch.pair_count;
    batch.pair_count = 0;
    if (count == 0) return;
    batch.tally.paired += count;
    const LandingRows& rows = batch.partners;
    LandingLimits limits = landing_limits(batch.depth, batch.proximity);
    limits.decide = false;
    plain_landing(batch.partners, count, limits);
    for (int j = 0; j < count; ++j) {
        const Batch::Pair& pair = batch.pairs[j];
        batch.path[pair.column] = Path::paired;
        const Standing stands = standing(rows, j, batch.depth, pair.other);
        const double apart = kappa(rows.b[j], rows.c[j]) - pair.kappa;
        if (stands == Standing::rejected || (stands == Standing::taken && apart > pair_share)) {
            batch.place[pair.column] = pair.own;
        } else if (stands == Standing::taken && apart < -pair_share) {
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

void Search::decide_close(Batch& batch, const Rules& rules) const {
    LandingRows& rows = batch.rows;
    FineKappaRows& fine = batch.fine;
    constexpr int part = LandingRows::room / 2;
    for (int first = 0; first < batch.close_count; first += part) {
        const int count = std::min(part, batch.close_count - first);
        for (int j = 0; j < count; ++j) {
            const Batch::Pair& pair = batch.close[first + j];
            fill(rows, 2 * j, pair.own, batch, pair.column);
            fill(rows, 2 * j + 1, pair.other, batch, pair.column);
        }
        fine_landing(rows, 2 * count, fine);
        for (int j = 0; j < count; ++j) {
            const Batch::Pair& pair = batch.close[first + j];
            const int own = 2 * j, other = own + 1;
            const double apart =
                (TwoDoubles(fine.high[other], fine.low[other]) - TwoDoubles(fine.high[own], fine.low[own])).high;
            if (apart > 3 * fine_kappa_share) {
                batch.place[pair.column] = pair.own;
            } else if (apart < -3 * fine_kappa_share) {
                LandingRows& landed = batch.partners;
                fill(landed, 0, pair.other, batch, pair.column);
                plain_landing(landed, 1, landing_limits(batch.depth, batch.proximity));
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
Search::Found Search::decide_pair(const Batch& batch, const Batch::Pair& pair, const Rules& rules) const {
    const int i = pair.column;
    const V3 y{batch.y[0][i], batch.y[1][i], batch.y[2][i]};
    const Window window{batch.gap[i], batch.depth, batch.proximity};
    Decider decider(y, window, rules);
    for (const int place : {pair.own, pair.other}) {
        const SegmentData segment = tool_.segment(segment_of(place));
        decider.add(segment_of(place), piece_of(place),
                    filter(y, segment, local_segment(segment), piece_of(place), window, rules));
    }
    Found found{decider.retained([&](int s) { return tool_.segment(s); }), Path::paired};
    if (found.retained.segment >= 0) batch.memory[i]->place = place_of(found.retained.segment, found.retained.piece);
    return found;
}

}  // namespace type21::optimized
