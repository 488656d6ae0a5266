// Many nodes at once, in the lanes of registers: balls and cores, then pairs (pairs.cpp), then all that may take them
// (rows_search.cpp).
#include <algorithm>
#include <cmath>
#include <cstring>

#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

constexpr double taking = weight_limit + plain_share - foreseen_share;  ///< as a core: all that the sub-triangle takes

}  // namespace

Retained Search::Batch::retained(int i) const {
    if (place[i] < 0) return {};
    Retained r;
    r.segment = segment_of(place[i]);
    r.piece = piece_of(place[i]);
    r.settled = settled[i];
    r.landing.kind = kind[i];
    r.landing.side = side[i];
    r.landing.b = b[i];
    r.landing.c = c[i];
    r.landing.lift = lift[i];
    r.landing.normal = {n[0][i], n[1][i], n[2][i]};
    return r;
}

void Search::find(Batch& batch, const Rules& rules) const {
    int last[Batch::part], open[Batch::room], left = 0;
    batch.pair_count = batch.close_count = batch.candidate_count = 0;
    batch.tally = {};
    std::fill_n(batch.path, batch.count, Path::certified);
    std::fill_n(batch.settled, batch.count, Settled::filter);
    std::fill_n(batch.kind, batch.count, Kind::contact);
    std::fill_n(batch.place, batch.count, -1);
    for (int first = 0; first < batch.count; first += Batch::part) {
        left += recall(batch, first, last, open + left);
        left += look_again(batch, first, last, rules, open + left);
    }
    // Those that no core holds: near a side they are asked of two, and only then of all.
    decide_pairs(batch, rules);
    decide_close(batch, rules);
    ask_rows(batch, open, left, rules, true);
}

int Search::recall(Batch& batch, int first, int* last, int* open) const {
    const int count = std::min(Batch::part, batch.count - first);
    const Memory* const memory = batch.memory + first;
    long long within[Batch::part];
    within_balls(memory, {batch.y[0] + first, batch.y[1] + first, batch.y[2] + first}, count, within);
    int left = 0;
    long quiet = 0;
    for (int j = 0; j < count; ++j) {
        last[j] = -1;
        if (!batch.asked[first + j]) continue;
        const float radius = memory[j].radius;
        const bool steady = within[j] != 0 && radius < 0;
        if (within[j] != 0 && radius > 0) {
            batch.path[first + j] = Path::quiet;
            ++quiet;
        } else if (memory[j].place >= 0 && !(radius > 0) && (steady || batch.cores || -double(radius) < small_ball_)) {
            tool_.prefetch_segment(segment_of(memory[j].place));
            if (steady) batch.path[first + j] = Path::steady;
            last[j] = memory[j].place;
        } else {
            open[left++] = first + j;
        }
    }
    batch.tally.quiet += quiet;
    return left;
}

int Search::look_again(Batch& batch, int first, const int* last, const Rules& rules, int* open) const {
    LandingRows& rows = batch.rows;
    const int count = std::min(Batch::part, batch.count - first);
    int any = -1;
    for (int c = 0; c < count; ++c) {
        if (last[c] < 0) continue;
        any = last[c];
        tool_.prefetch_corners(segment_of(last[c]));
        rows.core[c] = batch.path[first + c] == Path::steady ? taking : double(core(last[c]));
    }
    if (any < 0) return 0;
    // Whole rows are copied faster than parts of them, and what is behind the nodes is nobody's.
    const auto in = [&](const double* from, double* to) { std::memcpy(to, from + first, sizeof(LandingRows::Row)); };
    const auto out = [&](const double* from, double* to) { std::memcpy(to + first, from, sizeof(LandingRows::Row)); };
    for (int a = 0; a < 3; ++a)
        in(batch.y[a], rows.y[a]);
    in(batch.gap, rows.gap);
    // Nodes that do not look stand anywhere; what they get is not asked.
    constexpr int group = Ahead::group;
    for (int c = 0; c < count; c += group) {
        if (batch.ahead != nullptr) batch.ahead->ask(batch.first + first + c);
        int place[group];
        for (int i = 0; i < group; ++i)
            place[i] = c + i < count && last[c + i] >= 0 ? last[c + i] : any;
        gather(rows, tool_, place, c, group, growth_);
    }
    plain_landing(rows, 0, count, landing_limits(batch.depth, batch.proximity));
    out(rows.b, batch.b);
    out(rows.c, batch.c);
    out(rows.lift, batch.lift);
    for (int a = 0; a < 3; ++a) {
        out(rows.n[a], batch.n[a]);
        out(rows.x[a], batch.x[a]);
    }
    int left = 0, kept = 0, alone = 0;
    for (int c = 0; c < count; ++c) {
        if (last[c] < 0) continue;
        const int i = first + c;
        const double certain = rows.certain[c];
        batch.side[i] = rows.lift[c] > 0 ? 1 : -1;
        if (certain > 0) batch.place[i] = last[c];
        if (batch.path[i] == Path::steady) {
            kept += certain > 0;
            // A ball tells who is retained, not that nothing is.
            if (!(certain > 0)) open[left++] = i;
            continue;
        }
        alone += certain != 0;
        if (certain != 0) continue;
        if (!over_corner(batch, i, c) && !pair_up(batch, i, c)) open[left++] = i;
        if (batch.pair_count == Batch::part) decide_pairs(batch, rules);
    }
    batch.tally.steady += kept;
    batch.tally.certified += alone;
    return left;
}

