/// @file The reference implementation of a contact.
#pragma once

#include <memory>
#include <vector>

#include "reference/contract/contact_method.h"

namespace type21 {

namespace reference {

class Inspect;

class Contact final : public ContactMethod {
  public:
    Contact(const Scene& scene, int interface);
    ~Contact() override;
    ContactStep step(const Motion& motion) override;

    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override;
    std::vector<EffectMemory> memory_by_effect() const override;
    DecisionStageCounts decision_stage_counts() const override;
    /// In the positions of the Model.
    std::vector<InitialPenetration> initial_penetrations() const;

  private:
    struct State;
    friend class Inspect;
    std::unique_ptr<State> state_;
};

}  // namespace reference
}  // namespace type21
