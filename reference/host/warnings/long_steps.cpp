/// @file A tool that moves farther in one cycle than a node is looked for.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

/// The step that the deck sets, whatever the limits say: /DTIX with two equal values, or the first step alone.
double forced_step(const EngineControl& engine) {
    const double first = engine.first_step.value_or(0.0);
    const double largest = engine.largest_step.value_or(0.0);
    return first > 0 && first == largest ? largest : 0;
}

/// Largest speed of an imposed motion during the run: at a point of its function, or along one of its pieces.
double largest_speed(const ImposedMotion& motion, const Function& function, double end_time) {
    const double last = std::min(end_time, motion.stop);
    const bool velocity = motion.kind == ImposedMotion::Kind::velocity;
    std::vector<double> times{std::max(0.0, motion.start), last};
    for (const double x : function.x) {
        const double time = x * motion.scale_x;
        if (time > times[0] && time < last) times.push_back(time);
    }
    std::sort(times.begin(), times.end());
    double speed = 0;
    for (size_t i = 0; i < times.size(); ++i) {
        const double value = function(times[i] / motion.scale_x);
        if (velocity) {
            speed = std::max(speed, std::abs(motion.scale_y * value));
        } else if (i > 0 && times[i] > times[i - 1]) {
            const double before = function(times[i - 1] / motion.scale_x);
            speed = std::max(speed, std::abs(motion.scale_y * (value - before) / (times[i] - times[i - 1])));
        }
    }
    return speed;
}

/// Speed of the fastest point of a tool, by its drives [length/time].
double tool_speed(const Model& model, const Interface& interface) {
    const RigidBody& tool = model.rigid_bodies[at(interface.tool)];
    Vec3 along = Vec3::Zero();
    Vec3 about = Vec3::Zero();
    for (const ImposedMotion& motion : model.imposed_motions) {
        if (motion.group < 0 || motion.function < 0) continue;
        if (motion.kind == ImposedMotion::Kind::acceleration) continue;  // its speed is known in the run only
        const auto& nodes = model.groups[at(motion.group)].nodes;
        if (!std::binary_search(nodes.begin(), nodes.end(), tool.main_node)) continue;
        const double speed = largest_speed(motion, model.functions[at(motion.function)], model.engine.end_time);
        double& component = motion.direction < 3 ? along[motion.direction] : about[motion.direction - 3];
        component = std::max(component, speed);
    }
    double arm = 0;
    for (const int node : interface.main_nodes)
        arm = std::max(arm, (model.nodes.position[at(node)] - tool.center).norm());
    return along.norm() + about.norm() * arm;
}

}  // namespace

void warn_of_long_steps(const SurpriseCheck& check) {
    const double step = forced_step(check.model.engine);
    if (!(step > 0)) return;
    for (const Interface& interface : check.model.interfaces) {
        const double way = tool_speed(check.model, interface) * step;
        const double reach = interface.largest_gap + interface.depth;
        if (!(way > reach)) continue;
        check.at_interface(interface, "DEPTH", check.quantity(interface.depth, dim::length),
                           fmt::format("the tool moves up to {} in one step of /DTIX, {}, and a node is found within "
                                       "gap + DEPTH = {} only: it can pass through the tool unseen",
                                       check.quantity(way, dim::length), check.quantity(step, dim::time),
                                       check.quantity(reach, dim::length)),
                           "Give a smaller step or a slower tool");
    }
}

}  // namespace type21