void Search::find(const Asked* asked, int count, const Rules& rules, Found* found) const {
    const auto batch = std::make_unique<Batch>();
    for (int i = 0; i < count; ++i) {
        // The depth is one for all nodes of a batch.
        batch->count = 1;
        batch->depth = asked[i].window.depth;
        batch->proximity = asked[i].window.proximity;
        batch->y[0][0] = asked[i].y.x;
        batch->y[1][0] = asked[i].y.y;
        batch->y[2][0] = asked[i].y.z;
        batch->gap[0] = asked[i].window.gap;
        batch->memory = asked[i].memory;
        batch->asked[0] = asked[i].memory != nullptr;
        find(*batch, rules);
        found[i] = {batch->retained(0), batch->path[0]};
    }
}

LandingLimits Search::landing_limits(double depth, double proximity) const {
    // D34's boxes are asked one node after the other.
    return {limits_.outward, limits_.inward, depth, proximity, !reach_box_.on};
}

void Search::ask_at(LandingRows& rows, int column, int place, const V3& y, double gap) const {
    for (int a = 0; a < 3; ++a)
        rows.y[a][column] = y[a];
    rows.gap[column] = gap;
    rows.core[column] = foreseen(place) ? taking : double(beyond_foreseen);
}

void Search::land_one(const V3& y, const Window& window, int place, LandingRows& rows) const {
    ask_at(rows, 0, place, y, window.gap);
    gather(rows, tool_, &place, 0, 1, growth_);
    plain_landing(rows, 0, 1, landing_limits(window.depth, window.proximity));
}

void Search::take(Batch& batch, int i, int place, const LandingRows& rows, int column) const {
    if (batch.memory != nullptr) {
        batch.memory[i].place = place;
        batch.memory[i].forget();
    }
    batch.place[i] = place;
    batch.side[i] = rows.lift[column] > 0 ? 1 : -1;
    batch.b[i] = rows.b[column];
    batch.c[i] = rows.c[column];
    batch.lift[i] = rows.lift[column];
    for (int a = 0; a < 3; ++a) {
        batch.n[a][i] = rows.n[a][column];
        batch.x[a][i] = rows.x[a][column];
    }
}

void Search::put(Batch& batch, int i, const Found& found) const {
    const Retained& r = found.retained;
    batch.path[i] = found.path;
    batch.settled[i] = r.settled;
    batch.tally.certified += found.path == Path::certified;
    batch.tally.quiet += found.path == Path::quiet;
    batch.tally.searched += found.path == Path::searched;
    batch.tally.fine += r.settled == Settled::fine;
    batch.tally.whole += r.settled == Settled::whole;
    batch.place[i] = -1;
    if (r.segment < 0) return;
    batch.place[i] = place_of(r.segment, r.piece);
    batch.kind[i] = r.landing.kind;
    batch.side[i] = static_cast<signed char>(r.landing.side);
    batch.b[i] = r.landing.b;
    batch.c[i] = r.landing.c;
    batch.lift[i] = r.landing.lift;
    const V3 x = landed_at(tool_.segment(r.segment), r.piece, r.landing.b, r.landing.c);
    for (int a = 0; a < 3; ++a) {
        batch.n[a][i] = r.landing.normal[a];
        batch.x[a][i] = x[a];
    }
}

}  // namespace type21::optimized
