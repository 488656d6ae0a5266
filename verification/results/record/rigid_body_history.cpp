#include "verification/results/record/rigid_body_history.h"

#include <set>

namespace type21 {

RigidBodyHistory::RigidBodyHistory(const HostScene& scene) : model_(*scene.host) {
    std::set<int> bodies;
    for (const HistoryRequest& request : model_.histories)
        if (request.kind == HistoryRequest::Kind::rigid_body)
            bodies.insert(request.objects.begin(), request.objects.end());
    if (bodies.empty())
        for (const Interface& interface : model_.interfaces)
            bodies.insert(interface.tool);
    bodies.erase(-1);
    bodies_.assign(bodies.begin(), bodies.end());
    impulse_.assign(bodies_.size(), {Vec3::Zero(), Vec3::Zero()});
}

void RigidBodyHistory::add(const CycleRecord& record) {
    const double weight = 0.5 * (record.step + record.next_step);
    for (size_t body = 0; body < bodies_.size(); ++body) {
        for (size_t i = 0; i < model_.interfaces.size(); ++i) {
            if (model_.interfaces[i].tool != bodies_[body]) continue;
            const ToolLoad& load = (*record.contacts)[i].tool;
            impulse_[body][0] += load.force * weight;
            impulse_[body][1] += load.moment * weight;
        }
    }
}

const std::vector<std::string>& RigidBodyHistory::header() {
    static const std::vector<std::string> names{"time", "rbody", "X",   "Y",   "Z",  "DX", "DY", "DZ", "VX", "VY",
                                                "VZ",   "VRX",   "VRY", "VRZ", "FX", "FY", "FZ", "MX", "MY", "MZ"};
    return names;
}

std::vector<double> RigidBodyHistory::values(const CycleRecord& record, size_t body) const {
    const auto index = static_cast<size_t>(bodies_[body]);
    const ToolMotion& tool = record.motion->tools[index];
    const auto main_node = static_cast<size_t>(model_.rigid_bodies[index].main_node);
    std::vector<double> out;
    for (const Vec3& v : {tool.position, (*record.displacement)[main_node], tool.velocity, tool.angular_velocity,
                          impulse_[body][0], impulse_[body][1]})
        out.insert(out.end(), v.data(), v.data() + 3);
    return out;
}

}  // namespace type21
