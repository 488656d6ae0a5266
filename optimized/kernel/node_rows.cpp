// From the arrays of nodes to the rows of their forces, and back.
#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

bool ForceRows::ask(NodeData& nodes, int start, const Search::Batch& batch, int first_in_batch,
                    std::span<const Vec3> speeds, bool damped, bool rubbing) {
    rank = start;
    at = first_in_batch;
    count = std::min(room, batch.count - at);
    const int* const cycles = nodes.cycles.data() + start;
    const int* const place = batch.place + at;
    const Kind* const kind = batch.kind + at;
    long long any = 0;
    for (int j = 0; j < count; ++j) {
        contact[j] = -static_cast<long long>((place[j] >= 0) & (kind[j] == Kind::contact));
        first[j] = -static_cast<long long>(cycles[j] == 0);
        any |= contact[j];
    }
    for (int j = count; j < whole_registers(count); ++j)
        contact[j] = 0;
    if (any == 0) return false;
    // Whole registers are read and written: what is behind the last node is not ours.
    const bool whole = count == whole_registers(count);
    const auto numbers = [&](const std::vector<double>& from, size_t which) {
        const double* const first_one = from.data() + start;
        return whole ? first_one : (std::copy_n(first_one, count, copy[which]), copy[which]);
    };
    gap = numbers(nodes.gap, 0);
    stiffness = numbers(nodes.stiffness, 1);
    numbers(nodes.offset, 2);
    offset = whole ? nodes.offset.data() + start : copy[2];
    if (damped) mass = numbers(nodes.mass, 3);
    into_rows(speeds, nodes.node.data() + start, count, velocity);
    if (!rubbing) return true;
    increment = numbers(nodes.friction_stiffness.empty() ? nodes.stiffness : nodes.friction_stiffness, 4);
    into_rows(nodes.friction.data() + start, count, friction);
    return true;
}

void ForceRows::remember(NodeData& nodes, bool acts) const {
    if (!acts) {
        std::fill_n(nodes.offset.begin() + rank, count, 0.0);
        std::fill_n(nodes.cycles.begin() + rank, count, 0);
        if (!nodes.friction.empty()) std::fill_n(nodes.friction.begin() + rank, count, V3{});
        return;
    }
    if (offset == copy[2]) std::copy_n(offset, count, nodes.offset.data() + rank);
    int* const cycles = nodes.cycles.data() + rank;
    for (int j = 0; j < count; ++j)
        cycles[j] = (cycles[j] + 1) & static_cast<int>(closed[j]);
    if (!nodes.friction.empty()) from_rows(friction, count, nodes.friction.data() + rank);
}

void ForceRows::give(bool acts, Vec3* all_forces, double* all_stiffness) const {
    if (acts) {
        from_rows(force, count, all_forces + rank);
        std::copy_n(step_stiffness, count, all_stiffness + rank);
    } else {
        std::fill_n(all_forces + rank, count, Vec3(Vec3::Zero()));
        std::fill_n(all_stiffness + rank, count, 0.0);
    }
}

Prefetcher asked_by_search(const NodeData& nodes, const Motion& motion) {
    Prefetcher ahead(static_cast<int>(nodes.node.size()));
    ahead.add(motion.position, nodes.node);
    ahead.add(nodes.memory);
    ahead.add(nodes.gap);
    ahead.add(nodes.stiffness);
    return ahead;
}

void add_forces(const NodeData& nodes, const Motion& motion, const Vec3* forces, const double* stiffness,
                Prefetcher& ahead) {
    ahead.add(motion.velocity, nodes.node);
    ahead.add(nodes.cycles);
    ahead.add(nodes.friction);
    ahead.add(nodes.offset);
    ahead.add(nodes.mass);
    if (forces == nullptr) return;
    ahead.add(forces, sizeof(Vec3));
    ahead.add(stiffness, sizeof(double));
}

}  // namespace type21::optimized
