// Each departure is put in where it belongs, and nothing else changes with it.
#include <functional>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "reference/as_built/reading_of.h"
#include "small_scene.h"

namespace type21::reference {
namespace {

/// One number of each variation point, all of them different as documented and as built.
std::map<std::string, double> numbers_of(const ContactModel& model, const Interface& card) {
    const ContactReading reading = as_built::reading_of(model, card);
    const SegmentShape<double> square{{Vec3(-1, -1, 0), {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                                      {Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitZ()},
                                      false};
    const ContactReach<double> reach{0.5, 1.0, 2.0};
    const auto competes = [&](const ImpactReading& how) {
        return !how.competes || how.competes({5, 0, 0}, square, reach);
    };
    Projection<double> projection;
    projection.weights = {0.25, 0.25};
    projection.normal = {0.6, 0, 0.8};
    projection.height = projection.slope = 1;
    const ToolMotion pose;
    const RetainedProjection retained{square, 1, projection, {0, -0.4, 0.3}, {0, -0.4, 0.3}, pose};
    return {
        {"grown gap", reading.grown_gap(card, {2.0, 0.2, 0.7}).raw},
        {"search gap", reading.search_gap(card, {0.3, 0.3})},
        {"lowest weight", reading.impact.limits.low},
        {"lift leaning", reading.impact.limits.lift_leaning},
        {"competes", competes(reading.impact)},
        {"reach", reading.impact.reach(reach, 0.25).gap},
        {"proximity competes", reading.impact.proximity_competes},
        {"normal", reading.impact.geometry(retained).normal.x()},
        {"first lowest weight", reading.first_impact.limits.low},
        {"first lift leaning", reading.first_impact.limits.lift_leaning},
        {"first competes", competes(reading.first_impact)},
        {"first reach", reading.first_impact.reach(reach, 0.25).gap},
        {"first proximity competes", reading.first_impact.proximity_competes},
        {"first normal", reading.first_impact.geometry(retained).normal.x()},
        {"proximity has force", reading.proximity_has_force},
        {"Inacti later", reading.inacti_of_later_impacts(6, false)},
        {"counts without penetration", reading.counts_without_penetration},
        {"stiffness", reading.nodal_stiffness(card, 1000)},
        {"energy", reading.elastic_energy(10, 2)},
        {"friction stiffness", reading.friction_stiffness(card, 500, 1000)},
        {"friction temperature", reading.friction_temperature(card, 300, 900)},
        {"friction coefficient", reading.friction_coefficient(4, {0.3, {0.1, 0, 0, 0, 0, 0}}, 0, 0)},
        {"friction below zero", reading.friction_coefficient(0, {-0.1, {}}, 0, 0)},
        {"friction overflow", reading.friction_coefficient(2, {0.3, {0, 1, 0, 0, 0, 0}}, 1, 1e4)},
        {"part", reading.node_parts(model, card)[0]},
        {"filter", reading.filter_constant(card, 0.25)},
        {"heat reach", reading.heat_reach(card)},
        {"zones", reading.heat_zones(card, 3.2, 0.5).radiation},
        {"conduction abscissa", reading.conduction_abscissa(card, 100)},
        {"conductance", reading.distance_conductance(20, 0.5, 0.5, 50)},
        {"friction heat", reading.friction_heat_to_tool},
        {"division", reading.division_radius_factor},
        {"tool damping", reading.tool_damping_stiffness({1, 2}, {3, 4}).rotation},
        {"damped inertia", reading.damped_inertia(model.rigid_bodies[0], Mat3::Identity(), {0, 0, 2})},
    };
}

/// The variation points that change when one departure is switched on.
std::string changed_by(Departure departure, const std::function<void(Interface&)>& edit = {}) {
    SceneBuilder small = test::over_a_square({{0.2, 0.1, 0.6}});
    Interface& card = small.card();
    card.stmax.value = 800;
    card.stfac.value = 1;
    card.fscalegap.value = 1;
    card.largest_gap = 0.6;
    card.ascalef.value = card.ascalek.value = 2;
    small.model().rigid_bodies[0].inertia = Vec3(1, 2, 3).asDiagonal();
    // The node of the blank is on a shell of part 0 and then on one of part 1; the pair of /FRICTION names the second.
    const int node = small.blank_node(0);
    small.model().parts.resize(2);
    small.model().shells = {{1, {node, node, node, node}, 0, 1.0}, {2, {node, node, node, node}, 1, 1.0}};
    small.model().surfaces[static_cast<size_t>(card.secondary_surface)].segments = {{{node, node, node, node}, 0},
                                                                                    {{node, node, node, node}, 1}};
    small.model().friction_models.emplace_back().pairs.push_back({1, -1, {}});
    card.tint.value = 500;
    card.ithe.value = 1;
    card.drad.value = 3;
    card.ifiltr.value = card.card_ifiltr = 3;
    card.xfreq.value = card.card_xfreq = 0.1;
    if (edit) edit(card);
    const auto before = numbers_of(small.model(), card);
    small.model().as_built.set(departure);
    std::string changed;
    for (const auto& [name, value] : numbers_of(small.model(), card))
        if (value != before.at(name)) changed += (changed.empty() ? "" : ", ") + name;
    return changed;
}

// @manual departure D01, D04, D05, D06, D07, D08, D10, D13, D28, D39, D40, D42, D43
TEST(ContactReading, EachForceDepartureHasItsPlace) {
    EXPECT_EQ(changed_by(Departure::D01), "stiffness");
    EXPECT_EQ(changed_by(Departure::D04), "friction stiffness");
    EXPECT_EQ(changed_by(Departure::D05), "") << "with Istf 1 only";
    EXPECT_EQ(changed_by(Departure::D05, [](Interface& card) { card.istf.value = 1; }), "energy");
    EXPECT_EQ(changed_by(Departure::D05, [](Interface& card) { card.istf.value = 1, card.igap.value = 2; }), "")
        << "not with Igap 2";
    EXPECT_EQ(changed_by(Departure::D06), "filter");
    EXPECT_EQ(changed_by(Departure::D07), "") << "with Ifiltr 2 only";
    EXPECT_EQ(changed_by(Departure::D07, [](Interface& card) { card.ifiltr.value = 2, card.xfreq.value = 8; }),
              "filter");
    EXPECT_EQ(changed_by(Departure::D28), "") << "with /FRICTION only";
    EXPECT_EQ(changed_by(Departure::D28, [](Interface& card) { card.friction_model = 0, card.card_xfreq = 0; }),
              "filter");
    EXPECT_EQ(changed_by(Departure::D08), "friction temperature");
    EXPECT_EQ(changed_by(Departure::D10), "friction coefficient");
    EXPECT_EQ(changed_by(Departure::D13), "tool damping");
    EXPECT_EQ(changed_by(Departure::D39), "friction below zero");
    EXPECT_EQ(changed_by(Departure::D40), "damped inertia");
    EXPECT_EQ(changed_by(Departure::D42), "part") << "no part where no /FRICTION names one";
    EXPECT_EQ(changed_by(Departure::D42, [](Interface& card) { card.friction_model = 0; }), "part");
    EXPECT_EQ(changed_by(Departure::D43), "friction overflow");
}

// @manual departure D11, D12, D26, D30, D31, D33, D34, D35
TEST(ContactReading, EachDepartureOfTheImpactHasItsPlace) {
    EXPECT_EQ(changed_by(Departure::D11),
              "first proximity competes, heat reach, proximity competes, proximity has force");
    EXPECT_EQ(changed_by(Departure::D12), "first normal, normal");
    EXPECT_EQ(changed_by(Departure::D26), "Inacti later");
    EXPECT_EQ(changed_by(Departure::D30), "grown gap");
    EXPECT_EQ(changed_by(Departure::D31), "first lowest weight, first normal, first reach");
    EXPECT_EQ(changed_by(Departure::D33), "counts without penetration, search gap");
    EXPECT_EQ(changed_by(Departure::D34), "competes, first competes");
    EXPECT_EQ(changed_by(Departure::D35), "first lift leaning, lift leaning");
}

// @manual departure D15, D16, D32, D37, D38
TEST(ContactReading, EachDepartureOfOtherEffectsHasItsPlace) {
    EXPECT_EQ(changed_by(Departure::D15, [](Interface& card) { card.frad.value = 1; }), "zones");
    EXPECT_EQ(changed_by(Departure::D16), "friction heat");
    EXPECT_EQ(changed_by(Departure::D32), "conductance");
    EXPECT_EQ(changed_by(Departure::D37), "division");
    EXPECT_EQ(changed_by(Departure::D38), "conduction abscissa");
}

}  // namespace
}  // namespace type21::reference
