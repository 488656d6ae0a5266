#include "reference/as_built/reading_of.h"

#include <algorithm>

#include "reference/as_built/d01_d04_stiffness.h"
#include "reference/as_built/d05_elastic_energy.h"
#include "reference/as_built/d06_d07_d28_filter.h"
#include "reference/as_built/d08_friction_temperature.h"
#include "reference/as_built/d10_d39_d43_friction_law.h"
#include "reference/as_built/d11_proximity.h"
#include "reference/as_built/d12_contact_normal.h"
#include "reference/as_built/d13_tool_damping.h"
#include "reference/as_built/d15_d16_d32_heat.h"
#include "reference/as_built/d26_inacti_6.h"
#include "reference/as_built/d30_d33_gap.h"
#include "reference/as_built/d31_first_impact.h"
#include "reference/as_built/d34_reach_box.h"
#include "reference/as_built/d35_d37_limits.h"
#include "reference/as_built/d38_pressure_scale.h"
#include "reference/as_built/d40_tool_inertia.h"
#include "reference/as_built/d42_node_parts.h"

namespace type21::reference::as_built {

/// @manual departure D16, D37
ContactReading reading_of(const ContactModel& model, const Interface& interface) {
    using enum Departure;
    const auto on = [&](Departure departure) { return model.as_built.has(departure); };
    ContactReading reading;
    if (on(D01)) reading.nodal_stiffness = nodal_stiffness;
    if (on(D04)) reading.friction_stiffness = friction_stiffness;
    if (on(D05) && interface.istf == 1 && interface.igap != 2) {
        reading.elastic_energy = [stfac = double(interface.stfac)](double stiffness, double penetration) {
            return elastic_energy(stfac, stiffness, penetration);
        };
    }
    if (on(D06) || on(D07) || on(D28)) {
        const FilterDepartures departures{on(D06), on(D07), on(D28)};
        reading.filter_constant = [departures](const Interface& card, double step) {
            return filter_constant(departures, card, step);
        };
    }
    if (on(D08)) reading.friction_temperature = friction_temperature;
    if (on(D10) || on(D39) || on(D43)) {
        const FrictionLawDepartures departures{on(D10), on(D39), on(D43)};
        reading.friction_coefficient = [departures](int ifric, const FrictionCoefficients& numbers, double pressure,
                                                    double speed) {
            return friction_coefficient(departures, ifric, numbers, pressure, speed);
        };
    }
    if (on(D11)) let_proximity_compete(reading);
    if (on(D12))
        reading.impact.geometry = [](const RetainedProjection& retained) {
            return as_built::contact_geometry(retained);
        };
    if (on(D13)) reading.tool_damping_stiffness = tool_damping_stiffness;
    if (on(D15)) reading.heat_zones = heat_zones;
    if (on(D16)) reading.friction_heat_to_tool = friction_heat_to_tool;
    if (on(D26)) reading.inacti_of_later_impacts = inacti_of_later_impacts;
    if (on(D30)) reading.grown_gap = grown_gap;
    if (on(D32)) reading.distance_conductance = distance_conductance;
    if (on(D33)) {
        reading.search_gap = search_gap;
        reading.counts_without_penetration = true;
    }
    if (on(D34)) {
        const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(interface.tool)];
        reading.impact.competes = [axes = reach_box_axes(tool, interface.tool_rotates)](
                                      const Vec3& y, const SegmentShape<double>& segment,
                                      const ContactReach<double>& reach) {
            return in_reach_box(y, segment, axes, std::max(reach.gap, reach.proximity), reach.depth);
        };
    }
    if (on(D35)) lift_leaning_normals(reading.impact.limits);
    if (on(D37)) reading.division_radius_factor = division_radius_factor;
    if (on(D38)) reading.conduction_abscissa = conduction_abscissa;
    if (on(D40)) reading.damped_inertia = damped_inertia;
    if (on(D42)) reading.node_parts = node_parts;
    // Last, since what D31 does not change at time 0 is that of every cycle.
    reading.first_impact = on(D31) ? first_impact(reading.impact) : reading.impact;
    return reading;
}

}  // namespace type21::reference::as_built
