#include "reference/cycle/inspect.h"

#include <algorithm>

#include "reference/contact/friction_law.h"
#include "reference/contact/reach_box.h"
#include "reference/cycle/contact_state.h"

namespace type21::reference {

Inspect::Inspect(const Contact& contact) : state_(*contact.state_) {}

Vec3 Inspect::tool_frame(int i, const Motion& motion) const {
    const ToolMotion& pose = motion.tools[static_cast<size_t>(state_.card().tool)];
    const int node = state_.card().secondary.node[static_cast<size_t>(i)];
    return pose.rotation.transpose() * (motion.position[static_cast<size_t>(node)] - pose.position);
}

std::vector<int> Inspect::candidates(int i, const Vec3& y) const {
    std::vector<int> near = state_.candidates.at(y);
    if (!state_.as_built(Departure::D34)) return near;
    const double gap = std::max(state_.nodes[static_cast<size_t>(i)].search_gap, state_.proximity);
    std::erase_if(near, [&](int s) {
        return !in_reach_box(y, state_.surface.shape(s), state_.box_axes, gap, state_.card().depth);
    });
    return near;
}

SegmentShape<double> Inspect::shape(int segment) const {
    return state_.surface.shape(segment);
}

const std::array<int, 4>& Inspect::segment_nodes(int segment) const {
    return state_.surface.nodes(segment);
}

ContactReach<double> Inspect::reach(int i) const {
    return {state_.nodes[static_cast<size_t>(i)].search_gap, state_.card().depth, state_.proximity};
}

ProjectionLimits<double> Inspect::limits() const {
    ProjectionLimits<double> limits;
    limits.lift_leaning = state_.as_built(Departure::D35);
    return limits;
}

bool Inspect::proximity_competes() const {
    return state_.as_built(Departure::D11);
}

double Inspect::stiffness(int i) const {
    return state_.nodes[static_cast<size_t>(i)].stiffness;
}

double Inspect::friction_stiffness(int i) const {
    return state_.nodes[static_cast<size_t>(i)].friction_stiffness;
}

double Inspect::mass(int i) const {
    return state_.nodes[static_cast<size_t>(i)].mass;
}

int Inspect::inacti() const {
    return state_.inacti;
}

bool Inspect::has(Effect effect) const {
    return state_.has(effect);
}

bool Inspect::deleted(int i, const Motion& motion) const {
    return state_.deletion && state_.deletion->deleted(i, motion.thickness);
}

std::optional<double> Inspect::raw_gap(int i, const Motion& motion) const {
    if (!state_.gap_growth) return std::nullopt;
    return state_.gap_growth->gap(i, motion.thickness).raw;
}

const PenetrationHistory& Inspect::history(int i) const {
    return state_.offsets[static_cast<size_t>(i)];
}

Vec3 Inspect::remembered_friction(int i) const {
    return state_.friction ? state_.friction->remembered(i) : Vec3(Vec3::Zero());
}

PmaxLimit Inspect::pmax_limit(int i) const {
    return state_.pmax_limit(i);
}

FrictionInput Inspect::friction_input(int i, const Motion& motion, const NodeContact& node, bool acts) const {
    const Interface& card = state_.card();
    FrictionInput input;
    input.normal_force = node.normal_force;
    input.stiffness = acts ? friction_stiffness(i) : 0.0;
    input.step = motion.friction_step;
    input.part_main = state_.part_of_segment(node.decision.segment);
    input.velocity = node.relative_velocity;
    input.normal = node.normal;
    if (has(Effect::pmax_limit) && card.itlim == 0) input.cap = tangential_limit(pmax_limit(i).pressure_force);
    if (has(Effect::friction_heat_factor)) {
        const bool d08 = state_.as_built(Departure::D08);
        const double blank = motion.temperature[static_cast<size_t>(card.secondary.node[static_cast<size_t>(i)])];
        const double mean = 0.5 * (blank + (d08 ? double(card.tint) : tool_temperature(node.decision, motion)));
        input.temperature_factor =
            state_.model->functions[static_cast<size_t>(card.function_friction)](d08 ? mean : card.ascalef * mean);
    }
    return input;
}

FrictionCoefficients Inspect::friction_numbers(int i, const FrictionInput& input) const {
    const int part = state_.friction ? state_.friction->part(i) : -1;
    return friction_coefficients(*state_.model, state_.card(), part, input.part_main);
}

double Inspect::friction_coefficient(int i, const FrictionInput& input) const {
    return state_.friction ? state_.friction->coefficient(i, input) : 0.0;
}

const HeatExchange* Inspect::heat_exchange() const {
    return state_.heat_exchange ? &*state_.heat_exchange : nullptr;
}

double Inspect::tool_temperature(const Decision& decision, const Motion& motion) const {
    return state_.tool_temperature(decision, motion);
}

}  // namespace type21::reference
