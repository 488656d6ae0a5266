// Friction laws and filters against numbers worked out beside them (manual page, comments 12 to 15).
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "reference/as_built/d06_d07_d28_filter.h"
#include "reference/as_built/d10_d39_d43_friction_law.h"
#include "reference/as_built/d42_node_parts.h"
#include "reference/contact/friction_filter.h"
#include "reference/contact/friction_increment.h"
#include "reference/contact/friction_law.h"
#include "reference/contact/node_parts.h"
#include "reference/contact/skid_line.h"
#include "reference/model/model.h"

namespace type21::reference {
namespace {

// @manual eq 9, 10; field Ifric, Fric, C1, C2, C3, C4, C5; comment 13
TEST(FrictionLaw, ViscousCountsEachTermOnce) {
    const FrictionCoefficients f{0.1, {2e-3, 3e-4, 5e-6, 7e-6, 11e-8, 0}};
    // p = 10, s = 100: 0.1 + 0.02 + 0.03 + 0.005 + 0.0007 + 0.0011
    EXPECT_NEAR(friction_coefficient(1, f, 10, 100), 0.1568, 1e-15);
    // A pulling damper makes the pressure negative; the law goes on and stops at its floor.
    EXPECT_NEAR(friction_coefficient(1, f, -1e4, 0), 680.1, 1e-12);
    EXPECT_EQ(friction_coefficient(1, {0.1, {2e-3, 0, 0, 0, 0, 0}}, -1e4, 0), 1e-30);
}

// @manual eq 11; field C6; comment 13
TEST(FrictionLaw, Darmstadt) {
    const FrictionCoefficients f{0.05, {1e-4, -0.01, 2e-3, -0.02, 0.3, -0.03}};
    // p = 10, s = 100: e^-1, e^-2, e^-3
    const double expected = 0.05 + 1e-2 * std::exp(-1.0) + 2e-2 * std::exp(-2.0) + 0.3 * std::exp(-3.0);
    EXPECT_NEAR(friction_coefficient(2, f, 10, 100), expected, 1e-15);
}

// @manual comment 13; field Ifric
TEST(FrictionLaw, RenardMeetsItsFourCoefficients) {
    const FrictionCoefficients f{0.9, {0.10, 0.08, 0.15, 0.05, 10, 100}};      // Fric is not in it
    EXPECT_DOUBLE_EQ(friction_coefficient(3, f, 0, 0), 0.10);                  // static
    EXPECT_DOUBLE_EQ(friction_coefficient(3, f, 0, 10), 0.15);                 // maximum at C5
    EXPECT_NEAR(friction_coefficient(3, f, 0, 100), 0.05, 1e-15);              // minimum at C6
    EXPECT_NEAR(friction_coefficient(3, f, 0, 1e9), 0.08, 1e-12);              // dynamic
    EXPECT_NEAR(friction_coefficient(3, f, 0, 5), 0.10 + 0.05 * 0.75, 1e-15);  // x = 1/2: x (2 - x) = 3/4
    EXPECT_NEAR(friction_coefficient(3, f, 0, 55), 0.10, 1e-15);               // y = 1/2: y^2 (3 - 2 y) = 1/2
    EXPECT_NEAR(friction_coefficient(3, f, 0, 101), 0.08 - 1 / (1 / 0.03 + 1), 1e-15);
}

// @manual departure D10; field Ifric
TEST(FrictionLaw, ExponentialDecaysFromFricToC1) {
    const FrictionCoefficients f{0.3, {0.1, 0.01, 0, 0, 0, 0}};
    EXPECT_DOUBLE_EQ(friction_coefficient(4, f, 0, 0), 0.3);
    EXPECT_NEAR(friction_coefficient(4, f, 0, 100), 0.1 + 0.2 * std::exp(-1.0), 1e-15);
    // D10: 2 C1 - Fric at rest, here below the floor.
    const as_built::FrictionLawDepartures d10{true, false, false};
    EXPECT_EQ(as_built::friction_coefficient(d10, 4, f, 0, 0), 1e-30);
    EXPECT_NEAR(as_built::friction_coefficient(d10, 4, f, 0, 100), 0.1 - 0.2 * std::exp(-1.0), 1e-15);
    EXPECT_NEAR(as_built::friction_coefficient({true, false, true}, 4, f, 0, 100), 0.1 - 0.2 * std::exp(-1.0), 1e-15);
}

// C1 = 0 beside e^(C2 s) beyond double: the term is 0. D43: 0 times infinite is no number, and mu the smallest.
// @manual eq 10, 11; field Ifric, C1, C2; comment 13; departure D43
TEST(FrictionLaw, ATermWithCoefficientZeroIsZero) {
    const as_built::FrictionLawDepartures d43{false, false, true};
    const FrictionCoefficients law_2{0.1, {0, 1, 0, 2, 0, 3}};
    EXPECT_EQ(friction_coefficient(2, law_2, 10, 1e4), 0.1);
    EXPECT_EQ(as_built::friction_coefficient(d43, 2, law_2, 10, 1e4), 1e-30);
    EXPECT_EQ(as_built::friction_coefficient(d43, 2, law_2, 10, 10), 0.1) << "no overflow, no difference";
    EXPECT_EQ(friction_coefficient(2, {0.1, {0.2, 1, 0.3, 1, 0, 0}}, 0, 1e4), 0.1) << "the pressure is 0";
    const FrictionCoefficients law_4{0.1, {0.1, -1, 0, 0, 0, 0}};
    EXPECT_EQ(friction_coefficient(4, law_4, 10, 1e4), 0.1) << "Fric = C1";
    EXPECT_EQ(as_built::friction_coefficient(d43, 4, law_4, 10, 1e4), 1e-30);
    EXPECT_EQ(friction_coefficient(1, {0.1, {}}, 10, 1e200), 0.1);
}

// What really overflows is not finite, whatever its sign, and the number that does it is named.
// @manual eq 10, 11; field C2, C4, C6; comment 13
TEST(FrictionLaw, AnOverflowIsNotAFloor) {
    const FrictionCoefficients both{0.1, {0.2, 1, 0.3, 1, 0.4, 5}};
    EXPECT_FALSE(std::isfinite(friction_coefficient(2, both, 10, 1e4)));
    EXPECT_EQ(overflowing_coefficient(2, both, 1e4), 1U);
    EXPECT_EQ(overflowing_coefficient(2, {0.1, {0.2, -1, 0.3, 1, 0, 0}}, 1e4), 3U);
    EXPECT_FALSE(std::isfinite(friction_coefficient(2, {0.1, {-0.2, 1, 0, 0, 0, 0}}, 10, 1e4))) << "not 1e-30";
    EXPECT_FALSE(std::isfinite(friction_coefficient(4, {0.1, {0.2, -1, 0, 0, 0, 0}}, 0, 1e4)));
    EXPECT_EQ(overflowing_coefficient(4, {0.1, {0.2, -1, 0, 0, 0, 0}}, 1e4), 1U);
    EXPECT_FALSE(std::isfinite(friction_coefficient(1, {0.1, {0, 0, 0, 0, 1e-3, 0}}, 0, 1e200)));
    EXPECT_EQ(overflowing_coefficient(1, {0.1, {0, 0, 0, 0, 1e-3, 0}}, 1e200), 4U);
}

// @manual field Fric; comment 12; departure D39
TEST(FrictionLaw, CoulombIsNotNegative) {
    EXPECT_EQ(friction_coefficient(0, {-0.05, {}}, 10, 10), 0.0);
    EXPECT_EQ(as_built::friction_coefficient({false, true, false}, 0, {-0.05, {}}, 10, 10), -0.05);
}

// Node 0 is in segments of the parts 2, 0 and 1, in this order. The pairs of the /FRICTION name 0 and 1 only. Its part
// is that of the first segment, 2; D42: of the named ones the last of the deck, 1.
// @manual field fric_ID; departure D42
TEST(NodeParts, TheFirstSegmentOrTheLastNamedPart) {
    Model model;
    model.parts.resize(4);
    Surface surface;
    for (const int part : {2, 0, 1}) {
        model.shells.push_back({part + 1, {0, 1, 2, 3}, part, 1.0});
        surface.segments.push_back({{0, 1, 2, 3}, static_cast<int>(model.shells.size()) - 1});
    }
    surface.segments.push_back({{4, 5, 6, 7}, -1});  // on no element
    model.surfaces.push_back(surface);
    FrictionModel friction;
    friction.pairs = {{0, 3, {}}, {3, 1, {}}};
    model.friction_models.push_back(friction);
    Interface card;
    card.secondary_surface = 0;
    card.friction_model = 0;
    card.secondary.node = {0, 1, 2, 3, 4, 5, 6, 7};
    EXPECT_EQ(node_parts(model, card), (std::vector<int>{2, 2, 2, 2, -1, -1, -1, -1}));
    EXPECT_EQ(as_built::node_parts(model, card), (std::vector<int>{1, 1, 1, 1, -1, -1, -1, -1}));
    model.friction_models[0].pairs = {{3, 3, {}}};
    EXPECT_EQ(as_built::node_parts(model, card)[0], -1) << "no pair names a part of it";
}

// @manual comment 12; field Fric, fric_ID
TEST(FrictionLaw, CoulombIsFricAndAPairOfPartsGoesFirst) {
    EXPECT_EQ(friction_coefficient(0, {0.12, {1, 1, 1, 1, 1, 1}}, 10, 10), 0.12);
    Model model;
    Interface card;
    card.fric.value = 0.12;
    card.c[2].value = 7;
    EXPECT_EQ(friction_coefficients(model, card, 0, 1).fric, 0.12);
    EXPECT_EQ(friction_coefficients(model, card, 0, 1).c[2], 7);
    FrictionModel friction;
    friction.fallback.fric = 0.2;
    friction.pairs.push_back({3, 4, {0.35, {}}});
    model.friction_models.push_back(friction);
    card.friction_model = 0;
    EXPECT_EQ(friction_coefficients(model, card, 0, 1).fric, 0.2);
    EXPECT_EQ(friction_coefficients(model, card, 3, 4).fric, 0.35);
    EXPECT_EQ(friction_coefficients(model, card, 4, 3).fric, 0.35);
}

constexpr as_built::FilterDepartures d06{true, false, false};
constexpr as_built::FilterDepartures d07{false, true, false};
constexpr as_built::FilterDepartures d28{false, false, true};

Interface filtered(int ifiltr, double xfreq) {
    Interface card;
    card.ifiltr.value = card.card_ifiltr = ifiltr;
    card.xfreq.value = card.card_xfreq = xfreq;
    return card;
}

// @manual eq 13; field Ifiltr, Xfreq; comment 15; departure D06, D07
TEST(FrictionFilter, Constants) {
    constexpr double turn = 2 * std::numbers::pi;
    EXPECT_EQ(filter_constant(filtered(0, 0.3), 1e-6), 1.0);
    for (const int ifiltr : {1, 2, 3})
        EXPECT_EQ(filter_constant(filtered(ifiltr, 0), 1e-6), 1.0) << "Xfreq 0 is no filter";
    EXPECT_EQ(filter_constant(filtered(1, 0.3), 1e-6), 0.3);
    EXPECT_DOUBLE_EQ(filter_constant(filtered(2, 0.05), 1e-6), turn * 0.05);
    EXPECT_EQ(filter_constant(filtered(2, 0.5), 1e-6), 1.0);
    EXPECT_DOUBLE_EQ(as_built::filter_constant(d07, filtered(2, 20), 1e-6), turn / 20);
    EXPECT_DOUBLE_EQ(filter_constant(filtered(3, 5e4), 1e-6), turn * 0.05);
    EXPECT_EQ(filter_constant(filtered(3, 3e5), 1e-6), 1.0);
    EXPECT_EQ(as_built::filter_constant(d06, filtered(3, 5e4), 1e-6), 1.0);
    EXPECT_DOUBLE_EQ(as_built::filter_constant(d06, filtered(3, 3e5), 1e-6), turn * 0.3);
}

// @manual departure D28
TEST(FrictionFilter, AsBuiltTheCardKeepsItsConstant) {
    Interface card = filtered(1, 0.3);
    card.friction_model = 0;
    card.card_ifiltr = 0;
    card.card_xfreq = 0;
    EXPECT_EQ(filter_constant(card, 1e-6), 0.3);
    EXPECT_EQ(as_built::filter_constant(d28, card, 1e-6), 1.0);
}

// Sticking at constant velocity the force after n cycles is n alpha k v dt: the filter only scales the increment.
// @manual eq 12, 13; comment 14
TEST(FrictionFilter, StepResponse) {
    const double alpha = filter_constant(filtered(1, 0.3), 1e-3);
    Vec3 force = Vec3::Zero();
    for (int n = 1; n <= 10; ++n) {
        force = friction_force(force, alpha * 500, {2, 0, 0}, 1e-3, {0, 0, 1}, 1e9).force;
        ASSERT_NEAR(force.x(), n * 0.3 * 500 * 2 * 1e-3, 1e-12);
    }
}

// @manual eq 19; comment 18; field Fheat
TEST(FrictionEnergy, SlipDissipatesWhatTheSpringDoesNotKeep) {
    // T = 100 * 0.3 = 30, limit 12: the spring keeps 12 / 100 of the way 0.3, slip is 0.18 under the force 12.
    const auto slip = friction_force(Vec3::Zero(), 100, {3, 0, 0}, 0.1, {0, 0, 1}, 12);
    EXPECT_NEAR(slip_energy(slip, 100), 12 * 0.18, 1e-14);
    const auto stick = friction_force(Vec3::Zero(), 100, {3, 0, 0}, 0.1, {0, 0, 1}, 40);
    EXPECT_EQ(slip_energy(stick, 100), 0.0);
    EXPECT_EQ(slip_energy(slip, 0), 0.0);
}

// @manual field Pskid
TEST(SkidLine, IsAnEnvelopeOfSlidingOnly) {
    EXPECT_EQ(skid_ratio(false, 10, 5, 4), 0.0);
    EXPECT_DOUBLE_EQ(skid_ratio(true, 10, 5, 4), 10 * std::sqrt(3.0) / 20);
    EXPECT_EQ(skid_ratio(true, 1000, 5, 4), 1.0);
    SkidLine line(2);
    line.record(1, 0.4);
    EXPECT_EQ(line.record(1, 0.2), 0.4);
    EXPECT_EQ(line.largest(0), 0.0);
}

}  // namespace
}  // namespace type21::reference
