// When sensors are on, by hand; and what an interface does that is on, off and on again.
#include <gtest/gtest.h>

#include "../contact/small_scene.h"
#include "reference/contract/make_contact.h"
#include "reference/host/march.h"
#include "reference/host/sensors.h"

namespace type21::sensors {
namespace {

using test::over_a_square;

/// A sensor of TIME.
Sensor during(double delay, double stop = 1e30) {
    Sensor sensor;
    sensor.delay = delay;
    sensor.stop = stop;
    return sensor;
}

Sensor of(Sensor::Kind kind, std::vector<int> others, double delay = 0) {
    Sensor sensor;
    sensor.kind = kind;
    sensor.of = std::move(others);
    sensor.delay = delay;
    return sensor;
}

/// Steps the sensors of a model by hand. Each stands behind those that it looks at.
struct Hand {
    explicit Hand(std::vector<Sensor> sensors) {
        model.sensors = std::move(sensors);
        for (int i = 0; i < static_cast<int>(model.sensors.size()); ++i)
            model.sensor_order.push_back(i);
        states.resize(model.sensors.size());
    }
    const SensorState& last(double time) {
        update_sensors(model, time, position, forces, states);
        return states.back();
    }

    Model model;
    std::vector<Vec3> position{Vec3::Zero(), Vec3::Zero()};
    std::vector<InterfaceForce> forces{1};
    std::vector<SensorState> states;
};

// Every truth of two sensors: off off, on off, on on, off on.
TEST(Sensors, AndOrNotFollowTheOthersBothWays) {
    const std::vector<double> times{0.5, 1.5, 2.5, 3.5};
    const auto truth = [&](Sensor::Kind kind) {
        Hand hand({during(1, 3), during(2, 4), of(kind, {0, 1})});
        std::vector<bool> on;
        for (const double time : times)
            on.push_back(hand.last(time).on);
        return on;
    };
    EXPECT_EQ(truth(Sensor::Kind::all), (std::vector<bool>{false, false, true, false}));
    EXPECT_EQ(truth(Sensor::Kind::any), (std::vector<bool>{false, true, true, true}));
    EXPECT_EQ(truth(Sensor::Kind::none), (std::vector<bool>{true, false, false, false}));
}

// The time of a drive counts from the moment itself, not from the cycle that sees it.
TEST(Sensors, TheTimeOfAChangeIsThatOfTheSensorThatMadeIt) {
    Hand all({during(1.1), during(2.2), of(Sensor::Kind::all, {0, 1})});
    all.last(0.5);
    EXPECT_EQ(all.last(3).since, 2.2) << "the last of both";
    Hand any({during(1.1), during(2.2), of(Sensor::Kind::any, {0, 1})});
    any.last(0.5);
    EXPECT_EQ(any.last(3).since, 1.1) << "the first of both";
    Hand off({during(1.1, 2.2), of(Sensor::Kind::none, {0})});
    EXPECT_EQ(off.last(0.5).since, 0);
    EXPECT_FALSE(off.last(2).on);
    EXPECT_EQ(off.last(3).since, 2.2);
}

TEST(Sensors, OnOffAndOnAgain) {
    Hand hand({during(1, 2), during(3, 4), of(Sensor::Kind::any, {0, 1})});
    std::vector<bool> on;
    for (const double time : {0.0, 1.0, 1.9, 2.0, 2.9, 3.0, 4.0})
        on.push_back(hand.last(time).on);
    EXPECT_EQ(on, (std::vector<bool>{false, true, true, false, false, true, false}));
    EXPECT_EQ(hand.states[2].since, 4) << "off since then";
}

// Tdelay: the condition must have held for that time.
TEST(Sensors, ADelayWaits) {
    Hand hand({during(1, 3), of(Sensor::Kind::all, {0}, 0.5)});
    EXPECT_FALSE(hand.last(1.4).on);
    EXPECT_TRUE(hand.last(1.6).on);
    EXPECT_EQ(hand.last(1.7).since, 1.5);
    EXPECT_FALSE(hand.last(3.0).on) << "it ends at once";
}

Sensor apart(double low, double high, double lasting = 0, double delay = 0) {
    Sensor sensor;
    sensor.kind = Sensor::Kind::distance;
    sensor.node_a = 0;
    sensor.node_b = 1;
    sensor.low = low;
    sensor.high = high;
    sensor.lasting = lasting;
    sensor.delay = delay;
    return sensor;
}

TEST(Sensors, ADistanceOutsideOfItsLimitsSwitchesOnForGood) {
    Hand hand({apart(1, 5)});
    hand.position[1] = {0, 3, 4};
    EXPECT_FALSE(hand.last(0).on) << "5 is not above 5";
    hand.position[1] = {0, 3, 4.1};
    EXPECT_TRUE(hand.last(1).on);
    hand.position[1] = {0, 3, 0};
    EXPECT_TRUE(hand.last(2).on);
    EXPECT_EQ(hand.last(3).since, 1);
    Hand near({apart(1, 1e30)});
    near.position[1] = {0.9, 0, 0};
    EXPECT_TRUE(near.last(0).on);
}

// Tmin without a break, then Tdelay whatever happens.
TEST(Sensors, ADistanceMustLast) {
    Hand hand({apart(-1e30, 5, 1.0, 0.5)});
    const auto at = [&](double time, double distance) {
        hand.position[1] = {distance, 0, 0};
        return hand.last(time).on;
    };
    EXPECT_FALSE(at(0.0, 6));
    EXPECT_FALSE(at(0.9, 4)) << "a break";
    EXPECT_FALSE(at(1.0, 6));
    EXPECT_FALSE(at(1.9, 6));
    EXPECT_FALSE(at(2.0, 6)) << "held for Tmin";
    EXPECT_FALSE(at(2.4, 1)) << "Tdelay runs";
    EXPECT_TRUE(at(2.5, 1));
    EXPECT_EQ(hand.states[0].since, 2.5);
}

TEST(Sensors, PartsOfAContactForce) {
    const auto on = [](Sensor::Force part, double high) {
        Sensor sensor;
        sensor.kind = Sensor::Kind::force;
        sensor.interface = 0;
        sensor.part = part;
        sensor.high = high;
        Hand hand({sensor});
        hand.forces[0] = {{0, 3, -4}, {2, 0, 1}};
        return hand.last(0).on;
    };
    using Force = Sensor::Force;
    EXPECT_TRUE(on(Force::normal, 4.99));
    EXPECT_FALSE(on(Force::normal, 5.0));
    EXPECT_TRUE(on(Force::tangential, 2.23));
    EXPECT_FALSE(on(Force::tangential, 2.24));
    EXPECT_TRUE(on(Force::x, 1.9));
    EXPECT_FALSE(on(Force::y, 3.0));
    EXPECT_FALSE(on(Force::z, -2.9)) << "-3 is below, with its sign";
}

/// A sheet node that is pressed into the tool and slides; the interface is on, off and on again.
SceneBuilder interrupted() {
    SceneBuilder small = over_a_square({{-0.5, 0.1, 0.3}});
    small.fix(0, {true, true, true, true, true, true});
    const int node = small.blank_node(0);
    small.fix(node, {false, true, true, false, false, false});
    small.drive(node, 0, 1.0);
    small.fric(0.2);
    small.card().sensor = 2;
    Model& model = small.model();
    model.sensors = {during(0, 0.0095), during(0.0195, 1e30), of(Sensor::Kind::any, {0, 1})};
    model.sensor_order = {0, 1, 2};
    model.engine.end_time = 0.0295;
    return small;
}

struct Cycle {
    bool active;
    double elastic;
    double friction;
};

std::vector<Cycle> run(const SceneBuilder& small, const MakeContact& make) {
    std::vector<Cycle> cycles;
    march(small.scene(), make, [&](const CycleRecord& r) {
        const ContactStep& step = (*r.contacts)[0];
        const bool there = !step.nodes.empty();
        cycles.push_back(
            {step.active, there ? step.nodes[0].elastic_force : 0, there ? step.nodes[0].friction.x() : 0});
    });
    return cycles;
}

// The history waits: the friction force of cycle 10 goes on from that of cycle 9. Both implementations.
// @manual field sens_ID; comment 20
TEST(Sensors, TheHistoryWaitsWhileAnInterfaceIsOff) {
    const std::vector<MakeContact> both{
        [](const Scene& scene, int i) { return type21::reference::make_contact(scene, i); },
        [](const Scene& scene, int i) { return type21::optimized::make_contact(scene, i); }};
    for (const MakeContact& make : both) {
        const std::vector<Cycle> cycles = run(interrupted(), make);
        ASSERT_EQ(cycles.size(), 30U);
        for (size_t i = 0; i < cycles.size(); ++i)
            EXPECT_EQ(cycles[i].active, i < 10 || i >= 20) << i;
        // k = 1000, dt = 1 ms, v = 1: the stick spring grows by the same increment in every cycle that is on.
        const double increment = cycles[9].friction - cycles[8].friction;
        EXPECT_GT(increment, 0);
        EXPECT_NEAR(cycles[20].friction - cycles[9].friction, increment, 1e-9 * increment);
        EXPECT_NEAR(cycles[20].elastic, cycles[9].elastic, 1e-9) << "no first impact: the full force at once";
        EXPECT_EQ(cycles[15].elastic, 0);
    }
}

// The node leaves the gap in the pause and comes back before its end.
TEST(Sensors, BothImplementationsAgreeOverAPause) {
    SceneBuilder small = interrupted();
    small.drive(small.blank_node(0), 2, 1.0, ImposedMotion::Kind::displacement);
    small.model().functions.back() = {1, "", {0, 0.01, 0.014, 0.018, 0.03}, {0, 0, 0.6, 0.05, 0}};
    small.card().inacti.value = 6;
    const auto a = run(small, [](const Scene& scene, int i) { return type21::reference::make_contact(scene, i); });
    const auto b = run(small, [](const Scene& scene, int i) { return type21::optimized::make_contact(scene, i); });
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i].active, b[i].active) << i;
        EXPECT_NEAR(a[i].elastic, b[i].elastic, 1e-12) << i;
        EXPECT_NEAR(a[i].friction, b[i].friction, 1e-12) << i;
    }
}

