/// @file What the model makes of a card on which only the surfaces and the tool are given.
#pragma once

#include <map>
#include <string_view>

#include "reference/contract/interface.h"

namespace type21 {

/// Field name -> text, right-justified in the field's columns.
using CardFields = std::map<std::string_view, std::string_view>;

/// The interface of an otherwise blank card over a small scene, resolved by the model itself: the one place where a
/// default is written. A value that comes from the mesh (Gapmin, DEPTH) is that of the small scene and means nothing.
Interface blank_card(const CardFields& fields = {});

}  // namespace type21
