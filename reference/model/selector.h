/// @file Works out what a group, surface, box or set holds, when a card first asks for it.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

#include "reference/model/mesh_index.h"
#include "reference/model/part_choice.h"
#include "reference/model/reading.h"
#include "reference/model/segment_card.h"
#include "reference/model/selection_cards.h"

namespace type21 {

/// What a group, box or set holds: the union of all that it lists.
struct Content {
    std::vector<int> nodes;        ///< listed, or in a box
    std::vector<int> shells;       ///< listed or in a box, with their nodes
    std::vector<int> parts;        ///< with their shells and nodes
    std::vector<int> shell_parts;  ///< of which only /SHELL counts (/GRSHEL/PART)
    std::vector<int> sh3n_parts;   ///< of which only /SH3N counts (/GRSH3N/PART)
    std::vector<int> bare_shells;  ///< of a /SET that has lost some of their nodes
    std::vector<int> bare_parts;   ///< of a /SET that has lost some of their shells or nodes
    std::vector<Segment> segments;
};

/// A card that another one lists, and as what: a /SET may stand for a group.
struct Link {
    const SelectionCard* card = nullptr;
    Family as = Family::node_group;
};

/// Boxes see the nodes where /TRANSFORM has put them and where rigid bodies have not yet moved their main nodes.
class Selector {
  public:
    explicit Selector(Reading& reading);

    /// Ascending, each once.
    std::vector<int> nodes(const SelectionCard& card);
    std::vector<int> shells(const SelectionCard& card, ShellKind kind);
    std::vector<int> parts(const SelectionCard& card);
    /// In the order of the card; shells that one card chooses in the order of the deck.
    std::vector<Segment> segments(const SelectionCard& card);

    const SelectionCards& cards() const { return cards_; }
    /// The card with this id; nullptr and an error when there is none, or two.
    /// @param field  for the message; the usual one of the family unless given
    const SelectionCard* find(CardReader& reader, size_t line, Family family, Id id, std::string_view field = {});
    /// From now on boxes hold what lies in them: the nodes stand where they stay.
    void place_nodes();
    /// The numbers of a card that nothing has asked for: a word that is none is an error there, too.
    void check_unused();

  private:
    // selector.cpp: cards made of cards
    Content gather(const SelectionCard& card);
    std::vector<Link> open(const SelectionCard& card, Content& content);
    void take(const Link& link, Content& content);
    /// The links of a card that lists others; when some are negative, the difference goes into content instead.
    std::vector<Link> union_of_links(const SelectionCard& card, CardReader& reader, Family family, Content& content);
    std::vector<int> items(const SelectionCard& card, Family family);
    CardReader reader(const SelectionCard& card);
    void complain_of_circle(const SelectionCard& card);
    void complain_of_type(const SelectionCard& card, CardReader& reader);
    std::vector<int> nodes_of(const Content& content);
    std::vector<int> whole_shells_of(const Content& content, ShellKind kind);
    std::vector<int> shells_of(const Content& content, ShellKind kind);
    std::vector<int> parts_of(const Content& content);

    // group_members.cpp: what one card lists
    std::vector<Link> open_node_group(const SelectionCard& card, CardReader& reader, Content& content);
    std::vector<Link> open_shell_group(const SelectionCard& card, CardReader& reader, Content& content);
    std::vector<Link> open_part_group(const SelectionCard& card, CardReader& reader, Content& content);
    std::vector<Link> open_box(const SelectionCard& card, CardReader& reader, Content& content);
    void append_listed_parts(const SelectionCard& card, CardReader& reader, std::vector<int>& parts);
    void append_node(CardReader& reader, size_t line, Id id, std::vector<int>& nodes);
    void append_shell(CardReader& reader, size_t line, ShellKind kind, Id id, std::vector<int>& shells);
    void append_node_range(Id first, Id last, Id step, std::vector<int>& nodes) const;
    void append_part_range(Id first, Id last, Id step, std::vector<int>& parts) const;
    /// Shells with all their nodes in the box, or with at least one.
    void append_boxed(const SelectionCard& box, ShellKind kind, bool whole, std::vector<int>& shells);

    // set_clauses.cpp
    struct Clause;
    std::vector<Clause> clauses(CardReader& reader);
    std::vector<Link> open_set(const SelectionCard& card, CardReader& reader, Content& content);
    std::vector<Link> open_clause(const Clause& clause, CardReader& reader, Content& content);
    void append_segments(const Clause& clause, CardReader& reader, Content& content);
    void append_ranges(const Clause& clause, CardReader& reader, Content& content);

    // surface_segments.cpp
    struct SignedLink;
    using SignedShell = std::pair<int, bool>;  ///< index, turned
    std::vector<SignedLink> open_surface(const SelectionCard& card, bool turned, std::vector<Segment>& segments);
    std::vector<SignedLink> open_surface(const SelectionCard& card, CardReader& card_reader, bool turned,
                                         std::vector<Segment>& segments);
    void append_set(const SelectionCard& card, bool turned, std::vector<Segment>& segments);
    std::vector<SignedShell> listed_shells(const SelectionCard& card, CardReader& reader);
    void append_shells(std::vector<SignedShell> shells, bool turned, std::vector<Segment>& segments) const;
    void append_segment(CardReader& reader, size_t line, const std::array<Id, 4>& ids, std::vector<Segment>& segments);
    size_t most_segments() const;

    Reading& reading_;
    SelectionCards cards_;
    PartChoice part_choice_;
    MeshIndex mesh_;
    std::optional<ShellFinder> finder_;  ///< made for the first segment that is given by its nodes
    bool placed_ = false;
    std::vector<Vec3> positions_;  ///< of the nodes; empty without a /BOX
    std::unordered_set<const SelectionCard*> open_;
    std::unordered_set<const SelectionCard*> read_;  ///< whose problems have been told
    Problems told_before_;
    int depth_ = 0;
};

/// The same piece seen from its other side.
Segment reversed(const Segment& segment);

/// Ranges of a /GENE (first, last) or /GEN_INCR (first, last, step) card, one after the other on each line.
struct IdRange {
    Id first = 0, last = 0, step = 1;
};
std::vector<IdRange> id_ranges(CardReader& reader, bool with_step);

}  // namespace type21
