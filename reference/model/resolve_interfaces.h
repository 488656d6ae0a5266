/// @file The TYPE21 cards: twelve lines read, every default resolved, everything of time 0 computed.
#pragma once

#include "reference/deck/deck.h"
#include "reference/deck/problem.h"
#include "reference/model/model.h"

namespace type21 {

/// Reads every /INTER/TYPE21 of the deck into model.interfaces. All else of the model is resolved before.
void resolve_interfaces(const Deck& deck, Model& model, Problems& problems);

/// Unit system of a card that names a unit_ID (word `position` of its keyword), the input units of the deck otherwise;
/// an unknown unit_ID is an error. Implemented where /UNIT is read.
const UnitSystem& card_units(const Deck& deck, const Card& card, size_t position, const Model& model,
                             Problems& problems);

}  // namespace type21
