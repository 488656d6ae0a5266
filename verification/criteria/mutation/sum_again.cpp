#include "verification/criteria/mutation/break_contact.h"

namespace type21 {

void sum_again(ContactStep& step, const Motion& motion, const Interface& card) {
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card.tool)];
    ContactSums sums;
    sums.friction_heat = step.sums.friction_heat;
    sums.heat_to_blank = step.sums.heat_to_blank;
    sums.heat_to_tool = step.sums.heat_to_tool;
    ToolLoad tool = step.tool;
    tool.force = tool.moment = Vec3::Zero();
    tool.step_stiffness = tool.step_rotation = 0;
    for (const NodeContact& node : step.nodes) {
        sums.elastic_energy += node.elastic_energy;
        if (node.status == Status::open) continue;
        const Vec3 on_tool = -node.normal_force * node.normal;
        const Vec3 total = on_tool + node.friction;
        const double speed = node.relative_velocity.dot(node.normal);
        sums.normal += on_tool;
        sums.tangential += node.friction;
        sums.abs_normal += on_tool.cwiseAbs();
        sums.signed_normal -= node.normal_force;
        sums.abs_total += total.cwiseAbs();
        sums.norm_total += total.norm();
        sums.friction_work += motion.step * node.relative_velocity.dot(node.friction);
        sums.damping_work += node.damping * speed * speed * motion.step;
        const Vec3 arm = node.point - pose.position;
        tool.force -= node.force;
        tool.moment -= arm.cross(node.force);
        tool.step_stiffness += node.step_stiffness;
        tool.step_rotation += node.step_stiffness * arm.squaredNorm();
    }
    step.sums = sums;
    step.tool = tool;
}

}  // namespace type21
