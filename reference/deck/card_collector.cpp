#include "reference/deck/card_collector.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/include_line.h"
#include "reference/deck/text_file.h"

namespace type21 {

namespace {

constexpr int max_include_depth = 15;
constexpr int max_inclusions = 20000;      ///< of all files together: includes that multiply at every level end here
constexpr std::size_t max_columns = 1000;  ///< of a keyword or data line; a card has 100

/// {"INTER", "TYPE21", "1"} of "/INTER/TYPE21/1".
std::vector<std::string> words_of(std::string_view keyword) {
    std::vector<std::string> words;
    while (!keyword.empty()) {
        keyword.remove_prefix(1);
        const std::size_t end = std::min(keyword.find('/'), keyword.size());
        if (const std::string_view word = trimmed(keyword.substr(0, end)); !word.empty()) words.push_back(upper(word));
        keyword.remove_prefix(end);
    }
    return words;
}

bool is_keyword(const Card& card, std::string_view word) {
    return !card.words.empty() && card.words[0] == word;
}

bool ends_engine(const std::vector<std::string>& words) {
    return words.size() == 2 && words[0] == "END" && words[1] == "ENGINE";
}

}  // namespace

void CardCollector::read_starter(const std::string& path) {
    cards_ = &deck_.starter;
    read_main(path);
    if (ended_ && !deck_.has_engine) read_engine_behind();
}

void CardCollector::read_engine(const std::string& path) {
    cards_ = &deck_.engine;
    read_main(path);
    deck_.has_engine = readable_;
}

void CardCollector::read_main(const std::string& path) {
    main_ = path;
    Problem blame;
    blame.place = {path, 0};
    read_file(path, blame);
    if (stray_lines_ == 0) return;
    Problem stray;
    stray.place = deck_.place(first_stray_);
    stray.count = cards_->empty() ? 1 : stray_lines_;
    complain(std::move(stray), "",
             cards_->empty() ? "this is no Radioss deck: none of its lines begins with '/'"
                             : "data stand before the first keyword",
             "A deck begins with a keyword line that starts with '/' in column 1");
}

/// What follows /END in a starter deck is not read, unless it is the engine input of the same run.
void CardCollector::read_engine_behind() {
    const auto found = loaded_.find(files_.identity(main_));
    if (found == loaded_.end()) return;
    LineReader lines(found->second.file);
    std::vector<DataLine> behind;
    std::string_view text;
    bool engine = false;
    for (int number = 1; lines.next(text); ++number) {
        if (number <= main_lines_) continue;
        const std::string head = upper(text.substr(0, 11));
        engine = engine || head.starts_with("/RUN/") || head.starts_with("/END/ENGINE");
        behind.emplace_back(text, found->second.index, number);
    }
    if (!engine) return;
    cards_ = &deck_.engine;
    deck_.has_engine = true;
    open_.push_back(found->first);
    bool in_card = false;  // text between /END and the first keyword belongs to nobody
    for (const DataLine& line : behind) {
        in_card = in_card || line.text().starts_with('/');
        if (in_card && !take(line.text(), line)) break;
    }
    open_.pop_back();
}

void CardCollector::read_file(const std::string& path, const Problem& blame) {
    const std::string real = files_.identity(path);
    if (!check_include(real, path, blame)) return;
    const Loaded* loaded = load(real, path, blame);
    if (loaded == nullptr) return;
    readable_ = true;
    if (loaded->file.size == 0 && !open_.empty()) {
        Problem empty = blame;
        empty.severity = Severity::warning;
        complain(std::move(empty), path, "the file is empty", "Check that it was written");
    }
    bytes_ += loaded->file.size;
    if (bytes_ > max_bytes || ++inclusions_ > max_inclusions) {
        complain(blame, path,
                 fmt::format("a deck is at most 2 GB and {} inclusions large, all its files together", max_inclusions),
                 "Look for a file that is included again and again");
        ended_ = true;
        return;
    }
    open_.push_back(real);
    int number = 0;
    LineReader lines(loaded->file);
    for (std::string_view text; lines.next(text);) {
        if (!included()) ++main_lines_;
        if (!take(text, DataLine(text, loaded->index, ++number)) || ended_) break;
    }
    open_.pop_back();
    if (unread_) deck_.unread.push_back(std::move(*std::exchange(unread_, std::nullopt)));
}

const CardCollector::Loaded* CardCollector::load(const std::string& real, const std::string& path,
                                                 const Problem& blame) {
    const auto known = loaded_.find(real);
    if (known != loaded_.end()) return &known->second;
    std::optional<TextFile> file = files_.load(path, blame, problems_);
    if (!file) return nullptr;
    deck_.files.push_back(path);
    deck_.texts.insert(deck_.texts.end(), file->pieces.begin(), file->pieces.end());
    return &loaded_.emplace(real, Loaded{std::move(*file), static_cast<int>(deck_.files.size()) - 1}).first->second;
}

/// An include that is open already never ends; one that is nested too deep most likely neither.
bool CardCollector::check_include(const std::string& real, const std::string& path, const Problem& blame) {
    if (std::find(open_.begin(), open_.end(), real) != open_.end()) {
        complain(blame, path, "the file includes itself, directly or through others", "Remove one #include");
        return false;
    }
    if (static_cast<int>(open_.size()) > max_include_depth) {
        complain(blame, path, fmt::format("includes are nested at most {} deep", max_include_depth),
                 "Include the file from a higher one");
        return false;
    }
    return true;
}

bool CardCollector::take(std::string_view text, const DataLine& line) {
    last_ = line;
    if (text.starts_with('#') || text.starts_with('$')) {
        if (is_end_of_data(text)) {
            ended_ = ended_ || !included();
            return false;
        }
        if (const auto names = included_names(text)) include(*names, line);
        return true;
    }
    if (text.size() > max_columns) {
        complain(at(line), fmt::format("{} characters", text.size()),
                 fmt::format("a line of a deck has at most {} characters", max_columns), "Break the line");
        return true;
    }
    if (text.starts_with('/')) return open_card(line);
    if (unread_) {
        unread_->lines.push_back(line);
    } else if (!cards_->empty()) {
        cards_->back().lines.push_back(line);
    } else if (!text.empty()) {
        if (stray_lines_++ == 0) first_stray_ = line;
        empty_ = false;
    }
    return true;
}

bool CardCollector::open_card(const DataLine& line) {
    empty_ = false;
    if (unread_) deck_.unread.push_back(std::move(*std::exchange(unread_, std::nullopt)));
    Card card;
    card.keyword = std::string(line.text());
    card.place = line;
    card.words = words_of(line.text());
    if (is_keyword(card, "END") && card.words.size() == 1) {
        if (!included()) ended_ = true;
        return false;
    }
    if (ends_engine(card.words)) {
        const bool starter = cards_ == &deck_.starter;
        if (!starter) return false;
        const bool begun =
            std::any_of(cards_->begin(), cards_->end(), [](const Card& c) { return is_keyword(c, "BEGIN"); });
        if (begun) {
            complain(at(line), card.keyword, "/END/ENGINE stands within the starter input",
                     "In one file with both inputs, put the engine's before /BEGIN or behind /END");
        } else {
            move_to_engine();
        }
        return true;
    }
    if (is_keyword(card, "SUBMODEL")) submodel_ = true;
    if (is_keyword(card, "ENDSUB")) submodel_ = false;
    if (is_keyword(card, "BEGIN") && !submodel_) {
        if (included()) {
            unread_ = std::move(card);
            return true;
        }
        const bool engine =
            std::any_of(cards_->begin(), cards_->end(), [](const Card& c) { return is_keyword(c, "RUN"); });
        if (engine && cards_ == &deck_.starter) move_to_engine();
    }
    cards_->push_back(std::move(card));
    return true;
}

/// The cards met so far in the starter's file are the engine input.
void CardCollector::move_to_engine() {
    deck_.engine = std::exchange(deck_.starter, {});
    deck_.has_engine = true;
}

void CardCollector::include(const std::vector<std::string>& names, const DataLine& line) {
    Problem blame = at(line);
    blame.card = "#include";
    if (names.front().empty()) {
        complain(std::move(blame), "\"\"", "the name of the file is missing", "Write #include FILE");
        return;
    }
    const std::string& including = deck_.files.at(static_cast<std::size_t>(line.file));
    std::vector<std::string> found;
    for (const std::string& name : names) {
        for (std::string& path : include_paths(name, including, main_)) {
            if (files_.exists(path)) found.push_back(std::move(path));
        }
        if (!found.empty()) break;
    }
    if (found.empty()) {
        const std::string path = include_paths(names.front(), including, main_).front();
        const std::string similar = files_.similar(path);
        complain(std::move(blame), path, "there is no such file",
                 similar.empty()
                     ? "It was looked for beside the including file, beside the main deck and in the working "
                       "directory; give its path from one of them"
                     : fmt::format("There is '{}': upper and lower case differ", similar));
        return;
    }
    const auto other = std::find_if(found.begin(), found.end(), [&](const std::string& path) {
        return files_.identity(path) != files_.identity(found.front());
    });
    if (other != found.end()) {
        Problem twice = blame;
        twice.severity = Severity::warning;
        complain(std::move(twice), names.front(),
                 fmt::format("two files have this name; {} is read, {} is not", found.front(), *other),
                 "Give a path that names one of them");
    }
    read_file(found.front(), blame);
}

Problem CardCollector::at(const DataLine& line) const {
    Problem problem;
    problem.place = deck_.place(line);
    return problem;
}

void CardCollector::complain(Problem problem, std::string value, std::string rule, std::string remedy) {
    problem.value = std::move(value);
    problem.rule = std::move(rule);
    problem.remedy = std::move(remedy);
    problems_.add(std::move(problem));
}

}  // namespace type21
