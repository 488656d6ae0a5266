/// @file The effects that an interface may ask for.
#pragma once

#include <string_view>

namespace type21 {

inline constexpr double no_limit = 1e30;  ///< a limit of this size or more is none; the "1030" of the manual page

/// What an interface computes. Each but `elastic` is there only when its card asks for it.  Formulation 9, step 17.
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

/// What the effect computes, in words.
std::string_view name(Effect effect);

}  // namespace type21
