// A node under constant load bounces on a flat tool.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "verification/stability/long_run_scene.h"
#include "verification/stability/long_runs.h"

namespace type21::stability {
namespace {

constexpr double acceleration = 2.0;  ///< of the constant load [mm/s^2]
constexpr double drop = 0.2;          ///< height over the gap [mm]
constexpr double omega_step = 0.02;   ///< omega dt [-]
constexpr double eps = std::numeric_limits<double>::epsilon();

/// Speed at which x'' + 2 zeta omega x' + omega^2 x = a, x(0) = 0, x'(0) = speed comes back to x = 0, downward
/// positive.
double speed_after(double speed, double zeta, double omega) {
    const double damped = omega * std::sqrt(1 - zeta * zeta);
    const double rest = acceleration / (omega * omega);
    const double b = (speed - zeta * omega * rest) / damped;
    const auto x = [&](double t) {
        return rest + std::exp(-zeta * omega * t) * (-rest * std::cos(damped * t) + b * std::sin(damped * t));
    };
    double low = 0.1 / omega;  // in contact: the fastest return takes half a period
    double high = low;
    while (x(high) > 0 && high < 10 / omega)
        high += 0.01 / omega;
    if (x(high) > 0) return 0;  // it does not come back: the load holds it
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (x(middle) > 0 ? low : high) = middle;
    }
    const double h = 1e-6 / omega;
    return -(x(low + h) - x(low - h)) / (2 * h);
}

/// Energy of the scheme in free flight, which it keeps exactly: half m v_{n-1/2} v_{n+1/2} + m a z_n.
double flight_energy(double z, double before) {
    const double after = before - acceleration * (omega_step / std::sqrt(stiffness / node_mass));
    return 0.5 * node_mass * before * after + node_mass * acceleration * z;
}

struct Bounces {
    long count = 0;
    double first_energy = 0, last_energy = 0;
    double sum = 0, least = HUGE_VAL, most = -HUGE_VAL;  ///< of the gain, or of the error, of a bounce
    double flight_drift = 0;                             ///< largest relative change of the energy in one flight
};

}  // namespace

