// A chunk of nodes in rows: positions, retained impacts, forces, sums. For t > 0 and the effects that most scenes have,
// see in_lanes.
#include "optimized/kernel/contact_point.h"
#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

namespace {

Vec3 column(const double (*rows)[ForceRows::capacity], int j) {
    return {rows[0][j], rows[1][j], rows[2][j]};
}

/// Formulation 1, step 1; Formulation 3, steps 1 to 6; Formulation 4, steps 1 to 5.
void locate(const Laws& laws, const Cycle& cycle, const ForceCycle& c, NodeData& nodes, int first,
            Search::Batch& batch) {
    batch.first = first;
    into_rows(cycle.motion.position, nodes.node.data() + first, batch.count, batch.y);
    batch.memory = nodes.memory_from(first);
    // A node without stiffness has no contact.
    for (int j = 0; j < batch.count; ++j)
        batch.active[j] = nodes.stiffness[static_cast<size_t>(first + j)] != 0;
    fetch(nodes.search_gap.empty() ? nodes.gap : nodes.search_gap, first, batch.count, batch.gap);
    to_tool_frame(batch, batch.count, c);
    laws.search->find(batch, laws.rules);
}

/// The input of the forces. @param at  index of the node in the batch   @return false where no node is in contact
bool prepare(const Laws& laws, const Cycle& cycle, NodeData& nodes, int start, const Search::Batch& batch, int at,
             ForceRows& f) {
    if (!f.prepare(nodes, start, batch, at, cycle.motion.velocity, laws.has(effect::damping),
                   laws.has(effect::friction)))
        return false;
    if (!laws.has(effect::pmax)) return true;
    const SecondarySide& side = laws.card->secondary;
    for (int j = 0; j < f.count; ++j) {
        const auto i = static_cast<size_t>(start + j);
        f.growth[j] = std::max(nodes.gap[i] - side.gap[i], 0.0);
        f.pmax_force[j] = side.area[i] * laws.card->pmax;
    }
    return true;
}

/// Lists of released and inverted nodes, in their order. Before store_history(), which increments the cycle counts.
/// @manual field IBC, Invn, Pskid; comment 7, 21
void list(const Laws& laws, NodeData& nodes, const Search::Batch& batch, const ForceRows& f, ChunkLists& lists) {
    for (int j = 0; j < f.count; ++j) {
        const auto i = static_cast<size_t>(f.rank + j);
        if (f.in_contact[j] == 0) continue;
        if (laws.normals_test && f.first[j] != 0 && f.p_g[j] > f.gap[j] + 0.99 * laws.card->depth)
            lists.inverted.push_back({nodes.node[i], batch.id[f.at + j].segment(), f.p_g[j]});
        if (laws.release && f.penetration[j] > 0 && nodes.released[i] == 0) {
            nodes.released[i] = 1;
            lists.released.push_back(nodes.node[i]);
        }
        if (!laws.skid || !laws.has(effect::friction)) continue;
        const V3 friction{f.friction[0][j], f.friction[1][j], f.friction[2][j]};
        const double share =
            f.slides[j] != 0 ? skid_share(norm(friction), laws.card->pskid, laws.card->secondary.area[i]) : 0.0;
        nodes.skid[i] = std::max(nodes.skid[i], share);
    }
}

/// The report of the node in column j.
void report(const Laws& laws, const Search::Batch& batch, int j, const ForceRows& f, double gap, NodeContact& out) {
    out = NodeContact{};
    out.gap = gap;
    if (!batch.id[f.at + j].exists()) return;
    out.decision = decision_of(batch.retained(f.at + j));
    out.distance = f.distance[j];
    out.normal = column(f.normal, j);
    out.point = column(f.point, j);
    out.geometric_penetration = f.p_g[j];
    if (f.in_contact[j] == 0) return;
    out.offset = f.offset[j];
    out.penetration = f.penetration[j];
    out.stiffness = f.acting[j];
    out.damping = f.damping[j];
    out.elastic_force = f.elastic[j];
    out.elastic_energy = f.energy[j];
    out.normal_force = f.normal_force[j];
    out.relative_velocity = column(f.velocity, j);
    out.force = column(f.force, j);
    out.step_stiffness = f.step_stiffness[j];
    if (f.acting[j] != 0) out.status = Status::slip;
    if (!laws.has(effect::friction)) return;
    out.friction = column(f.friction, j);
    out.status = f.slides[j] != 0 ? Status::slip : Status::stick;
}

/// Writes the output of the nodes.
void write_output(const Laws& laws, const NodeData& nodes, const Search::Batch& batch, const ForceRows& f, bool acts,
                  const Output& out) {
    const int start = f.rank;
    if (out.node != nullptr) {
        for (int j = 0; j < f.count; ++j)
            report(laws, batch, j, f, nodes.gap[static_cast<size_t>(start + j)], out.node[start + j]);
        for (int j = 0; j < f.count && laws.skid; ++j)
            out.skid[start + j] = nodes.skid[static_cast<size_t>(start + j)];
    } else {
        f.store_forces(acts, out.force, out.step_stiffness);
    }
}

}  // namespace

void lanes_kernel(const Laws& laws, const Cycle& cycle, NodeData& nodes, int first, int last, const Output& out,
                  ChunkLists& own, Workspace& work) {
    const ForceCycle c(laws, cycle);
    const Forces forces = forces_for(laws.effects());
    Search::Batch& batch = *work.batch;
    ForceRows& f = *work.forces;
    static_assert(Search::Batch::part == TermBlock::capacity);
    batch.depth = laws.card->depth;
    batch.proximity = laws.proximity;
    Prefetcher prefetcher = prefetched_by_search(nodes, cycle.motion);
    add_forces(nodes, cycle.motion, out.force, out.step_stiffness, prefetcher);
    batch.prefetcher = &prefetcher;
    f.lists = &own;
    f.full_report = out.node != nullptr || laws.has(effect::lists);
    batch.count = last - first;
    locate(laws, cycle, c, nodes, first, batch);
    work.tally.add(batch.tally);
    for (int start = first; start < last; start += ForceRows::capacity) {
        const bool acts = prepare(laws, cycle, nodes, start, batch, start - first, f);
        if (acts) {
            forces(c, batch, f, work.terms);
            if (laws.has(effect::lists)) list(laws, nodes, batch, f, own);
            work.sums.add(work.terms, laws.terms());
            work.terms.clear();
        }
        f.store_history(nodes, acts);
        write_output(laws, nodes, batch, f, acts, out);
    }
    batch.prefetcher = nullptr;
}

}  // namespace type21::optimized
