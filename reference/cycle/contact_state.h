/// @file What a reference contact holds: constants of time 0, histories, and the effects that the scene asks for.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "reference/contact/adaptive_data.h"
#include "reference/contact/candidates.h"
#include "reference/contact/contact_geometry.h"
#include "reference/contact/contact_reading.h"
#include "reference/contact/deletion.h"
#include "reference/contact/friction.h"
#include "reference/contact/gap_growth.h"
#include "reference/contact/heat_exchange.h"
#include "reference/contact/penetration_offset.h"
#include "reference/contact/pmax_limit.h"
#include "reference/contact/release.h"
#include "reference/contact/skid_line.h"
#include "reference/contact/tool_surface.h"
#include "reference/cycle/contact.h"
#include "reference/exact/staged_impact.h"

namespace type21::reference {

/// Constants of one secondary node, but for the gaps, which follow the thickness with Igap 2.
struct NodeConstants {
    double gap = 0;                 ///< g [length]
    double search_gap = 0;          ///< gap that decides contact: g, larger with D33 [length]
    double stiffness = 0;           ///< k; 0 once Inacti 1 has switched the node off [force/length]
    double friction_stiffness = 0;  ///< k of the friction increment [force/length]
    double mass = 0;                ///< m [mass]
};

template <class Archive>
void visit_state(Archive& archive, NodeConstants& node) {
    auto& [gap, search_gap, stiffness, friction_stiffness, mass] = node;
    archive(gap, search_gap, stiffness, friction_stiffness, mass);
}

/// The retained impact of a node with its geometry, in the tool frame.
struct LocatedImpact {
    Decision decision;
    ContactGeometry geometry;
    double penetration = 0;  ///< p_g [length]
};

/// In all functions i is the rank of a secondary node, as in SecondarySide::node.
struct Contact::State {
    /// @throws std::out_of_range when the model has no such interface
    State(const Scene& scene, int interface);

    const Interface& card() const { return model->interfaces[static_cast<size_t>(interface)]; }
    const RigidBody& tool() const { return model->rigid_bodies[static_cast<size_t>(card().tool)]; }
    const ToolMotion& pose(const Motion& motion) const { return motion.tools[static_cast<size_t>(card().tool)]; }
    size_t model_node(int i) const { return static_cast<size_t>(card().secondary.node[static_cast<size_t>(i)]); }
    bool has(Effect effect) const { return scene.has(interface, effect); }

    /// Fills the history of time 0 according to Inacti.  Formulation 6, step 1.
    void start(const Motion& motion);
    /// Gaps of this cycle; the boxes grow when a gap outgrows them.  Formulation 2, step 5.
    void update_gaps(const Motion& motion, ContactStep& step);
    /// Boxes for the reach that a checkpoint gives.
    void restore_reach();

    // Chapters 3 to 5: locate.cpp

    /// Distances at which node i counts.  Formulation 3, step 5.
    ContactReach<double> reach_of(int i) const;
    /// Ranks of the segments that compete for node i at y, ascending.  Formulation 4, step 1.
    std::vector<int> competitors(const Vec3& y, const ContactReach<double>& reach, const ImpactReading& how) const;
    /// The exact decision for a node at y; counts it in stage_counts.  Formulation 4, step 5.
    StagedImpact decide(const Vec3& y, const std::vector<int>& segments, const ContactReach<double>& reach,
                        const ImpactReading& how) const;
    /// The retained impact of node i, which is at `position` in global axes.
    /// @param how  reading.impact in a cycle, reading.first_impact for the penetrations of time 0
    LocatedImpact locate(int i, const Vec3& position, const ToolMotion& pose, const ImpactReading& how) const;

    // One node in one cycle: node_step.cpp

    NodeContact node_step(int i, const Motion& motion, ContactStep& step);
    /// Chapter 6, the end of an impact: offset, count and friction force are dropped.  Formulation 6, step 5.
    void forget(int i);
    /// Counts the cycles of an impact.  Formulation 6, step 5.
    /// @return whether the node has an impact in this cycle
    bool count_cycle(int i, const NodeContact& node, bool can_have_force, bool time_zero);
    /// Chapter 7.
    void normal_force(int i, const Motion& motion, NodeContact& out) const;
    /// Chapter 8.
    /// @param acts  the stiffness acts (Formulation 6, step 4)
    void friction_force(int i, const Motion& motion, bool acts, NodeContact& out, ContactStep& step);
    /// Says in the step where the coefficient is below zero or not finite.
    void note_friction(int i, const FrictionInput& input, const FrictionState& state, ContactStep& step) const;
    FrictionInput friction_input(int i, const Motion& motion, const NodeContact& node, bool acts) const;
    /// What limits the node under Pmax.  Formulation 7, step 3.
    PmaxLimit pmax_limit(int i) const;
    /// Index into ContactModel::parts of the element under a main segment, -1 where there is none.
    int part_of_segment(int segment) const;

    // Chapter 9, heat of one node: node_heat.cpp

    void heat(int i, const Motion& motion, const NodeContact& node, ContactStep& step) const;
    /// Gives the tool nodes their shares.  Formulation 9, step 11.
    void heat_tool(const Decision& decision, double heat, ContactStep& step) const;
    /// T_m: Tint, or that of the tool at the contact point [temperature].  Formulation 9, step 4.
    double tool_temperature(const Decision& decision, const Motion& motion) const;

    Scene scene;
    std::shared_ptr<const ContactModel> model;
    int interface;
    ContactReading reading;  ///< as documented, or with departures
    std::vector<NodeConstants> nodes;
    ToolSurface surface;
    double proximity;  ///< largest reach of the heat, 0 without [length]
    double reach;      ///< that the boxes are grown by [length]
    Candidates candidates;
    mutable DecisionStageCounts stage_counts;  ///< of all decisions so far

    bool started = false;
    int inacti = 0;  ///< as it acts
    std::vector<PenetrationHistory> offsets;
    // Effects: empty unless the scene asks for them.  Formulation 9, step 17.
    std::optional<GapGrowth> gap_growth;
    std::optional<Friction> friction;
    std::optional<SkidLine> skid_line;
    std::optional<HeatExchange> heat_exchange;
    std::optional<Release> release;
    std::optional<Deletion> deletion;
    std::optional<AdaptiveData> adaptive;

    /// What the next cycle needs of the past. Every field of this struct is named here: one that is added later does
    /// not compile until it is decided whether it belongs to a checkpoint.
    template <class Archive>
    static void visit(Archive& archive, State& state) {
        auto& [the_scene, the_model, number, laws, node, tool_surface, zone, box_reach, boxes, counts, has_started,
               inacti_now, offset, growth, friction_force, skid, heat, released, shells, curvature] = state;
        archive(node, box_reach, counts, has_started, inacti_now, offset, friction_force, skid, released);
    }
};

/// The node in the tool frame: y = R^T (x - x_G) [length].  Formulation 1, step 1.
Vec3 in_tool_frame(const Vec3& position, const ToolMotion& pose);

}  // namespace type21::reference
