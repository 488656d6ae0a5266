/// @file The rules of the card that the manual page and the public program read differently.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/contract/departures.h"
#include "reference/model/friction_conditions.h"
#include "reference/model/nodal_gaps.h"

namespace type21 {

/// The reading of the cards: as documented where it is default-constructed. card_reading() puts the as-built rules of
/// the departures that are switched on in their places (Formulation 12, step 1). The rules of one place have one
/// signature, which is described at the documented one.
struct CardReading {
    CardReading();  // names documented rules of several files

    /// D07.  Formulation 8, step 8.
    std::optional<ConditionFault> (*filter_fault)(int ifiltr, double xfreq);
    /// D17.  Formulation 8, step 6.
    std::vector<ConditionFault> (*renard_faults)(const std::array<double, 6>& c, const UnitSystem& units);
    /// Ifiltr and Xfreq of the card act with /FRICTION, too: D28.  Formulation 8, step 8.
    bool filter_of_card_stays = false;
    /// fct_IDF takes Tint for the temperature of the tool: D08.  Formulation 8, step 3.
    bool friction_takes_tint = false;

    /// D20.  Formulation 6, step 1.
    void (*check_inacti)(const CardValidator& validator);
    /// D18.  Formulation 1, step 2.
    void (*report_shared_nodes)(const CardValidator& validator, const std::string& nodes);

    /// D19.  Formulation 2, step 3.
    GapminDefault (*gapmin_default)(const CardValidator& validator);
    /// D29.  Formulation 2, step 2.
    std::vector<double> (*contact_thickness)(const Model& model, const Surface& secondary,
                                             const std::vector<int>& nodes);
    /// A segment that a surface holds twice counts twice: D41.  Formulation 7, step 3.
    bool repeated_segments_count = false;
    /// D33.  Formulation 2, step 7.
    double (*search_gap)(const Interface& interface, double raw, double gap);

    /// Kthe 0 with fct_IDK means 1: D36.  Formulation 9, step 7.
    bool kthe_zero_means_one = false;
    /// Drad has its default without Frad and Fcond, too: D11.  Formulation 9, step 5.
    bool drad_without_radiation = false;
    /// D14.  Formulation 9, step 5.
    void (*default_dcond)(Interface& interface);
};

/// The one place where the departures of the card are put in.
CardReading card_reading(const AsBuilt& as_built);

/// Puts the values in place that the public program takes for those of the card (D02, D03, D09, D20, D36, D38), before
/// any default; each says so in its origin. Nothing changes without these departures.
void take_as_built_values(const CardValidator& validator);

}  // namespace type21
