// A chunk of nodes in rows: where they are, what they touch, their forces, the sums. For t > 0 and the effects that
// most scenes have; kernel_for tells which.
#include <cstring>

#include "optimized/kernel/contact_point.h"
#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

namespace {

Vec3 column(const double (*rows)[ForceRows::room], int j) {
    return {rows[0][j], rows[1][j], rows[2][j]};
}

/// Sections 1, 3, 4.
void locate(const Laws& laws, const Cycle& cycle, const ForceCycle& c, NodeData& nodes, int first,
            Search::Batch& batch) {
    const auto position = cycle.motion.position;
    for (int j = 0; j < batch.count; ++j) {
        const auto i = static_cast<size_t>(first + j);
        fetch(position[static_cast<size_t>(nodes.node[i])], batch.y, j);
        // A node without stiffness is not asked.
        batch.memory[j] = nodes.stiffness[i] != 0 ? &nodes.memory[i] : nullptr;
    }
    fetch(nodes.search_gap.empty() ? nodes.gap : nodes.search_gap, first, batch.count, batch.gap);
    to_tool_frame(batch, batch.count, c);
    laws.search->find(batch, laws.rules);
}

/// What the forces ask for. @return false where no node is in contact
/// @param first  node   @param at  its column in the batch
bool prepare(const Laws& laws, const Cycle& cycle, const NodeData& nodes, int first, const Search::Batch& batch, int at,
             int count, ForceRows& f) {
    long long any = 0;
    for (int j = 0; j < count; ++j) {
        const long long contact =
            -static_cast<long long>(batch.place[at + j] >= 0 && batch.kind[at + j] == Kind::contact);
        f.contact[j] = contact;
        f.first[j] = -static_cast<long long>(nodes.cycles[static_cast<size_t>(first + j)] == 0);
        any |= contact;
    }
    for (int j = count; j < whole_registers(count); ++j)
        f.contact[j] = 0;
    if (any == 0) return false;
    const auto velocity = cycle.motion.velocity;
    for (int j = 0; j < count; ++j)
        fetch(velocity[static_cast<size_t>(nodes.node[static_cast<size_t>(first + j)])], f.velocity, j);
    fetch(nodes.gap, first, count, f.gap);
    fetch(nodes.stiffness, first, count, f.stiffness);
    fetch(nodes.offset, first, count, f.offset);
    if (laws.has(effect::damping)) fetch(nodes.mass, first, count, f.mass);
    f.rank = first;
    if (laws.has(effect::friction)) {
        for (int j = 0; j < count; ++j)
            fetch(nodes.friction[static_cast<size_t>(first + j)], f.friction, j);
        fetch(nodes.friction_stiffness.empty() ? nodes.stiffness : nodes.friction_stiffness, first, count, f.increment);
    }
    if (laws.has(effect::pmax)) {
        const SecondarySide& side = laws.card->secondary;
        for (int j = 0; j < count; ++j) {
            const auto i = static_cast<size_t>(first + j);
            f.growth[j] = std::max(nodes.gap[i] - side.gap[i], 0.0);
            f.most[j] = side.area[i] * laws.card->pmax;
        }
    }
    return true;
}

/// History that is left when no node of a batch is in contact.
void forget(NodeData& nodes, int first, int count) {
    std::fill_n(nodes.offset.begin() + first, count, 0.0);
    std::fill_n(nodes.cycles.begin() + first, count, 0);
    if (!nodes.friction.empty()) std::fill_n(nodes.friction.begin() + first, count, V3{});
}

void remember(const ForceRows& f, int first, int count, NodeData& nodes) {
    std::memcpy(nodes.offset.data() + first, f.offset, static_cast<size_t>(count) * sizeof(double));
    int* cycles = nodes.cycles.data() + first;
    for (int j = 0; j < count; ++j)
        cycles[j] = (cycles[j] + 1) & static_cast<int>(f.closed[j]);
    if (nodes.friction.empty()) return;
    for (int j = 0; j < count; ++j)
        nodes.friction[static_cast<size_t>(first + j)] = {f.friction[0][j], f.friction[1][j], f.friction[2][j]};
}

/// Nodes that have to be named, in their order; before remember(), which counts the cycles on.
void list(const Laws& laws, NodeData& nodes, const Search::Batch& batch, int at, int first, int count,
          const ForceRows& f, ChunkLists& lists) {
    for (int j = 0; j < count; ++j) {
        const auto i = static_cast<size_t>(first + j);
        if (f.closed[j] == 0) continue;
        if (laws.normals_test && f.first[j] != 0 && f.deep[j] > f.gap[j] + 0.99 * laws.card->depth)
            lists.inverted.push_back({nodes.node[i], segment_of(batch.place[at + j]), f.deep[j]});
        if (laws.release && f.penetration[j] > 0 && nodes.released[i] == 0) {
            nodes.released[i] = 1;
            lists.released.push_back(nodes.node[i]);
        }
        if (!laws.skid || !laws.has(effect::friction)) continue;
        const V3 rub{f.friction[0][j], f.friction[1][j], f.friction[2][j]};
        const double share =
            f.slides[j] != 0 ? skid_share(norm(rub), laws.card->pskid, laws.card->secondary.area[i]) : 0.0;
        nodes.skid[i] = std::max(nodes.skid[i], share);
    }
}

/// One node for the whole step, in column i of the batch and j of the forces.
void report(const Laws& laws, const Search::Batch& batch, int i, const ForceRows& f, int j, double gap,
            NodeContact& out) {
    out = NodeContact{};
    out.gap = gap;
    if (batch.memory[i] == nullptr || batch.place[i] < 0) return;
    out.decision = decision_of(batch.retained(i));
    out.distance = f.distance[j];
    out.normal = column(f.normal, j);
    out.point = column(f.point, j);
    out.geometric_penetration = f.deep[j];
    if (f.closed[j] == 0) return;
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

}  // namespace

void lanes_kernel(const Laws& laws, const Cycle& cycle, NodeData& nodes, int first, int last, const Output& out,
                  ChunkLists& own, Workspace& work) {
    const ForceCycle c(laws, cycle);
    const Forces forces = forces_for(laws.effects());
    static_assert(Search::Batch::room == TermBlock::room);
    Search::Batch& batch = *work.batch;
    ForceRows& f = *work.forces;
    batch.depth = laws.card->depth;
    batch.proximity = laws.proximity;
    batch.count = last - first;
    locate(laws, cycle, c, nodes, first, batch);
    work.tally.add(batch.tally);
    int columns = 0;
    for (int start = first; start < last; start += ForceRows::room) {
        const int count = std::min(ForceRows::room, last - start), at = start - first;
        const bool acts = prepare(laws, cycle, nodes, start, batch, at, count, f);
        if (acts) {
            forces(c, batch, at, f, count, work.terms, columns);
            if (laws.has(effect::lists)) list(laws, nodes, batch, at, start, count, f, own);
            columns += whole_registers(count);
            remember(f, start, count, nodes);
        } else {
            forget(nodes, start, count);
        }
        if (out.node != nullptr) {
            for (int j = 0; j < count; ++j)
                report(laws, batch, at + j, f, j, nodes.gap[static_cast<size_t>(start + j)], out.node[start + j]);
            for (int j = 0; j < count && laws.skid; ++j)
                out.node[start + j].skid = nodes.skid[static_cast<size_t>(start + j)];
        } else if (acts) {
            for (int j = 0; j < count; ++j)
                out.force[start + j] = column(f.force, j);
            std::memcpy(out.step_stiffness + start, f.step_stiffness, static_cast<size_t>(count) * sizeof(double));
        } else {
            std::fill_n(out.force + start, count, Vec3(Vec3::Zero()));
            std::fill_n(out.step_stiffness + start, count, 0.0);
        }
    }
    work.terms.resize(columns);
    work.sums.add(work.terms, laws.terms());
    work.terms.clear();
}

}  // namespace type21::optimized
