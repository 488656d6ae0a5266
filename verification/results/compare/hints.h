/// @file What may be behind a difference: units, signs, a force beside an impulse, ids, the unit of time.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "reference/contract/mesh.h"

namespace type21 {

/// The values of one column at the times that both histories have.
struct PairedColumn {
    std::string column;
    std::vector<double> time, ours, reference;
};

/// "ours is 1000 times the reference", where one factor leaves less than a thousandth of the largest value: first for
/// the values themselves, then for the integral of the reference over time, by the trapezoidal rule, where one of
/// twenty is allowed, as the reference may be coarse. Empty where neither fits.
std::string hint_on_values(const PairedColumn& column);

/// Columns with the same hint share one line.
class HintList {
  public:
    void add(const std::string& column, const std::string& hint);
    std::vector<std::string> lines() const;

  private:
    std::vector<std::pair<std::string, std::vector<std::string>>> hints_;
};

/// No id in common: which ids there are, and their constant distance if they have one. Empty where some are in common.
std::string hint_on_ids(const std::set<Id>& ours, const std::set<Id>& reference);
/// The interfaces that the run has.
std::string hint_on_interface(const std::string& file, const std::set<Id>& ours);
/// One history ends at 10^3n of the time of the other: a unit of time. Ends within a tenth count.
std::string hint_on_times(const std::vector<double>& ours, const std::vector<double>& reference);

}  // namespace type21
