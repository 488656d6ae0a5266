/// @file From cards to the Model.
#pragma once

#include "reference/deck/deck.h"
#include "reference/deck/problem.h"
#include "reference/model/model.h"

namespace type21 {

/// What a deck means, with every default resolved, in the work units of /BEGIN.
/// @param as_built  departures that are switched on (Formulation 12, step 1)
/// @param problems  gets everything that is wrong; the model is complete only when it has no error
Model resolve(const Deck& deck, const AsBuilt& as_built, Problems& problems);

/// The same for a deck that is not needed afterwards: the lines of its mesh are forgotten as soon as they are read,
/// which halves the memory of a large deck.
Model resolve_and_forget(Deck& deck, const AsBuilt& as_built, Problems& problems);

/// An error when the deck has no /INTER/TYPE21, with the contacts that it has instead.
void check_interfaces(const Deck& deck, const Model& model, Problems& problems);

}  // namespace type21
