/// @file What a reference contact holds: constants of time 0, and the rooms of the effects that the scene asks for.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "reference/contact/adaptive_data.h"
#include "reference/contact/candidates.h"
#include "reference/contact/contact_geometry.h"
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

/// The retained impact of a node with its geometry, in the tool frame.
struct LocatedImpact {
    Decision decision;
    ContactGeometry geometry;
    double penetration = 0;  ///< p_g [length]
};

struct Contact::State {
    State(const Scene& scene, int interface);

    const Interface& card() const { return model->interfaces[static_cast<size_t>(interface)]; }
    const RigidBody& tool() const { return model->rigid_bodies[static_cast<size_t>(card().tool)]; }
    bool as_built(Departure departure) const { return model->as_built.has(departure); }
    bool has(Effect effect) const { return scene.has(interface, effect); }

    /// The exact decision for a node at y; counts it in the stage_counts.
    StagedImpact decide(const Vec3& y, const std::vector<int>& near, const ContactReach<double>& seen,
                        const ProjectionLimits<double>& limits) const;
    /// The retained impact of secondary node i at tool-frame position y.
    LocatedImpact touch(int i, const Vec3& y, const Vec3& position, const ToolMotion& pose) const;
    /// The impact at time 0 that decides Inacti; with D31 by another projection than every cycle.
    LocatedImpact first_touch(int i, const Vec3& y, const Vec3& position, const ToolMotion& pose) const;
    /// Fills the history of time 0 according to Inacti.
    void start(const Motion& motion);
    /// Gaps of this cycle; the boxes grow when a gap outgrows them.
    void update_gaps(const Motion& motion, ContactStep& step);
    NodeContact node_step(int i, const Motion& motion, ContactStep& step);

    // Parts of node_step, in its order.
    void normal_force(int i, const Motion& motion, NodeContact& out) const;
    void friction_force(int i, const Motion& motion, bool acts, NodeContact& out);
    void heat(int i, const Motion& motion, NodeContact& out, ContactStep& step) const;
    /// T_m: Tint, or that of the tool at the contact point.
    double tool_temperature(const Decision& decision, const Motion& motion) const;
    PmaxLimit pmax_limit(int i) const;
    /// Index into Model::parts of the element under a main segment, -1 where there is none.
    int part_of_segment(int segment) const;

    Scene scene;
    std::shared_ptr<const ContactModel> model;
    int interface;
    std::vector<NodeConstants> nodes;
    ToolSurface surface;
    double proximity;  ///< largest reach of the heat, 0 without [length]
    double reach;      ///< that the boxes are grown by [length]
    Candidates candidates;
    Mat3 box_axes;
    mutable DecisionStageCounts stage_counts;  ///< of all decisions so far

    bool started = false;
    int inacti = 0;  ///< as it acts; with D26 it becomes 0 when nothing penetrates at time 0
    std::vector<PenetrationHistory> offsets;
    // Rooms of the effects: empty unless the scene asks for them.
    std::optional<GapGrowth> gap_growth;
    std::optional<Friction> friction;
    std::optional<SkidLine> skid_line;
    std::optional<HeatExchange> heat_exchange;
    std::optional<Release> release;
    std::optional<Deletion> deletion;
    std::optional<AdaptiveData> adaptive;
};

}  // namespace type21::reference
