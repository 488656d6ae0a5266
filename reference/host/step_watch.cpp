#include "reference/host/step_watch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "reference/host/march.h"
#include "reference/host/when.h"

namespace type21 {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A bound on the step that the engine deck alone sets.
struct StepBound {
    double step = infinite;  ///< [time]
    const char* card = "";
    const char* field = "";
};

StepBound bound_of(const EngineControl& engine) {
    const double largest = engine.largest_step.value_or(0.0);
    const double initial = engine.first_step.value_or(0.0);
    StepBound bound;
    if (largest > 0) bound = {largest, "/DTIX", "DTmax"};
    if (largest > 0 && largest == initial) return bound;  // a constant step, whatever /TFILE says
    if (engine.history_interval > 0 && engine.history_interval < bound.step)
        bound = {engine.history_interval, "/TFILE", "DTHIS"};
    return bound;
}

bool is_free(const HostState& state, size_t node) {
    const NodeConditions& conditions = state.conditions[node];
    return !(conditions.driven(0) && conditions.driven(1) && conditions.driven(2));
}

bool turns(const HostState& state, size_t node) {
    const NodeConditions& conditions = state.conditions[node];
    return !(conditions.driven(3) && conditions.driven(4) && conditions.driven(5));
}

std::string cycles_text(double cycles) {
    if (!std::isfinite(cycles)) return "more than 1e308";
    return cycles < 1e15 ? fmt::format("{:.0f}", cycles) : fmt::format("{:.3g}", cycles);
}

}  // namespace

void check_time_span(const Model& model, Problems& problems) {
    const double end = model.engine.end_time;
    const StepBound bound = bound_of(model.engine);
    if (!(end > 0) || !std::isfinite(bound.step)) return;
    const double cycles = end / bound.step;
    if (cycles <= many_cycles) return;
    Problem problem;
    problem.place.file = model.deck_path;
    problem.card = bound.card;
    problem.field = bound.field;
    problem.value = fmt::format("{:.6g} {}", bound.step, model.units.name(dim::time));
    const std::string time = fmt::format("{:.6g} {}", end, model.units.name(dim::time));
    problem.remedy = "Give a larger step or an earlier end time";
    if (end + bound.step == end) {
        problem.rule = fmt::format(
            "the step is lost in the time: t + dt = t before the end of the run, {}, which asks "
            "for {} cycles",
            time, cycles_text(cycles));
    } else if (cycles > most_cycles) {
        problem.rule = fmt::format("the run to {} asks for {} cycles; more than {:g} are refused", time,
                                   cycles_text(cycles), most_cycles);
    } else {
        problem.severity = Severity::warning;
        problem.rule = fmt::format("the run to {} asks for {} cycles", time, cycles_text(cycles));
    }
    problems.add(std::move(problem));
}

void check_step(const Model& model, const HostState& state, double step) {
    const std::string unit = model.units.name(dim::time);
    const auto stop = [](RunStopped::Why why, const std::string& message) { throw RunStopped(why, message); };
    if (!std::isfinite(step) || !(step > 0)) {
        stop(RunStopped::Why::diverged, fmt::format("the time step is {} {}, {}: nothing limits it; give a step by "
                                                    "/DTIX or an interval by /TFILE",
                                                    step, unit, when(state, model.units)));
    }
    if (step < model.engine.smallest_step) {
        stop(RunStopped::Why::step_too_small,
             fmt::format("the time step {:.6g} {} is below the smallest of /DT, {:.6g} {}, {}", step, unit,
                         model.engine.smallest_step, unit, when(state, model.units)));
    }
    if (state.time + step == state.time) {
        stop(RunStopped::Why::step_too_small,
             fmt::format("the time step {:.6g} {} does not change the time, {}: t + dt = t", step, unit,
                         when(state, model.units)));
    }
    const double cycles = (model.engine.end_time - state.time) / step;
    if (cycles > most_cycles) {
        stop(RunStopped::Why::step_too_small,
             fmt::format("the time step {:.6g} {} would need {} more cycles to the end, {}: more than {:g} are refused",
                         step, unit, cycles_text(cycles), when(state, model.units), most_cycles));
    }
}

bool is_long_run(const Model& model, const HostState& state, double step) {
    const double left = model.engine.end_time - state.time;
    return left / step > many_cycles && !(model.engine.end_time / bound_of(model.engine).step > many_cycles);
}

std::string warning_of_long_run(const Model& model, const HostState& state, double step) {
    return fmt::format("with the time step {:.6g} {}, {}, the run would need {} more cycles", step,
                       model.units.name(dim::time), when(state, model.units),
                       cycles_text((model.engine.end_time - state.time) / step));
}

double free_limit(const Model& model, const HostState& state, const std::vector<ContactStep>& contacts) {
    std::vector<double> stiffness(state.position.size(), 0.0);
    double limit = infinite;
    for (size_t i = 0; i < contacts.size(); ++i) {
        const Interface& interface = model.interfaces[i];
        for (size_t n = 0; n < contacts[i].nodes.size(); ++n)
            stiffness[static_cast<size_t>(interface.secondary.node[n])] += contacts[i].nodes[n].step_stiffness;
        const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(interface.tool)];
        const ToolLoad& load = contacts[i].tool;
        const auto main = static_cast<size_t>(tool.main_node);
        if (is_free(state, main)) limit = std::min(limit, damped_step(tool.mass, load.step_stiffness, load.damping));
        if (turns(state, main) && load.step_rotation > 0)
            limit = std::min(limit,
                             damped_step(smallest_inertia(tool.inertia), load.step_rotation, load.rotational_damping));
    }
    for (size_t n = 0; n < stiffness.size(); ++n) {
        if (stiffness[n] > 0 && state.body[n] < 0 && is_free(state, n))
            limit = std::min(limit, stable_step(model.nodal_mass[n], stiffness[n]));
    }
    return limit;
}

void note_excess(const Model& model, const HostState& state, const std::vector<ContactStep>& contacts,
                 const StepLimits& limits, double step, StepExcess& excess) {
    const double scale = model.engine.step_scale;
    double limit = limits.thermal_stable;
    // The limit over all nodes is a lower bound, and at hand.
    if (step > limits.nodal / scale) limit = std::min(limit, free_limit(model, state, contacts));
    if (!(step > limit)) return;
    excess.last_cycle = state.cycle;
    if (excess.cycles++ == 0) {
        excess.first_cycle = state.cycle;
        excess.first_time = state.time;
    }
    if (step / limit <= excess.worst) return;
    excess.worst = step / limit;
    excess.limit = limit;
    excess.step = step;
}

std::optional<std::string> warning_of(const StepExcess& excess, const Model& model, long cycles) {
    if (excess.cycles == 0) return std::nullopt;
    const std::string unit = model.units.name(dim::time);
    return fmt::format(
        "the step of /DTIX was above the stability limit in {} of {} cycles, the first at t = {:.6g} {}; "
        "at most {:.3g} times: {:.6g} {}, limit {:.6g} {}. Forces and energies may grow without bound; "
        "leave /DTIX out, or give a step below the limit",
        excess.cycles, cycles, excess.first_time, unit, excess.worst, excess.step, unit, excess.limit, unit);
}

}  // namespace type21
