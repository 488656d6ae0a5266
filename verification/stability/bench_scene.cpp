#include "verification/stability/bench_scene.h"

#include <memory>
#include <utility>

namespace type21::stability {

BenchScene::BenchScene(const Tool& tool, const std::vector<Vec3>& blank) {
    model_.units = model_.input_units = {1000.0, 0.001, 1.0, "Mg", "mm", "s"};
    model_.deck_path = "bench";
    RigidBody body;
    body.id = 1;
    body.main_node = add_node(900, Vec3::Zero());
    body.mass = 10;
    body.inertia = Mat3::Identity() * 5.0;
    Interface card;
    card.id = 1;
    for (const Vec3& x : tool.node) {
        const int node = add_node(1000 + model_.nodes.size(), x);
        body.nodes.push_back(node);
        card.main_nodes.push_back(node);
    }
    model_.rigid_bodies.push_back(body);
    model_.surfaces.resize(2);  // main, secondary; free nodes need no segment
    for (const auto& s : tool.segment)
        model_.surfaces[0].segments.push_back({{s[0] + 1, s[1] + 1, s[2] + 1, s[3] + 1}, -1});
    card.main_surface = 0;
    card.secondary_surface = 1;
    card.tool = 0;
    card.istf.value = 1;
    card.stfac.value = stiffness;
    card.stmax.value = card.tstop.value = card.pmax.value = card.gapmax.value = card.pskid.value = 1e30;
    card.depth.value = depth;
    card.viss.value = 0;
    SecondarySide& side = card.secondary;
    for (const Vec3& x : blank) {
        side.node.push_back(add_node(100000 + model_.nodes.size(), x));
        side.thickness.push_back(0);
        side.contact_thickness.push_back(0);
        side.gap.push_back(gap);
        side.search_gap.push_back(gap);
        side.area.push_back(1);
        side.element_stiffness.push_back(stiffness);
        side.mass.push_back(node_mass);
    }
    card.largest_gap = card.smallest_gap_raw = gap;
    card.shortest_edge = 1;
    model_.interfaces.push_back(card);
    model_.nodal_mass.assign(static_cast<size_t>(model_.nodes.size()), node_mass);
    hold(tool_node());
}

int BenchScene::add_node(Id id, const Vec3& x) {
    const int index = model_.nodes.size();
    model_.nodes.id.push_back(id);
    model_.nodes.position.push_back(x);
    model_.nodes.line.push_back(0);
    model_.nodes.index[id] = index;
    return index;
}

int BenchScene::group_of(int node) {
    NodeGroup group;
    group.nodes = {node};
    model_.groups.push_back(group);
    return static_cast<int>(model_.groups.size()) - 1;
}

int BenchScene::function(std::vector<double> x, std::vector<double> y) {
    model_.functions.push_back({static_cast<Id>(model_.functions.size()) + 1, "", std::move(x), std::move(y)});
    return static_cast<int>(model_.functions.size()) - 1;
}

void BenchScene::steps(double step, long cycles) {
    model_.engine.first_step = model_.engine.largest_step = step;
    model_.engine.end_time = (static_cast<double>(cycles) - 0.5) * step;
}

void BenchScene::hold(int node) {
    BoundaryCondition bcs;
    bcs.fixed.fill(true);
    bcs.group = group_of(node);
    model_.boundary_conditions.push_back(bcs);
}

void BenchScene::turn_tool(int direction, double rate) {
    ImposedMotion motion;
    motion.function = function({0.0}, {1.0});
    motion.direction = direction;
    motion.group = group_of(tool_node());
    motion.scale_y = rate;
    model_.imposed_motions.push_back(motion);
}

void BenchScene::load(int node, int direction, double force, double ramp) {
    ConcentratedLoad load;
    load.function = ramp > 0 ? function({0.0, ramp, 2.0 * ramp}, {0.0, 1.0, 1.0}) : function({0.0}, {1.0});
    load.direction = direction;
    load.group = group_of(node);
    load.scale_y = force;
    model_.loads.push_back(load);
}

HostScene BenchScene::scene() const {
    return plan(std::make_shared<const Model>(model_));
}

PrescribedNode::PrescribedNode(const HostScene& scene, const MakeContact& make_contact)
    : scene_(scene),
      contact_(make_contact(scene, 0)),
      position_(scene.model->nodes.position),
      velocity_(position_.size(), Vec3::Zero()) {}

NodeContact PrescribedNode::to(const Vec3& x, const Vec3& v, double step) {
    const auto node = static_cast<size_t>(scene_.model->interfaces[0].secondary.node[0]);
    position_[node] = x;
    velocity_[node] = v;
    if (begun_) time_ += step;
    Motion motion;
    motion.time = time_;
    motion.step = motion.friction_step = begun_ ? step : 0.0;
    motion.position = position_;
    motion.velocity = velocity_;
    motion.tools.resize(1);
    begun_ = true;
    return contact_->step(motion).nodes.front();
}

}  // namespace type21::stability
