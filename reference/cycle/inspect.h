/// @file What a reference contact knows of a node, for programs that explain a cycle. Nothing here computes a force.
#pragma once

#include <optional>
#include <vector>

#include "reference/contact/contact_reading.h"
#include "reference/contact/friction.h"
#include "reference/contact/heat_exchange.h"
#include "reference/contact/penetration_offset.h"
#include "reference/contact/pmax_limit.h"
#include "reference/contact/retained_impact.h"
#include "reference/contact/sub_triangle.h"
#include "reference/cycle/contact.h"

namespace type21::reference {

/// Looks into a Contact, which must outlive it. i is the rank of a secondary node, as in SecondarySide::node; neither
/// it nor a segment's rank is checked. After step(motion) the gaps and stiffnesses are those of that cycle, the
/// histories those with which the next cycle begins. Motion is that of the cycle.
class Inspect {
  public:
    explicit Inspect(const Contact& contact);

    /// The laws that the contact follows, as documented or as built.  Formulation 12, step 1.
    const ContactReading& reading() const;

    /// y = R^T (x - x_G) [length].  Formulation 1, step 1.
    Vec3 tool_frame(int i, const Motion& motion) const;
    /// Ranks of the segments that compete for node i at y, ascending.  Formulation 4, step 1.
    std::vector<int> candidates(int i, const Vec3& y) const;
    /// Corners and normals of a segment in the tool frame.
    SegmentShape<double> shape(int segment) const;
    /// Indices into ContactModel::nodes of a segment's nodes.
    const std::array<int, 4>& segment_nodes(int segment) const;

    /// Formulation 3, step 5.
    ContactReach<double> reach(int i) const;
    /// Formulation 3, step 2.
    ProjectionLimits<double> limits() const;
    /// D11: contact and proximity compete on kappa alone.
    bool proximity_competes() const;

    double stiffness(int i) const;           ///< k; 0 when the node is switched off [force/length]
    double friction_stiffness(int i) const;  ///< k of the increment [force/length]
    double mass(int i) const;                ///< m [mass]
    int inacti() const;                      ///< as it acts
    bool has(Effect effect) const;
    /// Formulation 9, step 3.
    bool deleted(int i, const Motion& motion) const;
    /// g_s, before Gapmin and Gapmax act, with Igap 2 [length]; nothing without.  Formulation 2, step 5.
    std::optional<double> raw_gap(int i, const Motion& motion) const;

    const PenetrationHistory& history(int i) const;
    /// F_t that enters the next trial, global axes [force]; zero without friction.
    Vec3 remembered_friction(int i) const;
    /// Formulation 7, step 3.
    PmaxLimit pmax_limit(int i) const;
    /// What the friction law is given for this node in this cycle.
    /// @param node  as step() returned it
    /// @param acts  the stiffness acts (Formulation 6, step 4)
    FrictionInput friction_input(int i, const Motion& motion, const NodeContact& node, bool acts) const;
    /// Fric and C1..C6 that hold for this pair of parts.  Formulation 8, step 1.
    FrictionCoefficients friction_numbers(int i, const FrictionInput& input) const;
    /// mu [-]; 0 without friction.
    double friction_coefficient(int i, const FrictionInput& input) const;

    /// Null without heat exchange.
    const HeatExchange* heat_exchange() const;
    /// T_m at the retained impact [temperature].  Formulation 9, step 4.
    double tool_temperature(const Decision& decision, const Motion& motion) const;

  private:
    const Contact::State& state_;
};

}  // namespace type21::reference
