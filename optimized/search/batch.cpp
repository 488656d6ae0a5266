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

static_assert(Prefetcher::distance == Search::Batch::room);

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

void Search::decide(Batch& batch, const ProjectionLimits& rules, bool projects) const {
    int last[Batch::part], open[Batch::room], left = 0;
    batch.pair_count = batch.close_count = batch.candidate_count = 0;
    batch.tally = {};
    std::fill_n(batch.settled, batch.count, Settled::filter);
    std::fill_n(batch.kind, batch.count, Kind::contact);
    for (int first = 0; first < batch.count; first += Batch::part) {
        left += recall(batch, first, last, open + left, projects);
        left += look_again(batch, first, last, rules, open + left, projects);
    }
    // Those that no core holds: near a side they are asked of two, and only then of all.
    decide_pairs(batch, rules);
    decide_close(batch, rules);
    ask_rows(batch, open, left, rules, true);
}

int Search::recall(Batch& batch, int first, int* last, int* open, bool projects) const {
    const int count = std::min(Batch::part, batch.count - first);
    const Memory* const memory = batch.memory + first;
    Recalled recalled;
    static_assert(Batch::part <= Recalled::room);
    recalled.find(memory, {batch.y[0] + first, batch.y[1] + first, batch.y[2] + first}, count,
                  batch.cores ? HUGE_VALF : shortened(small_ball_));
    // Without a branch: which of these a node is no processor can guess.
    const int looks = projects ? Recalled::held : Recalled::steady;
    Flags left;
    int quiet = 0, kept = 0;
    for (int j = 0; j < count; ++j) {
        const int asked = batch.asked[first + j] ? -1 : 0;
        const int what = recalled.what[j] & asked;
        const int held = what > looks ? -1 : 0, looking = (what >= Recalled::core ? -1 : 0) & ~held;
        last[j] = (recalled.place[j] & looking) | ~looking;
        batch.place[first + j] = (recalled.place[j] & held) | ~held;
        quiet += what == Recalled::quiet;
        kept -= held;
        recalled.what[j] = what;
        left.at[j] = (what == Recalled::nothing) & (asked != 0);
    }
    constexpr Path path[] = {Path::certified, Path::quiet, Path::certified, Path::steady, Path::steady};
    for (int j = 0; j < count; ++j)
        batch.path[first + j] = path[recalled.what[j]];
    for (int j = 0; j < count && !projects; ++j)
        batch.side[first + j] = memory[j].side();
    for (int j = 0; j < count && projects; ++j)
        tool_.prefetch_segment(segment_of(std::max(last[j], 0)));
    batch.tally.quiet += quiet;
    batch.tally.steady += kept;
    return left.list(count, first, open);
}

double Search::least_weight(const Batch& batch, int i, int place) const {
    return batch.path[i] == Path::steady ? taking : double(core(place));
}

void Search::land_in_place(Batch& batch, int first, int count, const int* last) const {
    ProjectionBatch& rows = batch.rows;
    int place[Batch::part];
    // Those that do not look stand anywhere, and what they get is not asked.
    const int any = *std::max_element(last, last + count);
    for (int c = 0; c < count; ++c) {
        place[c] = last[c] < 0 ? any : last[c];
        tool_.prefetch_corners(segment_of(place[c]));
        rows.core[c] = least_weight(batch, first + c, place[c]);
    }
    constexpr int group = Prefetcher::group;
    for (int c = 0; c < count; c += group) {
        if (batch.ahead != nullptr) batch.ahead->ask(batch.first + first + c);
        gather_asked(rows, tool_, place + c, c, std::min(group, count - c), growth_);
    }
    project_double(rows, place_in(batch, first), 0, count, landing_limits(batch.depth, batch.proximity));
}

void Search::land_apart(Batch& batch, int first, const int* nodes, int count, const int* last) const {
    ProjectionBatch& rows = batch.rows;
    int place[Batch::part] = {};
    for (int c = 0; c < count; ++c) {
        const int i = first + nodes[c];
        place[c] = last[nodes[c]];
        stand_at(rows, c, batch.point(i), batch.gap[i]);
        rows.core[c] = least_weight(batch, i, place[c]);
    }
    gather(rows, tool_, place, 0, count, growth_);
    project_double(rows, 0, count, landing_limits(batch.depth, batch.proximity));
    for (int c = 0; c < count; ++c)
        fill(batch, first + nodes[c], rows, c);
}

