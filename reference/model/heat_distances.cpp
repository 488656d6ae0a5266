/// @file Reach of radiation and of conduction beyond the gap.
#include <algorithm>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/heat_rules.h"
#include "reference/model/sourced_rules.h"

namespace type21 {
namespace {

void settle_given(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.frad == 0 && it.drad != 0) take_by_rule(it.drad, 0.0, "not used without Frad");
    if (it.fcond == 0 && it.dcond != 0) take_by_rule(it.dcond, 0.0, "not used without Fcond");
    if (it.dcond != 0 && it.drad == 0) take_by_rule(it.drad, it.dcond.value, "0 means Dcond");
    if (it.dcond <= it.drad) return;
    validator.warning("Dcond", fmt::format("is larger than Drad {}: Drad takes its place", validator.length(it.drad)),
                      "Give Dcond <= Drad");
    take_by_rule(it.dcond, it.drad.value, fmt::format("lowered from {} to Drad", it.dcond.value));
}

void settle_drad(const CardValidator& validator, std::string_view prefix) {
    Interface& it = validator.interface;
    if (it.drad == 0) {
        take_default(it.drad, std::max(it.largest_gap, it.shortest_edge),
                     fmt::format("{}0 means the larger of the largest gap and the shortest secondary edge", prefix));
    } else if (it.drad < it.largest_gap) {
        take_by_rule(it.drad, it.largest_gap, fmt::format("raised from {} to the largest gap", it.drad.value));
    }
    // A gap longer than the edge has had its own message, and no smaller Drad would change anything then.
    if (it.drad > it.shortest_edge && it.largest_gap <= it.shortest_edge)
        validator.warning(
            "Drad",
            fmt::format("is larger than the shortest secondary edge {}: more of the mesh is searched than one "
                        "element",
                        validator.length(it.shortest_edge)),
            "Give a smaller Drad unless heat really goes that far");
}

}  // namespace

/// @manual field Drad, Dcond; comment 17, 24; departure D11
void resolve_heat_distances(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.ithe == 0) return;
    const CardReading reading = validator.reading();
    settle_given(validator);
    if (it.frad != 0 || it.fcond != 0)
        settle_drad(validator, "");
    else if (reading.drad_without_radiation)
        settle_drad(validator, "D11: without Frad too, ");
    if (it.fcond == 0 || it.dcond != 0) return;
    reading.default_dcond(it);
}

void dcond_is_drad(Interface& interface) {
    take_default(interface.dcond, interface.drad.value, "0 means Drad");
}

}  // namespace type21
