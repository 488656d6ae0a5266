// A node that circles over a fold, and a fold that turns under a node.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "verification/stability/long_run_scene.h"
#include "verification/stability/long_runs.h"
#include "verification/support/prescribed_motion.h"

namespace type21::stability {
namespace {

constexpr double slope = std::numbers::pi / 6;  ///< of both planes [rad]
constexpr double friction = 0.2;                ///< Fric
constexpr double radius = 0.5;                  ///< of the circle [mm]
constexpr int points = 1000;                    ///< of a turn
constexpr double step = 1e-3;                   ///< [s]
constexpr double eps = std::numeric_limits<double>::epsilon();

/// So high over the fold that the circle stays between a third and two thirds of the gap deep in it [mm].
double height(bool convex) {
    return convex ? 0.3 : 0.7;
}

Vec3 on_circle(long phase, bool convex) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(phase % points) / points;
    return {radius * std::cos(angle), radius * std::sin(angle), height(convex)};
}

/// The circle's middle lies beside the ridge, so that no symmetry makes a drift cancel.
constexpr double ridge = -0.1;

/// The forces and the work of one turn.
struct Turn {
    std::vector<double> normal_force;
    std::vector<Vec3> friction;
    double normal_work = 0;  ///< of F_n nu on the node [mJ]
    double slip_work = 0;    ///< given to the tool by friction [mJ]
};

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0;
    for (size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double largest = 0;
    for (size_t i = 0; i < a.size(); ++i)
        largest = std::max(largest, (a[i] - b[i]).norm());
    return largest;
}

SceneBuilder fold_scene(bool convex) {
    return long_run_scene(make_fold(convex, slope, ridge), {on_circle(0, convex)}).fric(friction);
}

}  // namespace

LongRun circling(const MakeContact& make_contact, long cycles, bool convex) {
    LongRun run;
    run.name = convex ? "fold_convex" : "fold_concave";
    run.statement =
        "a node moves in a circle over a fold of 120 degrees, friction 0.2, 1000 cycles a turn, the same bits every "
        "turn";
    run.cycles = cycles;
    PrescribedNode node(fold_scene(convex).scene(), make_contact);
    // The speeds come from a table, too: the difference across the seam of the circle is that of every turn.
    std::vector<Vec3> place, speed;
    for (int i = 0; i < points; ++i)
        place.push_back(on_circle(i, convex));
    for (int i = 0; i < points; ++i)
        speed.emplace_back((place[static_cast<size_t>(i)] - place[static_cast<size_t>((i + points - 1) % points)]) /
                           step);

    // The first turn starts without friction; the second is the one that all others must repeat.
    Turn now, second;
    double open = 0;
    double largest_energy = 0;
    double normal_drift = 0;
    double friction_drift = 0;
    double work_drift = 0;
    long turns = 0;
    for (long cycle = 0; cycle < cycles; ++cycle) {
        const auto i = static_cast<size_t>(cycle % points);
        const NodeContact contact = node.to(place[i], speed[i], step);
        if (contact.status == Status::open) ++open;
        now.normal_force.push_back(contact.normal_force);
        now.friction.push_back(contact.friction);
        now.normal_work += contact.normal_force * contact.normal.dot(speed[i]) * step;
        now.slip_work += contact.friction.dot(speed[i]) * step;
        largest_energy = std::max(largest_energy, contact.elastic_energy);
        if (i + 1 < points) continue;
        ++turns;
        if (turns == 2) second = now;
        if (turns > 2) {
            normal_drift = std::max(normal_drift, largest_difference(now.normal_force, second.normal_force));
            friction_drift = std::max(friction_drift, largest_difference(now.friction, second.friction));
            work_drift = std::max(work_drift, std::abs(now.slip_work - second.slip_work));
        }
        now = {};
    }
    const double force =
        second.normal_force.empty() ? 0 : *std::max_element(second.normal_force.begin(), second.normal_force.end());
    const double stick_length = friction * force / stiffness;
    const double travel = 2 * std::numbers::pi * radius / points;
    // Each cycle of slip turns the remembered force towards the motion by the share travel / stick_length and rounds
    // once: roundings sum to eps stick_length / travel, however long the run.
    const double friction_bound = 8 * eps * friction * force * stick_length / travel;
    run.findings = {
        {"cycles out of contact", open, "-", 0, 0, "the circle lies in the gap"},
        {"turns compared with the second", static_cast<double>(std::max(turns - 2, 0L)), "-", 1, HUGE_VAL,
         "at least one, else nothing is shown"},
        {"normal force, largest F_n of a turn", force, "N", 1, HUGE_VAL, "there is a force"},
        {"normal force, largest drift from turn to turn", normal_drift, "N", 0, 0,
         "0: F_n is a function of the position only, and the positions repeat their bits"},
        {"friction force, largest drift from turn to turn", friction_drift, "N", 0, friction_bound,
         "slip forgets its history: 8 eps F_t x (stick length / travel of a cycle), whatever the number of turns"},
        {"friction work of a turn", second.slip_work, "mJ", 0, HUGE_VAL, "positive: friction takes energy"},
        {"friction work, largest drift from turn to turn", work_drift, "mJ", 0,
         friction_bound * 2 * std::numbers::pi * radius, "drift of the force x length of the circle"},
        {"work of the normal force over a closed turn", second.normal_work, "mJ", -HUGE_VAL, HUGE_VAL,
         "shown only: not 0, since the interpolated normal is not the gradient of the distance; the same every turn"},
        {"the same, as a share of the largest elastic energy", second.normal_work / largest_energy, "-", -0.5, 0.5,
         "below the energy itself: the fold is rounded over one element"}};
    return run;
}

