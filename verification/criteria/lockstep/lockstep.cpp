#include "verification/criteria/lockstep/lockstep.h"

#include <algorithm>

#include "verification/criteria/lockstep/step_difference.h"
#include "verification/support/contact_choice.h"

namespace type21 {

namespace {

/// Steps both with the same motion.
class Lockstep final : public ContactMethod {
  public:
    Lockstep(const Scene& scene, int interface, LockstepResult& result, const MakeContact& first,
             const MakeContact& second)
        : scene_(scene),
          first_(first(scene, interface)),
          second_(second(scene, interface)),
          difference_(scene.model->interfaces[static_cast<size_t>(interface)], *scene.model, result) {}

    ContactStep step(const Motion& motion) override {
        ContactStep reference = first_->step(motion);
        difference_.add(reference, second_->step(motion), motion, cycle_++);
        return reference;
    }
    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override {
        return first_->initial_penetrations(position);
    }
    std::vector<EffectMemory> memory_by_effect() const override { return first_->memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return first_->decision_stage_counts(); }

  private:
    Scene scene_;
    std::unique_ptr<ContactMethod> first_, second_;
    StepDifference difference_;
    long cycle_ = 0;
};

}  // namespace

LockstepResult& LockstepResult::operator+=(const LockstepResult& other) {
    cycles += other.cycles;
    decisions += other.decisions;
    in_contact += other.in_contact;
    different += other.different;
    grazing += other.grazing;
    lists += other.lists;
    for (size_t i = 0; i < tally.size(); ++i)
        tally[i] += other.tally[i];
    if (!first_decision) first_decision = other.first_decision;
    if (!first_force) first_force = other.first_force;
    return *this;
}

double LockstepResult::largest() const {
    double most = 0;
    for (const UlpTally& one : tally)
        most = std::max(most, one.largest());
    return most;
}

LockstepResult lockstep(const HostScene& scene, const MarchOptions& options, const MakeContact& first,
                        const MakeContact& second) {
    LockstepResult result;
    try {
        march(
            scene, [&](const Scene& s, int i) { return std::make_unique<Lockstep>(s, i, result, first, second); },
            [](const CycleRecord&) {}, options);
    } catch (const RunStopped&) {
        // What was compared until then counts.
    }
    return result;
}

LockstepResult lockstep(const HostScene& scene, const MarchOptions& options) {
    return lockstep(scene, options, contact_maker("reference"), contact_maker("optimized"));
}

}  // namespace type21
