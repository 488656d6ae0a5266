#include "reference/host/finite_check.h"

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "reference/host/when.h"

namespace type21 {

namespace {

/// NaN is not, too.
bool is_fit(double value) {
    return std::abs(value) < largest_number;
}

bool is_fit(const Vec3& v) {
    return is_fit(v.x()) && is_fit(v.y()) && is_fit(v.z());
}

std::string text(double value) {
    return fmt::format("{:.6g}", value);
}

std::string text(const Vec3& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x(), v.y(), v.z());
}

/// Stops a run with the first quantity that is not finite.
class Judge {
  public:
    Judge(const Model& model, const HostState& state) : model_(model), state_(state) {}

    template <class Value>
    void node(int node, std::string_view quantity, const Value& value, Dimension dimension) const {
        if (is_fit(value)) return;
        stop(fmt::format("the {} of node {}", quantity, model_.nodes.id[static_cast<size_t>(node)]), text(value),
             dimension);
    }

    template <class Value>
    void of(const std::string& whose, std::string_view quantity, const Value& value, Dimension dimension) const {
        if (!is_fit(value)) stop(fmt::format("the {} of {}", quantity, whose), text(value), dimension);
    }

  private:
    [[noreturn]] void stop(const std::string& what, const std::string& value, Dimension dimension) const {
        throw RunStopped(RunStopped::Why::diverged,
                         fmt::format("{} is {} {}, {}: not a finite number below {:g}", what, value,
                                     model_.units.name(dimension), when(state_, model_.units), largest_number));
    }

    const Model& model_;
    const HostState& state_;
};

constexpr Dimension impulse{1, 1, -1, 0};
constexpr Dimension moment_impulse{1, 2, -1, 0};
constexpr Dimension rotational_stiffness = dim::moment;
constexpr Dimension power_per_temperature{1, 2, -3, -1};

void check_nodes(const Judge& judge, const Interface& interface, const ContactStep& step) {
    for (size_t n = 0; n < step.nodes.size(); ++n) {
        const NodeContact& node = step.nodes[n];
        const int index = interface.secondary.node[n];
        judge.node(index, "contact force", node.force, dim::force);
        judge.node(index, "elastic energy", node.elastic_energy, dim::energy);
        judge.node(index, "contact stiffness", node.step_stiffness, dim::stiffness);
        judge.node(index, "gap", node.gap, dim::length);
        judge.node(index, "distance to the tool", node.distance, dim::length);
    }
    for (size_t n = 0; n < step.skid.size(); ++n)
        judge.node(interface.secondary.node[n], "skid ratio", step.skid[n], dim::none);
    for (size_t n = 0; n < step.heat.size(); ++n) {
        const int index = interface.secondary.node[n];
        judge.node(index, "heat", step.heat[n].heat, dim::energy);
        judge.node(index, "conductance", step.heat[n].conductance + step.heat[n].radiant_conductance,
                   power_per_temperature);
    }
}

/// Each node may be finite and their sum not.
void check_sums(const Judge& judge, const Interface& interface, const ContactStep& step) {
    const std::string whose = fmt::format("interface {}", interface.id);
    const ContactSums& sums = step.sums;
    judge.of(whose, "normal force", sums.normal, dim::force);
    judge.of(whose, "friction force", sums.tangential, dim::force);
    judge.of(whose, "sum of the absolute normal forces", sums.abs_normal, dim::force);
    judge.of(whose, "sum of the absolute forces", sums.abs_total, dim::force);
    judge.of(whose, "sum of the norms of the forces", sums.norm_total, dim::force);
    judge.of(whose, "sum of the normal forces", sums.signed_normal, dim::force);
    judge.of(whose, "elastic energy", sums.elastic_energy, dim::energy);
    judge.of(whose, "friction work", sums.friction_work, dim::energy);
    judge.of(whose, "damping work", sums.damping_work, dim::energy);
    judge.of(whose, "heat to the blank", sums.heat_to_blank, dim::energy);
    judge.of(whose, "heat to the tool", sums.heat_to_tool, dim::energy);
    judge.of(whose, "force on the tool", step.tool.force, dim::force);
    judge.of(whose, "moment on the tool", step.tool.moment, dim::moment);
    judge.of(whose, "damping force of the tool", step.tool.damping_force, dim::force);
    judge.of(whose, "damping moment of the tool", step.tool.damping_moment, dim::moment);
    judge.of(whose, "stiffness on the tool", step.tool.step_stiffness, dim::stiffness);
    judge.of(whose, "rotational stiffness on the tool", step.tool.step_rotation, rotational_stiffness);
}

}  // namespace

void check_finite(const Model& model, const HostState& state, const std::vector<ContactStep>& steps) {
    const Judge judge(model, state);
    for (size_t i = 0; i < steps.size(); ++i) {
        check_nodes(judge, model.interfaces[i], steps[i]);
        check_sums(judge, model.interfaces[i], steps[i]);
        for (const ToolHeat& heat : steps[i].tool_heat)
            judge.node(heat.node, "heat", heat.heat, dim::energy);
    }
    for (size_t n = 0; n < state.position.size(); ++n) {
        const auto node = static_cast<int>(n);
        judge.node(node, "position", state.position[n], dim::length);
        judge.node(node, "velocity", state.velocity[n], dim::velocity);
        judge.node(node, "angular velocity", state.angular_velocity[n], dim::frequency);
        if (!state.temperature.empty()) judge.node(node, "temperature", state.temperature[n], dim::temperature);
    }
    for (size_t b = 0; b < state.bodies.size(); ++b) {
        const std::string whose = fmt::format("the rigid body {}", model.rigid_bodies[b].id);
        judge.of(whose, "rotation", Vec3(state.bodies[b].rotation.vec()), dim::none);
        judge.of(whose, "angle", state.bodies[b].imposed_angle, dim::none);
    }
}

