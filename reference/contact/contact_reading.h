/// @file The laws of the contact that the manual page and the public program read differently.
#pragma once

#include <functional>

#include "reference/contact/contact_geometry.h"
#include "reference/contact/friction_filter.h"
#include "reference/contact/friction_law.h"
#include "reference/contact/gap_growth.h"
#include "reference/contact/heat_laws.h"
#include "reference/contact/node_parts.h"
#include "reference/contact/normal_force.h"
#include "reference/contact/penetration_offset.h"
#include "reference/contact/retained_impact.h"
#include "reference/contact/stiffness.h"
#include "reference/contact/tool_damping.h"

namespace type21::reference {

/// The reach of a cycle holds.  Formulation 3, step 5; as built, at time 0: D31.
inline ContactReach<double> reach_of_cycle(const ContactReach<double>& reach, double /*gap*/) {
    return reach;
}

/// How the impact of a node is located, chapters 3 to 5 of the formulation.
struct ImpactReading {
    ProjectionLimits<double> limits;  ///< Formulation 3, step 2; D31, D35

    /// @param gap  g of the node, which may be less than the gap that decides contact (D33) [length]
    std::function<ContactReach<double>(const ContactReach<double>& reach, double gap)> reach = reach_of_cycle;

    /// Which segments compete for a node; empty: every one, and none is asked.  Formulation 4, step 1; D34
    /// @param y  the node in the tool frame [length]
    std::function<bool(const Vec3& y, const SegmentShape<double>& segment, const ContactReach<double>& reach)> competes;

    /// Contact and proximity compete on kappa alone.  Formulation 4, step 2; D11
    bool proximity_competes = false;

    std::function<ContactGeometry(const RetainedProjection&)> geometry = [](const RetainedProjection& retained) {
        return contact_geometry(retained);
    };
};

/// The reading that a contact follows: as documented here, where a default-constructed one names the laws of this
/// folder. as_built::reading_of() puts the as-built laws of the departures that are switched on in their places
/// (Formulation 12, step 1). The laws of one place have one signature, which is described at the documented one.
struct ContactReading {
    // Chapter 2
    std::function<NodalGap(const Interface&, const SheetThickness&)> grown_gap = reference::grown_gap;  // D30
    std::function<double(const Interface&, const NodalGap&)> search_gap = reference::search_gap;        // D33

    // Chapters 3 to 5
    ImpactReading impact;        ///< in every cycle: D11, D12, D34, D35
    ImpactReading first_impact;  ///< at time 0, for Inacti (Formulation 6, step 1): D31
    /// A proximity node nearer than its gap has force.  Formulation 9, step 6; D11
    bool proximity_has_force = false;

    // Chapter 6
    std::function<int(int, bool)> inacti_of_later_impacts = reference::inacti_of_later_impacts;  // D26
    /// A node retained at time 0 begins its count of cycles although p_g = 0.  Formulation 6, step 5; D33
    bool counts_without_penetration = false;

    // Chapter 7
    std::function<double(const Interface&, double)> nodal_stiffness = reference::nodal_stiffness;  // D01
    std::function<double(double, double)> elastic_energy = reference::elastic_energy;              // D05

    // Chapter 8
    std::function<double(const Interface&, double, double)> friction_stiffness = reference::friction_stiffness;  // D04
    std::function<double(const Interface&, double, double)> friction_temperature =
        reference::friction_temperature;  // D08
    std::function<double(int, const FrictionCoefficients&, double, double)> friction_coefficient =
        reference::friction_coefficient;  // D10, D39, D43
    std::function<std::vector<int>(const ContactModel&, const Interface&)> node_parts = reference::node_parts;  // D42
    std::function<double(const Interface&, double)> filter_constant = reference::filter_constant;  // D06, D07, D28

    // Chapter 9
    std::function<double(const Interface&)> heat_reach = reference::heat_reach;                            // D11
    std::function<HeatZones(const Interface&, double, double)> heat_zones = reference::heat_zones;         // D15
    std::function<double(const Interface&, double)> conduction_abscissa = reference::conduction_abscissa;  // D38
    std::function<double(double, double, double, double)> distance_conductance =
        reference::distance_conductance;  // D32
    /// Share of a node's friction heat that goes to the tool as well, with Ithe_form 1.  Formulation 9, step 10; D16
    double friction_heat_to_tool = 0;
    /// On the tool radius below which an element is to be divided.  Formulation 9, step 15; D37
    double division_radius_factor = 1;
    std::function<ToolStiffness(const ToolStiffness&, const ToolStiffness&)> tool_damping_stiffness =
        reference::tool_damping_stiffness;  // D13
    std::function<double(const RigidBody&, const Mat3&, const Vec3&)> damped_inertia =
        reference::damped_inertia;  // D40
};

}  // namespace type21::reference
