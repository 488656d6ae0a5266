/// @file The departures of the card, each one named piece (Formulation 12, step 2), and the one place where they are
/// put in.
#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/card_rules.h"
#include "reference/model/heat_rules.h"
#include "reference/model/interface_rules.h"
#include "reference/model/tool_side.h"

namespace type21 {
namespace as_built {
namespace {

/// As documented: Istf 1 with Stfac 0 has no stiffness. As built: Stfac 0 means 1 in work units.
/// @manual departure D02
void stfac_of_istf_1(Interface& it) {
    if (it.istf == 1 && it.stfac == 0) take_default(it.stfac, 1.0, "D02: 0 means 1 in work units");
}

/// As documented: DEPTH is read for every Igap. As built: it is ignored for Igap 0.
/// @manual departure D03
void depth_of_igap_0(Interface& it) {
    if (it.igap == 0) idle(it.depth, 0.0, "D03: DEPTH is ignored with Igap 0");
}

/// As documented: Xfreq is between 0 and 1 for Ifiltr 2. As built: it is at least 2 pi.
/// @manual departure D07
std::optional<ConditionFault> filter_fault(int ifiltr, double xfreq) {
    constexpr double turn = 2.0 * std::numbers::pi;
    if (ifiltr != 2 || xfreq <= 0) return type21::filter_fault(ifiltr, xfreq);
    if (xfreq >= turn) return std::nullopt;
    return ConditionFault{0, fmt::format("D07: must be at least 2 pi = {:.6f} with Ifiltr 2, a period in cycles", turn),
                          "Give the period as a number of steps, or take D07 away"};
}

/// As documented: sens_ID replaces Tstart and Tstop. As built: the sensor is ignored.
/// @manual departure D09
void ignore_sensor(Interface& it) {
    if (it.sensor < 0) return;
    it.sensor = -1;
    take_by_rule(it.sens_id, it.sens_id.value, "D09: the sensor is ignored");
}

/// As documented: with Fcond, Dcond 0 means Drad. As built: it stays 0.
/// @manual departure D14
void keep_dcond_zero(Interface& it) {
    take_by_rule(it.dcond, 0.0, "D14: stays 0");
}

/// As documented: C1..C6 of the Renard law fulfil its conditions. As built: they are not checked.
/// @manual departure D17
std::vector<ConditionFault> no_conditions(const std::array<double, 6>& /*c*/, const UnitSystem& /*units*/) {
    return {};
}

/// As documented: a node on both sides is an error. As built: it is accepted.
/// @manual departure D18
void accept_shared_nodes(const CardValidator& validator, const std::string& nodes) {
    validator.warning_with("surf_IDs", nodes, "D18: nodes on both sides are accepted",
                           "Take them out of one of the surfaces");
}

/// As documented: the default of Gapmin is half of the mean thickness of the secondary shells. As built: half of the
/// mean over the secondary nodes of the thickest shell at each.
/// @manual departure D19
GapminDefault gapmin_of_nodes(const CardValidator& validator) {
    return {0.5 * mean(validator.interface.secondary.thickness),
            "D19: half of the mean over the secondary nodes of the thickest shell at each"};
}

/// As documented: 2 and 4 are errors. As built: 2, 3 and 4 are answered by a message and act as 0.
/// @manual departure D20
void check_inacti(const CardValidator& validator) {
    if (!among(validator.interface.inacti, {2, 4})) type21::check_inacti(validator);
}

/// @manual departure D20
void inacti_acts_as_0(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (!among(it.inacti, {2, 3, 4})) return;
    validator.warning("Inacti", "D20: is not available and acts as 0", "Give one of 0, 1, 5, 6");
    take_by_rule(it.inacti, 0, fmt::format("D20: {} acts as 0", it.inacti.value));
}

/// As documented: the contact thickness of a node is the largest of its parts. As built: corner c of each segment in
/// turn is compared with the model's node of c-th lowest id in place of its own earlier value, so that mostly the part
/// of the last segment holds.
/// @manual departure D29
std::vector<double> contact_thickness(const Model& model, const Surface& secondary, const std::vector<int>& nodes) {
    std::vector<double> thickness(model.nodes.id.size(), 0.0);  // nodes are sorted by id
    for (const Segment& segment : secondary.segments)
        for (size_t corner = 0; corner < 4; ++corner) {
            const double lowest = corner < thickness.size() ? thickness[corner] : 0.0;
            thickness[static_cast<size_t>(segment.node[corner])] = std::max(lowest, part_thickness(model, segment));
        }
    std::vector<double> of_nodes;
    of_nodes.reserve(nodes.size());
    for (const int node : nodes)
        of_nodes.push_back(thickness[static_cast<size_t>(node)]);
    return of_nodes;
}

/// As documented: a node's own gap decides contact. As built: the larger of min(g_s, Gapmax) and the largest gap.
/// @manual departure D33
double search_gap(const Interface& it, double raw, double /*gap*/) {
    return std::max(std::min(raw, it.gapmax.value), it.largest_gap);
}

/// As documented: Kthe is a conductance, also as the scale of fct_IDK. As built: with fct_IDK it is a pure number,
/// which no unit changes.
void kthe_without_unit(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.ithe == 0 || it.fct_idk == 0 || it.kthe == 0) return;
    const double unit = one_of_card(validator, dim::conductance);
    if (unit != 1) take_by_rule(it.kthe, it.kthe / unit, "D38: with fct_IDK the number as written");
}

/// As documented: Kthe 0 with fct_IDK means no conduction. As built: it means 1 in the units of the card.
/// @manual departure D36
void kthe_of_function(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.ithe == 0 || it.fct_idk == 0) return;
    default_for_zero(it.kthe, one_of_card(validator, dim::conductance), "D36: 0 means 1 in the units of the card");
}

}  // namespace
}  // namespace as_built

