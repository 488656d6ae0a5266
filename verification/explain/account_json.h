/// @file The account as data, with every digit and every rejected sub-triangle.
#pragma once

#include <nlohmann/json.hpp>

#include "verification/explain/explain_deck.h"

namespace type21 {

nlohmann::ordered_json account_json(const DeckAccount& account, const Model& model);

}  // namespace type21
