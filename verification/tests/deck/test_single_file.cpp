#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "problem_search.h"
#include "reference/deck/deck.h"

namespace type21 {
namespace {

using test::all_of;
using test::find_rule;
using test::keywords_of;
using test::TempFolder;

const std::vector<std::string> starter_cards{"/BEGIN", "/PART/1"};
const std::vector<std::string> engine_cards{"/VERS/2025", "/RUN/one/1"};

void expect_both(const std::string& text) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read_deck(folder.write("one_0000.rad", text), problems);
    EXPECT_TRUE(problems.list().empty()) << text << all_of(problems);
    EXPECT_TRUE(deck.has_engine) << text;
    EXPECT_EQ(keywords_of(deck.starter), starter_cards) << text;
    EXPECT_EQ(keywords_of(deck.engine), engine_cards) << text;
}

TEST(SingleFile, TheEngineInputFirst) {
    expect_both("#RADIOSS ENGINE\n/VERS/2025\n/RUN/one/1\n0.1\n/END/ENGINE\n#RADIOSS STARTER\n/BEGIN\n/PART/1\n/END\n");
    expect_both("/VERS/2025\n/RUN/one/1\n0.1\n/BEGIN\n/PART/1\n/END\n");
}

TEST(SingleFile, TheStarterInputFirst) {
    expect_both("/BEGIN\n/PART/1\n/END\n#RADIOSS ENGINE\n/VERS/2025\n/RUN/one/1\n0.1\n/END/ENGINE\n/ANIM/DT\n");
    expect_both("/BEGIN\n/PART/1\n/END\nremarks\n/VERS/2025\n/RUN/one/1\n0.1\n");
}

TEST(SingleFile, ItsDataLinesAreThere) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read_deck(folder.write("one.rad", "/RUN/one/1\n0.1\n/END/ENGINE\n/BEGIN\nrun\n/END\n"), problems);
    ASSERT_EQ(deck.engine.size(), 1U);
    EXPECT_EQ(deck.engine[0].lines.at(0).text(), "0.1");
    EXPECT_EQ(deck.place(deck.engine[0].lines.at(0)).line, 2);
    EXPECT_EQ(deck.starter.at(0).lines.at(0).text(), "run");
}

TEST(SingleFile, WhatFollowsEndIsElseNotRead) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read_deck(folder.write("one_0000.rad", "/BEGIN\n/END\n/PART/1\nold\n/ANIM/DT\n"), problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_FALSE(deck.has_engine);
    EXPECT_EQ(deck.starter.size(), 1U);
}

TEST(SingleFile, TheEngineDeckBesideIsNotReadThen) {
    const TempFolder folder;
    folder.write("one_0001.rad", "/RUN/other/1\n9\n");
    Problems problems;
    const Deck deck = read_deck(folder.write("one_0000.rad", "/RUN/one/1\n1\n/END/ENGINE\n/BEGIN\n/END\n"), problems);
    EXPECT_EQ(keywords_of(deck.engine), (std::vector<std::string>{"/RUN/one/1"}));
    EXPECT_FALSE(problems.has_errors());
    EXPECT_NE(find_rule(problems, "holds the engine input, too"), nullptr) << all_of(problems);
}

TEST(SingleFile, EndEngineWithinTheStarterInputIsAnError) {
    const TempFolder folder;
    Problems problems;
    read_deck(folder.write("one_0000.rad", "/BEGIN\n/RUN/one/1\n1\n/END/ENGINE\n/PART/1\n/END\n"), problems);
    EXPECT_EQ(problems.error_count(), 1) << all_of(problems);
}

TEST(SingleFile, EndEngineEndsAnEngineDeck) {
    const TempFolder folder;
    folder.write("one_0001.rad", "/RUN/one/1\n1\n/END/ENGINE\nanything\n/KILL\n");
    Problems problems;
    const Deck deck = read_deck(folder.write("one_0000.rad", "/BEGIN\n/END\n"), problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(keywords_of(deck.engine), (std::vector<std::string>{"/RUN/one/1"}));
}

}  // namespace
}  // namespace type21
