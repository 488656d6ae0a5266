/// @file Defaults, line by line.
#include "reference/model/interface_defaults.h"

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/card_rules.h"
#include "reference/model/friction_rules.h"
#include "reference/model/heat_rules.h"

namespace type21 {
namespace {

/// @manual field Fscalegap, Gapmax, Pmax, ITlim
void apply_gap(Interface& it) {
    if (it.igap == 0) {
        idle(it.fscalegap, 1.0, "not used with Igap 0");
        idle(it.gapmax, no_limit, "not used with Igap 0");
    }
    default_for_zero(it.fscalegap, 1.0, "0 means 1");
    default_for_zero(it.gapmax, no_limit, "0 means no upper bound");
    if (it.igap != 2) idle(it.pmax, no_limit, "used with Igap 2 only");
    default_for_zero(it.pmax, no_limit, "0 means no limit");
}

/// @manual field Istf, Stfac, Stmin, Stmax, Pskid; comment 6, 11
void apply_stiffness(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.istf == 1) {
        idle(it.stmin, 0.0, "bounds the stiffness of Istf 0 only");
        idle(it.stmax, no_limit, "bounds the stiffness of Istf 0 only");
    }
    default_for_zero(it.stmax, no_limit, "0 means no upper bound");
    default_for_zero(it.pskid, no_limit, "0 means no limit");
    if (it.istf != 1) {
        default_for_zero(it.stfac, 1.0, "0 means 1");
    } else if (it.stfac == 0) {
        validator.warning("Stfac",
                          "with Istf 1 it is the stiffness itself: the interface has no stiffness and gives no force",
                          "Give the stiffness of a node, or Istf 0 for the stiffness of its shells");
    }
}

/// Without a sensor Tstart and Tstop bound the activity, with one it decides alone. Formulation 9, step 2.
/// @manual field Tstart, Tstop, sens_ID; comment 20
void apply_activity(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.sensor >= 0) {
        if (it.tstart != 0)
            validator.warning("Tstart", "is not used: sens_ID alone switches the interface", "Leave Tstart blank");
        if (it.tstop != 0)
            validator.warning("Tstop", "is not used: sens_ID alone switches the interface", "Leave Tstop blank");
        idle(it.tstart, 0.0, "not used: sens_ID decides");
        idle(it.tstop, no_limit, "not used: sens_ID decides");
    }
    default_for_zero(it.tstop, no_limit, it.sensor >= 0 ? "not used: sens_ID decides" : "0 means never");
}

/// Memory for candidates; no result depends on it (manual page, comment 10).
/// @manual field Bumult; comment 10
void apply_bumult(Interface& it, int nodes) {
    if (nodes > 2'500'000)
        default_for_zero(it.bumult, 0.40, "more than 2.5 million nodes");
    else if (nodes > 1'500'000)
        default_for_zero(it.bumult, 0.30, "more than 1.5 million nodes");
    default_for_zero(it.bumult, 0.20, "0 means 0.20");
}

/// @manual field NRadm, Padm, Angladm
void apply_adaptive(Interface& it) {
    if (it.iadm != 2) {
        const std::string why = "used with Iadm 2 only";
        idle(it.nradm, 1, why);
        idle(it.padm, 1.0, why);
        idle(it.angladm, 0.0, why);
        if (it.nradm == 0) take_default(it.nradm, 1, "1 but for Iadm 2");
        default_for_zero(it.padm, 1.0, "1 but for Iadm 2");
        return;
    }
    if (it.nradm == 0) take_default(it.nradm, 3, "0 means 3");
    default_for_zero(it.padm, 1.0, "0 means 1");
}

/// A negative Idel keeps the node in the model; in the interface both signs are the same.
/// @manual field Idel
void apply_deletion(Interface& it) {
    if (it.idel < 0) take_by_rule(it.idel, -it.idel, fmt::format("{} acts as {}", it.idel.value, -it.idel));
}

}  // namespace

void apply_interface_defaults(const CardValidator& validator) {
    Interface& it = validator.interface;
    take_as_built_values(validator);
    apply_deletion(it);
    apply_gap(it);
    apply_stiffness(validator);
    apply_activity(validator);
    default_for_zero(it.viss, 1.0, "0 means 1");
    apply_bumult(it, validator.model.nodes.size());
    apply_friction(validator);
    apply_adaptive(it);
    apply_heat(validator);
}

}  // namespace type21
