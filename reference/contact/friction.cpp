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
      part_(reading.node_parts(model, interface)) {}

FrictionState Friction::state(int i, const FrictionInput& input) const {
    const auto n = static_cast<size_t>(i);
    FrictionCoefficients coefficients = friction_coefficients(model_, interface_, part_[n], input.part_main);
    if (interface_.ifric == 0) coefficients.fric *= input.temperature_factor;
    const double area = interface_.secondary.area[n];
    FrictionState state;
    state.pressure = area > 0 ? input.normal_force / area : 0.0;
    state.speed = (input.velocity - input.normal * input.velocity.dot(input.normal)).norm();
    state.coefficient = reading_.friction_coefficient(interface_.ifric, coefficients, state.pressure, state.speed);
    return state;
}

FrictionForce Friction::act(int i, const FrictionInput& input, double coefficient) {
    const double limit = std::min(coefficient * std::abs(input.normal_force), input.cap);
    const double alpha = reading_.filter_constant(interface_, input.step);
    Vec3& remembered = force_[static_cast<size_t>(i)];
    FrictionForce result =
        friction_force(remembered, alpha * input.stiffness, input.velocity, input.step, input.normal, limit);
    remembered = result.force;
    return result;
}

}  // namespace type21::reference
