#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "problem_search.h"
#include "reference/deck/deck.h"

namespace type21 {
namespace {

using test::all_of;
using test::TempFolder;

Deck read(const TempFolder& folder, std::string_view text, Problems& problems) {
    return read_deck(folder.write("scene_0000.rad", text), problems);
}

TEST(ReadDeck, CardsHaveTheirDataLinesAndLineNumbers) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read(folder,
                           "#RADIOSS STARTER\n\n/BEGIN\nrun\n# a comment\n      2025\n$ another\n/part/7/2\ntitle\n"
                           "/END\n/NODE\n1\n",
                           problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    ASSERT_EQ(deck.starter.size(), 2U) << "what follows /END is not read";
    EXPECT_EQ(deck.starter[0].keyword, "/BEGIN");
    ASSERT_EQ(deck.starter[0].lines.size(), 2U);
    EXPECT_EQ(deck.starter[0].lines[0].text(), "run");
    EXPECT_EQ(deck.starter[0].lines[1].text(), "      2025");
    EXPECT_EQ(deck.starter[0].lines[1].number, 6);
    EXPECT_EQ(deck.starter[1].keyword, "/part/7/2");
    EXPECT_EQ(deck.starter[1].words, (std::vector<std::string>{"PART", "7", "2"}));
    EXPECT_EQ(deck.place(deck.starter[1]).line, 8);
    EXPECT_EQ(deck.place(deck.starter[1]).file, folder.path("scene_0000.rad"));
}

TEST(ReadDeck, BlankLinesAreData) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read(folder, "/INTER/TYPE21/1\ntitle\n\n   \nlast\n/END\n", problems);
    ASSERT_EQ(deck.starter[0].lines.size(), 4U);
    EXPECT_EQ(deck.starter[0].lines[1].text(), "");
    EXPECT_EQ(deck.starter[0].lines[3].text(), "last");
}

TEST(ReadDeck, WindowsLineEndsTrailingBlanksAndByteOrderMarkAreGone) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read(folder, "\xEF\xBB\xBF/TITLE\r\nh\xC3\xA4lfte  \r\n/END\r\n\x1A", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    ASSERT_EQ(deck.starter.size(), 1U);
    EXPECT_EQ(deck.starter[0].keyword, "/TITLE");
    EXPECT_EQ(deck.starter[0].lines[0].text(), "h\xC3\xA4lfte");
}

TEST(ReadDeck, LinesOfAnOldMacintoshEnd) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read(folder, "/TITLE\rone\r/END\r", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    ASSERT_EQ(deck.starter.size(), 1U);
    EXPECT_EQ(deck.starter[0].lines.at(0).text(), "one");
}

TEST(ReadDeck, ATabLeadsToTheNextFieldOfTenColumns) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read(folder, "/NODE\n1\t2.5\t\t3.5\n1234567890\t7\n/END\n", problems);
    ASSERT_EQ(deck.starter[0].lines.size(), 2U);
    EXPECT_EQ(deck.starter[0].lines[0].text(), "1         2.5                 3.5");
    EXPECT_EQ(deck.starter[0].lines[1].text(), "1234567890          7");
}

TEST(ReadDeck, AnIncludeStandsForItsText) {
    const TempFolder folder;
    folder.write("parts/nodes.inc", "         2\n#include deeper.inc\n");
    folder.write("parts/deeper.inc", "         3\n/PART/1\n");
    Problems problems;
    const Deck deck = read(folder, "/NODE\n         1\n#include parts/nodes.inc\ntitle\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    ASSERT_EQ(deck.starter.size(), 2U);
    ASSERT_EQ(deck.starter[0].lines.size(), 3U);
    EXPECT_EQ(deck.starter[0].lines[2].text(), "         3");
    EXPECT_EQ(deck.place(deck.starter[0].lines[2]).file, folder.path("parts/deeper.inc"));
    EXPECT_EQ(deck.place(deck.starter[0].lines[2]).line, 1);
    EXPECT_EQ(deck.starter[1].lines.at(0).text(), "title");
    EXPECT_EQ(deck.files.size(), 3U);
}

TEST(ReadDeck, AnIncludeMayBeQuotedOrWrittenWithBackslashesAndReadTwice) {
    const TempFolder folder;
    folder.write("sub/x.inc", "/PART/1\n");
    Problems problems;
    const Deck deck = read(folder, "#INCLUDE \"sub/x.inc\"\n#include sub\\x.inc\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(deck.starter.size(), 2U);
    EXPECT_EQ(deck.files.size(), 2U) << "one file, read once";
}

TEST(ReadDeck, TheEngineDeckBesideIsReadAndNeedsNoEnd) {
    const TempFolder folder;
    folder.write("scene_0001.rad", "/RUN/scene/1\n1e-3\n");
    Problems problems;
    const Deck deck = read(folder, "/BEGIN\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_TRUE(deck.has_engine);
    ASSERT_EQ(deck.engine.size(), 1U);
    EXPECT_EQ(deck.place(deck.engine[0].lines.at(0)).file, folder.path("scene_0001.rad"));
}

TEST(ReadDeck, WithoutAnEngineDeckThereIsNone) {
    const TempFolder folder;
    Problems problems;
    EXPECT_FALSE(read(folder, "/BEGIN\n/END\n", problems).has_engine);
    EXPECT_TRUE(problems.list().empty());
}

}  // namespace
}  // namespace type21
