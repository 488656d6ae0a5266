// Departures that are neither a law nor a card: the first impact and what becomes of Inacti 6.
#include <vector>

#include <gtest/gtest.h>

#include "reference/contact/retained_impact.h"
#include "reference/cycle/contact.h"
#include "small_scene.h"

namespace type21::reference {
namespace {

using test::over_a_square;

/// P0 of one node that stays away from the tool at time 0, then penetrates by 0.2 and by 0.1; gap 0.5, Inacti 6.
double offset_of_a_later_impact(bool d26) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.6}});
    small.card().inacti.value = 6;
    small.model().as_built.set(Departure::D26, d26);
    Contact contact(small.scene(), 0);
    std::vector<Vec3> position = small.model().nodes.position;
    const std::vector<Vec3> velocity(position.size(), Vec3::Zero());
    double offset = 0;
    double time = 0;
    for (const double height : {0.6, 0.3, 0.4}) {
        position[static_cast<size_t>(small.blank_node(0))].z() = height;
        Motion motion;
        motion.time = time;
        motion.step = motion.friction_step = time > 0 ? 1e-3 : 0.0;
        motion.position = position;
        motion.velocity = velocity;
        motion.tools.resize(1);
        offset = contact.step(motion).nodes[0].offset;
        time += 1e-3;
    }
    return offset;
}

// @manual field Inacti; comment 9; departure D26
TEST(Departures, D26ForgetsInacti6WhereNothingPenetratesAtTimeZero) {
    EXPECT_NEAR(offset_of_a_later_impact(false), 0.95 * 0.2 + 0.05 * (0.1 + 0.05 * 0.4), 1e-12);
    EXPECT_NEAR(offset_of_a_later_impact(true), 0.95 * 0.2 + 0.05 * 0.1, 1e-12);
}

/// Friction of a node that slides under F_n = 200 with Fric 0.1 and f_IDF(x) = x / 1000, AscaleF 2: T_s = 300, tool
/// 900, Tint 500.
double friction_of_a_hot_node(bool d08) {
    SceneBuilder small = over_a_square({{0.2, 0.1, 0.3}});
    Interface& card = small.card();
    card.ithe.value = card.ithe_form.value = 1;
    card.tint.value = 500;
    card.fric.value = 0.1;
    card.ascalef.value = 2;
    card.fct_idf.value = 1;
    card.function_friction = 0;
    small.model().functions.push_back({1, "", {0.0, 1000.0}, {0.0, 1.0}});
    small.model().as_built.set(Departure::D08, d08);
    Contact contact(small.scene(), 0);
    std::vector<Vec3> velocity(small.model().nodes.position.size(), Vec3::Zero());
    velocity[static_cast<size_t>(small.blank_node(0))] = {1e3, 0, 0};
    std::vector<double> temperature(velocity.size(), 900.0);
    temperature[static_cast<size_t>(small.blank_node(0))] = 300;
    double friction = 0;
    for (int n = 0; n < 3; ++n) {
        Motion motion;
        motion.time = n * 1e-3;
        motion.step = motion.friction_step = n > 0 ? 1e-3 : 0.0;
        motion.position = small.model().nodes.position;
        motion.velocity = velocity;
        motion.temperature = temperature;
        motion.tools.resize(1);
        friction = contact.step(motion).nodes[0].friction.x();
    }
    return friction;
}

// mu = 0.1 f(2 (300 + 900) / 2) = 0.12; as built 0.1 f((300 + 500) / 2) = 0.04.
// @manual eq 7, 8; field fct_IDF, AscaleF; comment 12; departure D08
TEST(Departures, D08TakesTheFunctionOfTemperatureElsewhere) {
    EXPECT_NEAR(friction_of_a_hot_node(false), 0.12 * 200, 1e-10);
    EXPECT_NEAR(friction_of_a_hot_node(true), 0.04 * 200, 1e-10);
}

// 3 % beyond the border of the square: outside of the margin of 1 %, inside of that of 5 %.
// @manual departure D31
TEST(Departures, D31FindsTheFirstImpactWithWiderMargins) {
    SceneBuilder small = over_a_square({{1.03, 0.1, 0.3}});
    EXPECT_TRUE(Contact(small.scene(), 0).initial_penetrations().empty());
    small.model().as_built.set(Departure::D31);
    const auto found = Contact(small.scene(), 0).initial_penetrations();
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].penetration, 0.2, 1e-12);
}

// @manual departure D11
TEST(Departures, D11LetsTheMoreCentralProximityWin) {
    Impact<double> contact;
    contact.kind = Kind::contact;
    contact.segment = 1;
    contact.kappa = 0.9;
    Impact<double> proximity = contact;
    proximity.kind = Kind::proximity;
    proximity.kappa = 0.1;
    EXPECT_FALSE(precedes(proximity, contact));
    EXPECT_TRUE(precedes(proximity, contact, true));
    EXPECT_FALSE(precedes(Impact<double>{}, contact, true)) << "nothing never wins";
}

}  // namespace
}  // namespace type21::reference
