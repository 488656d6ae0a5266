// Many nodes at once: cores in the lanes of registers, then pairs likewise, then one after the other.
#include <cmath>

#include "optimized/decide/foreseen_bounds.h"
#include "optimized/search/margins.h"
#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

/// What a pair's weights and kappa must be away from what decides: ten times what foreseen() allows them to be off.
constexpr double pair_share = 1e-5;
constexpr double nobody = 9;  ///< as a core: no weight is so large

double kappa(double b, double c) {
    return std::abs(1.0 / 3 - b) + std::abs(1.0 / 3 - c) + std::abs(2.0 / 3 - b - c);
}

/// What is found of one column.
void copy_found(const LandingRows& from, int i, LandingRows& to, int j) {
    to.b[j] = from.b[i];
    to.c[j] = from.c[i];
    to.lift[j] = from.lift[i];
    to.height[j] = from.height[i];
    for (int a = 0; a < 3; ++a) {
        to.n[a][j] = from.n[a][i];
        to.x[a][j] = from.x[a][i];
    }
}

}  // namespace

Retained Search::Batch::retained(int i) const {
    if (place[i] < 0) return {};
    Retained r;
    r.segment = segment_of(place[i]);
    r.piece = piece_of(place[i]);
    r.settled = settled[i];
    r.landing.kind = kind[i];
    r.landing.side = side[i];
    r.landing.b = rows.b[i];
    r.landing.c = rows.c[i];
    r.landing.lift = rows.lift[i];
    r.landing.normal = {rows.n[0][i], rows.n[1][i], rows.n[2][i]};
    return r;
}

void Search::find(Batch& batch, const Rules& rules) const {
    LandingRows& rows = batch.rows;
    bool any = false;
    for (int i = 0; i < batch.count; ++i) {
        const Memory* memory = batch.memory[i];
        batch.place[i] = -1;
        if (memory == nullptr || memory->place < 0 || memory->quiet > 0) {
            rows.core[i] = nobody;
            rows.certain[i] = 0;
            continue;
        }
        any = true;
        fill(rows, i, memory->place);
    }
    if (any) plain_landing(rows, batch.count, landing_limits(batch.depth, batch.proximity));
    int open[Batch::room], count = 0;
    for (int i = 0; i < batch.count; ++i) {
        const double certain = rows.certain[i];
        batch.path[i] = Path::certified;
        batch.settled[i] = Settled::filter;
        if (certain == 0) {
            if (batch.memory[i] != nullptr) open[count++] = i;
            continue;
        }
        batch.kind[i] = Kind::contact;
        batch.side[i] = rows.lift[i] > 0 ? 1 : -1;
        batch.place[i] = certain > 0 ? batch.memory[i]->place : -1;
    }
    count = ask_pairs(batch, rules, open, count);
    for (int j = 0; j < count; ++j) {
        const int i = open[j];
        const V3 y{rows.y[0][i], rows.y[1][i], rows.y[2][i]};
        put(batch, i, find(y, {rows.gap[i], batch.depth, batch.proximity}, rules, *batch.memory[i]));
    }
}

void Search::find(const Asked* asked, int count, const Rules& rules, Found* found) const {
    const auto batch = std::make_unique<Batch>();
    for (int i = 0; i < count; ++i) {
        // The depth is one for all nodes of a batch.
        batch->count = 1;
        batch->depth = asked[i].window.depth;
        batch->proximity = asked[i].window.proximity;
        batch->rows.y[0][0] = asked[i].y.x;
        batch->rows.y[1][0] = asked[i].y.y;
        batch->rows.y[2][0] = asked[i].y.z;
        batch->rows.gap[0] = asked[i].window.gap;
        batch->memory[0] = asked[i].memory;
        find(*batch, rules);
        found[i] = {batch->retained(0), batch->path[0]};
    }
}

LandingLimits Search::landing_limits(double depth, double proximity) const {
    // D34's boxes are asked one node after the other.
    return {limits_.outward, limits_.inward, depth, proximity, !reach_box_.on};
}

void Search::fill(LandingRows& rows, int column, int place) const {
    const int segment = segment_of(place);
    for (int j = 0; j < 4; ++j) {
        const V3 &x = tool_.node(segment, j), &n = tool_.normal(segment, j);
        rows.corner[j][0][column] = x.x;
        rows.corner[j][1][column] = x.y;
        rows.corner[j][2][column] = x.z;
        rows.normal[j][0][column] = n.x;
        rows.normal[j][1][column] = n.y;
        rows.normal[j][2][column] = n.z;
    }
    rows.code[column] = tool_.is_triangle(segment) ? 4 : (place & 3);
    rows.core[column] = double(core(place));
    rows.size[column] = foreseen_size(tool_.extent(segment), std::max(limits_.outward, limits_.inward));
}

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
    // Clipping moves the point by at most half of the weights' change, 0.0404, times an edge; an edge is at most
    // 2 sqrt(3) times the extent.
    const double moved = least > pair_share ? 0.0 : 0.071 * tool_.extent(segment_of(place));
    const V3 n{rows.n[0][i], rows.n[1][i], rows.n[2][i]};
    const double farthest = std::abs(rows.lift[i]) * norm(n) + moved + 2 * pair_share * size;
    return farthest < (front ? rows.gap[i] : depth) ? Standing::taken : Standing::unknown;
}