CardReading::CardReading()
    : filter_fault(type21::filter_fault),
      renard_faults(type21::renard_faults),
      check_inacti(type21::check_inacti),
      report_shared_nodes(refuse_shared_nodes),
      gapmin_default(type21::gapmin_default),
      contact_thickness(type21::contact_thickness),
      search_gap(own_search_gap),
      default_dcond(dcond_is_drad) {}

CardReading card_reading(const AsBuilt& set) {
    using enum Departure;
    CardReading reading;
    if (set.has(D07)) reading.filter_fault = as_built::filter_fault;
    if (set.has(D08)) reading.friction_takes_tint = true;
    if (set.has(D11)) reading.drad_without_radiation = true;
    if (set.has(D14)) reading.default_dcond = as_built::keep_dcond_zero;
    if (set.has(D17)) reading.renard_faults = as_built::no_conditions;
    if (set.has(D18)) reading.report_shared_nodes = as_built::accept_shared_nodes;
    if (set.has(D19)) reading.gapmin_default = as_built::gapmin_of_nodes;
    if (set.has(D20)) reading.check_inacti = as_built::check_inacti;
    if (set.has(D28)) reading.filter_of_card_stays = true;
    if (set.has(D29)) reading.contact_thickness = as_built::contact_thickness;
    if (set.has(D33)) reading.search_gap = as_built::search_gap;
    if (set.has(D36)) reading.kthe_zero_means_one = true;
    if (set.has(D41)) reading.repeated_segments_count = true;
    return reading;
}

void take_as_built_values(const CardValidator& validator) {
    using enum Departure;
    const AsBuilt& set = validator.model.as_built;
    if (set.has(D02)) as_built::stfac_of_istf_1(validator.interface);
    if (set.has(D03)) as_built::depth_of_igap_0(validator.interface);
    if (set.has(D09)) as_built::ignore_sensor(validator.interface);
    if (set.has(D20)) as_built::inacti_acts_as_0(validator);
    if (set.has(D38)) as_built::kthe_without_unit(validator);
    if (set.has(D36)) as_built::kthe_of_function(validator);
}

}  // namespace type21
