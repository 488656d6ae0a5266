/// @file Departures: where the public OpenRadioss does something else than the manual page says.
/// Each is a switch, off by default (Formulation 12, step 2).
#pragma once

#include <bitset>
#include <string>
#include <string_view>
#include <vector>

namespace type21 {

/// The numbers are those of the table of departures; what each means is in departures().
// clang-format off
enum class Departure : int {
    D01 = 1, D02, D03, D04, D05, D06, D07, D08, D09, D10, D11, D12, D13, D14, D15, D16, D17, D18, D19, D20,
    D21, D22, D23, D24, D25, D26, D27, D28, D29, D30, D31, D32, D33, D34, D35, D36, D37, D38, D39, D40,
    D41, D42, D43, D44
};
// clang-format on

/// One row of the table: the behaviour as documented and as built.
struct DepartureRow {
    Departure id;
    std::string_view documented;  ///< what the manual page says
    std::string_view as_built;    ///< what the public OpenRadioss does
    bool available;               ///< can be switched on in this program
    std::string_view reason;      ///< why not, where it is not available
};

/// All rows, in the order of their numbers.  Formulation 12, step 2.
const std::vector<DepartureRow>& departures();

/// "D03"
std::string name(Departure departure);

/// The set of departures that a run switches on.
class AsBuilt {
  public:
    /// Every available departure.
    static AsBuilt all();

    bool has(Departure departure) const { return set_.test(static_cast<size_t>(departure)); }
    void set(Departure departure, bool on = true) { set_.set(static_cast<size_t>(departure), on); }
    bool any() const { return set_.any(); }
    /// "D03, D24" or "none".
    std::string text() const;

  private:
    std::bitset<64> set_;
};

}  // namespace type21
