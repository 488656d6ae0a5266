#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/deck.h"
#include "reference/deck/deck_files.h"
#include "reference/deck/text_file.h"

namespace type21 {

namespace {

namespace fs = std::filesystem;

constexpr int max_include_depth = 15;
constexpr int max_inclusions = 20000;      ///< of all files together: includes that multiply at every level end here
constexpr std::size_t max_columns = 1000;  ///< of a keyword or data line; a card has 100

/// Reads the text of one deck, includes in their place, into cards.
class CardCollector {
  public:
    CardCollector(const DeckFiles& files, Deck& deck, std::vector<Card>& cards, Problems& problems)
        : files_(files), deck_(deck), cards_(cards), problems_(problems) {}

    void read(const std::string& path) {
        Problem blame;
        blame.place = {path, 0};
        read_file(path, blame);
    }

    bool readable() const { return readable_; }
    bool ended() const { return ended_; }
    bool empty() const { return empty_; }
    Place last_place() const { return last_; }

  private:
    struct Loaded {
        TextFile file;
        int index = 0;
    };

    void read_file(const std::string& path, const Problem& blame) {
        const std::string real = files_.identity(path);
        if (!check_include(real, path, blame)) return;
        auto known = loaded_.find(real);
        if (known == loaded_.end()) {
            std::optional<TextFile> file = files_.load(path, blame, problems_);
            if (!file) return;
            deck_.files.push_back(path);
            deck_.texts.push_back(file->text);
            known = loaded_.emplace(real, Loaded{std::move(*file), static_cast<int>(deck_.files.size()) - 1}).first;
        }
        readable_ = true;
        const Loaded& loaded = known->second;
        bytes_ += loaded.file.text->size();
        if (bytes_ > max_bytes || ++inclusions_ > max_inclusions) {
            complain(
                blame, path,
                fmt::format("a deck is at most 2 GB and {} inclusions large, all its files together", max_inclusions),
                "Look for a file that is included again and again");
            ended_ = true;
            return;
        }
        open_.push_back(real);
        int number = 0;
        for (const std::string_view line : loaded.file.lines) {
            ++number;
            if (ended_) break;
            take(DataLine{line, loaded.index, number});
        }
        open_.pop_back();
    }

    /// An include that is open already never ends; one that is nested too deep most likely neither.
    bool check_include(const std::string& real, const std::string& path, const Problem& blame) {
        for (const std::string& open : open_) {
            if (open == real) {
                complain(blame, path, "the file includes itself, directly or through others", "Remove one #include");
                return false;
            }
        }
        if (static_cast<int>(open_.size()) > max_include_depth) {
            complain(blame, path, fmt::format("includes are nested at most {} deep", max_include_depth),
                     "Include the file from a higher one");
            return false;
        }
        return true;
    }

    void take(const DataLine& line) {
        const std::string_view text = line.text;
        last_ = deck_.place(line);
        if (text.starts_with('#') || text.starts_with('$')) {
            if (const std::string name = included(text); !name.empty()) include(name, line);
            return;
        }
        if (text.size() > max_columns) {
            complain(at(line), fmt::format("{} characters", text.size()),
                     fmt::format("a line of a deck has at most {} characters", max_columns), "Break the line");
        } else if (text.starts_with('/')) {
            open_card(line);
        } else if (!cards_.empty()) {
            cards_.back().lines.push_back(line);
        } else if (!text.empty()) {
            complain(at(line), "", "data stand before the first keyword",
                     "A deck begins with a keyword line that starts with '/' in column 1");
            empty_ = false;
        }
    }

    void open_card(const DataLine& line) {
        empty_ = false;
        Card card;
        card.keyword = std::string(line.text);
        card.place = line;
        std::string_view rest = line.text;
        while (!rest.empty()) {
            rest.remove_prefix(1);
            const std::size_t end = std::min(rest.find('/'), rest.size());
            if (const std::string_view word = trimmed(rest.substr(0, end)); !word.empty()) {
                card.words.push_back(upper(word));
            }
            rest.remove_prefix(end);
        }
        if (card.words.size() == 1 && card.words[0] == "END") {
            ended_ = true;
            if (open_.size() > 1) {
                Problem problem = at(line);
                problem.severity = Severity::warning;
                complain(problem, "", "/END in an included file ends the whole deck",
                         "What follows the #include is not read; remove this /END if it should be");
            }
            return;
        }
        cards_.push_back(std::move(card));
    }

    /// The file name of an "#include FILE" line, empty for any other comment.
    static std::string included(std::string_view text) {
        constexpr std::string_view word = "#INCLUDE";
        if (text.size() <= word.size() || upper(text.substr(0, word.size())) != word) return {};
        if (text[word.size()] != ' ') return {};
        std::string_view name = trimmed(text.substr(word.size()));
        if (name.size() > 1 && (name.front() == '"' || name.front() == '\'') && name.back() == name.front()) {
            name = name.substr(1, name.size() - 2);
        }
        return std::string(name);
    }

    void include(const std::string& name, const DataLine& line) {
        const fs::path folder = fs::path(deck_.files.at(static_cast<std::size_t>(line.file))).parent_path();
        fs::path path = (folder / name).lexically_normal();
        if (!files_.exists(path.string())) {
            // A deck from Windows writes its folders with backslashes.
            std::string other = name;
            for (char& c : other)
                c = c == '\\' ? '/' : c;
            const fs::path second = (folder / other).lexically_normal();
            if (files_.exists(second.string())) path = second;
        }
        Problem blame = at(line);
        blame.card = "#include";
        read_file(path.string(), blame);
    }

    Problem at(const DataLine& line) const {
        Problem problem;
        problem.place = deck_.place(line);
        return problem;
    }

    void complain(Problem problem, std::string value, std::string rule, std::string remedy) {
        problem.value = std::move(value);
        problem.rule = std::move(rule);
        problem.remedy = std::move(remedy);
        problems_.add(std::move(problem));
    }

    const DeckFiles& files_;
    Deck& deck_;
    std::vector<Card>& cards_;
    Problems& problems_;
    std::map<std::string, Loaded> loaded_;
    std::vector<std::string> open_;  ///< files that are being read, outermost first
    std::size_t bytes_ = 0;
    int inclusions_ = 0;
    Place last_;
    bool readable_ = false;
    bool ended_ = false;
    bool empty_ = true;
};

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

Deck read(const DeckFiles& files, const std::string& starter_path, Problems& problems) {
    Deck deck;
    CardCollector starter(files, deck, deck.starter, problems);
    starter.read(starter_path);
    if (!starter.readable()) return deck;
    Problem problem;
    problem.place = starter.last_place();
    if (problem.place.file.empty()) problem.place.file = starter_path;
    if (starter.empty()) {
        problem.rule = "the file holds no card";
        problem.remedy = "A starter deck begins with /BEGIN and ends with /END";
        problems.add(problem);
    } else if (!starter.ended()) {
        problem.rule = "the deck has no /END: it may be cut off";
        problem.remedy = "Add /END behind the last card when the deck is complete";
        problems.add(problem);
    }
    const std::string engine = engine_path(starter_path);
    if (!engine.empty() && files.exists(engine)) {
        CardCollector collector(files, deck, deck.engine, problems);
        collector.read(engine);
        deck.has_engine = collector.readable();
    }
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