LongRun bouncing(const MakeContact& make_contact, long cycles, double viss) {
    const double omega = std::sqrt(stiffness / node_mass);
    const double step = omega_step / omega;
    const double zeta = viss / std::numbers::sqrt2;  // C / (2 sqrt(k m)) with C = VISs sqrt(2 k m)
    const double zeta_of_scheme = zeta / std::sqrt(1 - zeta * omega_step);
    LongRun run;
    run.name = viss > 0 ? "bounce_damped" : "bounce";
    run.statement =
        fmt::format("a node under a constant load bounces on a flat tool, VISs {}, omega dt {}", viss, omega_step);
    run.cycles = cycles;
    SceneBuilder builder = long_run_scene(make_tool(Shape::flat, Mesh::quad), {Vec3(0.3, 0.4, gap + drop)});
    builder.viss(viss).load(builder.blank_node(0), 2, -node_mass * acceleration);
    set_cycles(builder, step, cycles);
    const HostScene scene = builder.scene();
    const auto at = static_cast<size_t>(builder.blank_node(0));

    Bounces bounces;
    bool touching = false;
    double entry_speed = 0;
    // From rest, v_{-1/2} and v_{1/2} are -+ a dt / 2 of the same trajectory.
    double start_of_flight =
        node_mass * acceleration * (gap + drop) - 0.125 * node_mass * acceleration * acceleration * step * step;
    bounces.first_energy = start_of_flight - node_mass * acceleration * gap;
    double last = start_of_flight;
    double settled_low = HUGE_VAL;
    double settled_high = -HUGE_VAL;
    double settled_place = 0;
    const auto observe = [&](const CycleRecord& record) {
        const NodeContact& node = (*record.contacts)[0].nodes[0];
        const double z = record.motion->position[at].z();
        const double speed = record.motion->velocity[at].z();
        if (10 * record.cycle > 9 * cycles) {
            settled_low = std::min(settled_low, node.normal_force);
            settled_high = std::max(settled_high, node.normal_force);
            settled_place = z;
        }
        if (record.cycle == 0) return;
        const bool touches = node.stiffness > 0;
        if (touches && !touching) {
            entry_speed = -speed;
            const double kinetic = 0.5 * node_mass * speed * speed;
            bounces.flight_drift = std::max(bounces.flight_drift, std::abs(last - start_of_flight) / kinetic);
        } else if (!touches && touching) {
            const double energy = flight_energy(z, speed);
            const double kinetic = 0.5 * node_mass * speed * speed;
            // Undamped: gain of a bounce. Damped: what is left of the energy, against the differential equation;
            // not where the load nearly holds the node, since whether it leaves hangs on little there.
            double change = (energy - start_of_flight) / kinetic;
            bool counts = true;
            if (viss > 0) {
                const double expected = speed_after(entry_speed, zeta_of_scheme, omega);
                counts = entry_speed > 2 * acceleration / omega;
                change = (speed * speed - expected * expected) / (entry_speed * entry_speed);
            }
            if (counts) {
                ++bounces.count;
                bounces.sum += change;
                bounces.least = std::min(bounces.least, change);
                bounces.most = std::max(bounces.most, change);
            }
            start_of_flight = energy;
        }
        if (!touches) last = flight_energy(z, speed);
        touching = touches;
    };
    march(scene, make_contact, observe);
    bounces.last_energy = start_of_flight - node_mass * acceleration * gap;

    const auto count = static_cast<double>(bounces.count);
    const double square = omega_step * omega_step;
    run.findings.push_back({"bounces compared", count, "-", 3, HUGE_VAL, "some, else nothing is shown"});
    // Adding a constant to a speed of size v rounds by eps v / 2, n times; the flight has at most some 1000 cycles.
    run.findings.push_back({"energy in free flight, largest relative drift of one flight", bounces.flight_drift, "-", 0,
                            4000 * eps, "the scheme keeps 1/2 m v_- v_+ + m a z: rounding only"});
    if (viss == 0) {
        // Inside the contact the scheme keeps 1/2 m v_- v_+ + 1/2 k x^2 - m a x. It enters with x = 0 (P0 = p_g of the
        // first cycle) and leaves with x = -u v dt, 0 <= u < 1, behind the end of the spring: there it has gained 1/2 m
        // omega^2 (u v dt) (v dt - u v dt), which is u (1 - u) (omega dt)^2 of 1/2 m v^2.
        run.findings.push_back({"least gain of energy in a bounce / (omega dt)^2", bounces.least / square, "-", -0.01,
                                0.25, "u (1 - u) >= 0: the scheme never loses energy to a bounce"});
        run.findings.push_back(
            {"largest gain / (omega dt)^2", bounces.most / square, "-", 0, 0.26, "u (1 - u) <= 1/4"});
        run.findings.push_back({"mean gain / (omega dt)^2", bounces.sum / count / square, "-", 0, 0.25,
                                "1/6 if u is spread evenly over the bounces: a bouncing node slowly gains energy"});
        run.findings.push_back({"energy at the end / at the start", bounces.last_energy / bounces.first_energy, "-",
                                1.0, std::exp(0.26 * square * (count + 1)), "exp(bounces (omega dt)^2 / 6)"});
    } else {
        // The scheme damps in whole cycles: its contact lasts up to one cycle more or less than that of the oscillator.
        // A cycle of damping takes the share 2 C dt / m = 4 zeta omega dt of the energy.
        const double order = 4 * zeta * omega_step;
        run.findings.push_back({"energy kept in a bounce - that of the oscillator, least", bounces.least, "-", -order,
                                order, "+- 4 zeta omega dt, against x'' + 2 zeta omega x' + omega^2 x = a"});
        run.findings.push_back({"the same, largest", bounces.most, "-", -order, order, "likewise"});
        run.findings.push_back({"share of the first energy left in the last flight",
                                bounces.last_energy / bounces.first_energy, "-", -1e-3, 1, "goes to 0"});
        const double ulp = stiffness * gap * eps;  // of k x position
        run.findings.push_back({"force in the last tenth of the run, largest - least", settled_high - settled_low, "N",
                                0, cycles >= 50000 ? 16 * ulp : HUGE_VAL, "16 ulp of k x position once it rests"});
        run.findings.push_back({"penetration at the end", gap - settled_place, "mm", -HUGE_VAL, HUGE_VAL,
                                fmt::format("shown only: m a / k = {} and the offset P0 of the last impact",
                                            acceleration * node_mass / stiffness)});
    }
    return run;
}

}  // namespace type21::stability
