/// @file What a reference contact knows of a node, for those who explain it; nothing here computes a force.
#pragma once

#include <optional>
#include <vector>

#include "reference/contact/friction.h"
#include "reference/contact/heat_exchange.h"
#include "reference/contact/penetration_offset.h"
#include "reference/contact/pmax_limit.h"
#include "reference/contact/retained_impact.h"
#include "reference/contact/sub_triangle.h"
#include "reference/cycle/contact.h"

namespace type21::reference {

/// Looks into a Contact that stays where it is. i is the rank of a secondary node, as in SecondarySide::node.
/// After step(motion) the gaps and stiffnesses are those of that cycle, the histories those that the next will meet.
class Inspect {
  public:
    explicit Inspect(const Contact& contact);

    /// y = R^T (x - x_G) [length]
    Vec3 tool_frame(int i, const Motion& motion) const;
    /// Ranks of the segments whose box holds y, ascending; with D34 only those whose box along the normals does, too.
    std::vector<int> candidates(int i, const Vec3& y) const;
    SegmentShape<double> shape(int segment) const;
    /// Indices into Model::nodes of a segment's nodes.
    const std::array<int, 4>& segment_nodes(int segment) const;

    ContactReach<double> reach(int i) const;
    ProjectionLimits<double> limits() const;
    /// D11: contact and proximity compete on kappa alone.
    bool proximity_competes() const;

    double stiffness(int i) const;           ///< k; 0 when the node is switched off [force/length]
    double friction_stiffness(int i) const;  ///< k of the increment [force/length]
    double mass(int i) const;                ///< m [mass]
    int inacti() const;                      ///< as it acts
    bool has(Effect effect) const;
    bool deleted(int i, const Motion& motion) const;
    /// g_s, before Gapmin and Gapmax act, with Igap 2 [length].
    std::optional<double> raw_gap(int i, const Motion& motion) const;

    const PenetrationHistory& history(int i) const;
    /// F_t that enters the next trial, global axes [force]; zero without friction.
    Vec3 remembered_friction(int i) const;
    PmaxLimit pmax_limit(int i) const;
    /// What the friction law is given for this node in this cycle.
    FrictionInput friction_input(int i, const Motion& motion, const NodeContact& node, bool acts) const;
    /// Fric and C1..C6 that hold for this pair of parts.
    FrictionCoefficients friction_numbers(int i, const FrictionInput& input) const;
    double friction_coefficient(int i, const FrictionInput& input) const;

    const HeatExchange* heat_exchange() const;
    /// T_m at the retained impact [temperature].
    double tool_temperature(const Decision& decision, const Motion& motion) const;

  private:
    const Contact::State& state_;
};

}  // namespace type21::reference
