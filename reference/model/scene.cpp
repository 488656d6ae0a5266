/// @file plan(): which effects the fields of each interface ask for.
#include "reference/model/scene.h"

#include <algorithm>

namespace type21 {
namespace {

/// Istf 1 with Stfac 0 is an interface without stiffness; Istf 0 has the stiffness of its shells.
bool has_stiffness(const Interface& interface) {
    return interface.stfac > 0;
}

/// /FRICTION replaces Fric of the card: its default and each of its part pairs may rub.
bool has_friction(const Model& model, const Interface& interface) {
    if (interface.friction_model < 0) return interface.fric > 0;
    const FrictionModel& friction = model.friction_models.at(static_cast<size_t>(interface.friction_model));
    return friction.fallback.fric > 0 ||
           std::any_of(friction.pairs.begin(), friction.pairs.end(),
                       [](const FrictionPair& pair) { return pair.coefficients.fric > 0; });
}

bool asks_for(const Model& model, const Interface& interface, Effect effect) {
    switch (effect) {
        case Effect::elastic:
            return true;
        case Effect::damping:
            return interface.viss > 0 && has_stiffness(interface);
        case Effect::coulomb:
            return has_friction(model, interface);
        case Effect::release_bcs:
            return interface.ibc != 0;
        case Effect::normals_test:
            return interface.invn == 1;
        case Effect::tool_damping:
            return interface.damp != 0 || interface.dampr != 0;
        case Effect::initial_offset:
            return interface.inacti == 5 || interface.inacti == 6;
        case Effect::activity_window:
            return interface.sensor >= 0 || interface.tstart > 0 || interface.tstop < 1e30;
    }
    return false;
}

}  // namespace

std::string_view name(Effect effect) {
    switch (effect) {
        case Effect::elastic:
            return "penalty force";
        case Effect::damping:
            return "contact damping (VISs)";
        case Effect::coulomb:
            return "Coulomb friction";
        case Effect::release_bcs:
            return "release of boundary conditions (IBC)";
        case Effect::normals_test:
            return "test for inverted main normals (Invn)";
        case Effect::tool_damping:
            return "tool damping (Damp, Dampr)";
        case Effect::initial_offset:
            return "initial penetration offset (Inacti)";
        case Effect::activity_window:
            return "activity in time (Tstart, Tstop, sens_ID)";
    }
    return "";
}

bool Scene::has(int interface, Effect effect) const {
    const auto& list = effects.at(static_cast<size_t>(interface));
    return std::find(list.begin(), list.end(), effect) != list.end();
}

Scene plan(std::shared_ptr<const Model> model) {
    constexpr Effect every[] = {Effect::elastic,        Effect::damping,        Effect::coulomb,
                                Effect::release_bcs,    Effect::normals_test,   Effect::tool_damping,
                                Effect::initial_offset, Effect::activity_window};
    Scene scene;
    for (const Interface& interface : model->interfaces) {
        std::vector<Effect> list;
        for (const Effect effect : every)
            if (asks_for(*model, interface, effect)) list.push_back(effect);
        scene.effects.push_back(std::move(list));
    }
    scene.model = std::move(model);
    return scene;
}

}  // namespace type21
