/// @file What a test looks for in the problems of a deck, and how it spoils one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "reference/deck/deck.h"
#include "verification/tests/temp_folder.h"

namespace type21::test {

/// All messages, one a line, for the output of a failing test.
inline std::string all_of(const Problems& problems) {
    std::string text;
    for (const Problem& problem : problems.list())
        text += to_text(problem) + "\n";
    return text;
}

/// The first problem whose rule contains these words; nullptr if none does.
inline const Problem* find_rule(const Problems& problems, std::string_view words) {
    for (const Problem& problem : problems.list()) {
        if (problem.rule.find(words) != std::string::npos) return &problem;
    }
    return nullptr;
}

/// The keyword lines of these cards.
inline std::vector<std::string> keywords_of(const std::vector<Card>& cards) {
    std::vector<std::string> names;
    for (const Card& card : cards)
        names.push_back(card.keyword);
    return names;
}

/// The text with its one piece `from` replaced; a test that replaces nothing tests nothing.
inline std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "the text has no '" << from << "'";
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

}  // namespace type21::test
