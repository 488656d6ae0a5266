/// @file The rules of the card, line by line.
#include "reference/model/interface_rules.h"

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/card_rules.h"
#include "reference/model/friction_rules.h"
#include "reference/model/heat_rules.h"

namespace type21 {
namespace {

void check_line_1(const CardValidator& validator) {
    const Interface& it = validator.interface;
    one_of(validator, "Istf", it.istf, {0, 1});
    one_of(validator, "Igap", it.igap, {0, 1, 2});  // D27, not reproduced: accepted as built
    one_of(validator, "Idel", it.idel, {-2, -1, 0, 1, 2});
    if (it.idel == -1 || it.idel == -2)
        validator.warning(
            "Idel",
            fmt::format("acts as {}: the sign only keeps the node in the model, it leaves the interface all "
                        "the same",
                        -it.idel),
            fmt::format("Give {}", -it.idel));
    one_of(validator, "Invn", it.invn, {0, 1});
    one_of(validator, "Iadm", it.iadm, {0, 1, 2});
    if (it.iadm == 1 || it.iadm == 2)
        validator.warning("Iadm", "no element is divided: what would divide which element is computed and written",
                          "Nothing needs to be done; forces do not depend on it");
}

void check_line_2(const CardValidator& validator) {
    const Interface& it = validator.interface;
    not_negative(validator, "Fscalegap", it.fscalegap);
    not_negative(validator, "Gapmax", it.gapmax);
    not_negative(validator, "DEPTH", it.depth);
    not_negative(validator, "Pmax", it.pmax);
    one_of(validator, "ITlim", it.itlim, {0, 1});
    unused(validator, "Fscalegap", it.igap == 0 && it.fscalegap != 0, "the constant gap of Igap 0 is Gapmin");
    unused(validator, "Gapmax", it.igap == 0 && it.gapmax != 0, "the constant gap of Igap 0 is Gapmin");
    unused(validator, "Pmax", it.igap != 2 && it.pmax != 0, "Pmax is used only with Igap 2");
    unused(validator, "ITlim", it.igap != 2 && it.itlim != 0, "ITlim is used only with Igap 2, as Pmax is");
    unused(validator, "ITlim", it.igap == 2 && it.itlim == 1 && it.pmax == 0, "Pmax is 0, there is no limit");
    if (it.igap != 0 && it.gapmax > 0 && it.gapmin > it.gapmax)
        validator.warning("Gapmin",
                          fmt::format("is larger than Gapmax {}: every gap is Gapmin", validator.length(it.gapmax)),
                          "Give Gapmin <= Gapmax");
}

void check_line_3(const CardValidator& validator) {
    const Interface& it = validator.interface;
    not_negative(validator, "Stmin", it.stmin);
    not_negative(validator, "Stmax", it.stmax);
    not_negative(validator, "Pskid", it.pskid);
    if (it.stmax > 0 && it.stmin > it.stmax)
        validator.error("Stmin",
                        fmt::format("must not be larger than Stmax {} {}", it.stmax.value,
                                    validator.model.units.name(dim::stiffness)),
                        "Give Stmin <= Stmax, or Stmax 0 for no upper bound");
    unused(validator, "Stmin", it.istf == 1 && it.stmin != 0, "it bounds the stiffness of Istf 0 only");
    unused(validator, "Stmax", it.istf == 1 && it.stmax != 0, "it bounds the stiffness of Istf 0 only");
}

void check_line_4(const CardValidator& validator) {
    const Interface& it = validator.interface;
    not_negative(validator, "Stfac", it.stfac);
    not_negative(validator, "Fric", it.fric);
    not_negative(validator, "Gapmin", it.gapmin);
    not_negative(validator, "Tstart", it.tstart);
    not_negative(validator, "Tstop", it.tstop);
    if (it.sens_id == 0 && it.tstop > 0 && it.tstop < it.tstart)
        validator.warning("Tstop",
                          fmt::format("is before Tstart {} {}: the interface never acts", it.tstart.value,
                                      validator.model.units.name(dim::time)),
                          "Give Tstop > Tstart, or 0 for no end");
}

void check_line_5(const CardValidator& validator) {
    const Interface& it = validator.interface;
    validator.reading().check_inacti(validator);
    not_negative(validator, "VISs", it.viss);
    not_negative(validator, "Bumult", it.bumult);
}

void check_line_9(const CardValidator& validator) {
    const Interface& it = validator.interface;
    constexpr double half_turn = 180;
    const bool used = it.iadm == 2;
    const std::string_view reason = "it is used with Iadm 2 only";
    unused(validator, "NRadm", it.nradm != 0 && !used, reason);
    unused(validator, "Padm", it.padm != 0 && !used, reason);
    unused(validator, "Angladm", it.angladm != 0 && !used, reason);
    if (!used) return;
    not_negative(validator, "NRadm", it.nradm);
    not_negative(validator, "Padm", it.padm);
    if (it.angladm < 0 || it.angladm > half_turn)
        validator.error("Angladm", "is an angle in degrees between 0 and 180", "Give for example 30");
    if (it.angladm == 0)
        validator.warning("Angladm", "has no default: with 0 every bend of the tool counts",
                          "Give an angle in degrees");
}

void check_line_12(const CardValidator& validator) {
    const Interface& it = validator.interface;
    not_negative(validator, "Damp", it.damp);
    not_negative(validator, "Dampr", it.dampr);
    unused(validator, "IDref", it.idref != 0 && it.damp == 0 && it.dampr == 0,
           "Damp and Dampr are 0, there is no tool damping");
}

}  // namespace

/// @manual field Inacti
void check_inacti(const CardValidator& validator) {
    const int inacti = validator.interface.inacti;
    if (among(inacti, {2, 4}))
        validator.error("Inacti", "2 and 4 do not exist for TYPE21", "Give one of 0, 1, 3, 5, 6");
    else
        one_of(validator, "Inacti", inacti, {0, 1, 3, 5, 6});
}

void check_interface_card(const CardValidator& validator) {
    check_line_1(validator);
    check_line_2(validator);
    check_line_3(validator);
    check_line_4(validator);
    check_line_5(validator);
    check_friction_card(validator);
    check_line_9(validator);
    check_heat_card(validator);
    check_line_12(validator);
}

}  // namespace type21
