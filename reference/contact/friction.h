/// @file Friction: parameters, what each node remembers, and one cycle of it (chapter 8 of the formulation).
#pragma once

#include <limits>
#include <vector>

#include "reference/contact/contact_reading.h"
#include "reference/contact/friction_increment.h"
#include "reference/contract/scene.h"

namespace type21::reference {

/// What friction needs to know of a node in contact.
struct FrictionInput {
    double normal_force = 0;                               ///< F_n, damping included, may be negative [force]
    double stiffness = 0;                                  ///< k of the increment [force/length]
    double step = 0;                                       ///< dt1 [time]
    double cap = std::numeric_limits<double>::infinity();  ///< A Pmax / sqrt(3) with ITlim 0 and Igap 2 [force]
    double abscissa = 0;                                   ///< of fct_IDF [temperature]
    double temperature_factor = 1;                         ///< f_IDF, scales Fric of law 0 [-]
    int part_main = -1;            ///< index into ContactModel::parts of the main segment's part, -1: none
    Vec3 velocity = Vec3::Zero();  ///< v of the node relative to the tool at X [velocity]
    Vec3 normal = Vec3::Zero();    ///< nu [-]
};

/// The friction coefficient of a node and what it depends on.
struct FrictionState {
    double pressure = 0;     ///< F_n / A [pressure]
    double speed = 0;        ///< s [velocity]
    double coefficient = 0;  ///< mu; not finite where the law overflows [-]
};

/// Present only when the scene asks for friction. Node i is the rank in SecondarySide::node; it is not checked.
class Friction {
  public:
    /// @param reading  law of the coefficient and filter, as documented or as built
    Friction(const ContactModel& model, const Interface& interface, const ContactReading& reading);

    /// mu of node i for this input.  Formulation 8, step 2 to step 7.
    FrictionState state(int i, const FrictionInput& input) const;
    /// F_t of node i in this cycle; remembered for the next.
    /// @param coefficient  mu [-]
    /// @return [force].  Formulation 8, step 8 to step 11.
    FrictionForce act(int i, const FrictionInput& input, double coefficient);
    /// Index into ContactModel::parts of the node's part, for the pairs of /FRICTION; -1: none.
    int part(int i) const { return part_[static_cast<size_t>(i)]; }
    /// F_t of the last cycle, as it will enter the next trial, global axes [force].
    const Vec3& remembered(int i) const { return force_[static_cast<size_t>(i)]; }
    /// The node has left: its friction force is dropped.  Formulation 6, step 5.
    void forget(int i) { force_[static_cast<size_t>(i)].setZero(); }
    /// What a checkpoint holds; @see StateWriter
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(force_);
    }

    static constexpr size_t bytes_per_node() { return sizeof(Vec3) + sizeof(int); }

  private:
    const ContactModel& model_;
    const Interface& interface_;
    const ContactReading& reading_;
    std::vector<Vec3> force_;  ///< F_t of the last cycle, global axes [force]
    std::vector<int> part_;    ///< index into ContactModel::parts of the node's part, -1: none
};

}  // namespace type21::reference
