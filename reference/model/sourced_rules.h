/// @file How a value changes after it was read, and says so.
#pragma once

#include <utility>

#include "reference/contract/origin.h"

namespace type21 {

/// A default takes the place of a blank or 0. A field that the deck's version does not have stays marked as absent, one
/// that a rule set to 0 stays marked by that rule.
template <class T>
void take_default(Sourced<T>& field, T value, const std::string& why) {
    const bool keep = field.origin.kind == Origin::Kind::absent || field.origin.kind == Origin::Kind::rule;
    field.value = std::move(value);
    field.origin.why = keep ? field.origin.why + "; " + why : why;
    if (!keep) field.origin.kind = Origin::Kind::fallback;
}

/// A rule puts another value in place of what the deck says; the line stays.
template <class T>
void take_by_rule(Sourced<T>& field, T value, const std::string& why) {
    field.value = std::move(value);
    field.origin.kind = Origin::Kind::rule;
    field.origin.why = why;
}

}  // namespace type21
