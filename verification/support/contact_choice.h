/// @file The implementation that computes the contact: the reference or the optimized one.
#pragma once

#include <string>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

/// Names for --with; the first is the default.
const std::vector<std::string>& contact_choices();

/// @param with  one of contact_choices()
MakeContact contact_maker(const std::string& with);

}  // namespace type21
