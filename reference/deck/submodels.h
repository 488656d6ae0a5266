/// @file //SUBMODEL ... //ENDSUB: a part of the deck with ids and units of its own.
#pragma once

#include "reference/deck/deck.h"

namespace type21 {

/// Makes one deck of a deck with submodels, as if its author had written it without: the ids of a submodel's cards are
/// moved by its offsets, its cards name its units, and what selects by SUBMODEL (/GRNOD/SUBMODEL, sub_ID of
/// /TRANSFORM, ...) selects by the ids that the submodel has. The cards //SUBMODEL and //ENDSUB are gone afterwards.
///   //SUBMODEL/submodel_ID/unit_ID
///   title
///   Off_def, Off_nod, Off_ele, Off_part, Off_mat, Off_prop: ten columns each; 0 of the others means Off_def
/// A /BEGIN within it gives its units. A card that refers to the submodel from outside names the moved id. Cards whose
/// ids are not known here, such as /INTER, must stand outside a submodel with offsets: an error names them.
void expand_submodels(Deck& deck, Problems& problems);

}  // namespace type21
