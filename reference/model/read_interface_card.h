/// @file The twelve data lines of /INTER/TYPE21, as written.
#pragma once

#include "reference/contract/interface.h"
#include "reference/model/card_reader.h"

namespace type21 {

/// Index of the data line of card line 1..12: the title is data line 0.
inline int data_line(int card_line) {
    return card_line;
}

/// Reads every field of the card, in work units and with its place; no default is applied: blank is 0.
/// Fields that the deck's version does not have are 0 and absent. Columns: the manual page, and those of a measured
/// OpenRadioss run (commit bd4557b) where the table of the manual page has lost its blank cells.
/// @param version  of /BEGIN
/// @return false when the lines cannot be told apart (not twelve of them): the fields are then left alone,
///         and the error is reported
bool read_interface_card(CardReader& card, int version, Interface& interface);

}  // namespace type21
