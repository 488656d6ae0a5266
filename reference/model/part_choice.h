/// @file Parts by their own ids, or by material, property or subset.
#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "reference/model/card_reader.h"

namespace type21 {

struct Reading;
class SelectionCards;

/// A subset has the parts that name it and those of the subsets that its card lists.
class PartChoice {
  public:
    PartChoice(Reading& reading, const SelectionCards& cards) : reading_(reading), cards_(cards) {}

    /// PART, MAT, PROP or SUBSET.
    static bool knows(std::string_view type);

    /// Appends the parts that this id of a list stands for. An id that no card has is an error.
    void append(CardReader& reader, size_t line, std::string_view type, Id id, std::vector<int>& parts);

  private:
    void append_subset(CardReader& reader, size_t line, Id id, std::vector<int>& parts);

    Reading& reading_;
    const SelectionCards& cards_;
    std::unordered_map<Id, std::vector<int>> parts_of_subset_;  ///< those that name it in /PART; made when needed
    bool subsets_known_ = false;
};

}  // namespace type21
