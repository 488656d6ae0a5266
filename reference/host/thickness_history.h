/// @file Thickness of the sheet replayed from a table, for decks whose elements do not strain yet.
#pragma once

#include <string>
#include <vector>

#include "reference/deck/problem.h"
#include "reference/model/model.h"

namespace type21 {

/// Thickness of elements over time, linear between the rows of a table and constant beyond both ends. A thickness of 0
/// marks a deleted element.
class ThicknessHistory {
  public:
    /// Reads a CSV file whose first line is `time,<element id>,...` and whose rows hold a time and one thickness a
    /// column, in the deck's work units; times ascend. Everything that is wrong goes to problems, with its line; the
    /// history holds then what could be read.
    static ThicknessHistory read(const std::string& path, const Model& model, Problems& problems);

    /// Thickness at this time, a time within 1e-6 of the row spacing of a row being that row; elements without a column
    /// keep theirs.
    /// @param thickness  of each of Model::shells [length]
    void at(double time, std::vector<double>& thickness) const;

    const std::vector<int>& shells() const { return shells_; }  ///< index into Model::shells, of each column
    const std::vector<double>& times() const { return times_; }

  private:
    std::vector<int> shells_;
    std::vector<double> times_;
    std::vector<std::vector<double>> rows_;  ///< of each time, of each column [length]
};

}  // namespace type21
