#include "verification/results/paraview/contact_grid.h"

#include <algorithm>
#include <cmath>

namespace type21 {
namespace {

using Numbers = std::vector<double>;
using Whole = std::vector<std::int64_t>;

/// Appends v to an array of three components.
void add_to(Numbers& values, const Vec3& v) {
    values.insert(values.end(), v.data(), v.data() + 3);
}

Vec3 tangential(const Vec3& v, const Vec3& normal) {
    return v - v.dot(normal) * normal;
}

/// The arrays that blank and tool share, in the order of the file.
struct ContactArrays {
    Whole segment, status;
    Numbers gap, penetration, normal, force, pressure, friction, slip;

    std::vector<VtuArray> named(const UnitSystem& units) {
        const std::string length = units.name(dim::length), force_unit = units.name(dim::force);
        return {{"SEGMENT_ID", "", 1, std::move(segment)},
                {"status", "", 1, std::move(status)},
                {"gap", length, 1, std::move(gap)},
                {"penetration", length, 1, std::move(penetration)},
                {"normal", "", 3, std::move(normal)},
                {"contact_force", force_unit, 3, std::move(force)},
                {"contact_pressure", units.name(dim::pressure), 1, std::move(pressure)},
                {"tangential_force", force_unit, 3, std::move(friction)},
                {"slip", length, 1, std::move(slip)}};
    }
};

/// What the nodes on one main segment do to it.
struct SegmentLoad {
    std::int64_t nodes = 0;
    Status status = Status::open;
    double gap = 0, penetration = -1, normal_force = 0, slip = 0;
    Vec3 normal = Vec3::Zero(), force = Vec3::Zero(), friction = Vec3::Zero();

    void add(const NodeContact& node, double slip_of_node) {
        ++nodes;
        status = std::max(status, node.status);
        slip = std::max(slip, slip_of_node);
        normal_force += node.normal_force;
        force -= node.force;
        friction += node.friction;
        if (node.penetration <= penetration) return;
        penetration = node.penetration;
        gap = node.gap;
        normal = node.normal;
    }
};

double area(const Segment& segment, std::span<const Vec3> position) {
    const auto x = [&](int corner) { return position[static_cast<size_t>(segment.node[static_cast<size_t>(corner)])]; };
    return 0.5 * (x(2) - x(0)).cross(segment.is_triangle() ? x(1) - x(0) : x(3) - x(1)).norm();
}

}  // namespace

ContactGrid::ContactGrid(const HostScene& scene, int interface) : model_(*scene.host), interface_(interface) {
    slip_.resize(this->interface().secondary.node.size(), 0.0);
}

void ContactGrid::add(const CycleRecord& record) {
    const std::vector<NodeContact>& nodes = (*record.contacts)[static_cast<size_t>(interface_)].nodes;
    for (size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].status == Status::slip)
            slip_[i] += tangential(nodes[i].relative_velocity, nodes[i].normal).norm() * record.step;
}

VtuGrid ContactGrid::grid_of(const CycleRecord& record, const std::vector<int>& nodes, int surface) const {
    VtuGrid grid;
    grid.time = record.time;
    grid.time_unit = model_.units.name(dim::time);
    grid.length_unit = model_.units.name(dim::length);
    Whole ids, shells;
    for (const int node : nodes) {
        grid.points.push_back(record.motion->position[static_cast<size_t>(node)]);
        ids.push_back(model_.nodes.id[static_cast<size_t>(node)]);
    }
    for (const Segment& segment : model_.surfaces[static_cast<size_t>(surface)].segments) {
        VtuCell cell{};
        for (size_t corner = 0; corner < 4; ++corner)
            cell[corner] = std::lower_bound(nodes.begin(), nodes.end(), segment.node[corner]) - nodes.begin();
        grid.cells.push_back(cell);
        shells.push_back(segment.shell < 0 ? 0 : model_.shells[static_cast<size_t>(segment.shell)].id);
    }
    grid.point_arrays.push_back({"NODE_ID", "", 1, std::move(ids)});
    grid.cell_arrays.push_back({"ELEMENT_ID", "", 1, std::move(shells)});
    return grid;
}

VtuGrid ContactGrid::blank(const CycleRecord& record) const {
    const SecondarySide& side = interface().secondary;
    VtuGrid grid = grid_of(record, side.node, interface().secondary_surface);
    Whole numbers(grid.cells.size());
    for (size_t i = 0; i < numbers.size(); ++i)
        numbers[i] = static_cast<std::int64_t>(i) + 1;
    grid.cell_arrays.push_back({"SEGMENT_ID", "", 1, std::move(numbers)});
    const std::vector<NodeContact>& contacts = (*record.contacts)[static_cast<size_t>(interface_)].nodes;
    ContactArrays arrays;
    for (size_t i = 0; i < side.node.size(); ++i) {
        const NodeContact node =
            i < contacts.size() && contacts[i].decision.kind == Kind::contact ? contacts[i] : NodeContact{};
        arrays.segment.push_back(node.decision.segment + 1);
        arrays.status.push_back(static_cast<int>(node.status));
        arrays.gap.push_back(i < contacts.size() ? contacts[i].gap : side.gap[i]);
        arrays.penetration.push_back(node.penetration);
        add_to(arrays.normal, node.normal);
        add_to(arrays.force, node.force);
        arrays.pressure.push_back(side.area[i] > 0 ? node.normal_force / side.area[i] : 0);
        add_to(arrays.friction, 0.0 - node.friction.array());
        arrays.slip.push_back(slip_[i]);
    }
    for (VtuArray& array : arrays.named(model_.units))
        grid.point_arrays.push_back(std::move(array));
    return grid;
}

VtuGrid ContactGrid::tool(const CycleRecord& record) const {
    VtuGrid grid = grid_of(record, interface().main_nodes, interface().main_surface);
    const std::vector<Segment>& segments = model_.surfaces[static_cast<size_t>(interface().main_surface)].segments;
    std::vector<SegmentLoad> loads(segments.size());
    const std::vector<NodeContact>& contacts = (*record.contacts)[static_cast<size_t>(interface_)].nodes;
    for (size_t i = 0; i < contacts.size(); ++i)
        if (contacts[i].decision.kind == Kind::contact)
            loads[static_cast<size_t>(contacts[i].decision.segment)].add(contacts[i], slip_[i]);
    ContactArrays arrays;
    Whole nodes;
    for (size_t s = 0; s < segments.size(); ++s) {
        const SegmentLoad& load = loads[s];
        const double size = area(segments[s], record.motion->position);
        nodes.push_back(load.nodes);
        arrays.segment.push_back(static_cast<std::int64_t>(s) + 1);
        arrays.status.push_back(static_cast<int>(load.status));
        arrays.gap.push_back(load.gap);
        arrays.penetration.push_back(std::max(load.penetration, 0.0));
        add_to(arrays.normal, load.normal);
        add_to(arrays.force, load.force);
        arrays.pressure.push_back(size > 0 ? load.normal_force / size : 0);
        add_to(arrays.friction, load.friction);
        arrays.slip.push_back(load.slip);
    }
    grid.cell_arrays.push_back({"nodes_in_contact", "", 1, std::move(nodes)});
    for (VtuArray& array : arrays.named(model_.units))
        grid.cell_arrays.push_back(std::move(array));
    return grid;
}

}  // namespace type21
