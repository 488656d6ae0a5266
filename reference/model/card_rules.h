/// @file Rules that many fields share: a flag outside its values, negative, without effect, a default, idle.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "reference/contract/effects.h"
#include "reference/model/card_validator.h"
#include "reference/model/sourced_rules.h"

namespace type21 {

/// Whether value is one of allowed.
bool among(int value, std::initializer_list<int> allowed);

/// An error for a flag outside its values.
void one_of(const CardValidator& validator, std::string_view field, int value, std::initializer_list<int> allowed);

/// An error for a negative value.
void not_negative(const CardValidator& validator, std::string_view field, double value);

/// A warning for a field that was given and has no effect.
void unused(const CardValidator& validator, std::string_view field, bool given, std::string_view reason);

/// The default takes the place of 0, with the reason for the user.
inline void default_for_zero(Sourced<double>& field, double value, const std::string& why) {
    if (field == 0) take_default(field, value, why);
}

/// A field that another one makes idle: if the deck gave it, the value that does nothing takes its place, with the
/// reason.
template <class T>
void idle(Sourced<T>& field, T nothing, const std::string& why) {
    if (field.value != T{}) take_by_rule(field, nothing, why);
}

}  // namespace type21
