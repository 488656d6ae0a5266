#include "verification/criteria/lockstep/node_scale.h"

#include <algorithm>
#include <cmath>

namespace type21 {

namespace {

/// Heat is a rate times differences of temperatures (or of their fourth powers), and a share of the friction's work,
/// which is the small difference of a trial force and the force that the law admits:
///   |Q| + conductance dt 2 T + Frad A dt 2 T^4 + Fheat |F_t| (scale of force) / k, T the highest temperature.
double heat_scale(const Interface& card, size_t i, const NodeContact& node, const NodeHeat& heat, const Motion& motion,
                  double force, double stiffness) {
    if (card.ithe == 0 || motion.temperature.empty()) return 0;
    double hottest = std::abs(card.tint);
    for (const double t : motion.temperature)
        hottest = std::max(hottest, std::abs(t));
    const double area = card.secondary.area[i];
    double scale = std::abs(heat.heat) + std::abs(heat.friction_heat) + heat.conductance * motion.step * 2 * hottest +
                   card.frad * area * motion.step * 2 * std::pow(hottest, 4);
    if (stiffness > 0) scale += card.fheat * node.friction.norm() * force / stiffness;
    return scale;
}

}  // namespace

NodeScale node_scale(const Interface& card, size_t i, const NodeContact& node, const NodeHeat& heat,
                     const Motion& motion, bool d12) {
    const auto n = static_cast<size_t>(card.secondary.node[i]);
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card.tool)];
    const Vec3 y = pose.rotation.transpose() * (motion.position[n] - pose.position);
    NodeScale scale;
    scale.length = y.cwiseAbs().maxCoeff() + node.gap;
    // The arm is taken to the contact point in global axes, D12 forms all of the geometry there.
    const double global = motion.position[n].norm() + pose.position.norm();
    if (d12) scale.length += global;
    scale.arm = y.norm() + global;
    scale.speed = motion.velocity[n].norm() + pose.velocity.norm() + pose.angular_velocity.norm() * scale.arm;
    scale.stiffness = std::max(node.stiffness, node.step_stiffness);
    scale.force = node.stiffness * scale.length + node.force.norm() + std::abs(node.normal_force) +
                  node.friction.norm() + (node.damping + node.stiffness * motion.friction_step) * scale.speed;
    // D12: the direction is the small difference of two points, divided by its length.
    if (d12 && node.distance != 0)
        scale.force += (node.force.norm() + std::abs(node.normal_force)) * scale.length / std::abs(node.distance);
    scale.heat = heat_scale(card, i, node, heat, motion, scale.force, node.stiffness);
    return scale;
}

}  // namespace type21
