/// @file The fields of the twelve lines: where each stands, its name, its dimension, since when it exists.
#pragma once

#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "reference/contract/interface.h"
#include "reference/model/units.h"

namespace type21 {

/// One field of /INTER/TYPE21. Columns count from 1 and are inclusive.
struct InterfaceField {
    int line = 0;  ///< 1..12
    int first = 0;
    int last = 0;
    std::string_view name;  ///< as on the manual page
    std::variant<Sourced<int> Interface::*, Sourced<Id> Interface::*, Sourced<double> Interface::*, size_t>
        member;         ///< size_t: rank in c
    Dimension fixed{};  ///< where it does not depend on a flag: see dimension()
    int since = 120;    ///< first version of /BEGIN that reads it
};

/// In the order of the card.
const std::vector<InterfaceField>& interface_fields();

/// Dimension of a field; that of Stfac, Xfreq and C1..C6 depends on Istf, Ifiltr and Ifric.
Dimension dimension(const InterfaceField& field, const Interface& interface);

/// Calls action(Sourced<...>&) with the field's value in the interface.
template <class AnyInterface, class Action>
decltype(auto) with_field(AnyInterface& interface, const InterfaceField& field, Action&& action) {
    return std::visit(
        [&](auto member) -> decltype(auto) {
            if constexpr (std::is_same_v<decltype(member), size_t>)
                return action(interface.c.at(member));
            else
                return action(interface.*member);
        },
        field.member);
}

}  // namespace type21
