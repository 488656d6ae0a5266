/// @file What the model makes of a card on which only the surfaces and the tool are given.
#pragma once

#include "reference/model/interface.h"

namespace type21 {

/// The interface of a blank card over a small scene, resolved by the model itself: the one place where a default is
/// written. A value that comes from the mesh (Gapmin, DEPTH) is that of the small scene and means nothing.
const Interface& blank_card();

}  // namespace type21
