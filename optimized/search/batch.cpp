// Many nodes at once, in the lanes of registers. First safe radii and exclusive regions, then edge neighbour zones
// (edge_neighbour_zone.cpp), then the full search (rows_search.cpp).
#include <algorithm>
#include <cmath>
#include <cstring>

#include "optimized/search/search.h"

namespace type21::optimized {

namespace {

/// A subset of the nodes of a part. It is marked without a branch and listed by eights.
struct Flags {
    alignas(8) bool at[Search::Batch::part] = {};

    /// Writes the marked ones among the first `count` to a list, with `first` added. @return how many there are
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

static_assert(Prefetcher::distance == Search::Batch::capacity);

/// The margin of a sub-triangle that is known to decide wherever it takes the node.
constexpr double everywhere = weight_limit + decision_margin - a_priori_share;

}  // namespace

Retained Search::Batch::retained(int i) const {
    if (!id[i].exists()) return {};
    Retained r;
    r.id = id[i];
    r.settled = settled[i];
    r.projection.kind = kind[i];
    r.projection.side = side[i];
    r.projection.b = b[i];
    r.projection.c = c[i];
    r.projection.lift = lift[i];
    r.projection.normal = {n[0][i], n[1][i], n[2][i]};
    return r;
}

void Search::decide(Batch& batch, const ProjectionLimits& rules, bool project_all) const {
    SubTriangleId last[Batch::part];
    int open[Batch::capacity], left = 0;
    batch.pair_count = batch.close_count = batch.candidate_count = 0;
    batch.tally = {};
    std::fill_n(batch.settled, batch.count, Settled::filter);
    std::fill_n(batch.kind, batch.count, Kind::contact);
    for (int first = 0; first < batch.count; first += Batch::part) {
        left += recall(batch, first, last, open + left, project_all);
        left += project_on_last(batch, first, last, rules, open + left, project_all);
    }
    // Nodes outside every exclusive region: near a side two sub-triangles are compared, elsewhere all are.
    decide_neighbour_pairs(batch, rules);
    decide_close_pairs(batch, rules);
    search_rows(batch, open, left, rules, true);
}

int Search::recall(Batch& batch, int first, SubTriangleId* last, int* open, bool project_all) const {
    const int count = std::min(Batch::part, batch.count - first);
    const Memory* const memory = batch.memory + first;
    Recalled recalled;
    static_assert(Batch::part <= Recalled::capacity);
    recalled.find(memory, {batch.y[0] + first, batch.y[1] + first, batch.y[2] + first}, count,
                  batch.exclusive_regions ? HUGE_VALF : rounded_down(small_radius_));
    // Without a branch, since no processor can predict which of these a node is.
    const int looks = project_all ? Recalled::contact_safe : Recalled::ranking_safe;
    Flags left;
    int separated = 0, kept = 0;
    for (int j = 0; j < count; ++j) {
        const int active = batch.active[first + j] ? -1 : 0;
        const int what = recalled.what[j] & active;
        const int known = what > looks ? -1 : 0, looking = (what >= Recalled::project ? -1 : 0) & ~known;
        last[j] = recalled.last[j].kept_by(looking);
        batch.id[first + j] = recalled.last[j].kept_by(known);
        separated += what == Recalled::separated;
        kept -= known;
        recalled.what[j] = what;
        left.at[j] = (what == Recalled::nothing) & (active != 0);
    }
    constexpr Path path[] = {Path::exclusive_region, Path::separated, Path::exclusive_region, Path::ranking_safe,
                             Path::ranking_safe};
    for (int j = 0; j < count; ++j)
        batch.path[first + j] = path[recalled.what[j]];
    for (int j = 0; j < count && !project_all; ++j)
        batch.side[first + j] = memory[j].side();
    for (int j = 0; j < count && project_all; ++j)
        tool_.prefetch_segment(std::max(last[j].code(), 0) >> 2);
    batch.tally.separated += separated;
    batch.tally.ranking_safe += kept;
    return left.list(count, first, open);
}

double Search::deciding_weight(const Batch& batch, int i, SubTriangleId id) const {
    return batch.path[i] == Path::ranking_safe ? everywhere : double(exclusive_margin(id));
}

void Search::project_in_place(Batch& batch, int first, int count, const SubTriangleId* last) const {
    ProjectionBatch& rows = batch.rows;
    SubTriangleId id[Batch::part];
    // A node that is not projected gets any sub-triangle, and its result is not used.
    const SubTriangleId any = *std::max_element(last, last + count);
    for (int c = 0; c < count; ++c) {
        id[c] = last[c].exists() ? last[c] : any;
        tool_.prefetch_corners(id[c].segment());
        rows.exclusive_margin[c] = deciding_weight(batch, first + c, id[c]);
    }
    constexpr int group = Prefetcher::group;
    for (int c = 0; c < count; c += group) {
        if (batch.prefetcher != nullptr) batch.prefetcher->prefetch(batch.first + first + c);
        gather_prefetched(rows, tool_, id + c, c, std::min(group, count - c), growth_);
    }
    project_double(rows, rows_from(batch, first), 0, count, batch_limits(batch.depth, batch.proximity));
}

void Search::project_gathered(Batch& batch, int first, const int* nodes, int count, const SubTriangleId* last) const {
    ProjectionBatch& rows = batch.rows;
    SubTriangleId id[Batch::part] = {};
    for (int c = 0; c < count; ++c) {
        const int i = first + nodes[c];
        id[c] = last[nodes[c]];
        put_node(rows, c, batch.point(i), batch.gap[i]);
        rows.exclusive_margin[c] = deciding_weight(batch, i, id[c]);
    }
    gather(rows, tool_, id, 0, count, growth_);
    project_double(rows, 0, count, batch_limits(batch.depth, batch.proximity));
    for (int c = 0; c < count; ++c)
        copy_result(batch, first + nodes[c], rows, c);
}

int Search::project_on_last(Batch& batch, int first, const SubTriangleId* last, const ProjectionLimits& rules,
                            int* open, bool project_all) const {
    ProjectionBatch& rows = batch.rows;
    const int count = std::min(Batch::part, batch.count - first);
    const Path* const path = batch.path + first;
    Flags looks;
    for (int j = 0; j < count; ++j)
        looks.at[j] = last[j].exists();
    int nodes[Batch::part] = {}, left = 0, kept = 0, alone = 0;
    const int looking = looks.list(count, 0, nodes);
    // A few nodes are gathered side by side.
    const bool in_place = looking > Batch::part / 3;
    if (in_place) {
        project_in_place(batch, first, count, last);
    } else {
        for (int j = 0; j < count && batch.prefetcher != nullptr; j += Prefetcher::group)
            batch.prefetcher->prefetch(batch.first + first + j);
        project_gathered(batch, first, nodes, looking, last);
    }
    for (int k = 0; k < looking; ++k) {
        const int j = nodes[k], c = in_place ? j : k, i = first + j;
        const bool ranking_safe = path[j] == Path::ranking_safe, takes = rows.certain[c] > 0,
                   misses = rows.certain[c] < 0;
        batch.side[i] = batch.lift[i] > 0 ? 1 : -1;
        if (takes) batch.id[i] = last[j];
        kept += ranking_safe & takes;
        alone += (takes | misses) & !ranking_safe;
        if (takes & (project_all | !ranking_safe)) continue;
        if (in_place) complete_rows(batch, i, c);
        if (takes) {
            keep_contact_safe(batch, i, c);
        } else if (ranking_safe) {
            // The ranking safe radius does not say what happens where the sub-triangle does not take the node.
            open[left++] = i;
        } else if (!misses && !above_leading_corner(batch, i, c) && !add_neighbour_pair(batch, i, c)) {
            open[left++] = i;
        }
        if (batch.pair_count == Batch::part) decide_neighbour_pairs(batch, rules);
    }
    batch.tally.ranking_safe += kept;
    batch.tally.exclusive_region += alone;
    return left;
}

void Search::complete_rows(Batch& batch, int i, int c) {
    ProjectionBatch& rows = batch.rows;
    put_node(rows, c, batch.point(i), batch.gap[i]);
    for (int a = 0; a < 3; ++a)
        rows.n[a][c] = batch.n[a][i];
    rows.b[c] = batch.b[i];
    rows.c[c] = batch.c[i];
    rows.lift[c] = batch.lift[i];
}

void Search::keep_contact_safe(Batch& batch, int i, int c) const {
    Memory& memory = batch.memory[i];
    const double radius = contact_safe_radius(batch.rows, c, batch.depth, memory.last);
    // The node would soon leave a smaller one, and with its centre moved the ranking safe radius shrinks as well.
    if (std::min(radius, memory.left_at(batch.point(i))) > small_radius_ / 16)
        memory.keep_contact_safe(batch.point(i), radius, batch.side[i]);
}

void Search::find(const NodeQuery* query, int count, const ProjectionLimits& rules, Found* found) const {
    const auto batch = std::make_unique<Batch>();
    for (int i = 0; i < count; ++i) {
        // The depth is one number for all nodes of a batch.
        batch->count = 1;
        batch->depth = query[i].reach.depth;
        batch->proximity = query[i].reach.proximity;
        batch->y[0][0] = query[i].y.x;
        batch->y[1][0] = query[i].y.y;
        batch->y[2][0] = query[i].y.z;
        batch->gap[0] = query[i].reach.gap;
        Memory none;
        batch->memory = query[i].memory != nullptr ? query[i].memory : &none;
        batch->active[0] = true;
        find(*batch, rules);
        found[i] = {batch->retained(0), batch->path[0]};
    }
}

BatchLimits Search::batch_limits(double depth, double proximity) const {
    // D34's boxes are tested one node after the other.
    return {limits_.outward, limits_.inward, depth, proximity, !reach_box_.on};
}

void Search::put_node(ProjectionBatch& rows, int column, const V3& y, double gap) {
    for (int a = 0; a < 3; ++a)
        rows.y[a][column] = y[a];
    rows.gap[column] = gap;
}

void Search::put_query(ProjectionBatch& rows, int column, SubTriangleId id, const V3& y, double gap) const {
    put_node(rows, column, y, gap);
    rows.exclusive_margin[column] = a_priori_bounded(id) ? everywhere : double(not_a_priori_bounded);
}

void Search::project_one(const V3& y, const ContactReach& reach, SubTriangleId id, ProjectionBatch& rows) const {
    put_query(rows, 0, id, y, reach.gap);
    gather(rows, tool_, &id, 0, 1, growth_);
    project_double(rows, 0, 1, batch_limits(reach.depth, reach.proximity));
}

void Search::take(Batch& batch, int i, SubTriangleId id, const ProjectionBatch& rows, int column) const {
    if (batch.memory != nullptr) batch.memory[i].look_at(id);
    batch.id[i] = id;
    batch.side[i] = rows.lift[column] > 0 ? 1 : -1;
    copy_result(batch, i, rows, column);
}

void Search::copy_result(Batch& batch, int i, const ProjectionBatch& rows, int column) {
    batch.b[i] = rows.b[column];
    batch.c[i] = rows.c[column];
    batch.lift[i] = rows.lift[column];
    for (int a = 0; a < 3; ++a) {
        batch.n[a][i] = rows.n[a][column];
        batch.x[a][i] = rows.x[a][column];
    }
}

void Search::put_found(Batch& batch, int i, const Found& found) const {
    const Retained& r = found.retained;
    batch.path[i] = found.path;
    batch.settled[i] = r.settled;
    batch.tally.exclusive_region += found.path == Path::exclusive_region;
    batch.tally.separated += found.path == Path::separated;
    batch.tally.searched += found.path == Path::searched;
    batch.tally.double_double += r.settled == Settled::double_double;
    batch.tally.integer += r.settled == Settled::integer;
    batch.id[i] = r.id;
    if (!r.exists()) return;
    batch.kind[i] = r.projection.kind;
    batch.side[i] = static_cast<signed char>(r.projection.side);
    batch.b[i] = r.projection.b;
    batch.c[i] = r.projection.c;
    batch.lift[i] = r.projection.lift;
    const V3 x = point_at(tool_.segment(r.id.segment()), r.id.triangle(), r.projection.b, r.projection.c);
    for (int a = 0; a < 3; ++a) {
        batch.n[a][i] = r.projection.normal[a];
        batch.x[a][i] = x[a];
    }
}

}  // namespace type21::optimized
