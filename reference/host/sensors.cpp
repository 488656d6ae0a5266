#include "reference/host/sensors.h"

#include <algorithm>

namespace type21 {

namespace {

double force_of(const Sensor& sensor, const InterfaceForce& force) {
    using Force = Sensor::Force;
    switch (sensor.part) {
        case Force::normal:
            return force.normal.norm();
        case Force::tangential:
            return force.tangential.norm();
        case Force::x:
        case Force::y:
        case Force::z:
            break;
    }
    const int axis = sensor.part == Force::x ? 0 : (sensor.part == Force::y ? 1 : 2);
    return (force.normal + force.tangential)[axis];
}

/// On for delay <= t < stop.
void update_time(const Sensor& sensor, double time, SensorState& state) {
    state.on = time >= sensor.delay && time < sensor.stop;
    if (state.on) {
        state.since = sensor.delay;
    } else {
        state.since = time < sensor.delay ? 0.0 : sensor.stop;
    }
}

/// A limit that is passed for Tmin without a break, and Tdelay after that, switches the sensor on for good.
void update_limit(const Sensor& sensor, double value, double time, SensorState& state) {
    if (state.on) return;
    if (!state.decided) {
        const bool outside = value < sensor.low || value > sensor.high;
        if (outside && !state.holds) state.holds_since = time;
        state.holds = outside;
        state.decided = outside && time >= state.holds_since + sensor.lasting;
    }
    const double start = state.holds_since + sensor.lasting + sensor.delay;
    if (!state.decided || time < start) return;
    state.on = true;
    state.since = start;
}

/// AND, OR, NOT: on while what it asks of the others has held for Tdelay.
void update_logic(const Sensor& sensor, double time, const std::vector<SensorState>& sensors, SensorState& state) {
    const auto other = [&](int index) -> const SensorState& { return sensors[static_cast<size_t>(index)]; };
    const auto is_on = [&](int index) { return other(index).on; };
    const auto& of = sensor.of;
    bool holds = false;
    if (sensor.kind == Sensor::Kind::all) holds = std::all_of(of.begin(), of.end(), is_on);
    if (sensor.kind == Sensor::Kind::any) holds = std::any_of(of.begin(), of.end(), is_on);
    if (sensor.kind == Sensor::Kind::none) holds = std::none_of(of.begin(), of.end(), is_on);
    if (holds != state.holds) {
        // It changed when the last of those changed that all had to, or the first of those that one of had to.
        const bool last = holds == (sensor.kind != Sensor::Kind::any);
        bool first_met = true;
        for (const int index : of) {
            const bool counts = other(index).on == (holds == (sensor.kind != Sensor::Kind::none));
            if (!counts) continue;
            const double since = other(index).since;
            if (first_met) {
                state.holds_since = since;
            } else {
                state.holds_since = last ? std::max(state.holds_since, since) : std::min(state.holds_since, since);
            }
            first_met = false;
        }
        state.holds = holds;
        if (!holds) state.since = state.holds_since;
    }
    state.on = state.holds && time >= state.holds_since + sensor.delay;
    if (state.on) state.since = state.holds_since + sensor.delay;
}

}  // namespace

void update_sensors(const Model& model, double time, const std::vector<Vec3>& position,
                    const std::vector<InterfaceForce>& forces, std::vector<SensorState>& sensors) {
    for (const int index : model.sensor_order) {
        const Sensor& sensor = model.sensors[static_cast<size_t>(index)];
        SensorState& state = sensors[static_cast<size_t>(index)];
        switch (sensor.kind) {
            case Sensor::Kind::time:
                update_time(sensor, time, state);
                break;
            case Sensor::Kind::all:
            case Sensor::Kind::any:
            case Sensor::Kind::none:
                update_logic(sensor, time, sensors, state);
                break;
            case Sensor::Kind::distance: {
                const Vec3 apart =
                    position[static_cast<size_t>(sensor.node_a)] - position[static_cast<size_t>(sensor.node_b)];
                update_limit(sensor, apart.norm(), time, state);
                break;
            }
            case Sensor::Kind::force:
                update_limit(sensor, force_of(sensor, forces[static_cast<size_t>(sensor.interface)]), time, state);
                break;
            case Sensor::Kind::unsupported:
                break;  // refused where a card uses it
        }
    }
}

void note_forces(const std::vector<ContactStep>& steps, std::vector<InterfaceForce>& forces) {
    for (size_t i = 0; i < steps.size(); ++i)
        forces[i] = {steps[i].sums.normal, steps[i].sums.tangential};
}

}  // namespace type21
