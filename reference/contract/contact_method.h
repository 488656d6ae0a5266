/// @file ContactMethod: one interface, computed one cycle after the other. The reference and the optimized
/// implementation, and any other, are used through it alone.
#pragma once

#include <stdexcept>
#include <vector>

#include "contact_step.h"
#include "decision_stage_counts.h"
#include "motion.h"
#include "scene.h"
#include "state_stream.h"

namespace type21 {

/// A node that penetrates at time 0, for `type21 check` and for Inacti 3.
struct InitialPenetration {
    int node = -1;               ///< index into ContactModel::nodes
    int segment = -1;            ///< rank in the main surface
    double penetration = 0;      ///< p_g [length]
    double distance = 0;         ///< delta [length]
    Vec3 normal = Vec3::Zero();  ///< nu, outward of the tool, global axes [-]
};

/// Memory that an effect takes for each secondary node.
struct EffectMemory {
    Effect effect = Effect::elastic;
    size_t bytes_per_node = 0;         ///< that the contact holds from cycle to cycle [byte]
    size_t report_bytes_per_node = 0;  ///< that a ContactStep of one cycle has for it [byte]
};

/// One TYPE21 interface with its history: friction force, penetration offset, contact count and what effects remember
/// of each secondary node. Made by reference::make_contact or optimized::make_contact (make_contact.h).
class ContactMethod {
  public:
    virtual ~ContactMethod() = default;

    /// Computes one cycle from the motion and from what is remembered, and remembers what the next cycle needs.
    ///
    /// **Order.** Call it once for each cycle, with times that do not decrease; this is not checked. The history
    /// belongs to the object: a cycle cannot be taken back. A cycle that is left out changes nothing in the history.
    ///
    /// **Time 0.** The first call applies Inacti to the penetrations that it finds, also when the interface is still
    /// inactive. Pass it motion.time = 0 and motion.step = 0: at time 0 the elastic force acts in full and friction has
    /// no increment (Formulation 6, step 1). Each call with a time of 0 or less is taken as time 0. If the first call
    /// has a later time, Inacti does nothing and each penetration is a first impact (Formulation 6, step 2).
    ///
    /// **Motion.** position and velocity have one entry for each of ContactModel::nodes, temperature too where the
    /// interface exchanges heat, thickness one for each of ContactModel::shells or none. tools has one pose for each of
    /// ContactModel::rigid_bodies, sensor_on one entry for each sensor where the interface has one. All are read only
    /// during the call. Sizes are not checked: a span that is too short is read beyond its end.
    ///
    /// **Not finite.** Nothing is checked and nothing is thrown. A node whose position is not finite has no impact. A
    /// velocity or temperature that is not finite spoils the forces or the heat of its node, and the sums.
    ///
    /// **Inactive.** Outside of Tstart and Tstop, or while the sensor is off, the result has `active` false and is
    /// empty otherwise; the history stays as it is and goes on when the interface comes back (Formulation 9, step 2).
    ///
    /// **Concurrency.** One call at a time for one object. Different objects may step at the same time, also when they
    /// share a Scene. The optimized implementation uses the threads of the calling TBB arena; its result is the same
    /// bits for any number of them.
    ///
    /// **Cost.** Proportional to the secondary nodes, with about 300 bytes written for each (NodeContact; NodeHeat and
    /// skid ratio where they are present). The reference projects a node on every segment whose box holds it.
    ///
    /// @throws std::bad_alloc
    virtual ContactStep step(const Motion& motion) = 0;

    /// The same cycle, written into a step of an earlier cycle. The optimized implementation uses its memory again.
    /// @param into  is overwritten; its content does not matter
    virtual void step_into(const Motion& motion, ContactStep& into) { into = step(motion); }

    /// The nodes that would penetrate at time 0 with the tools in their initial pose, in the order of the secondary
    /// nodes. The history is neither read nor changed; the gaps are those of the last cycle, with Igap 2 too. The
    /// decisions are counted in decision_stage_counts().
    /// @param position  of each of ContactModel::nodes [length]; the size is not checked.  Formulation 6, step 1.
    /// @manual field Inacti; comment 8; departure D31
    virtual std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const = 0;

    /// Memory of each effect that is present, in the order of the enum.  Formulation 9, step 17.
    virtual std::vector<EffectMemory> memory_by_effect() const = 0;

    /// Which arithmetic settled how many decisions since the object was made.  Formulation 10, step 6.
    virtual DecisionStageCounts decision_stage_counts() const = 0;

    /// Writes what the next cycle needs of the past: the histories and the counts. Where a search only remembers where
    /// to look first, it may leave that out. To be called between two cycles.
    /// @throws std::logic_error in an implementation that cannot be saved, which is what this one does
    virtual void save(StateWriter&) const { throw std::logic_error("this contact cannot be saved"); }

    /// Takes over what save() of the same implementation wrote for the same scene and interface. Every cycle that
    /// follows has then the same bits as if it had followed there. Call it before the first step; after an exception
    /// the contact is not to be used.
    /// @throws StateError when the state is not one of this contact
    virtual void restore(StateReader&) { throw std::logic_error("this contact cannot be restored"); }
};

}  // namespace type21
