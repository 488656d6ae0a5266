#include "verification/criteria/mutation/break_contact.h"

#include <algorithm>

namespace type21 {

namespace {

/// Wraps a sound contact; the parts that no mutation changes are passed on.
class Before : public ContactMethod {
  public:
    explicit Before(std::unique_ptr<ContactMethod> sound) : sound_(std::move(sound)) {}
    ContactStep step(const Motion& motion) override { return sound_->step(motion); }
    std::vector<InitialPenetration> initial_penetrations(const std::vector<Vec3>& position) const override {
        return sound_->initial_penetrations(position);
    }
    std::vector<EffectMemory> memory_by_effect() const override { return sound_->memory_by_effect(); }
    DecisionStageCounts decision_stage_counts() const override { return sound_->decision_stage_counts(); }

  protected:
    std::unique_ptr<ContactMethod> sound_;
};

class BrokenMotion final : public Before {
  public:
    using Change = std::function<void(Motion&, const Interface&)>;
    BrokenMotion(std::unique_ptr<ContactMethod> sound, const Scene& scene, int interface, Change change)
        : Before(std::move(sound)), scene_(scene), interface_(interface), change_(std::move(change)) {}
    ContactStep step(const Motion& motion) override {
        Motion changed = motion;
        change_(changed, scene_.model->interfaces[static_cast<size_t>(interface_)]);
        return sound_->step(changed);
    }

  private:
    Scene scene_;
    int interface_;
    Change change_;
};

class BrokenStep final : public Before {
  public:
    BrokenStep(std::unique_ptr<ContactMethod> sound, BreakStep change)
        : Before(std::move(sound)), change_(std::move(change)) {}
    ContactStep step(const Motion& motion) override {
        ContactStep step = sound_->step(motion);
        if (step.active) change_(step, motion);
        return step;
    }

  private:
    BreakStep change_;
};

class Forgetful final : public Before {
  public:
    Forgetful(const Scene& scene, int interface, MakeContact make)
        : Before(make(scene, interface)), scene_(scene), interface_(interface), make_(std::move(make)) {}
    ContactStep step(const Motion& motion) override {
        sound_ = make_(scene_, interface_);
        return sound_->step(motion);
    }

  private:
    Scene scene_;
    int interface_;
    MakeContact make_;
};

}  // namespace

BreakContact broken_card(std::function<void(ContactModel&, Interface&)> change, std::optional<Effect> without) {
    return [=](const Scene& scene, int interface, const MakeContact& sound) {
        auto model = std::make_shared<ContactModel>(*scene.model);
        change(*model, model->interfaces[static_cast<size_t>(interface)]);
        Scene changed = scene_of(model);
        if (without) std::erase(changed.effects[static_cast<size_t>(interface)], *without);
        return sound(changed, interface);
    };
}

BreakContact without_effect(Effect effect) {
    return broken_card([](ContactModel&, Interface&) {}, effect);
}

BreakContact broken_motion(std::function<void(Motion&, const Interface&)> change) {
    return [=](const Scene& scene, int interface, const MakeContact& sound) {
        return std::make_unique<BrokenMotion>(sound(scene, interface), scene, interface, change);
    };
}

BreakContact broken_step(std::function<BreakStep(const Scene&, int)> make) {
    return [=](const Scene& scene, int interface, const MakeContact& sound) {
        return std::make_unique<BrokenStep>(sound(scene, interface), make(scene, interface));
    };
}

BreakContact broken_sums(std::function<void(ContactStep&)> change) {
    return broken_step([=](const Scene&, int) { return [=](ContactStep& step, const Motion&) { change(step); }; });
}

BreakContact broken_nodes(std::function<void(NodeContact&)> change) {
    return broken_step([=](const Scene& scene, int interface) {
        return [=](ContactStep& step, const Motion& motion) {
            for (NodeContact& node : step.nodes)
                if (node.status != Status::open) change(node);
            sum_again(step, motion, scene.model->interfaces[static_cast<size_t>(interface)]);
        };
    });
}

BreakContact forgetful() {
    return [](const Scene& scene, int interface, const MakeContact& sound) {
        return std::make_unique<Forgetful>(scene, interface, sound);
    };
}

std::function<bool(const HostScene&, int)> has_effect(Effect effect) {
    return [=](const Scene& scene, int interface) { return scene.has(interface, effect); };
}

bool own_step(const HostScene& scene, int) {
    const EngineControl& engine = scene.host->engine;
    return !engine.largest_step || engine.first_step != engine.largest_step;
}

std::function<bool(const HostScene&, int)> has_card(std::function<bool(const Interface&)> such) {
    return [=](const Scene& scene, int interface) {
        return such(scene.model->interfaces[static_cast<size_t>(interface)]);
    };
}

}  // namespace type21
