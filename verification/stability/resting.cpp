// Free nodes rest on a flat tool under load, held by friction that sticks.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "verification/stability/long_run_scene.h"
#include "verification/stability/long_runs.h"

namespace type21::stability {
namespace {

constexpr double weight = 100.0;    ///< on each node [N]
constexpr double friction = 0.2;    ///< Fric
constexpr double omega_step = 0.1;  ///< sqrt(k/m) dt [-]
constexpr double eps = std::numeric_limits<double>::epsilon();
const Vec3 pull(0.8, 0.6, 0);  ///< direction of the tangential load, oblique to every axis

/// Range and mean of one quantity.
struct Range {
    double low = HUGE_VAL, high = -HUGE_VAL, sum = 0;
    long count = 0;

    void add(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
        sum += value;
        ++count;
    }
    double width() const { return high - low; }
    double mean() const { return sum / static_cast<double>(count); }
};

/// One node over one part of the run.
struct NodeRanges {
    Range normal, tangential;  ///< force [N]
    Range place;               ///< along the pull [mm]
};

}  // namespace

LongRun resting(const MakeContact& make_contact, long cycles, double share) {
    const double omega = std::sqrt(stiffness / node_mass);
    const double step = omega_step / omega;
    const double ramp = 0.2 * static_cast<double>(cycles) * step;
    const double tangential = share * friction * weight;
    LongRun run;
    run.name = share > 0.9 ? "rest_near_slip" : "rest";
    run.statement = fmt::format(
        "four free nodes rest on a flat tool under {} N each, pulled sideways with {} of the friction limit, VISs 1",
        weight, share);
    run.cycles = cycles;
    const double z = gap - weight / stiffness;
    const std::vector<Vec3> corners{{-1.3, -0.9, z}, {0.7, -0.9, z}, {0.7, 1.1, z}, {-1.3, 1.1, z}};
    SceneBuilder builder = long_run_scene(make_tool(Shape::flat, Mesh::quad), corners);
    builder.viss(1.0).fric(friction);
    for (int i = 0; i < 4; ++i) {
        builder.load(builder.blank_node(i), 2, -weight)
            .load(builder.blank_node(i), 0, tangential * pull.x(), ramp)
            .load(builder.blank_node(i), 1, tangential * pull.y(), ramp);
    }
    set_cycles(builder, step, cycles);
    const HostScene scene = builder.scene();

    // The load is up at a fifth of the run. Two windows behind it: from 3/10 to 6/10 and from 7/10 to the end.
    std::array<std::array<NodeRanges, 2>, 4> ranges;
    double slips = 0;
    double history_error = 0;
    const auto observe = [&](const CycleRecord& record) {
        const long tenth = 10 * record.cycle / cycles;
        for (size_t i = 0; i < 4; ++i) {
            const NodeContact& node = (*record.contacts)[0].nodes[i];
            const Vec3& x = record.motion->position[static_cast<size_t>(builder.blank_node(static_cast<int>(i)))];
            if (node.status != Status::stick) ++slips;
            // While it sticks the friction on the tool is k times the way: the history must not drift away from it.
            history_error =
                std::max(history_error,
                         (node.friction - stiffness * Vec3((x - corners[i]).x(), (x - corners[i]).y(), 0)).norm());
            const int window = tenth >= 7 ? 1 : tenth >= 3 && tenth < 6 ? 0 : -1;
            if (window < 0) continue;
            NodeRanges& w = ranges[i][static_cast<size_t>(window)];
            w.normal.add(node.normal_force);
            w.tangential.add(node.friction.dot(pull));
            w.place.add((x - corners[i]).dot(pull));
        }
    };
    march(scene, make_contact, observe);

    double normal_jitter = 0;
    double friction_jitter = 0;
    double growth = 0;
    double force_error = 0;
    double creep = 0;
    for (const auto& node : ranges) {
        for (const NodeRanges& w : node) {
            normal_jitter = std::max(normal_jitter, w.normal.width());
            friction_jitter = std::max(friction_jitter, w.tangential.width());
            force_error = std::max(force_error, std::abs(w.tangential.mean() - tangential));
        }
        growth = std::max(growth, node[1].tangential.width() - node[0].tangential.width());
        creep = std::max(creep, std::abs(node[1].place.mean() - node[0].place.mean()));
    }
    // A stuck node is an undamped oscillator along the tool (VISs acts along the normal only). The ramp leaves it
    // swinging with at most 2 / (omega ramp) of the load to each side; a mean over a window of length w misses it by
    // twice that / (omega w).
    const double n = static_cast<double>(cycles);
    const double swing = 2 * tangential / (omega * ramp);
    const double window = 0.3 * n * step;
    const double mean_error = 2 * swing / (omega * window);
    const double rounding = n * eps * (stiffness * 1.3 + tangential);  // of k x position and of the force, every cycle
    run.findings = {{"node cycles that slip", slips, "-", 0, 0, "none: the load stays below the limit"},
                    {"normal force, largest - least after settling", normal_jitter, "N", 0, 16 * stiffness * gap * eps,
                     "16 ulp of k x position; damped to rounding"},
                    {"friction force, largest - least after the ramp", friction_jitter, "N", 0, 2 * swing + rounding,
                     "4 T / (omega ramp): the stuck node swings undamped, VISs acts along the normal only"},
                    {"growth of that swing from the first to the second window", growth, "N", -HUGE_VAL,
                     1e-3 * swing + rounding, "none: central differences keep the energy of an oscillator"},
                    {"friction force, error of its mean", force_error, "N", 0, mean_error + rounding,
                     "the load itself; 4 T / (omega^2 ramp window)"},
                    {"friction history against k x way, largest difference", history_error, "N", 0, rounding,
                     "at most n eps (k |x| + T); sqrt(n) of it if the roundings are independent"},
                    {"the same in units of sqrt(n) eps (k |x| + T)", history_error * std::sqrt(n) / rounding, "-",
                     -HUGE_VAL, HUGE_VAL, "shown only"},
                    {"creep: way of the mean position from the first to the second window", creep, "mm", 0,
                     (2 * mean_error + rounding) / stiffness,
                     "none: stick is elastic; what the swing leaves in a mean, and rounding"}};
    return run;
}

}  // namespace type21::stability
