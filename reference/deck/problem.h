/// @file What is wrong with a deck, said so that its author can mend it.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

namespace type21 {

/// Where in the text something stands. line counts from 1; 0 means the file as a whole.
struct Place {
    std::string file;
    int line = 0;
};

enum class Severity { warning, error };

/// One problem. A field that does not apply is empty (a missing file has neither card nor field).
struct Problem {
    Severity severity = Severity::error;
    Place place;
    std::string card;    ///< keyword line of the card, e.g. "/INTER/TYPE21/1"
    std::string field;   ///< name of the field as the manual writes it, e.g. "DEPTH"
    std::string value;   ///< what stands in the deck, with its unit where it has one
    std::string rule;    ///< what is asked for
    std::string remedy;  ///< what to do
    int count = 1;       ///< how often the same problem was met; the place is the first one
};

/// All problems of one deck, in the order in which they were met; the same problem at other places is counted, not
/// repeated. When many values of one field break one rule, those after the twentieth share one message. Of errors and
/// of warnings 500 are kept each, the rest is one message with a count. Texts are printable() and at most 300
/// characters long.
class Problems {
  public:
    void add(Problem problem);
    bool has_errors() const;
    int error_count() const;
    int warning_count() const;
    const std::vector<Problem>& list() const { return list_; }

  private:
    std::vector<Problem> list_;
    std::unordered_map<std::string, std::size_t> index_;  ///< of each distinct problem in list_
    std::unordered_map<std::string, int> values_;         ///< how many values broke the same rule
    int errors_ = 0;                                      ///< kept one by one
    int warnings_ = 0;
};

/// "file:line: error: card, field 'X' = value: rule. remedy" on one line.
std::string to_text(const Problem& problem);

}  // namespace type21
