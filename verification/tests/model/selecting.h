/// @file Reads a deck up to its groups and surfaces, and asks for one as a card would that names it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "driven_scene.h"
#include "reference/model/reading.h"
#include "reference/model/selector.h"

namespace type21::test {

/// A card with a title and a line of ids.
std::string list_card(const std::string& keyword, const std::vector<std::string>& ids);

class Selecting {
  public:
    explicit Selecting(const std::string& starter);

    // Empty where there is no such card.
    std::vector<Segment> surface(Id id);
    std::vector<Id> nodes(Id grnod);  ///< ids, ascending
    std::vector<Id> shells(Id grshel);
    std::vector<Id> sh3n(Id grsh3n);
    std::vector<Id> parts(Id grpart);
    /// Ids of the nodes of each segment of a surface, in its order: "1 2 3 4, 2 5 3 3".
    std::string segments(Id surface);

    Problems problems;
    Model model;

  private:
    std::vector<Id> shell_ids(Family family, ShellKind kind, Id id);

    Deck deck_;
    std::unique_ptr<Reading> reading_;
};

}  // namespace type21::test
