/// @file The ids of a card turned into indices of the Model.
#pragma once

#include "reference/model/card_validator.h"

namespace type21 {

/// Surfaces, rigid body, sensor, friction model and the functions that are used; an id that does not exist is an error.
/// IDref waits until all are read.
void link_interface(const CardValidator& validator);

/// IDref: another TYPE21 interface.
void link_reference_interface(const CardValidator& validator);

}  // namespace type21
