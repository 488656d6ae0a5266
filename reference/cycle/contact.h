/// @file The reference implementation of a contact.
#pragma once

#include <memory>
#include <vector>

#include "reference/contract/contact_method.h"

namespace type21 {

namespace reference {

class Inspect;

/// The formulation as written, one node after the other, each decision exact. What the functions do is said in
/// ContactMethod.
class Contact final : public ContactMethod {
  public:
    /// @param interface  index into scene.model->interfaces
    /// @throws std::out_of_range when there is no such interface
    Contact(const Scene& scene, int interface);
    ~Contact() override;
    ContactStep step(const Motion& motion) override;

    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override;
    std::vector<EffectMemory> memory_by_effect() const override;
    DecisionStageCounts decision_stage_counts() const override;
    void save(StateWriter& out) const override;
    void restore(StateReader& in) override;
    /// The same in the positions of the model.
    std::vector<InitialPenetration> initial_penetrations() const;

  private:
    struct State;
    friend class Inspect;
    std::unique_ptr<State> state_;
};

}  // namespace reference
}  // namespace type21
