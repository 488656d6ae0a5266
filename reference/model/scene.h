/// @file The Scene: the Model plus the effects that each interface asks for, and no others.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reference/model/model.h"

namespace type21 {

/// What an interface computes. Each but `elastic` is there only when its card asks for it.
enum class Effect {
    elastic,               ///< penalty force (always)
    damping,               ///< VISs
    friction,              ///< Fric, Ifric 1 to 4, /FRICTION
    friction_filter,       ///< Ifiltr
    friction_heat_factor,  ///< fct_IDF
    gap_growth,            ///< Igap 2
    pmax_limit,            ///< Pmax, with Igap 2
    skid_line,             ///< Pskid
    heat,                  ///< Ithe
    adaptive_data,         ///< Iadm
    deletion,              ///< Idel
    release_bcs,           ///< IBC
    normals_test,          ///< Invn
    tool_damping,          ///< Damp, Dampr
    initial_offset,        ///< Inacti 5, 6
    activity_window        ///< Tstart, Tstop or a sensor
};

std::string_view name(Effect effect);

struct Scene {
    std::shared_ptr<const Model> model;
    std::vector<std::vector<Effect>> effects;  ///< per interface, in the order of the enum

    bool has(int interface, Effect effect) const;
};

Scene plan(std::shared_ptr<const Model> model);

}  // namespace type21
