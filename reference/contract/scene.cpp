/// @file Which effects the fields of each interface ask for.
#include "scene.h"

#include <algorithm>
#include <utility>

namespace type21 {
namespace {

constexpr Effect last_effect = Effect::activity_window;

/// Istf 1 with Stfac 0 is an interface without stiffness; Istf 0 has the stiffness of its shells.
bool has_stiffness(const Interface& interface) {
    return interface.stfac > 0;
}

bool asks_for(const ContactModel& model, const Interface& interface, Effect effect) {
    switch (effect) {
        case Effect::elastic:
            return true;
        case Effect::damping:
            return interface.viss > 0 && has_stiffness(interface);
        case Effect::friction:
            return has_friction(model, interface);
        case Effect::friction_filter:
            return filters_friction(model, interface);
        case Effect::friction_heat_factor:
            return interface.function_friction >= 0 && uses_friction_function(interface);
        case Effect::gap_growth:
            return interface.igap == 2;
        case Effect::pmax_limit:
            return interface.igap == 2 && interface.pmax < no_limit;
        case Effect::skid_line:
            return interface.pskid < no_limit && has_friction(model, interface);
        case Effect::heat:
            return interface.ithe > 0;
        case Effect::adaptive_data:
            return interface.iadm != 0;
        case Effect::deletion:
            return interface.idel != 0;
        case Effect::release_bcs:
            return interface.ibc != 0;
        case Effect::normals_test:
            return interface.invn == 1;
        case Effect::tool_damping:
            return interface.damp != 0 || interface.dampr != 0;
        case Effect::initial_offset:
            return interface.inacti == 5 || interface.inacti == 6;
        case Effect::activity_window:
            return interface.sensor >= 0 || interface.tstart > 0 || interface.tstop < no_limit;
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
        case Effect::friction:
            return "friction (Fric, Ifric, /FRICTION)";
        case Effect::friction_filter:
            return "filter of the tangential force (Ifiltr, Xfreq)";
        case Effect::friction_heat_factor:
            return "friction that changes with temperature (fct_IDF)";
        case Effect::gap_growth:
            return "gap that follows the thickness (Igap 2)";
        case Effect::pmax_limit:
            return "limit of the contact pressure (Pmax, ITlim)";
        case Effect::skid_line:
            return "skid line (Pskid)";
        case Effect::heat:
            return "heat exchange (Ithe)";
        case Effect::adaptive_data:
            return "data for adaptive meshing (Iadm)";
        case Effect::deletion:
            return "nodes leave with their elements (Idel)";
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

std::vector<Effect> effects_of(const ContactModel& model, const Interface& interface) {
    std::vector<Effect> effects;
    for (int rank = 0; rank <= static_cast<int>(last_effect); ++rank)
        if (const auto effect = static_cast<Effect>(rank); asks_for(model, interface, effect))
            effects.push_back(effect);
    return effects;
}

Scene scene_of(std::shared_ptr<const ContactModel> model) {
    Scene scene;
    for (const Interface& interface : model->interfaces)
        scene.effects.push_back(effects_of(*model, interface));
    scene.model = std::move(model);
    return scene;
}

bool uses_friction_function(const Interface& interface) {
    return interface.fct_idf != 0 && interface.fric_id == 0 && interface.ifric == 0;
}

bool has_friction(const ContactModel& model, const Interface& interface) {
    if (interface.ifric != 0) return true;
    if (interface.friction_model < 0) return interface.fric > 0;
    const FrictionModel& friction = model.friction_models.at(static_cast<size_t>(interface.friction_model));
    return friction.fallback.fric > 0 ||
           std::any_of(friction.pairs.begin(), friction.pairs.end(),
                       [](const FrictionPair& pair) { return pair.coefficients.fric > 0; });
}

bool filters_friction(const ContactModel& model, const Interface& interface) {
    const bool of_card = interface.friction_model >= 0 && model.as_built.has(Departure::D28) &&
                         interface.card_ifiltr != 0 && interface.card_xfreq != 0;
    return has_friction(model, interface) && (of_card || (interface.ifiltr != 0 && interface.xfreq != 0));
}

}  // namespace type21