int Search::look_again(Batch& batch, int first, const int* last, const ProjectionLimits& rules, int* open,
                       bool projects) const {
    ProjectionBatch& rows = batch.rows;
    const int count = std::min(Batch::part, batch.count - first);
    const Path* const path = batch.path + first;
    Flags looks;
    for (int j = 0; j < count; ++j)
        looks.at[j] = last[j] >= 0;
    int nodes[Batch::part] = {}, left = 0, kept = 0, alone = 0;
    const int looking = looks.list(count, 0, nodes);
    // A few are put side by side.
    const bool in_place = looking > Batch::part / 3;
    if (in_place) {
        land_in_place(batch, first, count, last);
    } else {
        for (int j = 0; j < count && batch.ahead != nullptr; j += Prefetcher::group)
            batch.ahead->ask(batch.first + first + j);
        land_apart(batch, first, nodes, looking, last);
    }
    for (int k = 0; k < looking; ++k) {
        const int j = nodes[k], c = in_place ? j : k, i = first + j;
        const bool steady = path[j] == Path::steady, takes = rows.certain[c] > 0, misses = rows.certain[c] < 0;
        batch.side[i] = batch.lift[i] > 0 ? 1 : -1;
        if (takes) batch.place[i] = last[j];
        kept += steady & takes;
        alone += (takes | misses) & !steady;
        if (takes & (projects | !steady)) continue;
        if (in_place) complete(batch, i, c);
        if (takes) {
            keep_held(batch, i, c);
        } else if (steady) {
            // A ball tells who is retained, not that nothing is.
            open[left++] = i;
        } else if (!misses && !over_corner(batch, i, c) && !pair_up(batch, i, c)) {
            open[left++] = i;
        }
        if (batch.pair_count == Batch::part) decide_pairs(batch, rules);
    }
    batch.tally.steady += kept;
    batch.tally.certified += alone;
    return left;
}

void Search::complete(Batch& batch, int i, int c) {
    ProjectionBatch& rows = batch.rows;
    stand_at(rows, c, batch.point(i), batch.gap[i]);
    for (int a = 0; a < 3; ++a)
        rows.n[a][c] = batch.n[a][i];
    rows.b[c] = batch.b[i];
    rows.c[c] = batch.c[i];
    rows.lift[c] = batch.lift[i];
}

void Search::keep_held(Batch& batch, int i, int c) const {
    Memory& memory = batch.memory[i];
    const double ball = holding_ball(batch.rows, c, batch.depth, memory.place);
    // A smaller one would soon be gone, and the steady one with it.
    if (std::min(ball, memory.left_at(batch.point(i))) > small_ball_ / 16)
        memory.keep_held(batch.point(i), ball, batch.side[i]);
}

void Search::find(const Asked* asked, int count, const ProjectionLimits& rules, Found* found) const {
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
        Memory none;
        batch->memory = asked[i].memory != nullptr ? asked[i].memory : &none;
        batch->asked[0] = true;
        find(*batch, rules);
        found[i] = {batch->retained(0), batch->path[0]};
    }
}

LandingLimits Search::landing_limits(double depth, double proximity) const {
    // D34's boxes are asked one node after the other.
    return {limits_.outward, limits_.inward, depth, proximity, !reach_box_.on};
}

void Search::stand_at(ProjectionBatch& rows, int column, const V3& y, double gap) {
    for (int a = 0; a < 3; ++a)
        rows.y[a][column] = y[a];
    rows.gap[column] = gap;
}

void Search::ask_at(ProjectionBatch& rows, int column, int place, const V3& y, double gap) const {
    stand_at(rows, column, y, gap);
    rows.core[column] = a_priori_bounded(place) ? taking : double(beyond_foreseen);
}

void Search::land_one(const V3& y, const ContactReach& window, int place, ProjectionBatch& rows) const {
    ask_at(rows, 0, place, y, window.gap);
    gather(rows, tool_, &place, 0, 1, growth_);
    project_double(rows, 0, 1, landing_limits(window.depth, window.proximity));
}

void Search::take(Batch& batch, int i, int place, const ProjectionBatch& rows, int column) const {
    if (batch.memory != nullptr) batch.memory[i].look_at(place);
    batch.place[i] = place;
    batch.side[i] = rows.lift[column] > 0 ? 1 : -1;
    fill(batch, i, rows, column);
}

void Search::fill(Batch& batch, int i, const ProjectionBatch& rows, int column) {
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
