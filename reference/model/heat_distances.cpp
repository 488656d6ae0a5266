/// @file Reach of radiation and of conduction beyond the gap.
#include <algorithm>

#include <fmt/format.h>

#include "reference/model/heat_rules.h"
#include "reference/model/sourced_rules.h"

namespace type21 {
namespace {

void settle_given(const CardValidator& judge) {
    Interface& it = judge.interface;
    if (it.frad == 0 && it.drad != 0) take_by_rule(it.drad, 0.0, "not used without Frad");
    if (it.fcond == 0 && it.dcond != 0) take_by_rule(it.dcond, 0.0, "not used without Fcond");
    if (it.dcond != 0 && it.drad == 0) take_by_rule(it.drad, it.dcond.value, "0 means Dcond");
    if (it.dcond <= it.drad) return;
    judge.warning("Dcond", fmt::format("is larger than Drad {}: Drad takes its place", judge.length(it.drad)),
                  "Give Dcond <= Drad");
    take_by_rule(it.dcond, it.drad.value, fmt::format("lowered from {} to Drad", it.dcond.value));
}

void settle_drad(const CardValidator& judge, std::string_view prefix) {
    Interface& it = judge.interface;
    if (it.drad == 0) {
        take_default(it.drad, std::max(it.largest_gap, it.shortest_edge),
                     fmt::format("{}0 means the larger of the largest gap and the shortest secondary edge", prefix));
    } else if (it.drad < it.largest_gap) {
        take_by_rule(it.drad, it.largest_gap, fmt::format("raised from {} to the largest gap", it.drad.value));
    }
    if (it.drad > it.shortest_edge)
        judge.warning(
            "Drad",
            fmt::format("is larger than the shortest secondary edge {}: more of the mesh is searched than one "
                        "element",
                        judge.length(it.shortest_edge)),
            "Give a smaller Drad unless heat really goes that far");
}

}  // namespace

/// @manual field Drad, Dcond; comment 17, 24; departure D14
void resolve_heat_distances(const CardValidator& judge) {
    Interface& it = judge.interface;
    if (it.ithe == 0) return;
    const AsBuilt& as_built = judge.model.as_built;
    settle_given(judge);
    if (it.frad != 0 || it.fcond != 0)
        settle_drad(judge, "");
    else if (as_built.has(Departure::D11))
        settle_drad(judge, "D11: without Frad too, ");
    if (it.fcond == 0 || it.dcond != 0) return;
    if (as_built.has(Departure::D14))
        take_by_rule(it.dcond, 0.0, "D14: stays 0");
    else
        take_default(it.dcond, it.drad.value, "0 means Drad");
}

}  // namespace type21
