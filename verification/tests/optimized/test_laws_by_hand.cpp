// The laws of the optimized contact one by one, by hand; those of the reference have tests of the same numbers.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "optimized/kernel/adaptive_law.h"
#include "optimized/kernel/friction_law.h"
#include "optimized/kernel/gap_law.h"
#include "optimized/kernel/heat_law.h"
#include "optimized/kernel/normal_law.h"

namespace type21::optimized {
namespace {

AsBuilt with(Departure departure) {
    AsBuilt as_built;
    as_built.set(departure);
    return as_built;
}

const AsBuilt page;

// k = 1000, the gap has grown by 0.05, P_A = 10: slope to p = 0.01, plateau to 0.05, slope again.
// @manual eq 5; field Pmax; comment 5
TEST(OptimizedLaws, TheSpringYieldsBetweenTwoSlopes) {
    EXPECT_DOUBLE_EQ(yielding_spring(1000, 0.005, 0.05, 10).force, 5);
    EXPECT_DOUBLE_EQ(yielding_spring(1000, 0.03, 0.05, 10).force, 10);
    EXPECT_NEAR(yielding_spring(1000, 0.10, 0.05, 10).force, 60, 1e-12);
    EXPECT_NEAR(yielding_spring(1000, 0.10, 0.05, 10).energy, 0.05 + 0.4 + 1.75, 1e-12);
    EXPECT_DOUBLE_EQ(yielding_spring(1000, 0.10, 0.01, 10).force, 100) << "k times the growth does not exceed P_A";
}

// @manual field Inacti; comment 9
TEST(OptimizedLaws, OffsetOfTimeZero) {
    EXPECT_EQ(offset_at_start(0, 0.2, 0.5, 5.0), 0.0);
    EXPECT_EQ(offset_at_start(5, 0.2, 0.5, 5.0), 0.2);
    EXPECT_DOUBLE_EQ(offset_at_start(6, 0.2, 0.5, 5.0), 0.2 + 0.05 * 5.3);
}

// @manual field Inacti; comment 9
TEST(OptimizedLaws, OffsetFollowsADecreasingPenetration) {
    EXPECT_DOUBLE_EQ(offset_after(0.2, false, 0.1, 0.5), 0.195);
    EXPECT_EQ(offset_after(0.2, false, 0.3, 0.5), 0.2) << "it never grows";
    EXPECT_DOUBLE_EQ(offset_after(0.2, true, 0.1, 0.5), 0.95 * 0.2 + 0.05 * (0.1 + 0.05 * 0.4));
}

// 0.8 * 3 / 2 + 0.8 * (2.3 - 2) / 2 = 1.32 with Thick 3; without it 0.92; with D30 from the clipped gap of time 0.
// @manual eq 2, 4; field Igap, Fscalegap, Gapmin, Gapmax; comment 2; departure D30
TEST(OptimizedLaws, TheGapFollowsTheThickestShell) {
    ContactModel model;
    model.shells = {{1, {0, 1, 2, 3}, 0, 2.0}, {2, {0, 4, 5, 6}, 0, 2.0}};
    model.parts.resize(1);
    model.parts[0].material = 0;
    model.materials.resize(1);
    model.materials[0].law = MaterialLaw::elastic;
    Interface card;
    card.fscalegap.value = 0.8;
    card.gapmax.value = 5;
    card.secondary.node = {0};
    card.secondary.thickness = {2.0};
    card.secondary.contact_thickness = {3.0};
    card.secondary.gap = {0.7};
    const std::vector<double> now{2.3, 2.1};
    const auto gap = [&] { return GapLaw(model, card).at(0, now); };
    EXPECT_NEAR(gap().clipped, 1.32, 1e-15);
    card.secondary.contact_thickness = {0.0};
    EXPECT_NEAR(gap().clipped, 0.92, 1e-15);
    card.gapmax.value = 0.9;
    EXPECT_NEAR(gap().raw, 0.92, 1e-15);
    EXPECT_EQ(gap().clipped, 0.9);
    card.gapmin.value = 0.95;
    EXPECT_EQ(gap().clipped, 0.95);
    card.gapmin.value = 0;
    model.as_built.set(Departure::D30);
    EXPECT_NEAR(gap().clipped, 0.82, 1e-15);
}

// p = 0.2 and s = 0.5 in law 1; p = 2 and s = 0.5 in law 2.
// @manual eq 9, 10, 11; field Ifric; comment 13; departure D10
TEST(OptimizedLaws, CoefficientsOfPressureAndSpeed) {
    const FrictionCoefficients viscous{0.1, {0.1, 0.2, 0.3, 0.4, 0.5, 0}};
    EXPECT_NEAR(FrictionLaw(1, page).coefficient(viscous, 0.2, 0.5, 1), 0.1 + 0.02 + 0.1 + 0.03 + 0.016 + 0.125, 1e-15);
    const FrictionCoefficients darmstadt{0.1, {0.1, 1, 0.2, 2, 0.3, 3}};
    EXPECT_NEAR(FrictionLaw(2, page).coefficient(darmstadt, 2, 0.5, 1),
                0.1 + 0.4 * std::exp(0.5) + 0.4 * std::exp(1.0) + 0.3 * std::exp(1.5), 1e-15);
    const FrictionCoefficients renard{0, {0.10, 0.12, 0.20, 0.08, 1, 3}};
    EXPECT_DOUBLE_EQ(FrictionLaw(3, page).coefficient(renard, 9, 0, 1), 0.10);
    EXPECT_DOUBLE_EQ(FrictionLaw(3, page).coefficient(renard, 9, 1, 1), 0.20);
    EXPECT_DOUBLE_EQ(FrictionLaw(3, page).coefficient(renard, 9, 2, 1), 0.14) << "half way from C3 to C4";
    EXPECT_NEAR(FrictionLaw(3, page).coefficient(renard, 9, 3, 1), 0.08, 1e-15);
    EXPECT_NEAR(FrictionLaw(3, page).coefficient(renard, 9, 1e6, 1), 0.12, 1e-11);
    const FrictionCoefficients decay{0.3, {0.1, 2, 0, 0, 0, 0}};
    EXPECT_NEAR(FrictionLaw(4, page).coefficient(decay, 9, 0.5, 1), 0.1 + 0.2 * std::exp(-1.0), 1e-15);
    EXPECT_EQ(FrictionLaw(4, with(Departure::D10)).coefficient(decay, 9, 0, 1), 1e-30) << "0.2 - 0.3, then the floor";
    EXPECT_DOUBLE_EQ(FrictionLaw(0, page).coefficient(decay, 9, 0.5, 1.2), 0.36) << "Fric f_IDF";
}

// Terms with the coefficient 0 are 0, also beside an exponential or a square beyond double; D43: the least coefficient.
// @manual eq 9, 10, 11; field Ifric; comment 13; departure D10, D39, D43
TEST(OptimizedLaws, ATermWithoutCoefficientIsNothing) {
    const FrictionLaw law_2(2, page), built_2(2, with(Departure::D43)), law_4(4, page),
        built_4(4, with(Departure::D43));
    EXPECT_EQ(law_2.coefficient({0.1, {0, 1, 0, 2, 0, 3}}, 2, 1e4, 1), 0.1);
    EXPECT_EQ(built_2.coefficient({0.1, {0, 1, 0, 2, 0, 3}}, 2, 1e4, 1), 1e-30);
    EXPECT_EQ(law_2.coefficient({0.1, {0.2, 1, 0.3, 1, 0, 0}}, 0, 1e4, 1), 0.1) << "no pressure, no term of it";
    EXPECT_EQ(law_4.coefficient({0.1, {0.1, -1, 0, 0, 0, 0}}, 2, 1e4, 1), 0.1) << "Fric = C1";
    EXPECT_EQ(built_4.coefficient({0.1, {0.1, -1, 0, 0, 0, 0}}, 2, 1e4, 1), 1e-30);
    EXPECT_EQ(FrictionLaw(1, page).coefficient({0.1, {}}, 2, 1e200, 1), 0.1);
    const FrictionCoefficients overflow{0.1, {0.2, 1, 0.3, 1, 0.4, 5}};
    EXPECT_FALSE(std::isfinite(law_2.coefficient(overflow, 2, 1e4, 1)));
    EXPECT_EQ(law_2.overflowing(overflow, 1e4), 1);
    EXPECT_EQ(law_2.overflowing({0.1, {0, 1, 0, 2, 0.4, 5}}, 1e4), 5);
    EXPECT_TRUE(std::isfinite(built_2.coefficient(overflow, 2, 1e4, 1)));
    EXPECT_FALSE(std::isfinite(law_4.coefficient({0.1, {0.2, -1, 0, 0, 0, 0}}, 2, 1e4, 1))) << "- infinite, too";
    EXPECT_EQ(FrictionLaw(0, page).coefficient({0.1, {}}, 2, 1, -0.5), 0.0);
    EXPECT_EQ(FrictionLaw(0, with(Departure::D39)).coefficient({0.1, {}}, 2, 1, -0.5), -0.05);
}

// Node 0 is in segments of the parts 2, 0 and 1; the pairs name 0 and 1. The first segment has no pair: the default
// 0.1. D42: part 1 and the pair with it, 0.3.
// @manual field fric_ID; departure D42
TEST(OptimizedLaws, ANodeOfSeveralParts) {
    ContactModel model;
    model.parts.resize(4);
    model.surfaces.resize(2);
    for (const int part : {2, 0, 1, 3}) {
        model.shells.push_back({part + 1, {0, 0, 0, 0}, part, 1.0});
        model.surfaces[part == 3 ? 1 : 0].segments.push_back({{0, 0, 0, 0}, static_cast<int>(model.shells.size()) - 1});
    }
    FrictionModel friction;
    friction.fallback.fric = 0.1;
    friction.pairs = {{0, 3, {0.2, {}}}, {3, 1, {0.3, {}}}};
    model.friction_models.push_back(friction);
    Interface card;
    card.secondary_surface = 0;
    card.main_surface = 1;
    card.friction_model = 0;
    card.secondary.node = {0};
    EXPECT_EQ(FrictionTable(model, card).at(0, 0).fric, 0.1);
    model.as_built.set(Departure::D42);
    EXPECT_EQ(FrictionTable(model, card).at(0, 0).fric, 0.3);
}

// A node of part 0 over main segments of parts 1 and 2; the pair (1, 0) is listed.
// @manual field fric_ID
TEST(OptimizedLaws, AListedPairOfPartsGoesFirst) {
    ContactModel model;
    model.shells = {{1, {0, 1, 2, 3}, 0, 1.0}, {2, {4, 5, 6, 7}, 1, 1.0}, {3, {4, 5, 6, 7}, 2, 1.0}};
    model.surfaces.resize(2);
    model.surfaces[0].segments = {{{0, 1, 2, 3}, 0}};
    model.surfaces[1].segments = {{{4, 5, 6, 7}, 1}, {{4, 5, 6, 7}, 2}};
    model.friction_models.resize(1);
    model.friction_models[0].fallback.fric = 0.2;
    model.friction_models[0].pairs = {{1, 0, {0.3, {}}}};
    Interface card;
    card.secondary_surface = 0;
    card.main_surface = 1;
    card.friction_model = 0;
    card.fric.value = 0.1;
    card.secondary.node = {0, 1, 2, 3};
    EXPECT_EQ(FrictionTable(model, card).at(0, 0).fric, 0.3);
    EXPECT_EQ(FrictionTable(model, card).at(0, 1).fric, 0.2);
    card.friction_model = -1;
    EXPECT_EQ(FrictionTable(model, card).at(0, 0).fric, 0.1);
}

// @manual eq 13; field Ifiltr, Xfreq; comment 15; departure D06, D07, D28
TEST(OptimizedLaws, FilterShares) {
    const double turn = 2 * std::numbers::pi;
    Interface card;
    const auto share = [&](int ifiltr, double xfreq, const AsBuilt& as_built) {
        card.ifiltr.value = ifiltr;
        card.xfreq.value = xfreq;
        return filter_share(card, 1e-3, as_built);
    };
    EXPECT_EQ(share(0, 0.5, page), 1.0);
    EXPECT_EQ(share(1, 0.5, page), 0.5);
    EXPECT_DOUBLE_EQ(share(2, 0.1, page), turn * 0.1);
    EXPECT_EQ(share(2, 0.5, page), 1.0) << "never above 1";
    EXPECT_DOUBLE_EQ(share(2, 10, with(Departure::D07)), turn / 10);
    EXPECT_DOUBLE_EQ(share(3, 20, page), turn * 20e-3);
    EXPECT_EQ(share(3, 20, with(Departure::D06)), 1.0);
    card.friction_model = 0;
    card.card_ifiltr = 1;
    card.card_xfreq = 0.25;
    EXPECT_EQ(share(2, 0.1, with(Departure::D28)), 0.25) << "that of the card";
}

// T = 10 (0.3, 0, 5) = (3, 0, 50); its part along z goes.
// @manual eq 12; comment 14
TEST(OptimizedLaws, TheTrialForceReturnsToItsLimit) {
    const V3 z{0, 0, 1};
    const Tangential sticks = returned_to_limit({0, 0, 0}, {0.3, 0, 5}, 10, z, 5);
    EXPECT_FALSE(sticks.slides);
    EXPECT_NEAR(sticks.force.x, 3, 1e-15);
    EXPECT_NEAR(sticks.force.z, 0, 1e-14);
    const Tangential slides = returned_to_limit({0, 4, 0}, {0.3, 0, 5}, 10, z, 2.5);
    EXPECT_TRUE(slides.slides);
    EXPECT_NEAR(slides.force.x, 1.5, 1e-14);
    EXPECT_NEAR(slides.force.y, 2.0, 1e-14);
    EXPECT_NEAR(slides.trial.y, 4.0, 1e-14);
}

// @manual field Pskid
TEST(OptimizedLaws, SkidShare) {
    EXPECT_DOUBLE_EQ(skid_share(300, 1000, 2), 300 * std::sqrt(3.0) / 2000);
    EXPECT_EQ(skid_share(3000, 1000, 2), 1.0);
    EXPECT_EQ(skid_share(300, 1000, 0), 0.0);
}

/// One node of area 4, k_s = 50 + 0.02 T, Kthe 20; T_s = 300, T_m = 500, dt = 1e-3.
struct Warm {
    Warm() {
        model.nodes.position = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
        model.shells = {{1, {0, 1, 2, 3}, 0, 1.0}};
        model.parts.resize(1);
        model.parts[0].material = 0;
        model.materials.resize(1);
        model.materials[0].heat = HeatMaterial{300, 0.036, 50, 0.02};
        card.ithe.value = 1;
        card.kthe.value = 20;
        card.ascalek.value = 1;
        card.secondary.node = {0};
        card.secondary.area = {4};
    }
    double to_node(double distance, double force = 0) const {
        return HeatLaw(model, card)(0, distance, 0.5, force, 300, 500, 1e-3).to_node;
    }
    ContactModel model;
    Interface card;
};

// @manual eq 14, 15; field Ithe, Kthe, fct_IDK, AscaleK; comment 16; departure D38
TEST(OptimizedLaws, ConductionFollowsDistanceAndPressure) {
    Warm warm;
    EXPECT_NEAR(warm.to_node(-0.1), 4 * 200 * 1e-3 * 20, 1e-13);
    EXPECT_NEAR(warm.to_node(0.3), 4 * 200 * 1e-3 / (0.3 / 56 + 1 / 20.0), 1e-13);
    EXPECT_EQ(warm.to_node(0.6), 0.0) << "beyond the gap";
    warm.card.function_conduction = 0;
    warm.card.ascalek.value = 2;
    warm.model.functions.push_back({1, "", {0.0, 100.0}, {1.0, 3.0}});
    EXPECT_NEAR(warm.to_node(0.3, -200), 4 * 200 * 1e-3 / (0.3 / 56 + 1 / 30.0), 1e-13) << "f_K(50 / 2) = 1.5";
    warm.model.as_built.set(Departure::D38);
    EXPECT_NEAR(warm.to_node(0.3, -200), 4 * 200 * 1e-3 / (0.3 / 56 + 1 / 60.0), 1e-13) << "D38: f_K(2 x 50) = 3";
}

// Half way from the gap to Dcond f is 0.5: K = 10 in series with the sheet over the gap; D32 takes half of the whole.
// @manual eq 20; field Fcond, Dcond; comment 22, 23; departure D32
TEST(OptimizedLaws, ConductionOverTheDistance) {
    Warm warm;
    warm.card.function_distance = 0;
    warm.card.dcond.value = 1.5;
    warm.model.functions.push_back({1, "", {0.0, 1.0}, {1.0, 0.0}});
    EXPECT_NEAR(warm.to_node(1.0), 4 * 200 * 1e-3 / (0.5 / 56 + 1 / 10.0), 1e-13);
    EXPECT_EQ(warm.to_node(1.6), 0.0);
    warm.model.as_built.set(Departure::D32);
    EXPECT_NEAR(warm.to_node(1.0), 0.5 * 4 * 200 * 1e-3 / (0.5 / 56 + 1 / 20.0), 1e-13);
}

// @manual eq 16, 17; field Frad, Drad; comment 17, 23; departure D15
TEST(OptimizedLaws, RadiationUpToDrad) {
    Warm warm;
    warm.card.frad.value = 5.67e-8;
    warm.card.drad.value = 1.0;
    const double radiated = 4 * 5.67e-8 * (std::pow(500.0, 4) - std::pow(300.0, 4)) * 1e-3;
    EXPECT_NEAR(warm.to_node(0.9), radiated, 1e-12 * radiated);
    EXPECT_EQ(warm.to_node(1.1), 0.0);
    warm.model.as_built.set(Departure::D15);
    EXPECT_NEAR(warm.to_node(1.1), radiated, 1e-12 * radiated) << "the distance beyond the gap";
}

/// A strip of three quads on a cylinder of radius 10 about y, each over an angle of 0.2: the nodal normals of the
/// middle one turn by 0.2, so that its radius is 10. One element of the blank, 3 by 2, lies on it with 0.1 of its gap
/// 0.5.
struct Strip {
    Strip() {
        for (const double angle : {-0.3, -0.1, 0.1, 0.3})
            for (const double y : {0.0, 3.0})
                model.nodes.position.emplace_back(10 * std::sin(angle), y, 10 * std::cos(angle));
        for (const Vec3& x : {Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(3, 2, 0), Vec3(0, 2, 0)})
            model.nodes.position.push_back(x);
        for (size_t node = 0; node < model.nodes.position.size(); ++node)
            model.nodes.id.push_back(static_cast<Id>(node) + 1);
        model.surfaces.resize(2);
        model.surfaces[0].segments = {{{0, 2, 3, 1}, -1}, {{2, 4, 5, 3}, -1}, {{4, 6, 7, 5}, -1}};
        model.surfaces[1].segments = {{{8, 9, 10, 11}, -1}};
        model.rigid_bodies.resize(1);
        for (int node = 0; node < 8; ++node)
            model.rigid_bodies[0].nodes.push_back(node);
        card.main_surface = 0;
        card.secondary_surface = 1;
        card.tool = 0;
        card.main_nodes = model.rigid_bodies[0].nodes;
        card.secondary.node = {8, 9, 10, 11};
        card.iadm.value = 2;
        card.nradm.value = 1;
    }
    AdaptiveElement element() const {
        std::vector<NodeContact> nodes(4);
        nodes[2].penetration = 0.1;
        nodes[2].gap = 0.5;
        nodes[2].decision.segment = 1;
        return AdaptiveLaw(model, card, Tool(model, card)).elements(nodes, model.nodes.position)[0];
    }
    ContactModel model;
    Interface card;
};

// @manual field Iadm, NRadm, Padm, Angladm; comment 3; departure D37
TEST(OptimizedLaws, AnElementDividesOnASmallRadiusOrASharpTurn) {
    Strip strip;
    strip.card.padm.value = 1;
    const AdaptiveElement element = strip.element();
    EXPECT_NEAR(element.radius, 10, 1e-12);
    EXPECT_NEAR(element.cosine, std::cos(0.1), 1e-15);
    EXPECT_DOUBLE_EQ(element.longest_edge, 3);
    EXPECT_DOUBLE_EQ(element.penetration, 0.2);
    strip.card.nradm.value = 3;
    EXPECT_FALSE(strip.element().divide) << "10 > 3 * 3";
    strip.model.as_built.set(Departure::D37);
    EXPECT_TRUE(strip.element().divide) << "10 < 3 * 3 sqrt 2";
    strip.model.as_built.set(Departure::D37, false);
    strip.card.nradm.value = 4;
    EXPECT_TRUE(strip.element().divide) << "10 < 4 * 3";
    strip.card.iadm.value = 1;
    EXPECT_FALSE(strip.element().divide) << "10 > 3";
    strip.card.iadm.value = 2;
    strip.card.nradm.value = 1;
    strip.card.padm.value = 0.1;
    strip.card.angladm.value = 5;
    EXPECT_TRUE(strip.element().divide) << "0.1 rad > 5 deg, and 0.2 > Padm";
    strip.card.angladm.value = 6;
    EXPECT_FALSE(strip.element().divide) << "0.1 rad < 6 deg";
    strip.card.angladm.value = 5;
    strip.card.padm.value = 0.3;
    EXPECT_FALSE(strip.element().divide);
}

}  // namespace
}  // namespace type21::optimized
