/// @file The Deck: cards with file and line numbers, nothing interpreted.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reference/deck/problem.h"

namespace type21 {

/// One data line of a card: neither a comment nor a keyword. Tabs are expanded and a carriage return is gone. A deck
/// has millions of them, so it is small.
class DataLine {
  public:
    DataLine() = default;
    DataLine(std::string_view text, int file_, int number_)
        : begin_(text.data()),
          number(number_),
          file(static_cast<std::uint16_t>(file_)),
          length_(static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 0xFFFF))) {}

    /// Points into Deck::texts.
    std::string_view text() const { return {begin_, length_}; }

  private:
    const char* begin_ = nullptr;

  public:
    int number = 0;          ///< line number, from 1
    std::uint16_t file = 0;  ///< index into Deck::files

  private:
    std::uint16_t length_ = 0;  ///< a longer line is refused
};
static_assert(sizeof(DataLine) == 16);

/// A keyword line and the data lines up to the next keyword.
struct Card {
    std::string keyword;             ///< as written, without trailing blanks: "/INTER/TYPE21/1"
    std::vector<std::string> words;  ///< upper case, split at '/': {"INTER", "TYPE21", "1"}
    DataLine place;                  ///< the keyword line itself
    std::vector<DataLine> lines;
};

/// The starter deck NAME_0000.rad and, if there is one, the engine deck NAME_0001.rad beside it.
struct Deck {
    std::vector<std::string> files;                         ///< every file read, included ones too
    std::vector<std::shared_ptr<const std::string>> texts;  ///< what the lines point into, some MB each
    std::vector<Card> starter;
    std::vector<Card> engine;
    std::vector<Card> unread;  ///< the /BEGIN cards of included files
    bool has_engine = false;   ///< beside the starter deck, or in the same file

    Place place(const DataLine& line) const { return {files.at(static_cast<size_t>(line.file)), line.number}; }
    Place place(const Card& card) const { return place(card.place); }
};

/// Gives back the memory of data lines that are not needed any more: the lines of these cards of the starter deck are
/// gone, and so are the pieces of text that no other line points into.
void forget_lines(Deck& deck, const std::function<bool(const Card&)>& of);

/// Reads a starter deck and the engine deck beside it, or one file that holds both inputs. Every problem of the text
/// itself (missing file or include, another program's file, binary content, an include that includes itself, text
/// before the first keyword, no /END) goes to problems.
Deck read_deck(const std::string& starter_path, Problems& problems);

/// One file of a deck that lies in memory.
struct MemoryFile {
    std::string path;  ///< by which the engine deck and includes are found
    std::string bytes;
};

/// The same for a deck in memory: files[0] is the starter deck, its engine deck and what it includes are looked for
/// among the others. Nothing is read from the disk.
Deck read_deck(const std::vector<MemoryFile>& files, Problems& problems);

}  // namespace type21
