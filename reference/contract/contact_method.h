/// @file ContactMethod: one interface, computed one cycle after the other. The reference and the optimized
/// implementation, and any other, are used through it alone.
#pragma once

#include <vector>

#include "contact_step.h"
#include "decision_stage_counts.h"
#include "motion.h"
#include "scene.h"

namespace type21 {

/// A node that penetrates at time 0, for `type21 check` and for Inacti 3.
struct InitialPenetration {
    int node = -1;               ///< index into ContactModel::nodes
    int segment = -1;            ///< rank in the main surface
    double penetration = 0;      ///< p_g [length]
    double distance = 0;         ///< delta [length]
    Vec3 normal = Vec3::Zero();  ///< nu, outward of the tool, global axes [-]
};

/// Memory that an effect holds for each secondary node.
struct EffectMemory {
    Effect effect = Effect::elastic;
    size_t bytes_per_node = 0;
};

/// One TYPE21 interface with its history: friction force, penetration offset, contact count and what effects remember
/// of each secondary node. Made by reference::make_contact or optimized::make_contact (make_contact.h).
class ContactMethod {
  public:
    virtual ~ContactMethod() = default;

    /// Computes one cycle from the motion and from what is remembered, and remembers what the next cycle needs.
    ///
    /// **Order.** Call it once for each cycle, with times that do not decrease. The history belongs to the object: a
    /// cycle cannot be taken back, and a cycle that is left out is a cycle in which nothing happened to the history.
    ///
    /// **Time 0.** The first call looks at the initial penetrations (Inacti), also when the interface is still
    /// inactive. Pass it motion.time = 0 and motion.step = 0: at time 0 the elastic force acts in full and no friction
    /// has accumulated (Formulation 6, step 1). A first call at a later time is taken as a first impact.
    ///
    /// **Motion.** position, velocity and temperature are read only during the call, indexed like ContactModel::nodes;
    /// one pose in motion.tools for each of ContactModel::rigid_bodies. Sizes are not checked.
    ///
    /// **Concurrency.** One call at a time for one object. Different objects may step at the same time, also when they
    /// share a Scene. The optimized implementation uses the threads of the calling TBB arena; its result is the same
    /// bits for any number of them.
    ///
    /// **Cost.** Proportional to the secondary nodes. The reference projects a node on every segment whose box holds it
    /// and writes about 400 bytes a node (NodeContact); step_into() uses the memory of an earlier step again.
    ///
    /// @throws std::bad_alloc. A NaN in the motion gives no exception: the host checks its own state.
    virtual ContactStep step(const Motion& motion) = 0;

    /// The same cycle, written into a step of an earlier cycle whose memory is used again.
    virtual void step_into(const Motion& motion, ContactStep& into) { into = step(motion); }

    /// The nodes that would penetrate at time 0 with the nodes at `position` (indexed like ContactModel::nodes)
    /// [length] and the tools in their initial pose. Neither reads nor changes the history. In the order of the
    /// secondary nodes.
    /// @manual field Inacti; comment 8; departure D31
    virtual std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const = 0;

    /// Memory of each effect that is present.
    virtual std::vector<EffectMemory> memory_by_effect() const = 0;

    /// Which arithmetic settled how many decisions since the start.
    virtual DecisionStageCounts decision_stage_counts() const = 0;
};

}  // namespace type21
