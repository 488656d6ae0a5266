#include "reference/contact/friction.h"

#include <algorithm>
#include <cmath>

#include "reference/contact/friction_law.h"

namespace type21::reference {

Friction::Friction(const ContactModel& model, const Interface& interface, const ContactReading& reading)
    : model_(model),
      interface_(interface),
      reading_(reading),
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

double Friction::coefficient(int i, const FrictionInput& input) const {
    const auto n = static_cast<size_t>(i);
    FrictionCoefficients coefficients = friction_coefficients(model_, interface_, part_[n], input.part_main);
    if (interface_.ifric == 0) coefficients.fric *= input.temperature_factor;
    const double area = interface_.secondary.area[n];
    const double pressure = area > 0 ? input.normal_force / area : 0.0;
    const Vec3 tangential = input.velocity - input.normal * input.velocity.dot(input.normal);
    return reading_.friction_coefficient(interface_.ifric, coefficients, pressure, tangential.norm());
}

FrictionForce Friction::act(int i, const FrictionInput& input) {
    const double limit = std::min(coefficient(i, input) * std::abs(input.normal_force), input.cap);
    const double alpha = reading_.filter_constant(interface_, input.step);
    Vec3& remembered = force_[static_cast<size_t>(i)];
    FrictionForce result =
        friction_force(remembered, alpha * input.stiffness, input.velocity, input.step, input.normal, limit);
    remembered = result.force;
    return result;
}

}  // namespace type21::reference
