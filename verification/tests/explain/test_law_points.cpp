#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "reference/host/prepare_deck.h"
#include "verification/explain/law_report.h"
#include "verification/support/contact_choice.h"

namespace type21 {
namespace {

std::vector<InterfaceLaws> laws_of(const std::string& name, const std::string& thickness = {}) {
    const std::string folder = std::string(TYPE21_SOURCE_DIR) + "/cases/" + name + "/";
    const PreparedDeck deck =
        prepare_deck(folder + name + "_0000.rad", "none", true, thickness.empty() ? thickness : folder + thickness);
    EXPECT_TRUE(deck.scene) << name;
    return law_points(*deck.scene, contact_maker("reference"), deck.options());
}

// The case drives nodes at 2100, 10500 and 25200 MPa with 200, 1000 and 3000 mm/s: its README.
TEST(LawPoints, LieOnTheLawOfTheirCard) {
    const std::vector<InterfaceLaws> all = laws_of("friction_laws_pv");
    ASSERT_EQ(all.size(), 5U);
    for (const InterfaceLaws& laws : all) {
        ASSERT_GE(laws.friction.size(), 3U) << laws.title;
        ASSERT_EQ(laws.curves.size(), 3U) << laws.title;
        EXPECT_LT(largest_difference(laws), 1e-14) << laws.title;
        for (const FrictionPoint& point : laws.friction) {
            const double on_law =
                point.pressure / laws.pressures.back() * static_cast<double>(laws.pressures.size() - 1);
            const auto below = static_cast<size_t>(on_law);
            for (const FrictionCurve& curve : laws.curves) {
                if (std::abs(curve.speed - point.speed) > 1e-6 * point.speed) continue;
                const double left = curve.mu[below], right = curve.mu[below + 1];
                EXPECT_GE(point.mu, std::min(left, right) - 1e-9) << laws.title;
                EXPECT_LE(point.mu, std::max(left, right) + 1e-9) << laws.title;
            }
        }
    }
    EXPECT_NEAR(all[0].friction[0].mu, 0.12, 1e-12) << "Coulomb";
    const auto slowest = std::min_element(all[1].friction.begin(), all[1].friction.end(),
                                          [](const auto& a, const auto& b) { return a.speed < b.speed; });
    EXPECT_NEAR(slowest->pressure, 2100, 1e-6);
    EXPECT_NEAR(slowest->speed, 200, 1e-9);
    EXPECT_NEAR(slowest->mu, 0.094941, 1e-9) << "law 1, by hand";
}

TEST(LawPoints, ShowThePlateauOfPmax) {
    const std::vector<InterfaceLaws> all = laws_of("pmax_plateau", "thickness.csv");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].pmax, 10);
    double on_plateau = 0, largest = 0;
    for (const NormalPoint& point : all[0].normal) {
        largest = std::max(largest, point.pressure);
        if (point.penetration > 0.0101 && point.penetration < 0.0499) {
            ++on_plateau;
            EXPECT_NEAR(point.pressure, 10, 1e-9) << point.penetration;
        }
    }
    EXPECT_GT(on_plateau, 8);
    EXPECT_GT(largest, 50);
    const PressureLimit& limit = all[0].limit;
    EXPECT_GT(limit.lowered, 1000U);
    EXPECT_LT(limit.lowered, limit.node_cycles);
    EXPECT_GT(limit.plateau, 100U);
    // Pmax/k = 0.01 mm, and the gap grows by 0.05 mm.
    EXPECT_NEAR(limit.first, 0.01, 0.001);
    EXPECT_NEAR(limit.last, 0.05, 1e-9);
    EXPECT_GT(limit.largest, 50);
    EXPECT_TRUE(all[0].friction.empty());
    EXPECT_TRUE(all[0].heat.empty());
}

TEST(LawPoints, CountForceThatPmaxLowersAlsoWhereFewPointsAreDrawn) {
    // 9200 MPa at most: hardly a point of the plateau at 600 MPa is drawn.
    const std::vector<InterfaceLaws> all = laws_of("igap2_pmax_itlim0", "thickness_quad.csv");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_GT(all[0].limit.lowered, all[0].limit.node_cycles / 2);
    EXPECT_GT(all[0].limit.plateau, 100U);
    // The sheet thins first: the force is lowered, and never on the plateau.
    const std::vector<InterfaceLaws> thin = laws_of("igap2_pmax_thin_thick", "thickness_quad.csv");
    ASSERT_EQ(thin.size(), 1U);
    EXPECT_GT(thin[0].limit.lowered, 0U);
    EXPECT_EQ(thin[0].limit.plateau, 0U);
    EXPECT_LT(thin[0].limit.lowered, thin[0].limit.node_cycles);
}

TEST(LawPoints, SayThatPmaxDoesNotActWhileTheGapDoesNotGrow) {
    const std::vector<InterfaceLaws> all = laws_of("pmax_plateau");
    ASSERT_EQ(all.size(), 1U);
    EXPECT_GT(all[0].limit.node_cycles, 0U);
    EXPECT_EQ(all[0].limit.lowered, 0U);
    EXPECT_EQ(all[0].limit.plateau, 0U);
}

TEST(LawPoints, ShowTheHeatThatFlows) {
    const std::vector<InterfaceLaws> all = laws_of("therm_cond");
    ASSERT_FALSE(all.empty());
    EXPECT_FALSE(all[0].heat.empty());
    const auto json = to_json(all, {});
    EXPECT_EQ(json["interfaces"][0]["heat"].size(), all[0].heat.size());
    EXPECT_NE(to_text(all, {}).find("heat flows"), std::string::npos);
}

TEST(LawPoints, ADifferenceOfTheLawsIsSeen) {
    InterfaceLaws laws;
    laws.curves = {{100, {0.1, 0.2}, {0.1, 0.2}}};
    EXPECT_EQ(largest_difference(laws), 0);
    laws.curves[0].mu_optimized[1] = 0.21;
    EXPECT_NEAR(largest_difference(laws), 0.05, 1e-12);
}

}  // namespace
}  // namespace type21
