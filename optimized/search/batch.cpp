// Many nodes at once, in the lanes of registers: balls and cores, then pairs (pairs.cpp), then all that may take them
// (rows_search.cpp).
#include <algorithm>
#include <cmath>
#include <cstring>

#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

/// Some nodes of a part, found without a branch and listed by eights.
struct Flags {
    alignas(8) bool at[Search::Batch::part] = {};

    /// @return how many of the first `count` there are; each is put into the list, with `first` added
    int list(int count, int first, int* into) const {
        int found = 0;
        for (int c = 0; c < count; c += 8) {
            std::uint64_t eight;
            std::memcpy(&eight, at + c, 8);
            for (int i = c; eight != 0; ++i, eight >>= 8)
                if ((eight & 1) != 0) into[found++] = first + i;
        }
        return found;
    }
};

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

LandingPlace Search::Batch::from(int i) {
    return {{y[0] + i, y[1] + i, y[2] + i}, gap + i, b + i, c + i, lift + i, {n[0] + i, n[1] + i, n[2] + i},
            {x[0] + i, x[1] + i, x[2] + i}};
}

int Search::recall(Batch& batch, int first, int* last, int* open) const {
    const int count = std::min(Batch::part, batch.count - first);
    const Memory* const memory = batch.memory + first;
    Path* const path = batch.path + first;
    long long within[Batch::part];
    within_balls(memory, {batch.y[0] + first, batch.y[1] + first, batch.y[2] + first}, count, within);
    // Without a branch: which of these a node is no processor can guess.
    const float small = batch.cores ? HUGE_VALF : shortened(small_ball_);
    Flags left;
    int quiet = 0;
    for (int j = 0; j < count; ++j) {
        const float radius = memory[j].radius;
        const int place = memory[j].place;
        const bool in = within[j] != 0, asked = batch.asked[first + j];
        const bool steady = in & (radius < 0), rests = asked & in & (radius > 0);
        const bool looks = asked & (place >= 0) & !(radius > 0) & (steady | (-radius < small));
        last[j] = looks ? place : -1;
        path[j] = looks & steady ? Path::steady : (rests ? Path::quiet : Path::certified);
        quiet += rests;
        left.at[j] = asked & !rests & !looks;
        tool_.prefetch_segment(segment_of(looks ? place : 0));
    }
    batch.tally.quiet += quiet;
    return left.list(count, first, open);
}

int Search::look_again(Batch& batch, int first, const int* last, const Rules& rules, int* open) const {
    LandingRows& rows = batch.rows;
    const int count = std::min(Batch::part, batch.count - first);
    const Path* const path = batch.path + first;
    int any = -1;
    for (int c = 0; c < count; ++c) {
        if (last[c] < 0) continue;
        any = last[c];
        tool_.prefetch_corners(segment_of(last[c]));
        rows.core[c] = path[c] == Path::steady ? taking : double(core(last[c]));
    }
    if (any < 0) return 0;
    // Nodes that do not look stand anywhere; what they get is not asked.
    constexpr int group = Ahead::group;
    for (int c = 0; c < count; c += group) {
        if (batch.ahead != nullptr) batch.ahead->ask(batch.first + first + c);
        int place[group];
        for (int i = 0; i < group; ++i)
            place[i] = c + i < count && last[c + i] >= 0 ? last[c + i] : any;
        gather(rows, tool_, place, c, group, growth_);
    }
    plain_landing(rows, batch.from(first), 0, count, landing_limits(batch.depth, batch.proximity));
    Flags unsure;
    int kept = 0, alone = 0;
    for (int c = 0; c < count; ++c) {
        const bool looks = last[c] >= 0, steady = path[c] == Path::steady;
        const bool takes = looks & (rows.certain[c] > 0), misses = looks & (rows.certain[c] < 0);
        batch.place[first + c] = takes ? last[c] : -1;
        batch.side[first + c] = batch.lift[first + c] > 0 ? 1 : -1;
        kept += steady & takes;
        alone += (takes | misses) & !steady;
        // A ball tells who is retained, not that nothing is.
        unsure.at[c] = looks & !takes & !(misses & !steady);
    }
    batch.tally.steady += kept;
    batch.tally.certified += alone;
    int nodes[Batch::part], left = 0;
    const int looking = unsure.list(count, 0, nodes);
    for (int j = 0; j < looking; ++j) {
        const int c = nodes[j], i = first + c;
        if (path[c] == Path::steady || !near_side(batch, i, c)) open[left++] = i;
        if (batch.pair_count == Batch::part) decide_pairs(batch, rules);
    }
    return left;
}

bool Search::near_side(Batch& batch, int i, int c) const {
    LandingRows& rows = batch.rows;
    for (int a = 0; a < 3; ++a) {
        rows.y[a][c] = batch.y[a][i];
        rows.n[a][c] = batch.n[a][i];
    }
    rows.gap[c] = batch.gap[i];
    rows.b[c] = batch.b[i];
    rows.c[c] = batch.c[i];
    rows.lift[c] = batch.lift[i];
    return over_corner(batch, i, c) || pair_up(batch, i, c);
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
