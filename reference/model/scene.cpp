/// @file plan(): which effects the fields of each interface ask for.
#include "reference/model/scene.h"

#include <algorithm>

#include "reference/model/card_rules.h"
#include "reference/model/friction_rules.h"

namespace type21 {
namespace {

constexpr Effect last_effect = Effect::activity_window;

/// Istf 1 with Stfac 0 is an interface without stiffness; Istf 0 has the stiffness of its shells.
bool has_stiffness(const Interface& interface) {
    return interface.stfac > 0;
}

bool asks_for(const Model& model, const Interface& interface, Effect effect) {
    switch (effect) {
        case Effect::elastic:
            return true;
        case Effect::damping:
            return interface.viss > 0 && has_stiffness(interface);
        case Effect::friction:
            return rubs(model, interface);
        case Effect::friction_filter:
            return filters_friction(model, interface);
        case Effect::friction_heat_factor:
            return interface.function_friction >= 0 && uses_friction_function(interface);
        case Effect::gap_growth:
            return interface.igap == 2;
        case Effect::pmax_limit:
            return interface.igap == 2 && interface.pmax < no_limit;
        case Effect::skid_line:
            return interface.pskid < no_limit && rubs(model, interface);
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

Scene plan(std::shared_ptr<const Model> model) {
    Scene scene;
    for (const Interface& interface : model->interfaces) {
        std::vector<Effect> list;
        for (int rank = 0; rank <= static_cast<int>(last_effect); ++rank)
            if (const auto effect = static_cast<Effect>(rank); asks_for(*model, interface, effect))
                list.push_back(effect);
        scene.effects.push_back(std::move(list));
    }
    scene.model = std::move(model);
    return scene;
}

}  // namespace type21
