/// @file From cards to the Model.
#pragma once

#include "reference/deck/deck.h"
#include "reference/deck/problem.h"
#include "reference/model/model.h"

namespace type21 {

/// Reads meaning into a deck. All problems are collected; the model is complete only when problems has no error.
Model resolve(const Deck& deck, const AsBuilt& as_built, Problems& problems);

}  // namespace type21
