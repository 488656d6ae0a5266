/// @file The one seam: reference::Contact and optimized::Contact have this constructor and this step.
#pragma once

#include <memory>
#include <vector>

#include "reference/contact/contact_step.h"
#include "reference/contact/exact/funnel.h"
#include "reference/host/motion.h"
#include "reference/model/scene.h"

namespace type21 {

/// A node that penetrates at time 0, for `type21 check` and for Inacti 3.
struct InitialPenetration {
    int node = -1;           ///< index into Model::nodes
    int segment = -1;        ///< rank in the main surface
    double penetration = 0;  ///< p_g [length]
    double distance = 0;     ///< delta [length]
    Vec3 normal = Vec3::Zero();
};

/// What an effect holds per secondary node.
struct RoomSize {
    Effect effect = Effect::elastic;
    size_t bytes_per_node = 0;
};

/// What the host, the harness and the command line see of a contact.
class ContactMethod {
  public:
    virtual ~ContactMethod() = default;
    virtual ContactStep step(const Motion& motion) = 0;
    /// The same into a step of an earlier cycle, whose memory may be used again.
    virtual void step_into(const Motion& motion, ContactStep& into) { into = step(motion); }
    /// The nodes that penetrate at time 0 with the nodes at `position` (indexed like Model::nodes); nothing is
    /// remembered.
    /// @page field Inacti; comment 8; departure D31
    virtual std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const = 0;
    /// The effects that hold anything, and how much.
    virtual std::vector<RoomSize> rooms() const = 0;
    /// What settled the decisions since the start.
    virtual Funnel funnel() const = 0;
};

namespace reference {

class Inspect;

class Contact final : public ContactMethod {
  public:
    Contact(const Scene& scene, int interface);
    ~Contact() override;
    ContactStep step(const Motion& motion) override;

    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override;
    std::vector<RoomSize> rooms() const override;
    Funnel funnel() const override;
    /// In the positions of the Model.
    std::vector<InitialPenetration> initial_penetrations() const;

  private:
    struct State;
    friend class Inspect;
    std::unique_ptr<State> state_;
};

}  // namespace reference
}  // namespace type21
