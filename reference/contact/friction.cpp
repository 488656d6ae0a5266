#include "reference/contact/friction.h"

#include <algorithm>
#include <cmath>

#include "reference/contact/friction_law.h"

namespace type21::reference {

Friction::Friction(const Model& model, const Interface& interface)
    : model_(model),
      interface_(interface),
      force_(static_cast<size_t>(interface.secondary.size()), Vec3::Zero()),
      part_(static_cast<size_t>(interface.secondary.size()), -1) {
    // Part of a node, for the pairs of /FRICTION: that of the first segment of the surface that holds it.
    const auto& nodes = interface.secondary.node;
    for (const Segment& segment : model.surfaces[static_cast<size_t>(interface.secondary_surface)].segments) {
        if (segment.shell < 0) continue;
        for (const int node : segment.node) {
            const auto at = std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
            int& part = part_[static_cast<size_t>(at)];
            if (part < 0) part = model.shells[static_cast<size_t>(segment.shell)].part;
        }
    }
}

FrictionForce Friction::act(int i, const FrictionInput& input) {
    const auto n = static_cast<size_t>(i);
    const double mu = coulomb_coefficient(model_, interface_, part_[n], input.part_main);
    const double limit = mu * std::abs(input.normal_force);
    const FrictionForce result =
        friction_force(force_[n], input.stiffness, input.velocity, input.step, input.normal, limit);
    force_[n] = result.force;
    return result;
}

}  // namespace type21::reference
