/// @file The Deck: cards with file and line numbers, nothing interpreted.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "reference/deck/problem.h"

namespace type21 {

/// One data line of a card: neither a comment nor a keyword. Tabs are expanded and a carriage return is gone.
struct DataLine {
    std::string_view text;  ///< points into Deck::texts
    int file = 0;           ///< index into Deck::files
    int number = 0;         ///< line number, from 1
};

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
    std::vector<std::shared_ptr<const std::string>> texts;  ///< what the lines point into
    std::vector<Card> starter;
    std::vector<Card> engine;
    bool has_engine = false;

    Place place(const DataLine& line) const { return {files.at(static_cast<size_t>(line.file)), line.number}; }
    Place place(const Card& card) const { return place(card.place); }
};

/// Reads a starter deck and the engine deck beside it. Every problem of the text itself (missing file or include,
/// binary content, an include that includes itself, text before the first keyword, no /END) goes to problems.
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
