/// @file The rules of the card, line by line.
#include "reference/model/interface_rules.h"

#include <fmt/format.h>

#include "reference/model/card_rules.h"
#include "reference/model/friction_rules.h"
#include "reference/model/heat_rules.h"

namespace type21 {
namespace {

void check_line_1(const CardValidator& judge) {
    const Interface& it = judge.interface;
    one_of(judge, "Istf", it.istf, {0, 1});
    one_of(judge, "Igap", it.igap, {0, 1, 2});  // D27, not reproduced: accepted as built
    one_of(judge, "Idel", it.idel, {-2, -1, 0, 1, 2});
    if (it.idel == -1 || it.idel == -2)
        judge.warning("Idel",
                      fmt::format("acts as {}: the sign only keeps the node in the model, it leaves the interface all "
                                  "the same",
                                  -it.idel),
                      fmt::format("Give {}", -it.idel));
    one_of(judge, "Invn", it.invn, {0, 1});
    one_of(judge, "Iadm", it.iadm, {0, 1, 2});
    if (it.iadm == 1 || it.iadm == 2)
        judge.warning("Iadm", "no element is divided: what would divide which element is computed and written",
                      "Nothing needs to be done; forces do not hang on it");
}

void check_line_2(const CardValidator& judge) {
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
    unused(judge, "ITlim", it.igap == 2 && it.itlim == 1 && it.pmax == 0, "Pmax is 0, there is no limit");
    if (it.igap != 0 && it.gapmax > 0 && it.gapmin > it.gapmax)
        judge.warning("Gapmin", fmt::format("is larger than Gapmax {}: every gap is Gapmin", judge.length(it.gapmax)),
                      "Give Gapmin <= Gapmax");
}

void check_line_3(const CardValidator& judge) {
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
}

void check_line_4(const CardValidator& judge) {
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

void check_line_5(const CardValidator& judge) {
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

void check_line_9(const CardValidator& judge) {
    const Interface& it = judge.interface;
    constexpr double half_turn = 180;
    const bool used = it.iadm == 2;
    const std::string_view reason = "it is used with Iadm 2 only";
    unused(judge, "NRadm", it.nradm != 0 && !used, reason);
    unused(judge, "Padm", it.padm != 0 && !used, reason);
    unused(judge, "Angladm", it.angladm != 0 && !used, reason);
    if (!used) return;
    not_negative(judge, "NRadm", it.nradm);
    not_negative(judge, "Padm", it.padm);
    if (it.angladm < 0 || it.angladm > half_turn)
        judge.error("Angladm", "is an angle in degrees between 0 and 180", "Give for example 30");
    if (it.angladm == 0)
        judge.warning("Angladm", "has no default: with 0 every bend of the tool counts", "Give an angle in degrees");
}

void check_line_12(const CardValidator& judge) {
    const Interface& it = judge.interface;
    not_negative(judge, "Damp", it.damp);
    not_negative(judge, "Dampr", it.dampr);
    unused(judge, "IDref", it.idref != 0 && it.damp == 0 && it.dampr == 0,
           "Damp and Dampr are 0, there is no tool damping");
}

}  // namespace

void check_interface_card(const CardValidator& judge) {
    check_line_1(judge);
    check_line_2(judge);
    check_line_3(judge);
    check_line_4(judge);
    check_line_5(judge);
    check_friction_card(judge);
    check_line_9(judge);
    check_heat_card(judge);
    check_line_12(judge);
}

}  // namespace type21