int Search::ask_pairs(Batch& batch, const Rules& rules, int* open, int count) const {
    if (reach_box_.on || rules.low != Rules{}.low) return count;
    const LandingRows& rows = batch.rows;
    int left = 0, asked = 0, column[Batch::room], place[Batch::room];
    for (int j = 0; j < count; ++j) {
        const int i = open[j];
        open[left++] = i;
        if (rows.core[i] >= double(beyond_foreseen)) continue;  // no place to look at is one of these, too
        const int own = batch.memory[i]->place;
        const double w[3] = {rows.weight[0][i], rows.weight[1][i], rows.weight[2][i]};
        const int side = w[0] < w[1] ? (w[0] < w[2] ? 0 : 2) : (w[1] < w[2] ? 1 : 2);
        const double along = std::min(w[(side + 1) % 3], w[(side + 2) % 3]);
        const float pair = margins_[static_cast<size_t>(own)].pair.load(std::memory_order_relaxed);
        if (!(along >= double(pair) + pair_share) || standing(rows, i, batch.depth, own) != Standing::taken) continue;
        const int other = partner(own, side);
        if (other < 0) continue;
        --left;
        column[asked] = i;
        place[asked] = other;
        fill(batch.other, asked, other);
        for (int a = 0; a < 3; ++a)
            batch.other.y[a][asked] = rows.y[a][i];
        batch.other.gap[asked++] = rows.gap[i];
    }
    if (asked == 0) return left;
    LandingLimits limits = landing_limits(batch.depth, batch.proximity);
    limits.decide = false;
    plain_landing(batch.other, asked, limits);
    for (int j = 0; j < asked; ++j) {
        const int i = column[j], own = batch.memory[i]->place;
        const Standing stands = standing(batch.other, j, batch.depth, place[j]);
        const double apart = kappa(batch.other.b[j], batch.other.c[j]) - kappa(rows.b[i], rows.c[i]);
        if (stands == Standing::rejected || (stands == Standing::taken && apart > pair_share)) {
            take(batch, i, own);
        } else if (stands == Standing::taken && apart < -pair_share) {
            copy_found(batch.other, j, batch.rows, i);
            take(batch, i, place[j]);
        } else {
            put(batch, i, decide_pair(batch, i, own, place[j], rules));
        }
        batch.path[i] = Path::paired;
    }
    return left;
}

/// Only these two can take the node: the exact way of telling them apart.
Search::Found Search::decide_pair(const Batch& batch, int i, int own, int other, const Rules& rules) const {
    const LandingRows& rows = batch.rows;
    const V3 y{rows.y[0][i], rows.y[1][i], rows.y[2][i]};
    const Window window{rows.gap[i], batch.depth, batch.proximity};
    Decider decider(y, window, rules);
    for (const int place : {own, other}) {
        const SegmentData segment = tool_.segment(segment_of(place));
        decider.add(segment_of(place), piece_of(place),
                    filter(y, segment, local_segment(segment), piece_of(place), window, rules));
    }
    Found found{decider.retained([&](int s) { return tool_.segment(s); }), Path::paired};
    if (found.retained.segment >= 0) batch.memory[i]->place = place_of(found.retained.segment, found.retained.piece);
    return found;
}

void Search::take(Batch& batch, int i, int place) const {
    batch.memory[i]->place = place;
    batch.place[i] = place;
    batch.kind[i] = Kind::contact;
    batch.side[i] = batch.rows.lift[i] > 0 ? 1 : -1;
}

void Search::put(Batch& batch, int i, const Found& found) const {
    const Retained& r = found.retained;
    batch.path[i] = found.path;
    batch.settled[i] = r.settled;
    batch.place[i] = -1;
    if (r.segment < 0) return;
    batch.place[i] = place_of(r.segment, r.piece);
    batch.kind[i] = r.landing.kind;
    batch.side[i] = static_cast<signed char>(r.landing.side);
    LandingRows& rows = batch.rows;
    rows.b[i] = r.landing.b;
    rows.c[i] = r.landing.c;
    rows.lift[i] = r.landing.lift;
    const V3 x = landed_at(tool_.segment(r.segment), r.piece, r.landing.b, r.landing.c);
    for (int a = 0; a < 3; ++a) {
        rows.n[a][i] = r.landing.normal[a];
        rows.x[a][i] = x[a];
    }
}

}  // namespace type21::optimized
