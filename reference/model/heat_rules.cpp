/// @file Ithe, lines 10 and 11.
#include "reference/model/heat_rules.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/card_rules.h"
#include "reference/model/friction_rules.h"

namespace type21 {
namespace {

void check_unused(const CardValidator& validator) {
    const Interface& it = validator.interface;
    const std::string_view reason = "Ithe is 0, there is no heat exchange";
    unused(validator, "Kthe", it.kthe != 0, reason);
    unused(validator, "fct_IDK", it.fct_idk != 0, reason);
    unused(validator, "AscaleK", it.ascalek != 0, reason);
    unused(validator, "Tint", it.tint != 0, reason);
    unused(validator, "Ithe_form", it.ithe_form != 0, reason);
    unused(validator, "Frad", it.frad != 0, reason);
    unused(validator, "Drad", it.drad != 0, reason);
    unused(validator, "Fheat", it.fheat != 0, reason);
    unused(validator, "Fcond", it.fcond != 0, reason);
    unused(validator, "Dcond", it.dcond != 0, reason);
}

/// Tint is the tool's temperature only while the tool has none of its own.
void check_tool_temperature(const CardValidator& validator) {
    const Interface& it = validator.interface;
    const bool constant = it.ithe == 1 && it.ithe_form == 0;
    const bool in_friction = validator.reading().friction_takes_tint && uses_friction_function(it);
    unused(validator, "Tint", it.tint != 0 && !constant && !in_friction, "the tool has the temperatures of its nodes");
    if (it.tint < 0)
        validator.error("Tint", "an absolute temperature is not negative", "Give it in K");
    else if (constant && it.tint == 0 && (it.kthe != 0 || it.frad != 0))
        validator.warning("Tint", "the tool is at absolute zero", "Give the tool's temperature in K");
}

}  // namespace

void check_heat_card(const CardValidator& validator) {
    const Interface& it = validator.interface;
    one_of(validator, "Ithe", it.ithe, {0, 1, 2});
    if (it.ithe == 0) return check_unused(validator);
    one_of(validator, "Ithe_form", it.ithe_form, {0, 1});
    not_negative(validator, "Kthe", it.kthe);
    not_negative(validator, "Frad", it.frad);
    not_negative(validator, "Drad", it.drad);
    not_negative(validator, "Fheat", it.fheat);
    not_negative(validator, "Dcond", it.dcond);
    unused(validator, "AscaleK", it.ascalek != 0 && it.fct_idk == 0, "fct_IDK is 0");
    unused(validator, "Drad", it.drad > 0 && it.frad == 0, "Frad is 0, nothing radiates");
    unused(validator, "Dcond", it.dcond > 0 && it.fcond == 0, "Fcond is 0, nothing is conducted beyond the gap");
    check_tool_temperature(validator);
    if (it.fheat > 1)
        validator.warning("Fheat", "is a share of the friction work, and above 1: more heat than work", "Give 0 to 1");
    if (it.kthe == 0 && it.fct_idk != 0 && !validator.reading().kthe_zero_means_one)
        validator.warning("Kthe", "is the scale of fct_IDK and 0: no heat is conducted",
                          "Give Kthe, 1 to take fct_IDK as it is");
    if (it.kthe == 0 && it.fct_idk == 0) {
        unused(validator, "Fcond", it.fcond != 0, "it scales Kthe, and Kthe is 0");
        if (it.frad == 0 && it.fheat == 0)
            validator.warning("Ithe", "no heat is exchanged: Kthe, Frad and Fheat are 0",
                              "Give one of them, or set Ithe to 0");
    }
}

double one_of_card(const CardValidator& validator, Dimension dimension) {
    return conversion(validator.card.from(), validator.card.to(), dimension);
}

/// @manual field Ithe, Kthe, AscaleK
void apply_heat(const CardValidator& validator) {
    Interface& it = validator.interface;
    // A blank AscaleK is 1 in the units of the card, not in work units.
    const double one_pressure = one_of_card(validator, dim::pressure);
    if (it.ithe == 0) {
        const std::string why = "not used without Ithe";
        for (Sourced<double>* field : {&it.kthe, &it.tint, &it.frad, &it.drad, &it.fheat, &it.dcond})
            idle(*field, 0.0, why);
        idle(it.ascalek, one_pressure, why);
        idle(it.ithe_form, 0, why);
        idle(it.fct_idk, Id{0}, why);
        idle(it.fcond, Id{0}, why);
    }
    default_for_zero(it.ascalek, one_pressure, "0 means 1 in the units of the card");
}

/// @manual field Fcond; comment 22
void check_distance_function(const CardValidator& validator) {
    const Interface& it = validator.interface;
    if (it.function_distance < 0) return;
    const Function& function = validator.model.functions[static_cast<size_t>(it.function_distance)];
    const auto check = [&](std::string_view axis, const std::vector<double>& values) {
        const auto outside =
            std::find_if(values.begin(), values.end(), [](double value) { return value < 0 || value > 1; });
        if (outside == values.end()) return;
        validator.error_with(
            "Fcond", fmt::format("{} ({} = {})", function.id, axis, *outside),
            "abscissae and ordinates of this function are between 0 and 1",
            fmt::format("Mend /FUNCT/{}: share of the way from gap to Dcond against share of Kthe", function.id));
    };
    check("X", function.x);
    check("Y", function.y);
}

}  // namespace type21
