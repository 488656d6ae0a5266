/// @file Collects the cards of one deck from its main file and from what that includes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reference/deck/deck.h"
#include "reference/deck/deck_files.h"

namespace type21 {

/// Reads the text of one deck, includes in their place, into cards.
///   /END            ends the deck; in an included file that file alone
///   "#enddata"      ends the file that it stands in
///   /BEGIN          of an included file is not read, but within //SUBMODEL ... //ENDSUB
///   /END/ENGINE     ends the engine input. In one file with both inputs the engine's comes first, up to /END/ENGINE or
///                   /BEGIN, or behind the starter's /END
class CardCollector {
  public:
    CardCollector(const DeckFiles& files, Deck& deck, Problems& problems)
        : files_(files), deck_(deck), problems_(problems) {}

    /// Reads the starter deck, and the engine input where it stands in the same file.
    void read_starter(const std::string& path);
    void read_engine(const std::string& path);

    bool readable() const { return readable_; }  ///< a file was found and is text
    bool ended() const { return ended_; }        ///< by /END or "#enddata", or by force
    bool empty() const { return empty_; }        ///< neither a keyword nor data were met
    /// Of the last line read.
    Place last_place() const { return last_.number > 0 ? deck_.place(last_) : Place{}; }

  private:
    struct Loaded {
        TextFile file;
        int index = 0;
    };

    void read_main(const std::string& path);
    void read_file(const std::string& path, const Problem& blame);
    const Loaded* load(const std::string& real, const std::string& path, const Problem& blame);
    void read_engine_behind();
    bool check_include(const std::string& real, const std::string& path, const Problem& blame);
    /// False when the rest of the file is not read.
    bool take(std::string_view text, const DataLine& line);
    bool open_card(const DataLine& line);
    void move_to_engine();
    void include(const std::vector<std::string>& names, const DataLine& line);
    bool included() const { return open_.size() > 1; }
    Problem at(const DataLine& line) const;
    void complain(Problem problem, std::string value, std::string rule, std::string remedy);

    const DeckFiles& files_;
    Deck& deck_;
    Problems& problems_;
    std::vector<Card>* cards_ = nullptr;  ///< where new cards go
    std::map<std::string, Loaded> loaded_;
    std::vector<std::string> open_;  ///< files that are being read, outermost first
    std::string main_;               ///< path of the main file
    int main_lines_ = 0;             ///< lines of the main file that were read
    std::size_t bytes_ = 0;
    int inclusions_ = 0;
    int stray_lines_ = 0;  ///< data before the first keyword
    DataLine first_stray_;
    DataLine last_;
    bool readable_ = false;
    bool ended_ = false;
    bool empty_ = true;
    bool submodel_ = false;
    std::optional<Card> unread_;  ///< the /BEGIN of an include while its lines are met
};

}  // namespace type21
