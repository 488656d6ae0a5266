#include "reference/cycle/inspect.h"

#include "reference/contact/friction_law.h"
#include "reference/cycle/contact_state.h"

namespace type21::reference {

Inspect::Inspect(const Contact& contact) : state_(*contact.state_) {}

const ContactReading& Inspect::reading() const {
    return state_.reading;
}

Vec3 Inspect::tool_frame(int i, const Motion& motion) const {
    return in_tool_frame(motion.position[state_.model_node(i)], state_.pose(motion));
}

std::vector<int> Inspect::candidates(int i, const Vec3& y) const {
    return state_.competitors(y, state_.reach_of(i), state_.reading.impact);
}

SegmentShape<double> Inspect::shape(int segment) const {
    return state_.surface.shape(segment);
}

const std::array<int, 4>& Inspect::segment_nodes(int segment) const {
    return state_.surface.nodes(segment);
}

ContactReach<double> Inspect::reach(int i) const {
    return state_.reach_of(i);
}

ProjectionLimits<double> Inspect::limits() const {
    return state_.reading.impact.limits;
}

bool Inspect::proximity_competes() const {
    return state_.reading.impact.proximity_competes;
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
    return state_.reading.grown_gap(state_.card(), state_.gap_growth->sheet(i, motion.thickness)).raw;
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
    return state_.friction_input(i, motion, node, acts);
}

FrictionCoefficients Inspect::friction_numbers(int i, const FrictionInput& input) const {
    const int part = state_.friction ? state_.friction->part(i) : -1;
    return friction_coefficients(*state_.model, state_.card(), part, input.part_main);
}

double Inspect::friction_coefficient(int i, const FrictionInput& input) const {
    return state_.friction ? state_.friction->state(i, input).coefficient : 0.0;
}

const HeatExchange* Inspect::heat_exchange() const {
    return state_.heat_exchange ? &*state_.heat_exchange : nullptr;
}

double Inspect::tool_temperature(const Decision& decision, const Motion& motion) const {
    return state_.tool_temperature(decision, motion);
}

}  // namespace type21::reference
