/// @file Units that the header of another program's table names: "kN s", "N*ms", "mm/s", "J".
#pragma once

#include <optional>
#include <string_view>

#include "reference/model/units.h"

namespace type21 {

struct Unit {
    Dimension dimension;
    double si = 1;  ///< size of one unit
};

/// A product of mass, length and time units as Radioss decks write them, N, Pa, J, W with prefixes, K and rad; with
/// '/', '*', '.', '^2', '2' and brackets behind a '/'. Nothing for any other text; units with an offset (°C) are not
/// read either.
std::optional<Unit> unit_of(std::string_view text);

/// What a column of a history measures; nothing where its name does not tell.
std::optional<Dimension> dimension_of(std::string_view column);

}  // namespace type21