LongRun turning(const MakeContact& make_contact, long cycles) {
    LongRun run;
    run.name = "fold_turning";
    run.statement =
        "a tool with a convex fold of 120 degrees turns under a held node, 1000 cycles a turn, through the march";
    run.cycles = cycles;
    SceneBuilder builder = fold_scene(true);
    builder.hold(builder.blank_node(0)).drive(builder.main_node(), 5, 2 * std::numbers::pi / (points * step));
    set_cycles(builder, step, cycles);
    const HostScene scene = builder.scene();

    std::vector<double> second(points, 0.0);
    double largest = 0;
    double steepest = 0;
    double last = 0;
    double drift = 0;
    double angle_drift = 0;
    double stretch = 0;
    double open = 0;
    const auto observe = [&](const CycleRecord& record) {
        const NodeContact& node = (*record.contacts)[0].nodes[0];
        const Mat3& rotation = record.motion->tools[0].rotation;
        const auto phase = static_cast<size_t>(record.cycle % points);
        if (node.status == Status::open) ++open;
        // From the wanted angle to the one that is there; no number of turns is lost in the difference.
        const double wanted = 2 * std::numbers::pi * static_cast<double>(phase) / points;
        const double angle = std::atan2(rotation(1, 0), rotation(0, 0)) - wanted;
        angle_drift = std::max(angle_drift, std::abs(std::remainder(angle, 2 * std::numbers::pi)));
        stretch = std::max(stretch, (rotation * rotation.transpose() - Mat3::Identity()).cwiseAbs().maxCoeff());
        largest = std::max(largest, node.normal_force);
        if (record.cycle >= points && record.cycle < 2 * points) {
            second[phase] = node.normal_force;
            steepest = std::max(steepest, std::abs(node.normal_force - last));
        } else if (record.cycle >= 2 * points) {
            drift = std::max(drift, std::abs(node.normal_force - second[phase]));
        }
        last = node.normal_force;
    };
    march(scene, make_contact, observe);

    // The angle of a step rounds the same way every step, so the error may grow with n; a random walk would give
    // sqrt(n).
    const auto n = static_cast<double>(cycles);
    const double slope_of_force = steepest * points / (2 * std::numbers::pi);
    run.findings = {{"cycles out of contact", open, "-", 0, 0, "the circle lies in the gap"},
                    {"normal force, largest F_n", largest, "N", 1, HUGE_VAL, "there is a force"},
                    {"angle of the tool, largest error", angle_drift, "rad", 0, 8 * eps + n * eps,
                     "at most n eps (the same rounding every cycle), sqrt(n) eps if the roundings were independent"},
                    {"the same in units of sqrt(n) eps", angle_drift / (std::sqrt(n) * eps), "-", -HUGE_VAL, HUGE_VAL,
                     "shown only"},
                    {"length of the tool's axes, largest error", stretch, "-", 0, 16 * eps,
                     "does not grow: the quaternion is normalised"},
                    {"normal force, largest drift from turn to turn", drift, "N", 0,
                     2 * (8 * eps + n * eps) * slope_of_force + 64 * eps * stiffness,
                     "error of the angle x steepest slope of F_n, and rounding of k x position"}};
    return run;
}

}  // namespace type21::stability
