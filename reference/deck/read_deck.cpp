#include <algorithm>

#include <fmt/format.h>

#include "reference/deck/card_collector.h"
#include "reference/deck/deck.h"
#include "reference/deck/deck_files.h"
#include "reference/deck/submodels.h"
#include "reference/deck/text_file.h"

namespace type21 {

namespace {

/// NAME_0000.rad -> NAME_0001.rad; empty when the name has no such ending.
std::string engine_path(const std::string& starter) {
    const std::string ending = "_0000.RAD";
    if (starter.size() < ending.size()) return {};
    const std::size_t at = starter.size() - ending.size();
    if (upper(std::string_view(starter).substr(at)) != ending) return {};
    std::string engine = starter;
    engine[at + 4] = '1';
    return engine;
}

bool has_keyword(const std::vector<Card>& cards, std::string_view word) {
    return std::any_of(cards.begin(), cards.end(),
                       [&](const Card& card) { return !card.words.empty() && card.words[0] == word; });
}

/// An engine deck in the place of the starter deck: said once, and nothing is made of its cards.
bool refuse_engine(Deck& deck, const std::string& path, Problems& problems) {
    if (has_keyword(deck.starter, "BEGIN") || !has_keyword(deck.starter, "RUN")) return false;
    Problem problem;
    problem.place = {path, 0};
    problem.rule = "this is an engine deck: it has /RUN and no /BEGIN";
    problem.remedy = "Give the starter deck, NAME_0000.rad; the engine deck beside it is found by its name";
    problems.add(problem);
    deck.starter.clear();
    return true;
}

/// A starter deck is whole when it has cards and an end.
void check_whole(const Deck& deck, const CardCollector& starter, const std::string& path, Problems& problems) {
    Problem problem;
    problem.place = starter.last_place();
    if (problem.place.file.empty()) problem.place.file = path;
    if (starter.empty()) {
        problem.rule = "the file holds no card";
        problem.remedy = "A starter deck begins with /BEGIN and ends with /END";
        problems.add(problem);
    } else if (!starter.ended() && !deck.starter.empty()) {
        problem.rule = "the deck has no /END: it may be cut off";
        problem.remedy = "Add /END behind the last card when the deck is complete";
        problems.add(problem);
    }
}

/// The engine deck beside the starter deck, unless the starter's file holds the engine input, too.
void read_engine_beside(const DeckFiles& files, Deck& deck, const std::string& starter_path, Problems& problems) {
    const std::string path = engine_path(starter_path);
    if (path.empty() || !files.exists(path)) return;
    if (!deck.has_engine) {
        CardCollector(files, deck, problems).read_engine(path);
        return;
    }
    Problem problem;
    problem.severity = Severity::warning;
    problem.place = {path, 0};
    problem.rule = fmt::format("the file is not read: {} holds the engine input, too", starter_path);
    problem.remedy = "Remove one of the two";
    problems.add(problem);
}

Deck read(const DeckFiles& files, const std::string& starter_path, Problems& problems) {
    Deck deck;
    CardCollector starter(files, deck, problems);
    starter.read_starter(starter_path);
    if (!starter.readable()) return deck;
    if (refuse_engine(deck, starter_path, problems)) return deck;
    check_whole(deck, starter, starter_path, problems);
    expand_submodels(deck, problems);
    read_engine_beside(files, deck, starter_path, problems);
    return deck;
}

}  // namespace

Deck read_deck(const std::string& starter_path, Problems& problems) {
    return read(DiskFiles(), starter_path, problems);
}

Deck read_deck(const std::vector<MemoryFile>& files, Problems& problems) {
    if (files.empty()) return {};
    return read(MemoryFiles(files), files.front().path, problems);
}

}  // namespace type21
