/// @file The room of friction: parameters, what each node remembers, and one cycle of it (formulation section 8).
#pragma once

#include <limits>
#include <vector>

#include "reference/contact/friction_increment.h"
#include "reference/contract/scene.h"

namespace type21::reference {

/// What friction needs to know of a node in contact.
/// @manual eq 7, 8; field fct_IDF, AscaleF; comment 12; departure D08
struct FrictionInput {
    double normal_force = 0;                               ///< F_n, damping included, may be negative [force]
    double stiffness = 0;                                  ///< k of the increment [force/length]
    double step = 0;                                       ///< dt1 [time]
    double cap = std::numeric_limits<double>::infinity();  ///< A Pmax / sqrt(3) with ITlim 0 and Igap 2 [force]
    double temperature_factor = 1;                         ///< f_IDF, scales Fric of law 0 [-]
    int part_main = -1;            ///< index into Model::parts of the main segment's part, -1: none
    Vec3 velocity = Vec3::Zero();  ///< v of the node relative to the tool at X [velocity]
    Vec3 normal = Vec3::Zero();    ///< nu [-]
};

/// Present only when the scene asks for friction.
class Friction {
  public:
    Friction(const ContactModel& model, const Interface& interface);

    /// F_t of secondary node i in this cycle; remembered for the next.
    FrictionForce act(int i, const FrictionInput& input);
    /// mu for this input [-].
    double coefficient(int i, const FrictionInput& input) const;
    /// Index into Model::parts of the node's part, for the pairs of /FRICTION; -1: none.
    int part(int i) const { return part_[static_cast<size_t>(i)]; }
    /// F_t of the last cycle, as it will enter the next trial [force].
    const Vec3& remembered(int i) const { return force_[static_cast<size_t>(i)]; }
    /// The node has left: its friction force is dropped.
    void forget(int i) { force_[static_cast<size_t>(i)].setZero(); }

    static constexpr size_t bytes_per_node() { return sizeof(Vec3) + sizeof(int); }

  private:
    const ContactModel& model_;
    const Interface& interface_;
    std::vector<Vec3> force_;  ///< F_t of the last cycle, global axes [force]
    std::vector<int> part_;    ///< index into Model::parts of the node's part, -1: none
};

}  // namespace type21::reference