// A drive on a DIST sensor starts when the tool has come far enough, and its function starts with it.
TEST(Sensors, ADriveStartsWithItsSensor) {
    SceneBuilder small = over_a_square({{5, 5, 5}});
    small.fix(small.blank_node(0), {true, true, true, true, true, true});
    small.fix(0, {false, true, true, true, true, true});
    small.drive(0, 0, 10.0);
    Model& model = small.model();
    Sensor near = apart(Vec3(5, 5, 5).norm() - 0.05, 1e30);
    near.node_b = small.blank_node(0);
    model.sensors = {near};
    model.sensor_order = {0};
    small.drive(0, 1, 1.0, ImposedMotion::Kind::displacement);
    model.imposed_motions.back().sensor = 0;
    model.engine.end_time = 0.03;
    double since = 0;
    double y = 0;
    double time = 0;
    march(
        small.scene(), [](const Scene& scene, int i) { return type21::reference::make_contact(scene, i); },
        [&](const CycleRecord& r) {
            if (since == 0 && r.motion->sensor_on[0]) since = r.time;
            time = r.time;
            y = (*r.displacement)[0].y();
        });
    EXPECT_GT(since, 0.005);
    EXPECT_LT(since, 0.02);
    EXPECT_NEAR(y, time - since, 1e-12) << "the displacement is the time since the sensor is on";
}

// The force of the first cycle with contact switches a sensor on in the cycle behind it.
TEST(Sensors, AContactForceSwitchesInTheCycleBehindIt) {
    SceneBuilder small = over_a_square({{0, 0, 0.52}});
    small.fix(0, {true, true, false, true, true, true});
    small.drive(0, 2, 10.0);
    small.fix(small.blank_node(0), {true, true, true, true, true, true});
    Sensor force;
    force.kind = Sensor::Kind::force;
    force.interface = 0;
    force.high = 20;
    Model& model = small.model();
    model.sensors = {force};
    model.sensor_order = {0};
    model.engine.end_time = 0.01;
    std::vector<double> forces;
    std::vector<bool> on;
    march(
        small.scene(), [](const Scene& scene, int i) { return type21::reference::make_contact(scene, i); },
        [&](const CycleRecord& r) {
            forces.push_back((*r.contacts)[0].sums.normal.norm());
            on.push_back(r.motion->sensor_on[0]);
        });
    ASSERT_GE(on.size(), 10U);
    for (size_t i = 1; i < on.size(); ++i)
        EXPECT_EQ(on[i], forces[i - 1] > 20) << i;
    EXPECT_TRUE(on.back());
}

}  // namespace
}  // namespace type21::sensors