void check_finite(const Model& model, const HostState& state, const HostState& next,
                  const std::vector<InterfaceTotals>& totals) {
    const Judge judge(model, state);
    for (size_t n = 0; n < next.position.size(); ++n) {
        const auto node = static_cast<int>(n);
        judge.node(node, "acceleration", next.acceleration[n], dim::acceleration);
        judge.node(node, "reaction", next.reaction[n], impulse);
        judge.node(node, "reaction moment", next.reaction_moment[n], moment_impulse);
        if (!next.temperature.empty()) judge.node(node, "temperature", next.temperature[n], dim::temperature);
    }
    for (size_t i = 0; i < totals.size(); ++i) {
        const std::string whose = fmt::format("interface {}", model.interfaces[i].id);
        const InterfaceTotals& sum = totals[i];
        judge.of(whose, "normal impulse", sum.normal, impulse);
        judge.of(whose, "friction impulse", sum.tangential, impulse);
        judge.of(whose, "sum of the absolute normal impulses", sum.abs_normal, impulse);
        judge.of(whose, "sum of the absolute impulses", sum.abs_total, impulse);
        judge.of(whose, "sum of the norms of the impulses", sum.norm_total, impulse);
        judge.of(whose, "sum of the normal impulses", sum.signed_normal, impulse);
        judge.of(whose, "friction energy", sum.friction_energy, dim::energy);
        judge.of(whose, "friction heat", sum.friction_heat, dim::energy);
        judge.of(whose, "damping energy", sum.damping_energy, dim::energy);
        judge.of(whose, "heat to the blank", sum.heat_to_blank, dim::energy);
        judge.of(whose, "heat to the tool", sum.heat_to_tool, dim::energy);
    }
}

namespace {

/// The first of many that is not fit, with how many there are.
class Unfit {
  public:
    void add(Id id, double value) {
        if (is_fit(value)) return;
        if (count_++ > 0) return;
        id_ = id;
        value_ = value;
    }
    void report(const Model& model, std::string_view card, std::string_view quantity, Dimension dimension,
                std::string_view remedy, Problems& problems) const {
        if (count_ == 0) return;
        Problem problem;
        problem.place.file = model.deck_path;
        problem.card = std::string(card);
        problem.value = fmt::format("{:.6g} {} at node {}{}", value_, model.units.name(dimension), id_,
                                    count_ > 1 ? fmt::format(" ({} nodes in all)", count_) : "");
        problem.rule = fmt::format("the {} of a node is a finite number below {:g}", quantity, largest_number);
        problem.remedy = std::string(remedy);
        problems.add(std::move(problem));
    }

  private:
    int count_ = 0;
    Id id_ = 0;
    double value_ = 0;
};

}  // namespace

void check_finite(const Model& model, Problems& problems) {
    Unfit mass;
    Unfit capacity;
    Unfit place;
    for (size_t n = 0; n < model.nodal_mass.size(); ++n) {
        mass.add(model.nodes.id[n], model.nodal_mass[n]);
        if (!model.nodal_heat_capacity.empty()) capacity.add(model.nodes.id[n], model.nodal_heat_capacity[n]);
        place.add(model.nodes.id[n], model.nodes.position[n].cwiseAbs().maxCoeff());
    }
    mass.report(model, "/MAT, /PROP, /ADMAS", "mass", dim::mass, "correct density, thickness or added mass", problems);
    capacity.report(model, "/HEAT/MAT, /PROP", "heat capacity", {1, 2, -2, -1}, "correct rho_Cp or thickness",
                    problems);
    place.report(model, "/NODE", "position", dim::length, "correct the coordinates", problems);
    for (const Interface& interface : model.interfaces) {
        Unfit stiffness;
        Unfit area;
        const SecondarySide& side = interface.secondary;
        for (size_t n = 0; n < side.node.size(); ++n) {
            const Id id = model.nodes.id[static_cast<size_t>(side.node[n])];
            if (n < side.element_stiffness.size()) stiffness.add(id, side.element_stiffness[n]);
            if (n < side.area.size()) area.add(id, side.area[n]);
        }
        const std::string card = fmt::format("/INTER/TYPE21/{}", interface.id);
        stiffness.report(model, card, "stiffness of the elements", dim::stiffness,
                         "correct Young's modulus or thickness", problems);
        area.report(model, card, "area", dim::area, "correct the coordinates", problems);
    }
    for (const RigidBody& tool : model.rigid_bodies) {
        if (is_fit(tool.mass) && is_fit(tool.inertia.cwiseAbs().maxCoeff())) continue;
        Problem problem;
        problem.place.file = model.deck_path;
        problem.card = fmt::format("/RBODY/{}", tool.id);
        problem.field = "Mass, Jxx to Jxz";
        problem.value = fmt::format("mass {:.6g} {}, largest inertia {:.6g} {}", tool.mass, model.units.name(dim::mass),
                                    tool.inertia.cwiseAbs().maxCoeff(), model.units.name(dim::inertia));
        problem.rule = fmt::format("mass and inertia of a tool are finite numbers below {:g}", largest_number);
        problem.remedy = "correct the card, or density and thickness of the tool";
        problems.add(std::move(problem));
    }
}

}  // namespace type21
