/// @file Lines 6 to 8.
#include "reference/model/friction_rules.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/card_rules.h"
#include "reference/model/friction_conditions.h"
#include "reference/model/interface_fields.h"
#include "reference/model/sourced_rules.h"

namespace type21 {
namespace {

std::string_view coefficient_name(size_t rank) {
    constexpr std::string_view names[] = {"C1", "C2", "C3", "C4", "C5", "C6"};
    return names[rank];
}

/// How many of C1..C6 a law reads (manual page, comment 13, table 1).
size_t coefficients_of(int ifric) {
    constexpr size_t count[] = {0, 5, 6, 6, 2};
    return ifric >= 0 && ifric <= 4 ? count[ifric] : 6;
}

/// @manual field Ifric; comment 13
void check_law(const CardValidator& validator) {
    const Interface& it = validator.interface;
    for (size_t rank = coefficients_of(it.ifric); rank < it.c.size(); ++rank)
        unused(validator, coefficient_name(rank), it.c.at(rank) != 0,
               it.ifric == 0 ? "Ifric is 0, Coulomb's law has Fric alone"
                             : fmt::format("law {} does not use it", it.ifric.value));
    unused(validator, "Fric", it.ifric == 3 && it.fric != 0, "the Renard law has C1 to C6 alone");
    if (it.ifric != 3) return;
    std::array<double, 6> c{};
    std::copy(it.c.begin(), it.c.end(), c.begin());
    for (const ConditionFault& fault : validator.reading().renard_faults(c, validator.model.units))
        validator.error(coefficient_name(fault.rank), fault.rule, fault.remedy);
}

/// @manual field fct_IDF
void check_function(const CardValidator& validator) {
    const Interface& it = validator.interface;
    unused(validator, "AscaleF", it.ascalef != 0 && it.fct_idf == 0, "fct_IDF is 0");
    if (it.fct_idf == 0) return;
    unused(validator, "fct_IDF", it.ifric != 0, "it scales Fric of Ifric 0 only");
    if (uses_friction_function(it) && it.ithe == 0)
        validator.error("fct_IDF", "friction that depends on temperature needs temperatures, and Ithe is 0",
                        "Set Ithe to 1 or 2, or set fct_IDF to 0 and give the coefficient as Fric");
}

/// @manual departure D28
void check_replaced(const CardValidator& validator) {
    const Interface& it = validator.interface;
    const std::string_view taken = "/FRICTION of fric_ID takes its place";
    const bool filter_stays = validator.reading().filter_of_card_stays;
    unused(validator, "Fric", it.fric != 0, taken);
    unused(validator, "Ifric", it.ifric != 0, taken);
    unused(validator, "Ifiltr", it.ifiltr != 0 && !filter_stays, taken);
    unused(validator, "Xfreq", it.xfreq != 0 && !filter_stays, taken);
    unused(validator, "fct_IDF", it.fct_idf != 0, taken);
    unused(validator, "AscaleF", it.ascalef != 0, taken);
    for (size_t rank = 0; rank < it.c.size(); ++rank)
        unused(validator, coefficient_name(rank), it.c.at(rank) != 0, taken);
}

/// /FRICTION replaces the friction fields of the card. Formulation 8, step 1.
/// @manual field fric_ID
void apply_friction_model(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.friction_model < 0) return;
    const FrictionModel& model = validator.model.friction_models[static_cast<size_t>(it.friction_model)];
    const std::string why = fmt::format("from /FRICTION/{}", model.id);
    const std::string of_default = why + (model.pairs.empty() ? "" : ", for parts that are not in its pairs");
    take_by_rule(it.ifric, model.ifric, why);
    take_by_rule(it.ifiltr, model.ifiltr, why);
    take_by_rule(it.xfreq, model.xfreq, why);
    take_by_rule(it.fric, model.fallback.fric, of_default);
    for (size_t rank = 0; rank < it.c.size(); ++rank)
        take_by_rule(it.c[rank], model.fallback.c[rank], of_default);
}

void note_without_friction(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (has_friction(validator.model, it)) return;
    const std::string_view reason = "the interface has no friction";
    unused(validator, "Pskid", it.pskid < no_limit, reason);
    unused(validator, "Fheat", it.ithe != 0 && it.fheat != 0, reason);
    unused(validator, "Ifiltr", it.friction_model < 0 && it.ifiltr != 0, reason);
    if (it.pskid < no_limit) take_by_rule(it.pskid, no_limit, "not used without friction");
}

}  // namespace

/// @manual field Xfreq; comment 15; departure D28
void check_friction_card(const CardValidator& validator) {
    const Interface& it = validator.interface;
    const bool by_model = it.fric_id != 0;
    one_of(validator, "Ifric", it.ifric, {0, 1, 2, 3, 4});
    one_of(validator, "Ifiltr", it.ifiltr, {0, 1, 2, 3});
    const CardReading reading = validator.reading();
    const bool filter_used = !by_model || reading.filter_of_card_stays;
    if (const auto fault = reading.filter_fault(filter_used ? it.ifiltr.value : 0, it.xfreq))
        validator.error("Xfreq", fault->rule, fault->remedy);
    unused(validator, "Xfreq", it.xfreq > 0 && filter_used && it.ifiltr == 0, "Ifiltr is 0");
    if (by_model) {
        check_replaced(validator);
    } else {
        check_law(validator);
        check_function(validator);
    }
}

/// @manual field fct_IDF, AscaleF; comment 12
void apply_friction(const CardValidator& validator) {
    Interface& it = validator.interface;
    const bool by_function = uses_friction_function(it);
    it.card_ifiltr = it.ifiltr;
    it.card_xfreq = it.xfreq;
    apply_friction_model(validator);
    if (!by_function)
        idle(it.fct_idf, Id{0}, it.friction_model >= 0 ? "not used with fric_ID" : "used with Ifric 0 only");
    if (by_function) default_for_zero(it.fric, 1.0, "0 means 1, the scale of fct_IDF");
    if (it.xfreq == 0) idle(it.ifiltr, 0, "Xfreq 0: no filter");
    default_for_zero(it.ascalef, 1.0, "0 means 1");
    note_without_friction(validator);
}

}  // namespace type21
