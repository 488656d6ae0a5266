/// @file The rules of the card, line by line.
#include "reference/model/interface_rules.h"

#include <algorithm>
#include <initializer_list>

#include <fmt/format.h>

#include "reference/model/interface_fields.h"

namespace type21 {
namespace {

bool among(int value, std::initializer_list<int> allowed) {
    return std::find(allowed.begin(), allowed.end(), value) != allowed.end();
}

/// A flag outside its values.
void one_of(const InterfaceJudge& judge, std::string_view field, int value, std::initializer_list<int> allowed) {
    if (among(value, allowed)) return;
    judge.error(field, fmt::format("must be one of {}", fmt::join(allowed, ", ")), "Give one of these values");
}

void not_negative(const InterfaceJudge& judge, std::string_view field, double value) {
    if (value < 0) judge.error(field, "must not be negative", "Give 0 for the default, or a positive value");
}

void not_here(const InterfaceJudge& judge, std::string_view field, std::string_view effect, std::string remedy) {
    judge.error(field, fmt::format("this version has no {}", effect), std::move(remedy));
}

void unused(const InterfaceJudge& judge, std::string_view field, bool given, std::string_view reason) {
    if (given) judge.warning(field, fmt::format("has no effect: {}", reason), "Leave it blank to keep the deck clear");
}

void check_line_1(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    one_of(judge, "Istf", it.istf, {0, 1});
    if (it.ithe != 0) not_here(judge, "Ithe", "heat exchange", "Set Ithe to 0 for a run without temperatures");
    if (it.igap == 2)
        judge.error("Igap", "Igap 2 (thickness changing in time) is not in this version",
                    "Use Igap 1 (gap from the thickness at time 0) or 0");
    else
        one_of(judge, "Igap", it.igap, {0, 1, 2});  // D27, not reproduced: accepted as built
    one_of(judge, "Idel", it.idel, {0, 1, 2});
    unused(judge, "Idel", it.idel == 1 || it.idel == 2, "no element is ever deleted in this version");
    one_of(judge, "Invn", it.invn, {0, 1});
    if (it.iadm != 0) not_here(judge, "Iadm", "adaptive meshing data", "Set Iadm to 0; forces do not hang on it");
}

void check_line_2(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    not_negative(judge, "Fscalegap", it.fscalegap);
    not_negative(judge, "Gapmax", it.gapmax);
    not_negative(judge, "DEPTH", it.depth);
    not_negative(judge, "Pmax", it.pmax);
    one_of(judge, "ITlim", it.itlim, {0, 1});
    unused(judge, "Fscalegap", it.igap == 0 && it.fscalegap != 0, "the constant gap of Igap 0 is Gapmin");
    unused(judge, "Gapmax", it.igap == 0 && it.gapmax != 0, "the constant gap of Igap 0 is Gapmin");
    unused(judge, "Pmax", it.igap != 2 && it.pmax != 0, "Pmax is used only with Igap 2");
    unused(judge, "ITlim", it.igap != 2 && it.itlim != 0, "ITlim is used only with Igap 2, as Pmax is");
    if (it.igap != 0 && it.gapmax > 0 && it.gapmin > it.gapmax)
        judge.warning("Gapmin", fmt::format("is larger than Gapmax {}: every gap is Gapmin", judge.length(it.gapmax)),
                      "Give Gapmin <= Gapmax");
}

void check_line_3(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    not_negative(judge, "Stmin", it.stmin);
    not_negative(judge, "Stmax", it.stmax);
    not_negative(judge, "Pskid", it.pskid);
    if (it.stmax > 0 && it.stmin > it.stmax)
        judge.error(
            "Stmin",
            fmt::format("must not be larger than Stmax {} {}", it.stmax.value, judge.model.units.name(dim::stiffness)),
            "Give Stmin <= Stmax, or Stmax 0 for no upper bound");
    unused(judge, "Stmin", it.istf == 1 && it.stmin != 0, "it bounds the stiffness of Istf 0 only");
    unused(judge, "Stmax", it.istf == 1 && it.stmax != 0, "it bounds the stiffness of Istf 0 only");
    unused(judge, "Pskid", it.pskid != 0, "it needs /H3D/NODA/SKID_LINE, an output that this version does not have");
}

void check_line_4(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    not_negative(judge, "Stfac", it.stfac);
    not_negative(judge, "Fric", it.fric);
    not_negative(judge, "Gapmin", it.gapmin);
    not_negative(judge, "Tstart", it.tstart);
    not_negative(judge, "Tstop", it.tstop);
    if (it.sens_id == 0 && it.tstop > 0 && it.tstop < it.tstart)
        judge.warning("Tstop",
                      fmt::format("is before Tstart {} {}: the interface never acts", it.tstart.value,
                                  judge.model.units.name(dim::time)),
                      "Give Tstop > Tstart, or 0 for no end");
}

void check_line_5(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    if (!among(it.inacti, {0, 1, 3, 5, 6})) {
        if (!among(it.inacti, {2, 4}))
            one_of(judge, "Inacti", it.inacti, {0, 1, 3, 5, 6});
        else if (!judge.model.as_built.has(Departure::D20))
            judge.error("Inacti", "2 and 4 do not exist for TYPE21", "Give one of 0, 1, 3, 5, 6");
    }
    not_negative(judge, "VISs", it.viss);
    not_negative(judge, "Bumult", it.bumult);
}

/// Lines 6 to 8. With fric_ID those fields are not used: /FRICTION has its own.
void check_friction(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    one_of(judge, "Ifric", it.ifric, {0, 1, 2, 3, 4});
    one_of(judge, "Ifiltr", it.ifiltr, {0, 1, 2, 3});
    not_negative(judge, "Xfreq", it.xfreq);
    const bool by_model = it.fric_id != 0;
    const std::string_view taken = "/FRICTION of fric_ID takes its place";
    unused(judge, "Fric", by_model && it.fric != 0, taken);
    unused(judge, "Ifric", by_model && it.ifric != 0, taken);
    unused(judge, "Ifiltr", by_model && it.ifiltr != 0, taken);
    unused(judge, "fct_IDF", by_model && it.fct_idf != 0, taken);
    if (!by_model && it.ifric >= 1 && it.ifric <= 4)
        not_here(judge, "Ifric", "friction laws 1 to 4", "Use Ifric 0, Coulomb's law with Fric");
    if (!by_model && it.ifiltr != 0 && it.xfreq != 0)
        not_here(judge, "Ifiltr", "friction filter", "Set Ifiltr to 0, which filters nothing");
    if (!by_model && it.fct_idf != 0)
        not_here(judge, "fct_IDF", "friction that changes with temperature, since it has no heat exchange",
                 "Set fct_IDF to 0 and give the coefficient as Fric");
    unused(judge, "Xfreq", it.xfreq != 0 && (by_model || it.ifiltr == 0), by_model ? taken : "Ifiltr is 0");
    unused(judge, "AscaleF", it.ascalef != 0 && it.fct_idf == 0, "fct_IDF is 0");
    if (by_model || it.ifric == 0)
        for (const InterfaceField& field : interface_fields())
            if (const size_t* rank = std::get_if<size_t>(&field.member))
                unused(judge, field.name, it.c.at(*rank) != 0,
                       by_model ? taken : "Ifric is 0, Coulomb's law has Fric alone");
}

void check_line_9(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    unused(judge, "NRadm", it.nradm != 0, "it is used with Iadm 2 only");
    unused(judge, "Padm", it.padm != 0, "it is used with Iadm 2 only");
    unused(judge, "Angladm", it.angladm != 0, "it is used with Iadm 2 only");
}

/// Lines 10 and 11. With Ithe the card is refused as a whole, so these fields need no second word.
void check_heat(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    if (it.fct_idk != 0) not_here(judge, "fct_IDK", "heat exchange", "Set fct_IDK to 0");
    if (it.fcond != 0) not_here(judge, "Fcond", "heat exchange", "Set Fcond to 0");
    if (it.ithe != 0) return;
    const std::string_view reason = "Ithe is 0, there is no heat exchange";
    unused(judge, "Kthe", it.kthe != 0, reason);
    unused(judge, "AscaleK", it.ascalek != 0, reason);
    unused(judge, "Tint", it.tint != 0, reason);
    unused(judge, "Ithe_form", it.ithe_form != 0, reason);
    unused(judge, "Frad", it.frad != 0, reason);
    unused(judge, "Drad", it.drad != 0, reason);
    unused(judge, "Fheat", it.fheat != 0, reason);
    unused(judge, "Dcond", it.dcond != 0, reason);
}

void check_line_12(const InterfaceJudge& judge) {
    const Interface& it = judge.interface;
    not_negative(judge, "Damp", it.damp);
    not_negative(judge, "Dampr", it.dampr);
    unused(judge, "IDref", it.idref != 0 && it.damp == 0 && it.dampr == 0,
           "Damp and Dampr are 0, there is no tool damping");
}

}  // namespace

void check_interface_card(const InterfaceJudge& judge) {
    check_line_1(judge);
    check_line_2(judge);
    check_line_3(judge);
    check_line_4(judge);
    check_line_5(judge);
    check_friction(judge);
    check_line_9(judge);
    check_heat(judge);
    check_line_12(judge);
}

}  // namespace type21
