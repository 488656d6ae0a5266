/// @file What the readers of the starter deck share: the model in the making and the ids met so far.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "reference/model/card_reader.h"
#include "reference/model/known_keywords.h"
#include "reference/model/model.h"

namespace type21 {

/// Ids of one kind of card, their index in the model and where they stand.
struct Registry {
    std::string keyword;  ///< for messages: "/PART"
    struct Entry {
        int index = -1;
        Place place;
    };
    std::unordered_map<Id, Entry> entries;
    /// Ids of cards that are not supported: reported once as such, so that a reference to them is no second message.
    std::unordered_set<Id> unsupported;
    /// Keywords of cards that are not read and harmless until something refers to them.
    std::unordered_map<Id, std::string> unread = {};
    /// Reads the card of an entry whose index is `not_loaded`, notes its index and returns it.
    std::function<int(Id)> load = nullptr;
    static constexpr int not_loaded = -2;
    /// Those that do no harm where they stand, but that no card may refer to: the rule that a reference breaks.
    std::unordered_map<Id, std::string> refused{};

    /// Index in the model, -1 if the id is not there.
    int find(Id id) const {
        const auto found = entries.find(id);
        if (found == entries.end()) return -1;
        return load && found->second.index == not_loaded ? load(id) : found->second.index;
    }
};

/// One card of the starter deck with what its keyword means.
struct ReadCard {
    const Card* card = nullptr;
    KeywordMatch match;
};

/// Stands for the keyword line where a data line is asked for.
inline constexpr size_t keyword_line = std::numeric_limits<int>::max();

class Selector;

struct Reading {
    Reading(const Deck& deck_, Model& model_, Problems& problems_);
    ~Reading();

    const Deck& deck;
    Model& model;
    Problems& problems;
    std::vector<ReadCard> cards;

    Registry materials{"/MAT", {}, {}}, properties{"/PROP", {}, {}}, parts{"/PART", {}, {}};
    Registry surfaces{"/SURF", {}, {}}, groups{"/GRNOD", {}, {}}, functions{"/FUNCT", {}, {}};
    Registry skews{"/SKEW", {}, {}}, frames{"/FRAME", {}, {}};
    Registry sensors{"/SENSOR", {}, {}}, rigid_bodies{"/RBODY", {}, {}}, friction_models{"/FRICTION", {}, {}};
    Registry interfaces{"/INTER", {}, {}}, histories{"/TH", {}, {}}, units{"/UNIT", {}, {}};
    std::vector<Id> part_subsets;           ///< subset_ID of each part
    int first_sh3n = 0;                     ///< index of the first shell of a /SH3N card; those of /SHELL come before
    std::unique_ptr<Selector> selector;     ///< reads groups and surfaces when they are asked for
    Registry conditions{"", {}, {}};        ///< of one kind at a time: nothing refers to these
    std::vector<const Card*> sensor_cards;  ///< of each of Model::sensors
    std::unordered_map<int, std::string> sensor_users;  ///< the first card that refers to a sensor, by its index

    /// Calls read(card, reader, id) for every card of this keyword, in the order of the deck. A card without an id, or
    /// with one that another card of the registry has, is an error and is not read.
    /// @param index what the registry notes for the id: the entry that read() is about to append.
    void each(Keyword keyword, Registry& registry, const std::function<int()>& index,
              const std::function<void(CardReader&, Id)>& read);

    /// Index of what a field names. 0 or blank: -1, an error if it is required. An id that no card has, and a group or
    /// surface that is empty: -1 and an error.
    int reference(CardReader& reader, size_t line, std::string_view field, Id id, const Registry& registry,
                  bool required);
    /// reference() to the integer in these columns.
    int reference(CardReader& reader, size_t line, int first, int last, std::string_view field,
                  const Registry& registry, bool required);

    /// The same for a set that may still be empty, as a member of another set may.
    int member(CardReader& reader, size_t line, std::string_view field, Id id, const Registry& registry, bool required);

    CardReader reader(const Card& card, size_t unit_position);

    /// Gives back the memory of the lines of all cards of this keyword, which nobody reads again; empty where the deck
    /// belongs to someone else.
    std::function<void(std::string_view word)> forget = {};

    /// Counts a card that is not read because nothing here depends on it; say_ignored() makes one warning of them.
    void ignore(const Card& card);
    void say_ignored();

  private:
    bool is_empty(const Registry& registry, int index) const;
    std::map<std::string, int> ignored_;  ///< how often each keyword is there
    std::optional<Place> first_ignored_;
};

/// The id in word `position` of a keyword; none and an error when it is not a positive integer.
std::optional<Id> id_of(const Card& card, size_t position, CardReader& reader);

/// An error when the field is not 0: the feature behind it is not supported.
void refuse_unless_zero(CardReader& reader, size_t line, int first, int last, std::string_view field,
                        std::string_view feature);

/// A warning for data behind the last line of a card.
void warn_of_excess(CardReader& reader, size_t lines);

/// The ids of a list card, 10 fields of 10 columns a line, zeros left out, with the data line of each.
struct ListedId {
    Id id = 0;
    size_t line = 0;
};
std::vector<ListedId> listed_ids(CardReader& reader, size_t first_line, std::string_view field);

/// Direction X, Y, Z, XX, YY, ZZ as 0..5; -1 and an error for another word.
int direction(CardReader& reader, size_t line, int first, int last);

/// A scale factor of 20 columns; 0 means 1 in the units of the card.
double scale(CardReader& reader, size_t line, int first, std::string_view field, Dimension dimension);

/// "7.8e-06 Mg/mm^3": a value in work units for a message.
std::string quantity(const CardReader& reader, double value, Dimension dimension);

/// Index into Model::skews of the axes that a field of 10 columns names; -1 for 0 (global axes). A /SKEW or /FRAME that
/// moves is an error that names its kind.
/// @param registry  Reading::skews or Reading::frames
int skew_reference(Reading& reading, CardReader& reader, size_t line, int first, std::string_view field,
                   const Registry& registry);

/// Index of the /SENSOR that a field of 10 columns names; -1 for 0.
int sensor_reference(Reading& reading, CardReader& reader, size_t line, int first);

// The readers, in the order in which resolve() calls them.
void read_begin(Reading& reading);
void check_keywords(Reading& reading);
void read_skews(Reading& reading);
void read_functions(Reading& reading);
void read_sensors(Reading& reading);
void read_materials(Reading& reading);
void read_heat_materials(Reading& reading);
void read_mesh(Reading& reading);
void read_selections(Reading& reading);
void read_transforms(Reading& reading);
void read_conditions(Reading& reading);
void read_loads(Reading& reading);
void read_temperatures(Reading& reading);
void read_friction(Reading& reading);
void sum_nodal_mass(Model& model);
void sum_nodal_heat_capacity(Model& model);
void read_rigid_bodies(Reading& reading);
void link_sensors(Reading& reading);
void read_histories(Reading& reading);
void read_engine(Reading& reading);

}  // namespace type21
