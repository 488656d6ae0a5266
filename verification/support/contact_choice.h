/// @file The implementation that computes the contact: the reference or the optimized one, and the search of the
/// optimized one.
#pragma once

#include <string>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

/// Names for --with; the first is the default.
const std::vector<std::string>& contact_choices();
/// Names for --search, how the optimized contact finds candidates; the first is the default.
const std::vector<std::string>& search_choices();

/// @param with    one of contact_choices()
/// @param search  one of search_choices(), or empty for the default
/// @throws std::invalid_argument for another word, or where a search is chosen for the reference
MakeContact contact_maker(const std::string& with, const std::string& search = "");

}  // namespace type21
