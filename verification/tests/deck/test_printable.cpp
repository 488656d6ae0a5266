#include <string>

#include <gtest/gtest.h>

#include "reference/deck/printable.h"
#include "reference/deck/problem.h"

namespace type21 {
namespace {

TEST(Printable, ControlCharactersAreWrittenOut) {
    EXPECT_EQ(printable("\x1b]0;title\x07\x1b[2J"), "\\x1b]0;title\\x07\\x1b[2J");
    EXPECT_EQ(printable("a\nb\tc\rd\x7f"), "a\\nb\\tc\\rd\\x7f");
    EXPECT_EQ(printable("\xc2\x9b"
                        "31m"),
              "\\x9b31m")
        << "the second control block has a one-byte escape";
    EXPECT_EQ(printable("\xe2\x80\xae"
                        "dar"),
              "\\u202edar");
}

TEST(Printable, LettersStay) {
    EXPECT_EQ(printable("h\xc3\xa4lfte \xe6\x9d\xbf \xf0\x9f\x94\xa7 a\\b"),
              "h\xc3\xa4lfte \xe6\x9d\xbf \xf0\x9f\x94\xa7 a\\b");
    EXPECT_EQ(printable(""), "");
}

TEST(Printable, BytesThatAreNoUtf8AreWrittenOut) {
    EXPECT_EQ(printable("\xe4\x62"), "\\xe4b") << "Latin-1";
    EXPECT_EQ(printable("\x9b"), "\\x9b");
    EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf") << "an overlong slash";
    EXPECT_EQ(printable("\xe2\x82"), "\\xe2\\x82") << "cut off";
}

TEST(Printable, LongTextIsCutBetweenCharacters) {
    EXPECT_EQ(printable("abcdef", 6), "abcdef");
    EXPECT_EQ(printable("abcdefg", 3), "abc ... (7 characters)");
    EXPECT_EQ(printable("ab\xc3\xa4xyz", 3), "ab ... (7 characters)");
}

TEST(Printable, NothingInAProblemSteersATerminal) {
    Problem problem;
    problem.place.file = "a\x1b[31m.rad";
    problem.card = "/INTER/\x1b/1";
    problem.value = "\x07";
    problem.rule = "rule";
    Problems problems;
    problems.add(problem);
    for (const char c : to_text(problems.list()[0]))
        EXPECT_GE(c, ' ');
}

}  // namespace
}  // namespace type21
