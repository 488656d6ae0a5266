#include "verification/results/balance/balance.h"

#include <cmath>
#include <limits>

namespace type21 {
namespace {

/// The sums of one interface in one cycle; *_terms are the sums of absolute terms that the residuals are measured by.
struct Sums {
    Vec3 force = Vec3::Zero();
    double force_terms = 0;
    Vec3 moment = Vec3::Zero();  ///< on the tool about x_G
    double node_power = 0;
    double power_terms = 0;
    double law_power = 0;  ///< right-hand side
    double damping_power = 0;
    double damping_terms = 0;
    double friction_power = 0;
    double friction_terms = 0;
};

void add(Sums& sums, const NodeContact& node, const Vec3& velocity, const ToolMotion& tool) {
    const Vec3 arm = node.point - tool.position;
    const Vec3 turning = tool.angular_velocity.cross(arm);
    const Vec3 relative = velocity - (tool.velocity + turning);
    const double normal_velocity = relative.dot(node.normal);
    const double damping_power = node.damping * normal_velocity * normal_velocity;
    const double friction_power = node.friction.dot(relative);

    sums.force += node.force;
    sums.force_terms += node.force.norm();
    sums.moment -= arm.cross(node.force);
    sums.node_power += node.force.dot(velocity);
    sums.law_power += node.elastic_force * normal_velocity - damping_power - friction_power;
    sums.damping_power += damping_power;
    sums.friction_power += friction_power;
    // v_rel rounds with the size of the velocities it is the difference of.
    const double speed = velocity.norm() + tool.velocity.norm() + turning.norm();
    const double forces = std::abs(node.elastic_force) + node.damping * speed + node.friction.norm();
    sums.power_terms += forces * speed;
    sums.damping_terms += node.damping * speed * speed;
    sums.friction_terms += node.friction.norm() * speed;
}

/// A residual that is not a number is the worst of all.
void keep_largest(Residual& residual, double difference, double terms, const CycleRecord& record) {
    double relative = difference == 0 ? 0 : std::abs(difference) / terms;
    if (std::isnan(relative)) relative = std::numeric_limits<double>::infinity();
    if (relative > residual.relative) residual = {relative, record.cycle, record.time};
}

}  // namespace

const Residual* find_residual(const InterfaceBalance& balance, std::string_view name) {
    if (name == "force") return &balance.force;
    if (name == "power") return &balance.power;
    if (name == "CE_DAMP") return &balance.damping_energy;
    if (name == "CE_FRIC") return &balance.friction_energy;
    if (name == "heat") return &balance.heat;
    return nullptr;
}

BalanceObserver::BalanceObserver(const HostScene& scene)
    : model_(*scene.host), balance_(model_.interfaces.size()), energies_(model_.interfaces.size()) {}

void BalanceObserver::observe_heat(const CycleRecord& record) {
    const auto& capacity = model_.nodal_heat_capacity;
    if (record.temperature == nullptr || record.temperature->empty() || capacity.empty()) return;
    double stored = 0;
    double given = 0;
    double terms = 0;
    const auto give = [&](int node, double heat) {
        if (!(capacity[static_cast<size_t>(node)] > 0)) return;
        given += heat;
        terms += std::abs(heat);
    };
    for (size_t i = 0; i < balance_.size(); ++i) {
        const ContactStep& step = (*record.contacts)[i];
        for (size_t n = 0; n < step.heat.size(); ++n)
            give(model_.interfaces[i].secondary.node[n], step.heat[n].heat);
        for (const ToolHeat& heat : step.tool_heat)
            give(heat.node, heat.heat);
    }
    for (size_t n = 0; n < capacity.size(); ++n) {
        const double before = record.motion->temperature[n];
        const double after = (*record.temperature)[n];
        if (after == before) continue;
        stored += capacity[n] * (after - before);
        // A temperature difference rounds with the size of the temperatures.
        terms += capacity[n] * (std::abs(after) + std::abs(before));
    }
    for (InterfaceBalance& balance : balance_)
        keep_largest(balance.heat, stored - given, terms, record);
}

void BalanceObserver::observe(const CycleRecord& record) {
    observe_heat(record);
    for (size_t i = 0; i < balance_.size(); ++i) {
        const ContactStep& step = (*record.contacts)[i];
        InterfaceBalance& balance = balance_[i];
        Energies& energies = energies_[i];
        Sums sums;
        if (step.active) {
            const Interface& interface = model_.interfaces[i];
            const ToolMotion& tool = record.motion->tools[static_cast<size_t>(interface.tool)];
            for (size_t n = 0; n < step.nodes.size(); ++n)
                add(sums, step.nodes[n], record.motion->velocity[static_cast<size_t>(interface.secondary.node[n])],
                    tool);
        }
        if (sums.force_terms > 0) ++balance.cycles_in_contact;

        const Vec3 on_tool = step.sums.normal + step.sums.tangential;
        keep_largest(balance.force, (sums.force + on_tool).norm(), sums.force_terms + on_tool.norm(), record);

        if (step.active) {
            const ToolMotion& tool = record.motion->tools[static_cast<size_t>(model_.interfaces[i].tool)];
            const double power =
                sums.node_power - sums.force.dot(tool.velocity) + sums.moment.dot(tool.angular_velocity);
            keep_largest(balance.power, power - sums.law_power, sums.power_terms, record);
        }

        energies.damping += sums.damping_power * record.step;
        energies.damping_terms += sums.damping_terms * record.step;
        energies.friction += sums.friction_power * record.step;
        energies.friction_terms += sums.friction_terms * record.step;
        const InterfaceTotals& totals = (*record.totals)[i];
        keep_largest(balance.damping_energy, totals.damping_energy - energies.damping, energies.damping_terms, record);
        keep_largest(balance.friction_energy, totals.friction_energy + totals.friction_heat - energies.friction,
                     energies.friction_terms, record);
    }
}

}  // namespace type21
