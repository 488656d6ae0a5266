// From the arrays of nodes to the rows of their forces, and back.
#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

bool ForceRows::prepare(NodeData& nodes, int start, const Search::Batch& batch, int first_in_batch,
                        std::span<const Vec3> speeds, bool with_damping, bool with_friction) {
    rank = start;
    at = first_in_batch;
    count = std::min(capacity, batch.count - at);
    const int* const cycles = nodes.cycles.data() + start;
    const SubTriangleId* const id = batch.id + at;
    const Kind* const kind = batch.kind + at;
    long long any = 0;
    for (int j = 0; j < count; ++j) {
        contact[j] = -static_cast<long long>(id[j].exists() & (kind[j] == Kind::contact));
        first[j] = -static_cast<long long>(cycles[j] == 0);
        any |= contact[j];
    }
    for (int j = count; j < full_registers(count); ++j)
        contact[j] = 0;
    if (any == 0) return false;
    // Full registers are read and written, but memory behind the last node belongs to others.
    const bool full = count == full_registers(count);
    const auto numbers = [&](const std::vector<double>& from, size_t which) {
        const double* const first_one = from.data() + start;
        return full ? first_one : (std::copy_n(first_one, count, copy[which]), copy[which]);
    };
    gap = numbers(nodes.gap, 0);
    stiffness = numbers(nodes.stiffness, 1);
    numbers(nodes.offset, 2);
    offset = full ? nodes.offset.data() + start : copy[2];
    if (with_damping) mass = numbers(nodes.mass, 3);
    into_rows(speeds, nodes.node.data() + start, count, velocity);
    if (!with_friction) return true;
    increment = numbers(nodes.friction_stiffness.empty() ? nodes.stiffness : nodes.friction_stiffness, 4);
    into_rows(nodes.friction.data() + start, count, friction);
    return true;
}

void ForceRows::store_history(NodeData& nodes, bool acts) const {
    if (!acts) {
        std::fill_n(nodes.offset.begin() + rank, count, 0.0);
        std::fill_n(nodes.cycles.begin() + rank, count, 0);
        if (!nodes.friction.empty()) std::fill_n(nodes.friction.begin() + rank, count, V3{});
        return;
    }
    if (offset == copy[2]) std::copy_n(offset, count, nodes.offset.data() + rank);
    int* const cycles = nodes.cycles.data() + rank;
    for (int j = 0; j < count; ++j)
        cycles[j] = (cycles[j] + 1) & static_cast<int>(in_contact[j]);
    if (!nodes.friction.empty()) from_rows(friction, count, nodes.friction.data() + rank);
}

void ForceRows::store_forces(bool acts, Vec3* all_forces, double* all_stiffness) const {
    if (acts) {
        from_rows(force, count, all_forces + rank);
        std::copy_n(step_stiffness, count, all_stiffness + rank);
    } else {
        std::fill_n(all_forces + rank, count, Vec3(Vec3::Zero()));
        std::fill_n(all_stiffness + rank, count, 0.0);
    }
}

Prefetcher prefetched_by_search(const NodeData& nodes, const Motion& motion) {
    Prefetcher prefetcher(static_cast<int>(nodes.node.size()));
    prefetcher.add(motion.position, nodes.node);
    prefetcher.add(nodes.memory);
    prefetcher.add(nodes.gap);
    prefetcher.add(nodes.stiffness);
    return prefetcher;
}

void add_forces(const NodeData& nodes, const Motion& motion, const Vec3* forces, const double* stiffness,
                Prefetcher& prefetcher) {
    prefetcher.add(motion.velocity, nodes.node);
    prefetcher.add(nodes.cycles);
    prefetcher.add(nodes.friction);
    prefetcher.add(nodes.offset);
    prefetcher.add(nodes.mass);
    if (forces == nullptr) return;
    prefetcher.add(forces, sizeof(Vec3));
    prefetcher.add(stiffness, sizeof(double));
}

}  // namespace type21::optimized
