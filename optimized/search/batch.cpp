// Many nodes at once: cores in the lanes of registers, then pairs likewise (pairs.cpp), then one after the other.
#include <algorithm>
#include <cstring>

#include "optimized/decide/foreseen_bounds.h"
#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

constexpr double nobody = 9;  ///< as a core: no weight is so large

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

void PathTally::add(const PathTally& other) {
    certified += other.certified;
    paired += other.paired;
    quiet += other.quiet;
    searched += other.searched;
    fine += other.fine;
    whole += other.whole;
}

void Search::find(Batch& batch, const Rules& rules) const {
    int open[Batch::room], count = 0;
    batch.pair_count = batch.close_count = 0;
    batch.tally = {};
    std::fill_n(batch.path, batch.count, Path::certified);
    std::fill_n(batch.settled, batch.count, Settled::filter);
    std::fill_n(batch.kind, batch.count, Kind::contact);
    for (int first = 0; first < batch.count; first += LandingRows::room)
        count += find_part(batch, first, std::min(LandingRows::room, batch.count - first), rules, open + count);
    // Those that no core holds: near a side they are asked of two, and only then of all.
    decide_pairs(batch, rules);
    decide_close(batch, rules);
    for (int j = 0; j < count; ++j) {
        const int i = open[j];
        const V3 y{batch.y[0][i], batch.y[1][i], batch.y[2][i]};
        put(batch, i, find(y, {batch.gap[i], batch.depth, batch.proximity}, rules, *batch.memory[i]));
    }
}

int Search::find_part(Batch& batch, int first, int count, const Rules& rules, int* open) const {
    LandingRows& rows = batch.rows;
    bool any = false;
    for (int i = 0; i < count; ++i) {
        const Memory* memory = batch.memory[first + i];
        const bool looks = memory != nullptr && memory->place >= 0 && !(memory->quiet > 0);
        any |= looks;
        if (looks) {
            fill(rows, i, memory->place);
        } else {
            rows.core[i] = nobody;
            rows.certain[i] = 0;
        }
    }
    if (any) {
        const auto copy = [&](const double* from, double* to) {
            std::memcpy(to, from, static_cast<size_t>(count) * sizeof(double));
        };
        for (int a = 0; a < 3; ++a)
            copy(batch.y[a] + first, rows.y[a]);
        copy(batch.gap + first, rows.gap);
        plain_landing(rows, count, landing_limits(batch.depth, batch.proximity));
        copy(rows.b, batch.b + first);
        copy(rows.c, batch.c + first);
        copy(rows.lift, batch.lift + first);
        for (int a = 0; a < 3; ++a) {
            copy(rows.n[a], batch.n[a] + first);
            copy(rows.x[a], batch.x[a] + first);
        }
    }
    int left = 0;
    for (int i = 0; i < count; ++i) {
        const int at = first + i;
        const double certain = rows.certain[i];
        batch.side[at] = rows.lift[i] > 0 ? 1 : -1;
        batch.place[at] = certain > 0 ? batch.memory[at]->place : -1;
        batch.tally.certified += certain != 0;
        if (certain != 0 || batch.memory[at] == nullptr) continue;
        if (!over_corner(batch, first, i) && !pair_up(batch, first, i)) open[left++] = at;
        if (batch.pair_count == LandingRows::room) decide_pairs(batch, rules);
    }
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

void Search::fill(LandingRows& rows, int column, int place, const Batch& batch, int i) const {
    fill(rows, column, place);
    for (int a = 0; a < 3; ++a)
        rows.y[a][column] = batch.y[a][i];
    rows.gap[column] = batch.gap[i];
}

void Search::take(Batch& batch, int i, int place, const LandingRows& rows, int column) const {
    batch.memory[i]->place = place;
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
