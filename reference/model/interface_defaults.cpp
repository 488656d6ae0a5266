/// @file Defaults, line by line.
#include "reference/model/interface_defaults.h"

#include <fmt/format.h>

#include "reference/model/sourced_rules.h"

namespace type21 {
namespace {

constexpr double no_limit = 1e30;  ///< the page's "1030"

void default_for_zero(Sourced<double>& field, double value, const std::string& why) {
    if (field == 0) take_default(field, value, why);
}

/// A field that another one makes idle: if the deck gave it, the value that does nothing takes its place, with the
/// reason.
template <class T>
void idle(Sourced<T>& field, T nothing, const std::string& why) {
    if (field.value != T{}) take_by_rule(field, nothing, why);
}

void apply_gap(Interface& it, const AsBuilt& as_built) {
    if (it.igap == 0) {
        idle(it.fscalegap, 1.0, "not used with Igap 0");
        idle(it.gapmax, no_limit, "not used with Igap 0");
        if (as_built.has(Departure::D03)) idle(it.depth, 0.0, "D03: DEPTH is ignored with Igap 0");
    }
    default_for_zero(it.fscalegap, 1.0, "0 means 1");
    default_for_zero(it.gapmax, no_limit, "0 means no upper bound");
    if (it.igap != 2) idle(it.pmax, no_limit, "used with Igap 2 only");
    default_for_zero(it.pmax, no_limit, "0 means no limit");
}

void apply_stiffness(const InterfaceJudge& judge) {
    Interface& it = judge.interface;
    if (it.istf == 1) {
        idle(it.stmin, 0.0, "bounds the stiffness of Istf 0 only");
        idle(it.stmax, no_limit, "bounds the stiffness of Istf 0 only");
    }
    default_for_zero(it.stmax, no_limit, "0 means no upper bound");
    default_for_zero(it.pskid, no_limit, "0 means no limit");
    if (it.istf != 1) {
        default_for_zero(it.stfac, 1.0, "0 means 1");
    } else if (it.stfac == 0 && judge.model.as_built.has(Departure::D02)) {
        take_default(it.stfac, 1.0, "D02: 0 means 1 in work units");
    } else if (it.stfac == 0) {
        judge.warning("Stfac",
                      "with Istf 1 it is the stiffness itself: the interface has no stiffness and gives no force",
                      "Give the stiffness of a node, or Istf 0 for the stiffness of its shells");
    }
}

/// Without a sensor Tstart and Tstop bound the activity, with one it decides alone. Source: page, comment 20.
void apply_activity(const InterfaceJudge& judge) {
    Interface& it = judge.interface;
    if (it.sensor >= 0 && judge.model.as_built.has(Departure::D09)) {
        it.sensor = -1;
        take_by_rule(it.sens_id, it.sens_id.value, "D09: the sensor is ignored");
    }
    if (it.sensor >= 0) {
        if (it.tstart != 0)
            judge.warning("Tstart", "is not used: sens_ID alone switches the interface", "Leave Tstart blank");
        if (it.tstop != 0)
            judge.warning("Tstop", "is not used: sens_ID alone switches the interface", "Leave Tstop blank");
        idle(it.tstart, 0.0, "not used: sens_ID decides");
        idle(it.tstop, no_limit, "not used: sens_ID decides");
    }
    default_for_zero(it.tstop, no_limit, it.sensor >= 0 ? "not used: sens_ID decides" : "0 means never");
}

/// D20: as built 2, 3 and 4 are answered by a message and act as 0.
void apply_inacti(const InterfaceJudge& judge) {
    Interface& it = judge.interface;
    if (!judge.model.as_built.has(Departure::D20) || it.inacti < 2 || it.inacti > 4) return;
    judge.warning("Inacti", "D20: is not available and acts as 0", "Give one of 0, 1, 5, 6");
    take_by_rule(it.inacti, 0, fmt::format("D20: {} acts as 0", it.inacti.value));
}

/// Room for candidates; the answer never hangs on it. Source: page, comment 10.
void apply_bumult(Interface& it, int nodes) {
    if (nodes > 2'500'000)
        default_for_zero(it.bumult, 0.40, "more than 2.5 million nodes");
    else if (nodes > 1'500'000)
        default_for_zero(it.bumult, 0.30, "more than 1.5 million nodes");
    default_for_zero(it.bumult, 0.20, "0 means 0.20");
}

/// /FRICTION replaces the friction fields of the card. Source: formulation 8.
void apply_friction_model(const InterfaceJudge& judge) {
    Interface& it = judge.interface;
    if (it.friction_model < 0) return;
    const FrictionModel& model = judge.model.friction_models[static_cast<size_t>(it.friction_model)];
    const std::string why = fmt::format("from /FRICTION/{}", model.id);
    take_by_rule(it.ifric, model.ifric, why);
    take_by_rule(it.ifiltr, model.ifiltr, why);
    take_by_rule(it.xfreq, model.xfreq, why);
    take_by_rule(it.fric, model.fallback.fric,
                 why + (model.pairs.empty() ? "" : ", for parts that are not in its pairs"));
    for (size_t rank = 0; rank < it.c.size(); ++rank)
        take_by_rule(it.c[rank], model.fallback.c[rank], why);
    idle(it.fct_idf, Id{0}, "not used with fric_ID");
    if (model.ifric != 0)
        judge.error_with("fric_ID", fmt::format("{} (Ifric {})", model.id, model.ifric),
                         "this version has no friction laws 1 to 4",
                         "Use Ifric 0 in /FRICTION, Coulomb's law with Fric");
    if (model.ifiltr != 0 && model.xfreq != 0)
        judge.error_with("fric_ID", fmt::format("{} (Ifiltr {})", model.id, model.ifiltr),
                         "this version has no friction filter", "Set Ifiltr to 0 in /FRICTION");
}

void apply_friction(const InterfaceJudge& judge) {
    Interface& it = judge.interface;
    apply_friction_model(judge);
    if (it.xfreq == 0) idle(it.ifiltr, 0, "Xfreq 0: no filter");
    default_for_zero(it.ascalef, 1.0, "0 means 1");
}

/// Without Ithe nothing of lines 10 and 11 may reach a search distance or a step limit.
void apply_heat(const InterfaceJudge& judge) {
    Interface& it = judge.interface;
    // Blank is one pressure unit of the card, not of the work units.
    const double one_pressure = conversion(judge.card.from(), judge.card.to(), dim::pressure);
    if (it.ithe == 0) {
        const std::string why = "not used without Ithe";
        for (Sourced<double>* field : {&it.kthe, &it.tint, &it.frad, &it.drad, &it.fheat, &it.dcond})
            idle(*field, 0.0, why);
        idle(it.ascalek, one_pressure, why);
        idle(it.ithe_form, 0, why);
    }
    default_for_zero(it.ascalek, one_pressure, "0 means 1 in the units of the card");
}

void apply_adaptive(Interface& it) {
    if (it.nradm == 0) take_default(it.nradm, 3, "0 means 3");
    default_for_zero(it.padm, 1.0, "0 means 1");
}

}  // namespace

void apply_interface_defaults(const InterfaceJudge& judge) {
    Interface& it = judge.interface;
    apply_gap(it, judge.model.as_built);
    apply_stiffness(judge);
    apply_activity(judge);
    apply_inacti(judge);
    default_for_zero(it.viss, 1.0, "0 means 1");
    apply_bumult(it, judge.model.nodes.size());
    apply_friction(judge);
    apply_adaptive(it);
    apply_heat(judge);
}

}  // namespace type21
