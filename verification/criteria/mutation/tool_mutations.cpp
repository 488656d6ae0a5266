// The tool: its pose, what it gets, its damping; sums and energies (chapters 7 and 11 of the formulation).
#include "verification/criteria/mutation/break_contact.h"

namespace type21 {

namespace {

ToolMotion& tool_of(Motion& motion, const Interface& card) {
    return motion.tools[static_cast<size_t>(card.tool)];
}

/// The first node in contact is left out of the sums that the histories are made of, and of the tool's load.
BreakStep drop_a_node(const Scene& scene, int interface) {
    return [&card = scene.model->interfaces[static_cast<size_t>(interface)], model = scene.model](
               ContactStep& step, const Motion& motion) {
        ContactStep fewer = step;
        for (NodeContact& node : fewer.nodes) {
            if (node.status == Status::open) continue;
            node = {};
            break;
        }
        sum_again(fewer, motion, card);
        step.sums = fewer.sums;
        step.tool = fewer.tool;
    };
}

/// The sums are those of the cycle before.
BreakStep late_sums(const Scene&, int) {
    return [before = ContactSums()](ContactStep& step, const Motion&) mutable { std::swap(step.sums, before); };
}

}  // namespace

std::vector<Mutation> tool_mutations() {
    using enum Effect;
    const auto always = has_effect(elastic);
    const auto changed = [](auto change) { return broken_card([=](ContactModel&, Interface& card) { change(card); }); };
    const auto rotates = has_card([](const Interface& c) { return c.tool_rotates; });
    return {
        {"rotation_ignored",
         "pose of the tool, R",
         "the tool keeps the axes of time 0",
         rotates,
         broken_motion([](Motion& m, const Interface& c) { tool_of(m, c).rotation = Mat3::Identity(); }),
         {}},
        {"tool_velocity_ignored",
         "relative velocity, V_t",
         "the tool counts as standing still",
         always,
         broken_motion([](Motion& m, const Interface& c) { tool_of(m, c).velocity.setZero(); }),
         {}},
        {"turning_ignored",
         "relative velocity, Omega x arm",
         "the tool counts as not turning",
         rotates,
         broken_motion([](Motion& m, const Interface& c) { tool_of(m, c).angular_velocity.setZero(); }),
         {}},
        {"moment_off",
         "moment on the tool",
         "the contact gives no moment",
         rotates,
         broken_sums([](ContactStep& s) { s.tool.moment.setZero(); }),
         {}},
        {"tool_force_off",
         "force on the tool",
         "the contact gives no force",
         always,
         broken_sums([](ContactStep& s) { s.tool.force.setZero(); }),
         {}},
        {"tool_damping_off",
         "Damp",
         "no damping of the tool",
         has_card([](const Interface& c) { return c.damp != 0; }),
         changed([](Interface& c) { c.damp.value = 0; }),
         {}},
        {"turning_damping_off",
         "Dampr",
         "no damping of the tool's rotation",
         has_card([](const Interface& c) { return c.dampr != 0; }),
         changed([](Interface& c) { c.dampr.value = 0; }),
         {}},
        {"idref_ignored",
         "IDref",
         "the tool is damped against rest",
         has_card([](const Interface& c) { return c.reference_interface >= 0; }),
         changed([](Interface& c) { c.reference_interface = -1; }),
         {}},
        {"tool_step_off",
         "time step of the tool",
         "the contact does not limit the tool's step",
         own_step,
         broken_sums([](ContactStep& s) { s.tool.step_stiffness = s.tool.step_rotation = 0; }),
         {}},
        {"node_dropped",
         "sums over the nodes",
         "the first node in contact is left out",
         always,
         broken_step(drop_a_node),
         {}},
        {"sums_late",
         "impulses, weight (dt1 + dt2)/2",
         "the sums are those of the cycle before",
         always,
         broken_step(late_sums),
         {}},
        {"elastic_energy_off",
         "CE_ELAST",
         "the elastic energy is not reported",
         always,
         broken_sums([](ContactStep& s) { s.sums.elastic_energy = 0; }),
         {}},
        {"friction_work_off",
         "CE_FRIC",
         "the friction work is not reported",
         has_effect(friction),
         broken_sums([](ContactStep& s) { s.sums.friction_work = 0; }),
         {}},
        {"damping_work_off",
         "CE_DAMP",
         "the damping work is not reported",
         has_effect(damping),
         broken_sums([](ContactStep& s) { s.sums.damping_work = 0; }),
         {}},
        {"norm_total_off",
         "||F||",
         "the friction is missing in the norm of the force",
         has_effect(friction),
         broken_sums([](ContactStep& s) { s.sums.norm_total = -s.sums.signed_normal; }),
         {}},
        {"abs_normal_off",
         "|FNX|",
         "the absolute value of the sum replaces the sum of absolute values",
         always,
         broken_sums([](ContactStep& s) { s.sums.abs_normal = s.sums.normal.cwiseAbs() * (1 + 1e-6); }),
         {}},
        {"sign_of_norm",
         "||FN||",
         "the sign of ||FN|| is lost",
         always,
         broken_sums([](ContactStep& s) { s.sums.signed_normal = -s.sums.signed_normal; }),
         {}},
    };
}

}  // namespace type21
