// The pressure limit of a thickening sheet, the growing gap, adaptive data and deletion.
#include <cmath>

#include <gsl/gsl_integration.h>
#include <gtest/gtest.h>

#include "reference/as_built/d30_d33_gap.h"
#include "reference/as_built/d35_d37_limits.h"
#include "reference/contact/adaptive_data.h"
#include "reference/contact/deletion.h"
#include "reference/contact/gap_growth.h"
#include "reference/contact/pmax_limit.h"
#include "reference/model/model.h"

namespace type21::reference {
namespace {

// k = 1000, A = 1, Pmax = 10, Delta = 0.05: the plateau of the anchors, F = 10 from p = 0.01 to 0.05, then slope k
// again.
constexpr double k = 1000;
constexpr PmaxLimit plateau{0.05, 10};

// @manual eq 5; field Pmax; comment 5
TEST(PmaxLimit, PlateauBetweenTwoSlopes) {
    EXPECT_DOUBLE_EQ(limited_force(k, 0.005, plateau), 5);
    EXPECT_DOUBLE_EQ(limited_force(k, 0.01, plateau), 10);
    EXPECT_DOUBLE_EQ(limited_force(k, 0.03, plateau), 10);
    EXPECT_DOUBLE_EQ(limited_force(k, 0.05, plateau), 10);
    EXPECT_NEAR(limited_force(k, 0.06, plateau), 20, 1e-12);
    EXPECT_NEAR(limited_force(k, 0.10, plateau), 60, 1e-12);
}

TEST(PmaxLimit, DoesNotActWhileTheSheetHasGrownLittle) {
    const PmaxLimit little{0.01, 10};  // k Delta = P_A: not yet
    EXPECT_FALSE(limited(k, little));
    EXPECT_DOUBLE_EQ(limited_force(k, 0.1, little), 100);
    EXPECT_DOUBLE_EQ(limited_energy(k, 0.1, little), 5);
}

double force_of(double p, void*) {
    return limited_force(k, p, plateau);
}

// The energy against adaptive quadrature of the force, on all three pieces.
// @manual eq 5; field Pmax
TEST(PmaxLimit, EnergyIsTheIntegralOfTheForce) {
    gsl_integration_workspace* space = gsl_integration_workspace_alloc(100);
    const gsl_function force{force_of, nullptr};
    for (const double p : {0.004, 0.01, 0.02, 0.05, 0.07, 0.1}) {
        double kinks[] = {0, std::min(0.01, p * 0.5), std::min(0.05, p * 0.75), p};
        double integral = 0;
        double error = 0;
        gsl_integration_qagp(&force, kinks, 4, 0, 1e-12, 100, space, &integral, &error);
        EXPECT_NEAR(limited_energy(k, p, plateau), integral, 1e-9 * integral) << p;
    }
    gsl_integration_workspace_free(space);
    EXPECT_NEAR(limited_energy(k, 0.1, plateau), 0.05 + 0.4 + 1.75,
                1e-12);  // triangle, plateau, trapezium 10..60 over 0.05
}

// @manual eq 6; field Pmax, ITlim; comment 5
TEST(PmaxLimit, TangentialForceStopsAtTheShearYield) {
    EXPECT_DOUBLE_EQ(tangential_limit(600), 600 / std::sqrt(3.0));
}

Interface growing(double fscale, double gapmin, double gapmax) {
    Interface card;
    card.fscalegap.value = fscale;
    card.gapmin.value = gapmin;
    card.gapmax.value = gapmax;
    return card;
}

// @manual eq 2; field Fscalegap, Gapmin, Gapmax, Igap; comment 2; departure D30
TEST(GapGrowth, FollowsTheThickness) {
    const Interface card = growing(0.8, 0.1, 0.9);
    // t0 = 2, now 2.3: 0.8 (2 / 2 + 0.3 / 2) = 0.92, clipped to 0.9
    const NodalGap gap = grown_gap(card, {2.0, 0.3, 0.8});
    EXPECT_NEAR(gap.raw, 0.92, 1e-15);
    EXPECT_EQ(gap.clipped, 0.9);
    EXPECT_EQ(grown_gap(card, {2.0, -3.0, 0.8}).clipped, 0.1);  // g_s stops at 0, g at Gapmin
    EXPECT_EQ(grown_gap(card, {2.0, -3.0, 0.8}).raw, 0.0);
    // D30 starts from the bounded gap: with Gapmax 0.7 at time 0 the gap stays 0.7 until the sheet has lost 0.25 ...
    const Interface low = growing(0.8, 0.0, 0.7);
    EXPECT_EQ(grown_gap(low, {2.0, -0.2, 0.7}).clipped, 0.7);                      // 0.8 - 0.08 = 0.72
    EXPECT_NEAR(as_built::grown_gap(low, {2.0, -0.2, 0.7}).clipped, 0.62, 1e-15);  // 0.7 - 0.08
}

// @manual departure D33
TEST(GapGrowth, ANodesOwnGapDecidesContact) {
    Interface card = growing(1.0, 0.1, 0.9);
    card.largest_gap = 0.6;
    EXPECT_EQ(search_gap(card, {0.5, 0.5}), 0.5);
    EXPECT_EQ(as_built::search_gap(card, {0.5, 0.5}), 0.6);
    EXPECT_EQ(as_built::search_gap(card, {1.2, 0.9}), 0.9);
}

// A node of two shells, 2 thick at time 0 and 2.3 the thicker one now; its part has Thick 3.
// 0.8 * 3 / 2 + 0.8 * (2.3 - 2) / 2 = 1.32; without Thick it starts from 0.8 * 2 / 2.
// @manual eq 2, 4; field Igap, Fscalegap; comment 2
TEST(GapGrowth, StartsFromTheContactThickness) {
    Model model;
    model.shells = {{1, {0, 1, 2, 3}, 0, 2.0}, {2, {0, 4, 5, 6}, 0, 2.0}};
    model.parts.resize(1);
    model.parts[0].material = 0;
    model.materials.resize(1);
    model.materials[0].law = MaterialLaw::elastic;
    Interface card = growing(0.8, 0.1, 5.0);
    card.secondary.node = {0};
    card.secondary.thickness = {2.0};
    card.secondary.contact_thickness = {3.0};
    card.secondary.gap = {1.2};
    const std::vector<double> now{2.3, 2.1};
    EXPECT_NEAR(grown_gap(card, GapGrowth(model, card).sheet(0, now)).clipped, 1.32, 1e-15);
    EXPECT_NEAR(grown_gap(card, GapGrowth(model, card).sheet(0, {})).clipped, 1.2, 1e-15);
    card.secondary.contact_thickness = {0.0};
    EXPECT_NEAR(grown_gap(card, GapGrowth(model, card).sheet(0, now)).clipped, 0.92, 1e-15);
}

// @manual field Idel
TEST(Deletion, ANodeLeavesWithItsLastShell) {
    Model model;
    model.shells = {{1, {0, 1, 2, 3}, 0, 1.0}, {2, {1, 4, 5, 2}, 0, 1.0}};
    model.parts.resize(1);
    model.parts[0].material = 0;
    model.materials.resize(1);
    Interface card;
    card.secondary.node = {0, 1, 2, 3, 4, 5};
    const Deletion deletion(model, card);
    const std::vector<double> thickness{0.0, 0.8};
    EXPECT_TRUE(deletion.deleted(0, thickness));
    EXPECT_FALSE(deletion.deleted(1, thickness));
    EXPECT_FALSE(deletion.deleted(0, {}));
}

// A cylinder of radius 10 about the y axis: the quad spans the angle 0.2, its normals turn by 0.2 over the chord 20 sin
// 0.1.
// @manual comment 3
TEST(AdaptiveData, RadiusFromTheTurningOfNormals) {
    SegmentShape<double> s;
    const auto at = [](double angle, double y) { return Vec3(10 * std::sin(angle), y, 10 * std::cos(angle)); };
    s.node = {at(-0.1, 0), at(0.1, 0), at(0.1, 3), at(-0.1, 3)};
    for (size_t j = 0; j < 4; ++j)
        s.normal[j] = Vec3(s.node[j].x(), 0, s.node[j].z()).normalized();
    const SegmentCurvature curvature = segment_curvature(s);
    EXPECT_NEAR(curvature.radius, 10.0, 1e-12);  // chord 20 sin 0.1 over 2 sin 0.1
    EXPECT_NEAR(curvature.cosine, std::cos(0.1), 1e-15);
    for (Vec3& n : s.normal)
        n = Vec3(0, 0, 1);
    EXPECT_GT(segment_curvature(s).radius, 1e15);  // flat
}

// @manual field Iadm, NRadm, Padm, Angladm; comment 3; departure D37
TEST(AdaptiveData, WhenToDivide) {
    Interface card;
    card.iadm.value = 1;
    card.nradm.value = 3;
    card.padm.value = 0.5;
    card.angladm.value = 30;
    AdaptiveElement element{4.0, std::cos(0.6), 0.6, 3.0, false};
    EXPECT_FALSE(divides(card, element));                                   // 4 > 3
    EXPECT_TRUE(divides(card, element, as_built::division_radius_factor));  // 4 < 4.24
    card.iadm.value = 2;
    EXPECT_TRUE(divides(card, element));  // 4 < 9
    element.radius = 10;
    EXPECT_TRUE(divides(card, element));  // 0.6 rad > 30 deg and 0.6 > Padm
    element.penetration = 0.4;
    EXPECT_FALSE(divides(card, element));
    element.penetration = 0.6;
    element.cosine = std::cos(0.5);
    EXPECT_FALSE(divides(card, element));
}

}  // namespace
}  // namespace type21::reference
